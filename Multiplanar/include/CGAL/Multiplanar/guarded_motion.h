// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_GUARDED_MOTION_H
#define CGAL_MULTIPLANAR_GUARDED_MOTION_H

#include <CGAL/Cartesian_converter.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/Guarded_motion.h>
#include <CGAL/Multiplanar/internal/embedding.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Multiplanar {

/// Moves the vertices of a closed triangle mesh towards given positions as far as the mesh stays embedded.
///
/// Vertices move one at a time along straight segments. A move is made only if the surface touches itself at no instant
/// of it, which is decided by exact predicates; so nothing passes through anything, no triangle ever degenerates, and
/// the result is isotopic to the input. A vertex whose way is blocked tries 1/2, 1/4, ... of it, and tries again after
/// what blocked it has moved. Each vertex ends bitwise on its target, or part of the way there, or bitwise where it
/// was. The connectivity does not change. The result depends on nothing but the arguments.
///
/// There is no search for ways around obstacles. Displacements of many edge lengths are handled in one call too, but
/// cost time, since the region that a triangle may sweep then holds many others; intermediate targets help.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
/// \tparam TargetPointMap a model of `ReadablePropertyMap` with the mesh's vertex descriptor as key type and its point
///         type as value type.
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters".
///
/// \param mesh the mesh to move: closed, oriented, embedded, with a kernel whose number type is `double`.
/// \param target_point_map where each vertex should go, in the units of the mesh. A target that is not finite leaves
///        its vertex where it is.
/// \param np optional named parameters among
///   - `vertex_point_map`: the positions, a model of `ReadWritePropertyMap`; default `get(CGAL::vertex_point, mesh)`
///   - `geom_traits`: the kernel of the points; default deduced from the point type
///   - `number_of_iterations`: how often blocked vertices are tried, at least 1; default 4.
///
/// \returns how many vertices moved, went a part of their ways, and stayed; and what that took.
/// \throws std::invalid_argument if `mesh` is not a closed oriented 2-manifold of triangles, or intersects itself, or
///         has a face of zero area, or if `number_of_iterations` is less than 1. The mesh is then unchanged.
/// \throws std::logic_error if the mesh moved is not embedded, which is checked whole before anything is written and
///         would be an error of this package. The mesh is then unchanged.
///
/// Expected time O(F log F) for displacements of the order of an edge length; 0.05 s for 10,000 faces, most of it for
/// the checks of the whole mesh before and after.
/// \see Multiplanar::internal::Guarded_motion, which keeps its buffers from pass to pass.
template <class TriangleMesh, class TargetPointMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Guard_statistics guarded_move(TriangleMesh& mesh, TargetPointMap target_point_map,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Geom_traits = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  static_assert(std::is_same<typename Geom_traits::FT, double>::value,
                "guarded motion works on doubles: no other positions could be written back as they were tested");
  auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    CGAL::get_property_map(CGAL::vertex_point, mesh));
  const int rounds = int(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 4));
  if (rounds < 1) throw std::invalid_argument("number_of_iterations must be at least 1");

  const internal::Connectivity connectivity = internal::make_connectivity(mesh);
  const CGAL::Cartesian_converter<Geom_traits, Kernel> to_kernel;
  Points points, targets;
  for (auto v : vertices(mesh)) {
    points.push_back(to_kernel(get(point_map, v)));
    targets.push_back(to_kernel(get(target_point_map, v)));
  }
  if (const auto fault = internal::find_embedding_fault(connectivity, points)) {
    const std::string f = std::to_string(fault->first), g = std::to_string(fault->second);
    throw std::invalid_argument(fault->first == fault->second ? "face " + f + " has zero area or is not finite"
                                                              : "faces " + f + " and " + g + " intersect");
  }

  const Points before = points;
  const Guard_statistics statistics = internal::Guarded_motion(connectivity, 3, rounds).move(points, targets);
  if (!internal::is_embedded(connectivity, points))
    throw std::logic_error("guarded motion would have broken the mesh: an error of this package");
  const CGAL::Cartesian_converter<Kernel, Geom_traits> from_kernel;
  int i = 0;
  for (auto v : vertices(mesh)) {
    if (points[i] != before[i]) put(point_map, v, from_kernel(points[i]));
    ++i;
  }
  return statistics;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_GUARDED_MOTION_H
