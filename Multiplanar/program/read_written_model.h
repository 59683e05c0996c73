// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H
#define MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H

#include <CGAL/Multiplanar/Model.h>

#include <string>

/// Reads the model.json of a folder that make or fabricate wrote: all but the order of assembly; corners know no mesh.
/// \throws Failure (exit_input)
CGAL::Multiplanar::Model read_written_model(const std::string& folder);

#endif // MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H
