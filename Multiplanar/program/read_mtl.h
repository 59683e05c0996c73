// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_READ_MTL_H
#define MULTIPLANAR_PROGRAM_READ_MTL_H

#include "Soup_appearance.h"

#include <string>
#include <string_view>
#include <vector>

/// Adds the materials of a Wavefront material library: names, Kd, and map_Kd with the options -clamp, -s and -o (others
/// are passed over with their values). A texture takes the place of Kd. What is missing or makes no sense leaves the
/// plain colour and a note: looks must not keep anybody from cutting.
/// \param file the library, beside or below which its textures lie
void read_mtl(std::string_view text, const std::string& file, std::vector<Soup_material>& materials,
              std::vector<std::string>& notes);

#endif // MULTIPLANAR_PROGRAM_READ_MTL_H
