// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ADAPT_MESH_H
#define CGAL_MULTIPLANAR_INTERNAL_ADAPT_MESH_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/named_parameters.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>

// Between a user's mesh with its property maps and named parameters and the flat arrays that the rooms compute on.

namespace CGAL {
namespace Multiplanar {
namespace internal {

template <class TriangleMesh, class VertexPointMap>
Points read_points(const TriangleMesh& mesh, VertexPointMap vpm)
{
  Points points;
  points.reserve(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    const auto& p = get(vpm, v);
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  return points;
}

/// Writes back what moved; a vertex that did not keeps its point.
template <class TriangleMesh, class VertexPointMap>
void write_points(const TriangleMesh& mesh, VertexPointMap vpm, const Points& points)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  std::size_t i = 0;
  for (auto v : vertices(mesh)) {
    const Point_3& p = points[i++];
    put(vpm, v, Point(p.x(), p.y(), p.z()));
  }
}

template <class TriangleMesh>
std::vector<double> read_saliency(const TriangleMesh&, const CGAL::internal_np::Param_not_found&)
{
  return {};
}

template <class TriangleMesh, class FaceSaliencyMap>
std::vector<double> read_saliency(const TriangleMesh& mesh, const FaceSaliencyMap& map)
{
  std::vector<double> saliency;
  saliency.reserve(num_faces(mesh));
  for (auto f : faces(mesh)) saliency.push_back(get(map, f));
  return saliency;
}

template <class TriangleMesh, class NamedParameters>
Approximation_options approximation_options(const TriangleMesh& mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace ours = Multiplanar::internal_np;
  Approximation_options o;
  o.panels = choose_parameter(get_parameter(np, ours::number_of_panels), o.panels);
  o.iterations = int(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), o.iterations));
  o.seed = choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), o.seed);
  o.restarts = choose_parameter(get_parameter(np, ours::number_of_restarts), o.restarts);
  o.threads = choose_parameter(get_parameter(np, ours::number_of_threads), o.threads);
  o.effort = choose_parameter(get_parameter(np, ours::effort), o.effort);
  o.solver = choose_parameter(get_parameter(np, ours::deformation_solver), o.solver);
  o.smoothness = choose_parameter(get_parameter(np, ours::smoothness_weight), o.smoothness);
  o.saliency = read_saliency(mesh, get_parameter(np, ours::face_saliency_map));
  o.saliency_weight = choose_parameter(get_parameter(np, ours::saliency_weight), o.saliency_weight);
  o.min_edge = choose_parameter(get_parameter(np, ours::minimum_edge_length), o.min_edge);
  o.min_width = choose_parameter(get_parameter(np, ours::minimum_panel_width), o.min_width);
  o.sheet_thickness = choose_parameter(get_parameter(np, ours::sheet_thickness), o.sheet_thickness);
  return o;
}

inline Approximation_visitor& visitor_of(const CGAL::internal_np::Param_not_found&, Approximation_visitor& silent)
{
  return silent;
}

template <class Visitor>
Approximation_visitor& visitor_of(std::reference_wrapper<Visitor> given, Approximation_visitor&)
{
  static_assert(std::is_base_of<Approximation_visitor, Visitor>::value,
                "a visitor is derived from Multiplanar::Approximation_visitor and passed by std::ref");
  return given.get();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ADAPT_MESH_H
