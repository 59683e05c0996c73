// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_THIN_WEBS_H
#define CGAL_MULTIPLANAR_INTERNAL_THIN_WEBS_H

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/Flat_polygon.h>

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

// Boolean operations leave what no machine can cut: *webs*, material narrower than the beam leaves standing, between a
// hole and the outline or between two stretches of one loop; and *pinholes* as narrow. Both are cut away here: a gap
// that a thin web closed is then a notch, as it should be. Nothing is ever added, so parts that were apart stay so.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A vertex and the point of another side that is nearest to it.
struct Web
{
  Point_2 from, to;
};

inline Point_2 nearest_on_segment(const Point_2& p, const Point_2& a, const Point_2& b)
{
  const Kernel::Vector_2 d = b - a;
  const double q = d.squared_length(), s = q > 0 ? ((p - a) * d) / q : 0;
  return a + (std::min)((std::max)(s, 0.0), 1.0) * d;
}

/// Looks for webs from every vertex to every side.
class Web_finder
{
public:
  /// \param width what is narrower is a web
  Web_finder(const Flat_polygon& polygon, double width) : polygon(polygon), width(width)
  {
    loops.push_back(&polygon.outline);
    for (const Outline& hole : polygon.holes) loops.push_back(&hole);
    for (const Outline* loop : loops) {
      positions.push_back({0});
      for (std::size_t i = 0; i < loop->size(); ++i)
        positions.back().push_back(positions.back().back() + side_length(*loop, i));
    }
  }

  std::vector<Web> webs() const
  {
    std::vector<Web> result;
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t v = 0; v < loops[l]->size(); ++v)
        for (std::size_t m = 0; m < loops.size(); ++m)
          for (std::size_t s = 0; s < loops[m]->size(); ++s) add_web(l, v, m, s, result);
    return result;
  }

private:
  static double side_length(const Outline& loop, std::size_t i)
  {
    return std::sqrt(CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
  }

  void add_web(std::size_t l, std::size_t v, std::size_t m, std::size_t s, std::vector<Web>& result) const
  {
    const Point_2 &p = (*loops[l])[v], &a = (*loops[m])[s], &b = (*loops[m])[(s + 1) % loops[m]->size()];
    if ((std::min)(a.x(), b.x()) > p.x() + width || (std::max)(a.x(), b.x()) < p.x() - width ||
        (std::min)(a.y(), b.y()) > p.y() + width || (std::max)(a.y(), b.y()) < p.y() - width)
      return;
    const Point_2 q = nearest_on_segment(p, a, b);
    const double d = std::sqrt(CGAL::squared_distance(p, q));
    if (d >= width || d == 0 || !contains(polygon, CGAL::midpoint(p, q))) return;
    if (l == m && is_corner(l, positions[l][v], positions[m][s] + std::sqrt(CGAL::squared_distance(a, q)), d)) return;
    result.push_back({p, q});
  }

  /// Is the way along the loop between two of its points so short that no web lies between them, only a corner that is
  /// blunt or small?
  bool is_corner(std::size_t l, double from, double to, double d) const
  {
    const double way = std::abs(to - from), shorter = (std::min)(way, positions[l].back() - way);
    return shorter < 4 * d || shorter < 2 * width;
  }

  const Flat_polygon& polygon;
  double width;
  std::vector<const Outline*> loops;
  std::vector<std::vector<double>> positions; ///< of the vertices of each loop, in mm; the last is its length
};

/// The rectangle that cuts through a web, a little longer than it.
inline Exact_loop cut_through(const Web& web, double width)
{
  const Kernel::Vector_2 d = web.to - web.from, along = d * (1 / std::sqrt(d.squared_length()));
  const Kernel::Vector_2 across(-along.y() * width / 2, along.x() * width / 2), more = along * 0.01;
  return exact_loop(
      {web.from - more - across, web.to + more - across, web.to + more + across, web.from - more + across});
}

/// A pinhole made wider by half of `width` all around: its convex hull, and some.
inline Exact_loop widened_pinhole(const Outline& hole, double width)
{
  Outline wider, hull;
  for (const Point_2& p : hole)
    for (int i = 0; i < 4; ++i)
      wider.emplace_back(p.x() + (i % 2 ? width : -width) / 2, p.y() + (i / 2 ? width : -width) / 2);
  CGAL::convex_hull_2(wider.begin(), wider.end(), std::back_inserter(hull));
  return exact_loop(hull);
}

/// Twice the area over the perimeter: the width of a long strip, half the width of a square.
inline double strip_width(const Outline& loop)
{
  double perimeter = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    perimeter += std::sqrt(CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
  return perimeter > 0 ? std::abs(twice_signed_area(loop)) / perimeter : 0;
}

/// What has to be taken off a polygon so that it has neither webs nor pinholes narrower than `width` (mm). Both are
/// looked for in doubles, vertex by side: O(n^2).
inline std::vector<Exact_loop> cuts_of_webs(const Flat_polygon& polygon, double width)
{
  std::vector<Exact_loop> cuts;
  for (const Web& web : Web_finder(polygon, width).webs()) cuts.push_back(cut_through(web, width));
  for (const Outline& hole : polygon.holes)
    if (strip_width(hole) < width / 2) cuts.push_back(widened_pinhole(hole, width));
  return cuts;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_THIN_WEBS_H
