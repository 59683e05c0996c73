// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_READ_MESH_H
#define MULTIPLANAR_PROGRAM_READ_MESH_H

#include "Polygon_soup.h"

#include <string>
#include <string_view>
#include <vector>

// The readers of text formats and PLY are our own, small ones: they keep coordinates as doubles (the mesh libraries
// that read so many formats keep floats) and the order of vertices and faces, say at which line a file is wrong, and
// trust no count that a file announces. glTF, whose numbers are floats, is read by Assimp.

/// Reads an OFF, PLY, STL, OBJ or glTF file; its content decides which, its extension where the content leaves it open.
/// \param face_properties names of scalar face properties of a PLY file to be kept if they are there
/// \throws Failure (exit_input) that names the file and the line, vertex or face
Polygon_soup read_mesh(const std::string& file, const std::vector<std::string>& face_properties = {});

/// The readers of each format. `name` is that of the file, for messages.
Polygon_soup read_off(std::string_view text, const std::string& name);
Polygon_soup read_obj(std::string_view text, const std::string& name);
Polygon_soup read_gltf(std::string_view bytes, const std::string& name);
Polygon_soup read_stl(std::string_view bytes, const std::string& name);
Polygon_soup read_ply(std::string_view bytes, const std::string& name, const std::vector<std::string>& face_properties);

/// Is this binary STL, by its size?
bool is_binary_stl(std::string_view bytes);

/// The whole content of a file. \throws Failure if it cannot be read
std::string read_file(const std::string& file);

#endif // MULTIPLANAR_PROGRAM_READ_MESH_H
