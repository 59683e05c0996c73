// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_NESTING_GRID_H
#define CGAL_MULTIPLANAR_INTERNAL_NESTING_GRID_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Nesting computes with whole numbers: lengths in units of 1/1024 mm, at most 2^28 of them (260 m), so that every
// orientation, a difference of two products, is below 2^60 and exact in 64 bits.

constexpr double units_per_mm = 1024;

struct Grid_point
{
  std::int64_t x = 0, y = 0;
};

inline Grid_point operator+(const Grid_point& a, const Grid_point& b) { return {a.x + b.x, a.y + b.y}; }
inline Grid_point operator-(const Grid_point& a, const Grid_point& b) { return {a.x - b.x, a.y - b.y}; }
inline bool operator==(const Grid_point& a, const Grid_point& b) { return a.x == b.x && a.y == b.y; }
/// From below to above, on one line from left to right.
inline bool below(const Grid_point& a, const Grid_point& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

inline std::int64_t cross(const Grid_point& a, const Grid_point& b) { return a.x * b.y - a.y * b.x; }

/// Positive if a, b, c turn left.
inline std::int64_t turn(const Grid_point& a, const Grid_point& b, const Grid_point& c) { return cross(b - a, c - a); }

inline Grid_point to_grid(double x, double y)
{
  return {std::int64_t(std::llround(x * units_per_mm)), std::int64_t(std::llround(y * units_per_mm))};
}

/// A convex polygon with area: counter-clockwise from its lowest vertex, the leftmost of these, no three in a line.
using Convex_grid_polygon = std::vector<Grid_point>;

/// A rectangle, its sides included.
struct Grid_box
{
  std::int64_t min_x = INT64_MAX, min_y = INT64_MAX, max_x = INT64_MIN, max_y = INT64_MIN;

  void add(const Grid_point& p)
  {
    min_x = (std::min)(min_x, p.x), max_x = (std::max)(max_x, p.x);
    min_y = (std::min)(min_y, p.y), max_y = (std::max)(max_y, p.y);
  }
  void add(const std::vector<Grid_point>& points)
  {
    for (const Grid_point& p : points) add(p);
  }
};

/// The convex hull by Andrew's monotone chain; fewer than three vertices if the points are in a line.
inline Convex_grid_polygon convex_hull(std::vector<Grid_point> points)
{
  std::sort(points.begin(), points.end(), below);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::size_t n = points.size();
  if (n < 3) return points;
  Convex_grid_polygon hull(2 * n);
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i) { // the right chain, upward
    while (k >= 2 && turn(hull[k - 2], hull[k - 1], points[i]) <= 0) --k;
    hull[k++] = points[i];
  }
  for (std::size_t i = n - 1, right = k + 1; i-- > 0;) { // the left chain, downward
    while (k >= right && turn(hull[k - 2], hull[k - 1], points[i]) <= 0) --k;
    hull[k++] = points[i];
  }
  hull.resize(k - 1);
  return hull;
}

inline std::int64_t floor_quotient(std::int64_t a, std::int64_t b) // b > 0
{
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

inline std::int64_t ceil_quotient(std::int64_t a, std::int64_t b) // b > 0
{
  return -floor_quotient(-a, b);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_NESTING_GRID_H
