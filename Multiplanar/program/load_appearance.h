// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_LOAD_APPEARANCE_H
#define MULTIPLANAR_PROGRAM_LOAD_APPEARANCE_H

#include "Input_mesh.h"

#include <CGAL/Multiplanar/Surface_appearance.h>

#include <array>
#include <string>
#include <vector>

/// The texture points of the corners of every triangle, (0, 0) where there are none; empty if the file had none at all.
std::vector<std::array<CGAL::Multiplanar::Texture_point, 3>> texture_points_of(const Input_mesh& mesh);

/// The looks of every triangle, its pictures read: empty if the file says nothing of looks that would be worth printing
/// (no picture, no colours but one grey). A picture that cannot be read leaves its material plain, and a note.
CGAL::Multiplanar::Surface_appearance load_appearance(const Input_mesh& mesh, std::vector<std::string>& notes);

#endif // MULTIPLANAR_PROGRAM_LOAD_APPEARANCE_H
