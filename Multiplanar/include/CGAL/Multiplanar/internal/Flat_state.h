// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FLAT_STATE_H
#define CGAL_MULTIPLANAR_INTERNAL_FLAT_STATE_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/Triangle_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What the numerical work needs to know of a panel complex: who meets whom. Immutable.
struct Complex_topology
{
  struct Edge
  {
    std::array<int, 2> corners, panels;
  };

  std::vector<std::vector<int>> corner_panels;      ///< around each corner, counter-clockwise
  std::vector<std::vector<std::vector<int>>> loops; ///< of each panel: corners in order, the outer loop first
  std::vector<Edge> edges;

  int number_of_corners() const { return int(corner_panels.size()); }
  int number_of_panels() const { return int(loops.size()); }
};

/// \pre no edge of `complex` is closed
inline Complex_topology complex_topology(const Panel_complex& complex)
{
  Complex_topology t;
  for (const auto& c : complex.corners) t.corner_panels.push_back(c.panels);
  for (const auto& panel : complex.panels) {
    t.loops.emplace_back();
    for (const auto& loop : panel.loops) t.loops.back().push_back(complex.loop_corners(loop));
  }
  for (const auto& e : complex.edges) t.edges.push_back({e.corners, e.panels});
  return t;
}

/// Where planes and corners are: panel p lies in { x : normal[p] . x = offset[p] }.
struct Flat_state
{
  std::vector<Vec3> normal;
  std::vector<double> offset;
  std::vector<Vec3> corner;
};

inline Flat_state flat_state(const Panel_complex& complex)
{
  Flat_state s;
  for (const auto& panel : complex.panels) {
    const Vector_3& n = panel.plane.normal;
    s.normal.push_back(Vec3(n.x(), n.y(), n.z()));
    s.offset.push_back(panel.plane.offset);
  }
  for (const auto& c : complex.corners) s.corner.push_back(as_vec(c.point));
  return s;
}

/// The largest distance of a corner from a plane that it should lie in.
inline double flatness(const Complex_topology& t, const Flat_state& s)
{
  double worst = 0;
  for (int c = 0; c < t.number_of_corners(); ++c)
    for (int p : t.corner_panels[c]) worst = (std::max)(worst, std::abs(s.normal[p].dot(s.corner[c]) - s.offset[p]));
  return worst;
}

/// Two unit vectors orthogonal to the unit vector `n` and to each other.
inline std::array<Vec3, 2> tangents(const Vec3& n)
{
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  const Vec3 t = n.cross(Vec3::Unit(axis)).normalized();
  return {t, n.cross(t)};
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FLAT_STATE_H
