// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_RUN_APPROXIMATION_H
#define MULTIPLANAR_PROGRAM_RUN_APPROXIMATION_H

#include "Input_mesh.h"
#include "Progress.h"

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/io/write_report_json.h>

/// Approximates the mesh and looks at what came out. \throws Failure (exit_broken_promise) if a promise does not hold
CGAL::Multiplanar::Approximation_result
run_approximation(const Input_mesh& mesh, const CGAL::Multiplanar::Approximation_options& options, Progress& progress);

CGAL::Multiplanar::Accuracy accuracy_of(const CGAL::Multiplanar::Approximation_result& result);

#endif // MULTIPLANAR_PROGRAM_RUN_APPROXIMATION_H
