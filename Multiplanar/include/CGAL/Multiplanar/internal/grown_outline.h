// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_GROWN_OUTLINE_H
#define CGAL_MULTIPLANAR_INTERNAL_GROWN_OUTLINE_H

#include <CGAL/Multiplanar/kerf_compensation.h>

#include <CGAL/minkowski_sum_2.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A regular octagon around the circle of the given radius.
inline Exact_loop circumscribed_octagon(double radius)
{
  const double pi = 3.14159265358979323846, r = radius / std::cos(pi / 8);
  Exact_loop octagon;
  for (int i = 0; i < 8; ++i)
    octagon.push_back(Exact_point_2(r * std::cos(pi * (2 * i + 1) / 8), r * std::sin(pi * (2 * i + 1) / 8)));
  return octagon;
}

/// A region without its holes that are smaller than `smallest_hole`, as outer loop and holes.
struct Grown_outline
{
  Outline outer;
  std::vector<Outline> holes;
};

/// All points within `distance` of the part and some more, by the exact Minkowski sum with an octagon.
/// \pre outline and holes are simple, 0 < distance
inline Grown_outline grown_outline(const Outline& outline, const std::vector<Outline>& holes, double distance,
                                   double smallest_hole)
{
  Exact_polygon region(oriented_loop(outline, CGAL::COUNTERCLOCKWISE));
  for (const Outline& hole : holes)
    if (std::abs(twice_signed_area(hole)) / 2 >= smallest_hole) region.add_hole(oriented_loop(hole, CGAL::CLOCKWISE));
  const Exact_polygon sum = CGAL::minkowski_sum_2(region, circumscribed_octagon(distance));
  Grown_outline result;
  result.outer = rounded(sum.outer_boundary());
  for (auto hole = sum.holes_begin(); hole != sum.holes_end(); ++hole) {
    Outline loop = rounded(*hole);
    if (std::abs(twice_signed_area(loop)) / 2 >= smallest_hole && is_simple_outline(loop))
      result.holes.push_back(std::move(loop));
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_GROWN_OUTLINE_H
