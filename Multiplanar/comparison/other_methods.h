// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_COMPARISON_OTHER_METHODS_H
#define MULTIPLANAR_COMPARISON_OTHER_METHODS_H

#include "Compared_surface.h"

#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_approximation/approximate_triangle_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <iterator>
#include <vector>

// CGAL's two ways to a surface of few pieces, as the paper compares with them in its Table 1.

namespace CGAL {
namespace Multiplanar {
namespace comparison {

using namespace internal;

using Compared_mesh = CGAL::Surface_mesh<Point_3>;

/// The mesh that CGAL's own methods take.
inline Compared_mesh compared_mesh(const Connectivity& c, const Points& points)
{
  Compared_mesh mesh;
  std::vector<Compared_mesh::Vertex_index> vertex;
  for (const Point_3& p : points) vertex.push_back(mesh.add_vertex(p));
  for (const auto& t : c.triangles) mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
  return mesh;
}

/// CGAL's variational shape approximation by k proxies (Cohen-Steiner, Alliez, Desbrun 2004): hierarchical seeding and
/// 50 iterations, else its defaults. Panels are the proxies; the anchors of each boundary cycle of a proxy should lie
/// in one plane. The triangles are those it returns, a mesh or not.
inline Compared_surface surface_of_vsa(const Compared_mesh& mesh, int k)
{
  namespace VSA = CGAL::Surface_mesh_approximation;
  using Point_map = Compared_mesh::Property_map<Compared_mesh::Vertex_index, Point_3>;
  using Approximation = CGAL::Variational_shape_approximation<Compared_mesh, Point_map>;
  const Approximation::Error_metric metric(mesh, mesh.points());
  Approximation approximation(mesh, mesh.points(), metric);
  approximation.initialize_seeds(
      CGAL::parameters::seeding_method(VSA::HIERARCHICAL).max_number_of_proxies(std::size_t(k)));
  approximation.run(50);
  approximation.extract_mesh(CGAL::parameters::default_values());
  Compared_surface result;
  approximation.anchor_points(std::back_inserter(result.points));
  std::vector<std::array<std::size_t, 3>> triangles;
  approximation.indexed_triangles(std::back_inserter(triangles));
  for (const auto& t : triangles) result.triangles.push_back({int(t[0]), int(t[1]), int(t[2])});
  result.panels = int(approximation.number_of_proxies());
  std::vector<std::vector<std::size_t>> cycles;
  approximation.indexed_boundary_polygons(std::back_inserter(cycles));
  for (const auto& cycle : cycles) result.flat_together.emplace_back(cycle.begin(), cycle.end());
  return result;
}

/// Ends edge collapses as soon as a closed triangle mesh has at most so many faces: 3/2 of that in edges.
struct Face_limit
{
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t edges) const
  {
    return 2 * edges <= 3 * faces;
  }
  std::size_t faces;
};

/// CGAL's edge collapses by quadric errors (Garland and Heckbert 1997) down to k triangles, each of which is a panel,
/// as in the paper. Ends earlier where no collapse keeps the mesh a manifold.
inline Compared_surface surface_of_qem(Compared_mesh mesh, int k)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  const SMS::GarlandHeckbert_plane_policies<Compared_mesh, Kernel> policies(mesh);
  SMS::edge_collapse(mesh, Face_limit{std::size_t(k)},
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  mesh.collect_garbage();
  Compared_surface result;
  result.points.assign(mesh.points().begin(), mesh.points().end());
  for (const auto f : mesh.faces()) {
    std::array<int, 3> t{};
    int i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) t[i++] = int(v);
    result.triangles.push_back(t);
    result.flat_together.emplace_back(t.begin(), t.end());
  }
  result.panels = int(result.triangles.size());
  return result;
}

} // namespace comparison
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_COMPARISON_OTHER_METHODS_H
