// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SIMPLE_POLYGONS_H
#define CGAL_MULTIPLANAR_INTERNAL_SIMPLE_POLYGONS_H

#include <CGAL/Multiplanar/internal/Triangle_tree.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Exact decisions about a panel seen along a coordinate axis. Dropping the coordinate along which the normal is largest
// loses no digits, so that orientations of the projected corners are decided exactly on the coordinates as they are. A
// polygon whose projection is simple is itself embedded, whether or not its corners are coplanar to the last bit.

using Point_2 = Kernel::Point_2;

/// The projection along the largest coordinate of a normal; keeps counter-clockwise counter-clockwise.
struct Axis_projection
{
  int u = 0, v = 1;

  explicit Axis_projection(const Vec3& normal)
  {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
  }
  Point_2 operator()(const Vec3& p) const { return {p[u], p[v]}; }
};

using Polygon_loop = std::vector<Point_2>;

/// Is q on the closed segment ab, given that the three are collinear?
inline bool between(const Point_2& a, const Point_2& b, const Point_2& q)
{
  return a == q || b == q || CGAL::collinear_are_ordered_along_line(a, q, b);
}

/// Do the closed segments ab and cd meet? Exact.
inline bool segments_cross(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d)
{
  const auto abc = CGAL::orientation(a, b, c), abd = CGAL::orientation(a, b, d);
  if (abc == abd && abc != CGAL::COLLINEAR) return false;
  const auto cda = CGAL::orientation(c, d, a), cdb = CGAL::orientation(c, d, b);
  if (cda == cdb && cda != CGAL::COLLINEAR) return false;
  if (abc != abd && cda != cdb) return true;
  return between(a, b, c) || between(a, b, d) || between(c, d, a) || between(c, d, b);
}

/// Is the loop a simple polygon: no two sides meet but neighbours in their common end? Exact, quadratic.
inline bool is_simple_polygon_loop(const Polygon_loop& l)
{
  const int n = int(l.size());
  if (n < 3) return false;
  for (int i = 0; i < n; ++i) {
    const Point_2 &a = l[i], &b = l[(i + 1) % n], &c = l[(i + 2) % n];
    if (a == b) return false;
    if (CGAL::orientation(a, b, c) == CGAL::COLLINEAR && !CGAL::collinear_are_ordered_along_line(a, b, c)) return false;
    for (int j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
      if (segments_cross(a, b, l[j], l[(j + 1) % n])) return false;
  }
  return true;
}

/// Twice the sign of the area: is the simple polygon counter-clockwise? Exact: decided at its lowest corner.
inline bool is_counter_clockwise(const Polygon_loop& l)
{
  const int n = int(l.size());
  int low = 0;
  for (int i = 1; i < n; ++i)
    if (l[i] < l[low]) low = i;
  // At an extreme corner of a simple polygon the turn is the orientation; a straight one cannot be lexicographically
  // least.
  return CGAL::orientation(l[(low + n - 1) % n], l[low], l[(low + 1) % n]) == CGAL::LEFT_TURN;
}

/// Is q strictly inside the simple polygon? False on its boundary. Exact, by the crossing number.
inline bool is_inside(const Polygon_loop& l, const Point_2& q)
{
  const int n = int(l.size());
  bool inside = false;
  for (int i = 0; i < n; ++i) {
    const Point_2 &a = l[i], &b = l[(i + 1) % n];
    const auto turn = CGAL::orientation(a, b, q);
    if (turn == CGAL::COLLINEAR && between(a, b, q)) return false;
    if ((a.y() <= q.y()) != (b.y() <= q.y())) inside ^= (turn == CGAL::LEFT_TURN) == (b.y() > a.y());
  }
  return inside;
}

/// Do sides of two loops meet? Exact.
inline bool loops_meet(const Polygon_loop& l, const Polygon_loop& m)
{
  for (std::size_t i = 0; i < l.size(); ++i)
    for (std::size_t j = 0; j < m.size(); ++j)
      if (segments_cross(l[i], l[(i + 1) % l.size()], m[j], m[(j + 1) % m.size()])) return true;
  return false;
}

/// Is this a polygon with holes: loops simple and disjoint, the first counter-clockwise, the others clockwise, inside
/// the first and outside each other? Exact.
inline bool is_polygon_with_holes(const std::vector<Polygon_loop>& loops)
{
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!is_simple_polygon_loop(loops[i]) || is_counter_clockwise(loops[i]) != (i == 0)) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (loops_meet(loops[i], loops[j])) return false;
      if (is_inside(loops[j], loops[i][0]) != (j == 0)) return false;
      if (j > 0 && is_inside(loops[i], loops[j][0])) return false;
    }
  }
  return !loops.empty();
}

/// Cuts the simple counter-clockwise polygon into triangles of positive area, as positions in the loop: ears with the
/// largest smallest angle first. Exact decisions, cubic at worst; panels have few corners.
inline bool cut_ears(const Polygon_loop& l, std::vector<std::array<int, 3>>& triangles)
{
  std::vector<int> left(l.size());
  for (std::size_t i = 0; i < l.size(); ++i) left[i] = int(i);
  const auto is_ear = [&](int i) {
    const int n = int(left.size()), ia = left[(i + n - 1) % n], ib = left[i], ic = left[(i + 1) % n];
    const Point_2 &a = l[ia], &b = l[ib], &c = l[ic];
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return false;
    for (int j : left) {
      if (j == ia || j == ib || j == ic) continue;
      if (CGAL::orientation(a, b, l[j]) != CGAL::RIGHT_TURN && CGAL::orientation(b, c, l[j]) != CGAL::RIGHT_TURN &&
          CGAL::orientation(c, a, l[j]) != CGAL::RIGHT_TURN)
        return false;
    }
    return true;
  };
  const auto quality = [&](int i) { // area over the squared longest side
    const int n = int(left.size());
    const Point_2 &a = l[left[(i + n - 1) % n]], &b = l[left[i]], &c = l[left[(i + 1) % n]];
    const double longest =
        (std::max)({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
    return std::abs(CGAL::area(a, b, c)) / longest;
  };
  while (left.size() > 3) {
    int best = -1;
    double largest = -1;
    for (int i = 0; i < int(left.size()); ++i)
      if (is_ear(i)) {
        // Cutting an ear must not leave three collinear corners as the last triangle.
        if (left.size() == 4 &&
            CGAL::orientation(l[left[(i + 1) % 4]], l[left[(i + 2) % 4]], l[left[(i + 3) % 4]]) != CGAL::LEFT_TURN)
          continue;
        const double q = quality(i);
        if (q > largest) largest = q, best = i;
      }
    if (best < 0) return false;
    const int n = int(left.size());
    triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + best);
  }
  if (CGAL::orientation(l[left[0]], l[left[1]], l[left[2]]) != CGAL::LEFT_TURN) return false;
  triangles.push_back({left[0], left[1], left[2]});
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SIMPLE_POLYGONS_H
