// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FLAT_POLYGON_H
#define CGAL_MULTIPLANAR_INTERNAL_FLAT_POLYGON_H

#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Polygon_2.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// A polygon with holes whose coordinates are doubles, in mm: outline counter-clockwise, holes clockwise.
struct Flat_polygon
{
  Outline outline;
  std::vector<Outline> holes;

  /// In mm^2, holes taken off.
  double area() const
  {
    double sum = twice_signed_area(outline);
    for (const Outline& hole : holes) sum -= std::abs(twice_signed_area(hole));
    return sum / 2;
  }
};

namespace internal {

/// Calls f(a, b) for every side of the polygon, its inside on the left.
template <class F>
void for_each_side(const Flat_polygon& polygon, const F& f)
{
  const auto walk = [&f](const Outline& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) f(loop[i], loop[(i + 1) % loop.size()]);
  };
  walk(polygon.outline);
  for (const Outline& hole : polygon.holes) walk(hole);
}

inline bool is_simple_loop(const Outline& loop, CGAL::Orientation orientation)
{
  if (loop.size() < 3) return false;
  const CGAL::Polygon_2<Kernel> polygon(loop.begin(), loop.end());
  return polygon.is_simple() && polygon.orientation() == orientation;
}

/// Exactly: is `point` strictly inside?
inline bool contains(const Flat_polygon& polygon, const Point_2& point)
{
  const auto side = [&](const Outline& loop) {
    return CGAL::bounded_side_2(loop.begin(), loop.end(), point, Kernel());
  };
  if (side(polygon.outline) != CGAL::ON_BOUNDED_SIDE) return false;
  for (const Outline& hole : polygon.holes)
    if (side(hole) != CGAL::ON_UNBOUNDED_SIDE) return false;
  return true;
}

inline bool loops_touch(const Outline& first, const Outline& second)
{
  using Segment_2 = Kernel::Segment_2;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Segment_2 s(first[i], first[(i + 1) % first.size()]);
    for (std::size_t j = 0; j < second.size(); ++j)
      if (CGAL::do_intersect(s, Segment_2(second[j], second[(j + 1) % second.size()]))) return true;
  }
  return false;
}

/// Exactly: simple loops, rightly oriented, the holes inside the outline and apart from each other.
inline bool is_valid(const Flat_polygon& polygon)
{
  if (!is_simple_loop(polygon.outline, CGAL::COUNTERCLOCKWISE)) return false;
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    const Outline& hole = polygon.holes[i];
    if (!is_simple_loop(hole, CGAL::CLOCKWISE) || loops_touch(polygon.outline, hole)) return false;
    if (!contains({polygon.outline, {}}, hole[0])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (loops_touch(polygon.holes[j], hole) ||
          contains({{polygon.holes[j].rbegin(), polygon.holes[j].rend()}, {}}, hole[0]))
        return false;
  }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FLAT_POLYGON_H
