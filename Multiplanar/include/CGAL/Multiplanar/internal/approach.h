// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_APPROACH_H
#define CGAL_MULTIPLANAR_INTERNAL_APPROACH_H

#include <CGAL/Multiplanar/internal/Convex_body.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

// The way of parts to their place, beyond its last few millimetres: how far it is free along the last motion's own
// direction, and from which side it can be reached in a straight line.

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline bool is_free(const std::vector<const Bodies*>& moving, const std::vector<const Bodies*>& placed)
{
  for (const Bodies* m : moving)
    for (const Bodies* p : placed)
      if (!proved_apart(*m, *p)) return false;
  return true;
}

/// Is the way of `moving` free, from `from` to `from` + `way` off its place?
inline bool is_way_free(const std::vector<const Bodies*>& moving, const std::vector<const Bodies*>& placed,
                        const Vector_3& from, const Vector_3& way)
{
  for (const Bodies* m : moving) {
    const Bodies swept = swept_bodies(shifted_bodies(*m, from), way);
    if (!is_free({&swept}, placed)) return false;
  }
  return true;
}

/// A length that takes anything out of the box of all bodies.
inline double way_outside(const std::vector<const Bodies*>& moving, const std::vector<const Bodies*>& placed)
{
  CGAL::Bbox_3 box;
  for (const auto* list : {&moving, &placed})
    for (const Bodies* b : *list) box += b->box;
  return std::ceil(std::hypot(box.xmax() - box.xmin(), std::hypot(box.ymax() - box.ymin(), box.zmax() - box.zmin())));
}

/// The longest of some lengths from `least` to `most` over which the way along `out` is free. \pre it is over `least`
inline double free_travel(const std::vector<const Bodies*>& moving, const std::vector<const Bodies*>& placed,
                          const Vector_3& out, double least, double most)
{
  if (is_way_free(moving, placed, CGAL::NULL_VECTOR, most * out)) return most;
  double travel = least;
  for (const double length :
       {5., 6., 8., 10., 15., 20., 30., 40., 60., 80., 100., 150., 200., 300., 400., 600., 800.}) {
    if (length <= travel) continue;
    if (length >= most || !is_way_free(moving, placed, CGAL::NULL_VECTOR, length * out)) break;
    travel = length;
  }
  return travel;
}

/// The 26 directions from a cube's middle to its corners, edges and sides, those nearest to `first` first.
inline std::vector<Vector_3> straight_directions(const Vector_3& first)
{
  std::vector<Vector_3> result;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) result.push_back(Vector_3(x, y, z) / std::sqrt(double(x * x + y * y + z * z)));
  std::stable_sort(result.begin(), result.end(),
                   [&](const Vector_3& a, const Vector_3& b) { return a * first > b * first; });
  return result;
}

/// A direction along which `moving` can be brought, in a straight line from outside, to `travel` before its place.
inline std::optional<Vector_3> straight_approach(const std::vector<const Bodies*>& moving,
                                                 const std::vector<const Bodies*>& placed, const Vector_3& out,
                                                 double travel, double outside)
{
  if (travel >= outside) return -out;
  for (const Vector_3& d : straight_directions(out))
    if (is_way_free(moving, placed, travel * out, outside * d)) return -d;
  return std::nullopt;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_APPROACH_H
