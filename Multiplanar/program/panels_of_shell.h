// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PANELS_OF_SHELL_H
#define MULTIPLANAR_PROGRAM_PANELS_OF_SHELL_H

#include "Input_mesh.h"

#include <CGAL/Multiplanar/Panel_complex.h>

#include <vector>

/// The panel of every triangle, from the face property `panel` that the mesh was read with.
/// \throws Failure (exit_input) unless the values are 0, 1, ... without gaps
std::vector<int> panels_of_shell(const Input_mesh& mesh);

/// The panels of a shell. \throws Failure (exit_input) if they cannot be flat polygons, or are not flat
CGAL::Multiplanar::Panel_complex complex_of_shell(const Input_mesh& mesh, const std::vector<int>& panel_of_face);

#endif // MULTIPLANAR_PROGRAM_PANELS_OF_SHELL_H
