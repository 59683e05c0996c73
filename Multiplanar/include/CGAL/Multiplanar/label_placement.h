// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_LABEL_PLACEMENT_H
#define CGAL_MULTIPLANAR_LABEL_PLACEMENT_H

#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Multiplanar/io/stroke_font.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A polygon with holes as one set of sides.
struct Label_region
{
  std::vector<Outline> loops;

  /// Distance of `p` from the boundary, negative outside. Linear time.
  double depth(double x, double y) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (const Outline& loop : loops)
      for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const double ax = loop[j].x(), ay = loop[j].y(), dx = loop[i].x() - ax, dy = loop[i].y() - ay;
        const double length = dx * dx + dy * dy;
        const double t = length > 0 ? (std::min)(1., (std::max)(0., ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
        nearest = (std::min)(nearest, std::hypot(ax + t * dx - x, ay + t * dy - y));
        if ((ay > y) != (ay + dy > y) && x < ax + (y - ay) / dy * dx) inside = !inside;
      }
    return inside ? nearest : -nearest;
  }
};

/// A square of the search: no point of it lies deeper than `bound`.
struct Label_cell
{
  double x, y, half, depth, bound;
  bool operator<(const Label_cell& other) const { return bound < other.bound; }
};

/// The centre and radius of a circle inside the region, its radius within 2% of the largest: squares are split while
/// they can hold a better centre (Garcia-Castellanos and Lombardo 2007, as a quadtree). Radius 0 if nothing fits.
inline Label_cell deepest_point(const Label_region& region)
{
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
  for (const Point_2& p : region.loops[0]) {
    low_x = (std::min)(low_x, p.x()), high_x = (std::max)(high_x, p.x());
    low_y = (std::min)(low_y, p.y()), high_y = (std::max)(high_y, p.y());
  }
  const auto cell = [&](double x, double y, double half) {
    const double depth = region.depth(x, y);
    return Label_cell{x, y, half, depth, depth + half * std::sqrt(2.)};
  };
  const double size = (std::max)(high_x - low_x, high_y - low_y);
  Label_cell best = cell((low_x + high_x) / 2, (low_y + high_y) / 2, size / 2);
  std::priority_queue<Label_cell> cells;
  cells.push(best);
  best.depth = (std::max)(best.depth, 0.);
  while (!cells.empty()) {
    const Label_cell top = cells.top();
    cells.pop();
    if (top.bound <= best.depth * 1.02 + 1e-4 * size) break;
    const double h = top.half / 2;
    for (int i = 0; i < 4; ++i) {
      const Label_cell next = cell(top.x + (i % 2 ? h : -h), top.y + (i / 2 ? h : -h), h);
      if (next.depth > best.depth) best = next;
      cells.push(next);
    }
  }
  return best;
}

/// The largest place for `text` at one angle, not higher than `largest`. The plane is turned by the angle and squeezed
/// along the base line, so that the box of the text becomes a square.
inline Engraving label_at_angle(const std::string& text, const std::vector<Outline>& loops, double degrees,
                                double largest)
{
  const double free_margin = 1.2; // the box that is kept free, in units of the text's own box
  const double aspect = (std::max)(text_width(text), 0.1);
  const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
  Label_region region{loops};
  for (Outline& loop : region.loops)
    for (Point_2& p : loop) p = Point_2((c * p.x() + s * p.y()) / aspect, c * p.y() - s * p.x());
  const Label_cell place = deepest_point(region);
  Engraving label;
  label.text = text;
  label.at = Point_2(c * place.x * aspect - s * place.y, s * place.x * aspect + c * place.y);
  label.angle = degrees;
  label.height = (std::min)(largest, place.depth * std::sqrt(2.) / free_margin);
  return label;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

A good place for `text` inside a part, at one of thirteen angles within 90 degrees of `upright`, in the middle of the
largest circle there (which holds the largest square well enough). Text leans away from upright only where it gets
higher by a tenth for every 15 degrees.

\return the engraving; its height is at most `largest`, and as small as the part demands: the caller decides what is
        legible
\pre the outline is simple
*/
inline Engraving place_label(const std::string& text, const Outline& outline, const std::vector<Outline>& holes,
                             double largest, double upright = 0)
{
  std::vector<Outline> loops{outline};
  loops.insert(loops.end(), holes.begin(), holes.end());
  Engraving best;
  best.text = text;
  for (int i = 0; i < 13; ++i) {
    const int steps = (i + 1) / 2;
    const double required = best.height * (1 + 0.1 * steps);
    if (i > 0 && required >= largest) break;
    const double degrees = upright + (i % 2 ? 15 : -15) * steps; // 0, 15, -15, 30, ... from upright
    const Engraving label = internal::label_at_angle(text, loops, degrees, largest);
    if (label.height > required) best = label;
  }
  return best;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_LABEL_PLACEMENT_H
