// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TEXT_FITTER_H
#define CGAL_MULTIPLANAR_INTERNAL_TEXT_FITTER_H

#include <CGAL/Multiplanar/label_placement.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Places texts on a part, one after the other: no text comes nearer than `clearance` to a cut or to another text.
class Text_fitter
{
public:
  Text_fitter(const Part& part, double clearance) : clearance(clearance)
  {
    loops.push_back(part.outline);
    loops.insert(loops.end(), part.holes.begin(), part.holes.end());
  }

  /// Outline, holes, and boxes of the texts that were added.
  const std::vector<Outline>& obstacles() const { return loops; }
  const std::vector<Engraving>& texts() const { return added; }

  void add(const Engraving& e)
  {
    const double c = std::cos(radians(e)), s = std::sin(radians(e)), w = half_width(e), h = e.height / 2;
    const auto corner = [&](double x, double y) { return Point_2(e.at.x() + c * x - s * y, e.at.y() + s * x + c * y); };
    loops.push_back({corner(-w, -h), corner(-w, h), corner(w, h), corner(w, -h)});
    added.push_back(e);
  }

  /// Is the box of the text, with the clearance around it, in the part and off all obstacles?
  bool is_clear(const Engraving& e) const
  {
    const double c = std::cos(radians(e)), s = std::sin(radians(e));
    const double w = half_width(e) + clearance, h = e.height / 2 + clearance;
    const double reach = std::hypot(w, h);
    bool inside = false;
    for (const Outline& loop : loops)
      for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const double ax = loop[j].x() - e.at.x(), ay = loop[j].y() - e.at.y();
        const double bx = loop[i].x() - e.at.x(), by = loop[i].y() - e.at.y();
        if ((ay > 0) != (by > 0) && 0 < ax - ay / (by - ay) * (bx - ax)) inside = !inside;
        if ((std::max)(ax, bx) < -reach || (std::min)(ax, bx) > reach || (std::max)(ay, by) < -reach ||
            (std::min)(ay, by) > reach)
          continue;
        if (meets_box(c * ax + s * ay, c * ay - s * ax, c * bx + s * by, c * by - s * bx, w, h)) return false;
      }
    return inside;
  }

private:
  static double radians(const Engraving& e) { return e.angle * 3.14159265358979323846 / 180; }
  static double half_width(const Engraving& e) { return text_width(e.text) * e.height / 2; }

  /// Does a segment meet the box |x| <= w, |y| <= h? Clips it side by side.
  static bool meets_box(double ax, double ay, double bx, double by, double w, double h)
  {
    double from = 0, to = 1;
    const auto clip = [&](double a, double d, double half) {
      if (d == 0) return std::abs(a) <= half;
      const double t0 = (-half - a) / d, t1 = (half - a) / d;
      from = (std::max)(from, (std::min)(t0, t1));
      to = (std::min)(to, (std::max)(t0, t1));
      return from <= to;
    };
    return clip(ax, bx - ax, w) && clip(ay, by - ay, h);
  }

  double clearance;
  std::vector<Outline> loops;
  std::vector<Engraving> added;
};

/// What is tried for a text: heights in mm from the one wanted to the smallest one that can be read.
inline std::vector<double> text_heights(double largest, double smallest)
{
  std::vector<double> heights;
  for (double h = largest; h > smallest * 1.1; h *= 0.8) heights.push_back(h);
  heights.push_back(smallest);
  return heights;
}

/// Places one of `texts`, preferably the first, along the side from a to b of a part that lies on its left: the foot of
/// the letters toward the side, near its middle, and near the side. \return whether one fits
inline bool place_along_side(Text_fitter& fitter, const std::vector<std::string>& texts, const Point_2& a,
                             const Point_2& b, double largest, double smallest)
{
  const Kernel::Vector_2 side = b - a;
  const double length = std::sqrt(side.squared_length());
  if (length == 0) return false;
  const Kernel::Vector_2 e = side / length, inward(-e.y(), e.x());
  Engraving label;
  label.angle = std::atan2(e.y(), e.x()) * 180 / 3.14159265358979323846;
  for (const std::string& text : texts)
    for (double h : text_heights(largest, smallest)) {
      label.text = text;
      label.height = h;
      const double room = (std::max)(0., length - text_width(text) * h) / 2, step = (std::max)(1., room / 10);
      for (double depth = h / 2 + 0.6; depth < h / 2 + 10; depth += 0.8)
        for (int i = 0; (i + 1) / 2 * step <= room; ++i) {
          label.at = a + (length / 2 + (i % 2 ? 1 : -1) * ((i + 1) / 2) * step) * e + depth * inward;
          if (!fitter.is_clear(label)) continue;
          fitter.add(label);
          return true;
        }
    }
  return false;
}

/// Places a text as near as possible to `target`, within `reach` of it, at one of eight angles from `upright`, as high
/// as possible. \return whether it fits
inline bool place_near(Text_fitter& fitter, const std::string& text, const Point_2& target, double reach,
                       double upright, double largest, double smallest)
{
  const double step = 0.8;
  const int n = int(reach / step);
  for (double h : text_heights(largest, smallest)) {
    Engraving best;
    double nearest = reach * reach;
    for (int k = 0; k < 8; ++k)
      for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j) {
          const double d = step * step * (i * i + j * j);
          if (d >= nearest) continue;
          Engraving label{text, Point_2(target.x() + step * i, target.y() + step * j), upright + 45 * k, h};
          if (fitter.is_clear(label)) best = label, nearest = d;
        }
    if (best.height == 0) continue;
    fitter.add(best);
    return true;
  }
  return false;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TEXT_FITTER_H
