// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SALIENCY_H
#define MULTIPLANAR_PROGRAM_SALIENCY_H

#include "Input_mesh.h"

#include <string>
#include <vector>

/// A saliency in 0..1 for every triangle of `mesh`, from a file with one for every face of the file it came from: text
/// with a value a face, or a PLY with the float face property `saliency`.
/// \throws Failure
std::vector<double> read_saliency(const std::string& file, const Input_mesh& mesh);

#endif // MULTIPLANAR_PROGRAM_SALIENCY_H
