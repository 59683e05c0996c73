// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_APPROXIMATION_H
#define CGAL_MULTIPLANAR_APPROXIMATION_H

#include <CGAL/Multiplanar/approximate.h>
#include <CGAL/Multiplanar/named_parameters.h>
#include <CGAL/Multiplanar/internal/adapt_mesh.h>

#include <functional>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgMultiplanarRef

\brief deforms a closed triangle mesh so that it consists of at most k flat panels.

Connectivity stays as it is: only the points of the vertices change, so texture coordinates and every other property
remain valid. The result is embedded (checked with exact predicates), each panel is one connected, flat polygon, possibly
with holes, and all of them together are again a closed surface of the same genus.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FacePanelMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key
        and `std::size_t` (or a type convertible from `int`) as value

\param mesh the closed, oriented, embedded triangle mesh
\param panel_map receives the panel, 0 .. panels - 1, of every face
\pre the mesh does not intersect itself, and no face has zero area (checked in builds with expensive checks)

\param np optional \ref bgl_namedparameters "Named Parameters"

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_panels} \cgalParamDescription{k, the number of panels at most}
    \cgalParamType{`int`} \cgalParamDefault{50} \cgalParamExtra{at least 4 + 3 genus} \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations} \cgalParamDescription{passes of segmentation and deformation}
    \cgalParamType{`int`} \cgalParamDefault{50} \cgalParamNEnd
  \cgalParamNBegin{random_seed} \cgalParamDescription{seed of the first planes; equal seeds give equal results, for any
    number of threads} \cgalParamType{`std::uint64_t`} \cgalParamDefault{0} \cgalParamNEnd
  \cgalParamNBegin{number_of_restarts} \cgalParamDescription{seeds tried, the best result is kept}
    \cgalParamType{`int`} \cgalParamDefault{1} \cgalParamNEnd
  \cgalParamNBegin{number_of_threads} \cgalParamDescription{threads at most, 0: all of the machine}
    \cgalParamType{`int`} \cgalParamDefault{0} \cgalParamNEnd
  \cgalParamNBegin{effort} \cgalParamDescription{how long to look for a closer fit}
    \cgalParamType{`Multiplanar::Effort`} \cgalParamDefault{`Multiplanar::Effort::normal`} \cgalParamNEnd
  \cgalParamNBegin{deformation_solver} \cgalParamDescription{which linear solver}
    \cgalParamType{`Multiplanar::Solver`} \cgalParamDefault{`Multiplanar::Solver::automatic`} \cgalParamNEnd
  \cgalParamNBegin{smoothness_weight} \cgalParamDescription{weight of the smoothness objective (eq. 9)}
    \cgalParamType{`double`} \cgalParamDefault{0} \cgalParamNEnd
  \cgalParamNBegin{face_saliency_map} \cgalParamDescription{saliency in 0..1 of each face: high values get more panels}
    \cgalParamType{a model of `ReadablePropertyMap` from faces to `double`} \cgalParamDefault{none} \cgalParamNEnd
  \cgalParamNBegin{saliency_weight} \cgalParamDescription{W of w_t = W (1 - s) in eq. 4}
    \cgalParamType{`double`} \cgalParamDefault{1} \cgalParamNEnd
  \cgalParamNBegin{minimum_edge_length} \cgalParamDescription{edges of panels shorter than this are removed, as far as
    the panels can be flat without}
    \cgalParamType{`double`, in units of the mesh} \cgalParamDefault{0.002 of the bounding-box diagonal} \cgalParamNEnd
  \cgalParamNBegin{minimum_panel_width} \cgalParamDescription{panels narrower than this are merged with a neighbour, as
    far as the panels can be flat then}
    \cgalParamType{`double`, in units of the mesh} \cgalParamDefault{0.002 of the bounding-box diagonal} \cgalParamNEnd
  \cgalParamNBegin{sheet_thickness} \cgalParamDescription{of the material that panels will be cut from: the search
    prefers panels whose edges have room for connectors or teeth; 0: joints are not thought of}
    \cgalParamType{`double`, in units of the mesh} \cgalParamDefault{0} \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map} \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadWritePropertyMap` from vertices to 3D points with `double` coordinates}
    \cgalParamDefault{`get(CGAL::vertex_point, mesh)`} \cgalParamNEnd
  \cgalParamNBegin{visitor} \cgalParamDescription{is told the progress and may stop the loop}
    \cgalParamType{a reference (`std::ref`) to a class derived from `Multiplanar::Approximation_visitor`}
    \cgalParamDefault{one that does nothing} \cgalParamNEnd
\cgalNamedParamsEnd

\return the panels as polygons, the measured distances, and what the run noted

\throws std::invalid_argument if the mesh is not a closed oriented triangle mesh or a parameter does not fit it
\throws No_flat_panels if none were found that the mesh can be moved to; the mesh is as it was then
*/
template <class TriangleMesh, class FacePanelMap, class NamedParameters = parameters::Default_named_parameters>
Multiplanar::Approximation_result multiplanar_approximation(TriangleMesh& mesh, FacePanelMap panel_map,
                                                            const NamedParameters& np = parameters::default_values())
{
  namespace MP = Multiplanar;
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, mesh));
  const MP::internal::Connectivity connectivity = MP::internal::make_connectivity(mesh);
  const MP::Points source = MP::internal::read_points(mesh, vpm);
  const MP::Approximation_options options = MP::internal::approximation_options(mesh, np);

  MP::Approximation_visitor silent;
  MP::Approximation_visitor& visitor = MP::internal::visitor_of(get_parameter(np, internal_np::visitor), silent);
  MP::Approximation_result result = MP::internal::approximate(connectivity, source, options, visitor);

  MP::internal::write_points(mesh, vpm, result.points);
  std::size_t i = 0;
  for (auto f : faces(mesh)) put(panel_map, f, result.panel_of_face[i++]);
  return result;
}

} // namespace CGAL

#endif // CGAL_MULTIPLANAR_APPROXIMATION_H
