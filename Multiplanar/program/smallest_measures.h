// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SMALLEST_MEASURES_H
#define MULTIPLANAR_PROGRAM_SMALLEST_MEASURES_H

#include "Input_mesh.h"
#include "Settings.h"

/// Shortest edge, smallest width and thickness, which the command line has in mm, in the units of the mesh.
void set_smallest_measures(const Settings& settings, const Input_mesh& mesh,
                           CGAL::Multiplanar::Approximation_options& options);

#endif // MULTIPLANAR_PROGRAM_SMALLEST_MEASURES_H
