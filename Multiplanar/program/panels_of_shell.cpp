// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "panels_of_shell.h"
#include "failure.h"

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

/// What counts as flat when the planes are only known from the faces, as a part of the diagonal.
constexpr double flat = 1e-2;

const std::vector<double>& panel_property(const Input_mesh& mesh)
{
  const auto found = mesh.face_properties.find("panel");
  if (found == mesh.face_properties.end())
    throw input_error(mesh.file + ": the faces have no property \"panel\": give a PLY that approximate or make wrote");
  return found->second;
}

} // namespace

std::vector<int> panels_of_shell(const Input_mesh& mesh)
{
  const std::vector<double>& values = panel_property(mesh);
  std::vector<bool> used;
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (!(values[f] >= 0 && values[f] < double(values.size())) || values[f] != std::floor(values[f]))
      throw input_error(mesh.file + ": the panel of face " + std::to_string(f) + " is not a number from 0 to " +
                        std::to_string(values.size() - 1) + ": number the panels from 0");
    used.resize(std::max(used.size(), std::size_t(values[f]) + 1), false);
    used[std::size_t(values[f])] = true;
  }
  const auto gap = std::find(used.begin(), used.end(), false);
  if (gap != used.end())
    throw input_error(mesh.file + ": no face has the panel " + std::to_string(gap - used.begin()) +
                      ": number the panels without gaps");
  std::vector<int> panels;
  for (int f : mesh.face_of_triangle) panels.push_back(int(values[f]));
  return panels;
}

Panel_complex complex_of_shell(const Input_mesh& mesh, const std::vector<int>& panel_of_face)
{
  const int panels = 1 + *std::max_element(panel_of_face.begin(), panel_of_face.end());
  Panel_complex complex = make_panel_complex(mesh.connectivity, mesh.points, panel_of_face, panels);
  const auto problems = panel_complex_problems(complex);
  if (!problems.empty())
    throw input_error(mesh.file + ": panel " + std::to_string(problems[0].panel) + " " +
                      to_string(problems[0].problem) + ": it cannot be cut as one flat polygon");
  if (complex.planarity_deviation() > flat * mesh.diagonal)
    throw input_error(mesh.file + ": the panels are bent by up to " +
                      std::to_string(100 * complex.planarity_deviation() / mesh.diagonal) +
                      " % of the diagonal: flatten the mesh first (approximate)");
  return complex;
}
