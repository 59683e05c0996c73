// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ALTERNATION_H
#define CGAL_MULTIPLANAR_INTERNAL_ALTERNATION_H

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/Slab.h>

#include <CGAL/Multiplanar/Panel_complex.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

// Teeth are truncation with alternating priority. Planes across the line where two panels' planes meet, with normal
// d = n x n', are parallel to both panels' normals: they cut the overlap of the two slabs into cells whose projections
// onto either panel lie between the same planes, so that a tooth of the one fills the gap of the other exactly.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Positions low <= x <= high along an edge from its first corner, in mm.
using Interval = std::array<double, 2>;

/// Along `edge`, in these disjoint ascending intervals, the panel that elsewhere stays gives way, and the other stays.
struct Alternation
{
  int edge = -1;
  std::vector<Interval> intervals;

  bool operator==(const Alternation& other) const { return edge == other.edge && intervals == other.intervals; }
};

/// { (x, y) : a x + b y <= c } in the plane of a panel.
struct Exact_half_plane
{
  Exact_number a, b, c;
  Exact_number operator()(const Exact_point_2& p) const { return a * p.x() + b * p.y() - c; }
  Exact_half_plane opposite() const { return {-a, -b, -c}; }
};

/// The half-plane of panel `on` in front of the plane across the edge at a position along it.
inline Exact_half_plane half_plane_across(const Panel_complex& complex, int edge, double position, const Frame& on,
                                          const Frame& other)
{
  const Triple<Exact_number> n{on.normal[0], on.normal[1], on.normal[2]};
  const Triple<Exact_number> m{other.normal[0], other.normal[1], other.normal[2]};
  Triple<Exact_number> d;
  for (int i = 0; i < 3; ++i) d[i] = n[(i + 1) % 3] * m[(i + 2) % 3] - n[(i + 2) % 3] * m[(i + 1) % 3];
  const Vector_3 along = complex.edge_vector(edge);
  const Vector_3 rounded_d = CGAL::cross_product(on.normal, other.normal);
  if (rounded_d * along < 0)
    for (auto& x : d) x = -x;
  // The position is rounded here, the same way for both panels up to the sign of d: the plane is one and the same.
  const Point_3 start = complex.corners[complex.edges[edge].corners[0]].point;
  const Vector_3 step = along * (position / std::sqrt(along.squared_length()));
  const Point_3 through = start + step;
  const auto dot = [&d](double x, double y, double z) -> Exact_number { return d[0] * x + d[1] * y + d[2] * z; };
  return {dot(on.u[0], on.u[1], on.u[2]), dot(on.v[0], on.v[1], on.v[2]),
          dot(through.x(), through.y(), through.z()) - dot(on.origin.x(), on.origin.y(), on.origin.z())};
}

/// What of a convex polygon lies in a half-plane.
inline Exact_convex clipped(const Exact_convex& polygon, const Exact_half_plane& half_plane)
{
  Exact_convex result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact_point_2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Exact_number at_p = half_plane(p), at_q = half_plane(q);
    if (at_p <= 0) result.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) result.push_back(p + (at_p / (at_p - at_q)) * (q - p));
  }
  if (result.size() < 3) result.clear();
  return result;
}

/// A convex region of the plane of a panel.
using Cell = std::vector<Exact_half_plane>;

/// The cells between the planes at the ends of the intervals: those in the intervals if `inside`, else those before,
/// between and after them.
inline std::vector<Cell> cells_along(const Panel_complex& complex, const Alternation& teeth, const Frame& on,
                                     const Frame& other, bool inside)
{
  const auto until = [&](double position) { return half_plane_across(complex, teeth.edge, position, on, other); };
  std::vector<Cell> cells;
  const auto& intervals = teeth.intervals;
  for (std::size_t i = 0; inside && i < intervals.size(); ++i)
    cells.push_back({until(intervals[i][0]).opposite(), until(intervals[i][1])});
  for (std::size_t i = 0; !inside && i <= intervals.size(); ++i) {
    cells.emplace_back();
    if (i > 0) cells.back().push_back(until(intervals[i - 1][1]).opposite());
    if (i < intervals.size()) cells.back().push_back(until(intervals[i][0]));
  }
  return cells;
}

/// The same for several edges of one pair of panels, which lie on one line: the cells inside any, or outside all.
inline std::vector<Cell> cells_along(const Panel_complex& complex, const std::vector<Alternation>& teeth,
                                     const Frame& on, const Frame& other, bool inside)
{
  std::vector<Cell> result;
  if (!inside) result.emplace_back(); // everything
  for (const Alternation& alternation : teeth) {
    const auto cells = cells_along(complex, alternation, on, other, inside);
    if (inside) {
      result.insert(result.end(), cells.begin(), cells.end());
      continue;
    }
    std::vector<Cell> both;
    for (const Cell& a : result)
      for (const Cell& b : cells) {
        both.push_back(a);
        both.back().insert(both.back().end(), b.begin(), b.end());
      }
    result = std::move(both);
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ALTERNATION_H
