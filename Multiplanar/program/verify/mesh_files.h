// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_MESH_FILES_H
#define MULTIPLANAR_VERIFY_MESH_FILES_H

#include "written_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

struct Written_mesh
{
  std::vector<Point_3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::string> groups; ///< OBJ: by face
  std::vector<int> panels;         ///< PLY: by face
};

/// Vertices, faces and groups of an OBJ file. \throw Unreadable
Written_mesh read_obj(const std::filesystem::path& file);

/// Vertices, faces and their `panel` of a PLY file, ASCII or binary. \throw Unreadable
Written_mesh read_ply(const std::filesystem::path& file);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_MESH_FILES_H
