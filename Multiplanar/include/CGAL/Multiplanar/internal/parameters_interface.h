// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters of this package, in the form of CGAL's own list. No include guard: included with different
// definitions of the macro, as CGAL/STL_Extension/internal/parameters_interface.h is.

CGAL_add_named_parameter(number_of_panels_t, number_of_panels, number_of_panels)
CGAL_add_named_parameter(number_of_restarts_t, number_of_restarts, number_of_restarts)
CGAL_add_named_parameter(number_of_threads_t, number_of_threads, number_of_threads)
CGAL_add_named_parameter(effort_t, effort, effort)
CGAL_add_named_parameter(deformation_solver_t, deformation_solver, deformation_solver)
CGAL_add_named_parameter(smoothness_weight_t, smoothness_weight, smoothness_weight)
CGAL_add_named_parameter(face_saliency_map_t, face_saliency_map, face_saliency_map)
CGAL_add_named_parameter(saliency_weight_t, saliency_weight, saliency_weight)
CGAL_add_named_parameter(minimum_edge_length_t, minimum_edge_length, minimum_edge_length)
CGAL_add_named_parameter(minimum_panel_width_t, minimum_panel_width, minimum_panel_width)
CGAL_add_named_parameter(sheet_thickness_t, sheet_thickness, sheet_thickness)
CGAL_add_named_parameter(panel_complex_t, panel_complex, panel_complex)
CGAL_add_named_parameter(approximation_result_t, approximation_result, approximation_result)
