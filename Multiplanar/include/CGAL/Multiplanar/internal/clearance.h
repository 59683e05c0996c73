// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CLEARANCE_H
#define CGAL_MULTIPLANAR_INTERNAL_CLEARANCE_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Sufficient conditions, in floating point with an error bound, for two triangles to meet in their shared simplex only
// while their vertices move. "Yes" is a proof, "no" says nothing and leaves the decision to the exact predicates.
//
// Rounding. u = 2^-53, M = the largest absolute coordinate, |m|_1 = the sum of the absolute components of m. For any
// double vector m, however it was found, the computed product m.x differs from the true one by at most 3.01 u |m|_1 M
// (three products, two sums; underflow adds less than 3 DBL_MIN). So a computed gap between two projections that
// exceeds |m|_1 * slack + 4 DBL_MIN with slack >= 8 u M is a true gap.

/// The slack that covers rounding, and vertices that may be up to `drift` (per coordinate) off the hulls given.
/// Infinite, so that nothing is ever certified, where products of coordinates could overflow.
inline double projection_slack(double largest_coordinate, double drift = 0)
{
  if (!(largest_coordinate < 1e100)) return std::numeric_limits<double>::infinity();
  return 16 * DBL_EPSILON * largest_coordinate + 4 * drift;
}

inline double norm_1(const Vector_3& m) { return std::abs(m.x()) + std::abs(m.y()) + std::abs(m.z()); }
inline double projection(const Vector_3& m, const Point_3& p) { return m.x() * p.x() + m.y() * p.y() + m.z() * p.z(); }
inline double smallest_gap(const Vector_3& m, double slack) { return norm_1(m) * slack + 4 * DBL_MIN; }

/// True only if a plane strictly separates the hull of the `n` points `a` from that of the `k` points `b`.
///
/// Follows Chung and Wang's separating vector iteration: where m fails to separate the extreme points x of `a` and y of
/// `b`, m is mirrored in the bisector of the directions that would. O(n + k) a step, a few steps.
inline bool are_separated(const Point_3* a, int n, const Point_3* b, int k, double slack)
{
  constexpr int steps = 6;
  Vector_3 m(0, 0, 0);
  for (int j = 0; j < k; ++j) m = m + (b[j] - CGAL::ORIGIN) / k;
  for (int i = 0; i < n; ++i) m = m - (a[i] - CGAL::ORIGIN) / n;
  for (int step = 0; step < steps; ++step) {
    int x = 0, y = 0;
    double highest = projection(m, a[0]), lowest = projection(m, b[0]);
    for (int i = 1; i < n; ++i) {
      const double h = projection(m, a[i]);
      if (h > highest) highest = h, x = i;
    }
    for (int j = 1; j < k; ++j) {
      const double h = projection(m, b[j]);
      if (h < lowest) lowest = h, y = j;
    }
    if (lowest - highest > smallest_gap(m, slack)) return true;
    const Vector_3 r = b[y] - a[x];
    const double length = r.squared_length();
    if (!(length > 0)) return false;
    m = m - (2 * (lowest - highest) / length) * r;
  }
  return false;
}

/// A vertex on its way: anywhere on the segment between two positions.
struct Moving_point
{
  const Point_3 &from, &to;
};

inline double lowest_projection(const Vector_3& m, const Moving_point& p)
{
  return (std::min)(projection(m, p.from), projection(m, p.to));
}
inline double highest_projection(const Vector_3& m, const Moving_point& p)
{
  return (std::max)(projection(m, p.from), projection(m, p.to));
}

/// Does the plane through the shared vertex `apex` with normal `m` strictly separate b, c from v, w?
inline bool separates_at_vertex(const Vector_3& m, const Moving_point& apex, const Moving_point& b,
                                const Moving_point& c, const Moving_point& v, const Moving_point& w, double slack)
{
  const double gap = smallest_gap(m, slack);
  const double above = (std::min)(lowest_projection(m, b), lowest_projection(m, c));
  if (!(above - highest_projection(m, apex) > gap)) return false;
  const double below = (std::max)(highest_projection(m, v), highest_projection(m, w));
  return lowest_projection(m, apex) - below > gap;
}

inline Vector_3 direction(const Point_3& from, const Point_3& to)
{
  const Vector_3 d = to - from;
  return d / std::sqrt(d.squared_length());
}

/// True only if the triangles (apex, b, c) and (apex, v, w) meet in `apex` alone, wherever the five vertices are on
/// their ways. Tries the plane that bisects the two nearest edges, then the one between the triangles' middles.
inline bool are_separated_at_vertex(const Moving_point& apex, const Moving_point& b, const Moving_point& c,
                                    const Moving_point& v, const Moving_point& w, double slack)
{
  const Vector_3 left[2] = {direction(apex.from, b.from), direction(apex.from, c.from)};
  const Vector_3 right[2] = {direction(apex.from, v.from), direction(apex.from, w.from)};
  int x = 0, y = 0;
  double nearest = left[0] * right[0];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      if (left[i] * right[j] > nearest) nearest = left[i] * right[j], x = i, y = j;
  return separates_at_vertex(left[x] - right[y], apex, b, c, v, w, slack) ||
         separates_at_vertex(left[0] + left[1] - right[0] - right[1], apex, b, c, v, w, slack);
}

/// All normals that a triangle can have while its vertices move: those of length `length` around `unit` with an error
/// of at most `tilt * length`.
struct Normal_cone
{
  Vector_3 unit = Vector_3(0, 0, 0);
  double tilt = std::numeric_limits<double>::infinity();
};

/// The normal cone of the triangle (a, b, c) whose vertices move by at most da, db, dc (drift included).
///
/// (e + x) x (f + y) - e x f has length at most |x||f| + |e||y| + |x||y| for the edges e = b - a, f = c - a and their
/// changes |x| <= da + db, |y| <= da + dc; computing e x f from doubles adds at most 16 u |e||f|.
inline Normal_cone make_normal_cone(const Point_3& a, const Point_3& b, const Point_3& c, double da, double db,
                                    double dc)
{
  const Vector_3 e = b - a, f = c - a;
  const Vector_3 normal = CGAL::cross_product(e, f);
  const double length = std::sqrt(normal.squared_length());
  if (!(length > DBL_MIN / DBL_EPSILON)) return {};
  const double le = std::sqrt(e.squared_length()), lf = std::sqrt(f.squared_length());
  const double x = da + db, y = da + dc;
  const double error = (x * lf + le * y + x * y) * (1 + 1e-12) + 16 * DBL_EPSILON * le * lf;
  if (!std::isfinite(length) || !std::isfinite(error)) return {};
  return {normal / length, error / length};
}

/// True only if two triangles that share an edge meet in that edge alone and both keep a positive area.
///
/// Along the direction d = (m + n)/|m + n| between two unit normals m and n, m.d = n.d = sqrt((1 + m.n) / 2). If that
/// exceeds both tilts, then both triangles project along d with positive orientation in all their states: they lie on
/// either side of the projected edge. The constants cover the rounding of m.n and of the unit lengths.
inline bool are_unfolded(const Normal_cone& m, const Normal_cone& n)
{
  const double tilt = (std::max)(m.tilt, n.tilt) + 1e-12;
  return (1 + m.unit * n.unit - 1e-13) / 2 > tilt * tilt * (1 + 1e-12);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CLEARANCE_H
