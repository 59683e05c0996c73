// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CUTTING_LIMITS_H
#define CGAL_MULTIPLANAR_INTERNAL_CUTTING_LIMITS_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// A polygon can be simple and still have a spike, a neck or a web beside a hole that is as thin as a hair. A mesh
// hardly fits into it, and nobody can cut it.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What is thinner is a hair, in diagonals of the bounding box.
constexpr double width_of_hair = 2e-4;

inline double distance_from_side(const Vec3& x, const Vec3& a, const Vec3& b)
{
  const Vec3 d = b - a;
  const double q = d.squaredNorm(), t = q > 0 ? (x - a).dot(d) / q : 0;
  return (a + (std::min)((std::max)(t, 0.0), 1.0) * d - x).norm();
}

/// Does a corner lie nearer to a side than a hair is wide? The sides that end at it do not count, nor those at the
/// other end of a short side: that is only a short side. \param loops the corners of each loop of a panel
inline bool has_hair(const std::vector<std::vector<int>>& loops, const Flat_state& s)
{
  const auto is_short = [&](int x, int y) { return (s.corner[x] - s.corner[y]).norm() < 2 * width_of_hair; };
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int x = loop[i], before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
      for (const auto& other : loops)
        for (std::size_t j = 0; j < other.size(); ++j) {
          const int a = other[j], b = other[(j + 1) % other.size()];
          if (a == x || b == x || distance_from_side(s.corner[x], s.corner[a], s.corner[b]) >= width_of_hair) continue;
          const bool beyond_short_side = (a == after && is_short(x, after)) || (b == before && is_short(x, before));
          if (!beyond_short_side) return true;
        }
    }
  return false;
}

inline int count_hairs(const std::vector<std::vector<std::vector<int>>>& loops_of_panels, const Flat_state& s)
{
  int n = 0;
  for (const auto& loops : loops_of_panels) n += has_hair(loops, s);
  return n;
}

/// What can be cut, in diagonals.
struct Cutting_limits
{
  double min_edge = 0, min_width = 0;

  bool is_short(const Flat_state& s, const Complex_topology::Edge& e) const
  {
    return (s.corner[e.corners[0]] - s.corner[e.corners[1]]).norm() < min_edge;
  }

  /// Is the outer polygon of panel `p` narrower than allowed, measured across each of its sides, or has it a hair?
  bool is_narrow(const std::vector<std::vector<int>>& loops, const Flat_state& s, int p) const
  {
    if (has_hair(loops, s)) return true;
    const auto& loop = loops[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 &a = s.corner[loop[i]], &b = s.corner[loop[(i + 1) % loop.size()]];
      const Vec3 across = s.normal[p].cross(b - a).normalized();
      double low = 0, high = 0;
      for (int x : loop) {
        const double d = across.dot(s.corner[x] - a);
        low = (std::min)(low, d), high = (std::max)(high, d);
      }
      if (high - low < min_width) return true;
    }
    return false;
  }

  /// Edges that are too short, and panels that are too narrow.
  int count_offences(const Complex_topology& t, const Flat_state& s) const
  {
    int n = 0;
    for (const auto& e : t.edges) n += is_short(s, e);
    for (int p = 0; p < t.number_of_panels(); ++p) n += is_narrow(t.loops[p], s, p);
    return n;
  }
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CUTTING_LIMITS_H
