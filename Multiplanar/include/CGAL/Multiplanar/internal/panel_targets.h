// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_TARGETS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_TARGETS_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/injective_map.h>

#include <Eigen/Geometry>

#include <map>
#include <vector>

// Where the vertices of the mesh go once the polygons are known: corners onto corners, the vertices of a chain along the
// straight edge between its corners, the others into the polygon of their panel by an injective map.

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline Eigen::Vector3d to_eigen(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
inline Eigen::Vector3d to_eigen(const Vector_3& p) { return {p.x(), p.y(), p.z()}; }
inline Point_3 to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

/// An orthonormal frame of a panel's plane: u x v = normal.
struct Plane_frame
{
  Eigen::Vector3d origin, u, v;

  explicit Plane_frame(const Plane& plane)
  {
    const Eigen::Vector3d n = to_eigen(plane.normal).normalized();
    u = n.unitOrthogonal();
    v = n.cross(u);
    origin = n * (plane.offset / to_eigen(plane.normal).norm());
  }
  Point_2d flat(const Eigen::Vector3d& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  Eigen::Vector3d lifted(const Point_2d& p) const { return origin + p.x() * u + p.y() * v; }
};

/// Spreads the inner vertices of a chain over the segment between its corners, in proportion to the chain's lengths on
/// `shape`.
inline void place_chain(const std::vector<int>& chain, const Points& shape, const Point_3& from, const Point_3& to,
                        Points& targets)
{
  std::vector<double> length(chain.size(), 0);
  for (std::size_t i = 1; i < chain.size(); ++i)
    length[i] = length[i - 1] + std::sqrt(CGAL::squared_distance(shape[chain[i - 1]], shape[chain[i]]));
  const double total = length.back();
  targets[chain.front()] = from;
  targets[chain.back()] = to;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const double t = total > 0 ? length[i] / total : double(i) / double(chain.size() - 1);
    targets[chain[i]] = from + t * (to - from);
  }
}

/// The doubled area that a face of panel `p` must exceed in its polygon to count as positive: what rounding cannot undo.
inline double least_doubled_area(const Panel_complex& complex, int p)
{
  return 1e-7 * complex.area(p) / double(complex.panels[p].faces.size());
}

/// Maps the faces of one panel into its polygon. Positions of boundary vertices are read from `targets`, those of inner
/// vertices written there.
/// \return whether every triangle came out positive
inline bool place_panel(const Connectivity& c, const Points& shape, const std::vector<int>& labels,
                        const Panel_complex& complex, int p, std::vector<int>& local, Points& targets)
{
  const auto& panel = complex.panels[p];
  const Plane_frame frame(panel.plane);
  std::vector<int> global;
  Triangles triangles;
  std::vector<char> fixed;
  for (int f : panel.faces) {
    std::array<int, 3> t{};
    for (int i = 0; i < 3; ++i) {
      const int v = c.triangles[f][i];
      if (local[v] < 0) {
        local[v] = int(global.size());
        global.push_back(v);
        bool boundary = false;
        for (int g : c.star(v)) boundary |= labels[g] != p;
        fixed.push_back(boundary);
      }
      t[i] = local[v];
    }
    triangles.push_back(t);
  }
  std::vector<Eigen::Vector3d> form(global.size());
  std::vector<Point_2d> flat(global.size());
  for (std::size_t i = 0; i < global.size(); ++i) {
    form[i] = to_eigen(shape[global[i]]);
    flat[i] = frame.flat(to_eigen(fixed[i] ? targets[global[i]] : shape[global[i]]));
    local[global[i]] = -1;
  }
  const bool ok = injective_map(triangles, form, fixed, complex.area(p), least_doubled_area(complex, p), flat);
  for (std::size_t i = 0; i < global.size(); ++i)
    if (!fixed[i]) targets[global[i]] = to_point(frame.lifted(flat[i]));
  return ok;
}

/// Targets of all vertices for flat polygons.
/// \param shape positions that lengths and triangle shapes are taken from
/// \param complex made from `labels`; its corners lie on the planes of their panels
/// \param failed receives the panels whose triangles could not all be made positive
/// \return a position for every vertex
inline Points panel_targets(const Connectivity& c, const Points& shape, const std::vector<int>& labels,
                            const Panel_complex& complex, std::vector<int>& failed)
{
  Points targets = shape;
  for (const auto& e : complex.edges) {
    CGAL_precondition(!e.is_closed());
    place_chain(e.chain, shape, complex.corners[e.corners[0]].point, complex.corners[e.corners[1]].point, targets);
  }
  std::vector<int> local(c.number_of_vertices(), -1);
  failed.clear();
  for (int p = 0; p < complex.number_of_panels(); ++p)
    if (!place_panel(c, shape, labels, complex, p, local, targets)) failed.push_back(p);
  return targets;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_TARGETS_H
