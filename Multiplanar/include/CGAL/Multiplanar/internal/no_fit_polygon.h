// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_NO_FIT_POLYGON_H
#define CGAL_MULTIPLANAR_INTERNAL_NO_FIT_POLYGON_H

#include <CGAL/Multiplanar/internal/nesting_grid.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Notation: A lies still, B is moved by p. NFP(A, B) = { p : the interiors of A and B + p meet } = int A + int(-B), the
// no-fit polygon. If A and B are unions of convex A_i and B_j, it is the union of the interiors of A_i + (-B_j): an
// open set that meets A meets the interior of one A_i. That union is what CGAL::minkowski_sum_2() joins to a polygon
// with holes when it is given a decomposition. Here its convex members are kept as they are: a point is in the union if
// it is in one of them, and a member costs well under a microsecond, where the joined polygon costs a thousand times
// more.

/// The polygon turned by 180 degrees about the origin.
inline Convex_grid_polygon negated(const Convex_grid_polygon& polygon)
{
  std::size_t highest = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i)
    if (below(polygon[highest], polygon[i])) highest = i;
  Convex_grid_polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Grid_point& p = polygon[(highest + i) % polygon.size()];
    result.push_back({-p.x, -p.y});
  }
  return result;
}

/// The Minkowski sum of two convex polygons, moved by `shift`: their sides merged by direction. Linear time.
inline void convex_sum(const Convex_grid_polygon& a, const Convex_grid_polygon& b, const Grid_point& shift,
                       Convex_grid_polygon& sum)
{
  CGAL_precondition(a.size() >= 3 && b.size() >= 3);
  sum.clear();
  const std::size_t n = a.size(), m = b.size();
  Grid_point at = a[0] + b[0] + shift;
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    sum.push_back(at);
    const Grid_point u = i < n ? a[i + 1 < n ? i + 1 : 0] - a[i] : Grid_point(),
                     v = j < m ? b[j + 1 < m ? j + 1 : 0] - b[j] : Grid_point();
    // Both lists of sides are sorted by their angle in [0, 360): the half with y > 0, or y = 0 and x > 0, comes first.
    const auto first_half = [](const Grid_point& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
    bool take_u = j == m, take_v = i == n;
    if (!take_u && !take_v) {
      const bool hu = first_half(u), hv = first_half(v);
      const std::int64_t c = hu != hv ? (hu ? 1 : -1) : cross(u, v);
      take_u = c >= 0, take_v = c <= 0;
    }
    if (take_u) at = at + u, ++i;
    if (take_v) at = at + v, ++j;
  }
}

/// Is `p` in the interior of a convex polygon?
inline bool is_inside(const Convex_grid_polygon& polygon, const Grid_point& p)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (turn(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0], p) <= 0) return false;
  return true;
}

/// A convex polygon and the box around it.
struct Convex_piece
{
  explicit Convex_piece(Convex_grid_polygon points) : polygon(std::move(points)) { box.add(polygon); }
  Convex_grid_polygon polygon;
  Grid_box box;
};

/// The members of NFP(A, B) for A lying at `shift`, given the convex pieces of A and those of -B.
inline std::vector<Convex_grid_polygon>
no_fit_polygon(const std::vector<Convex_piece>& a, const std::vector<Convex_piece>& negated_b, const Grid_point& shift)
{
  std::vector<Convex_grid_polygon> members;
  for (const Convex_piece& p : a)
    for (const Convex_piece& q : negated_b) {
      members.emplace_back();
      convex_sum(p.polygon, q.polygon, shift, members.back());
    }
  return members;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_NO_FIT_POLYGON_H
