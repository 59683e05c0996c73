// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_TRIANGULATE_FACES_H
#define MULTIPLANAR_PROGRAM_TRIANGULATE_FACES_H

#include "Polygon_soup.h"

#include <array>
#include <string>
#include <vector>

/// Triangles, and the face of the file that each belongs to.
struct Triangulated_faces
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> face_of_triangle;
  std::vector<std::array<int, 3>> corners; ///< positions in `Polygon_soup::indices`
};

/// Splits every face with more than three vertices by the constrained Delaunay triangulation of its projection along
/// its mean normal; no vertex is added, the order of faces stays.
/// \throws Failure (exit_input) for a face whose projection crosses itself
Triangulated_faces triangulate_faces(const Polygon_soup& soup, const std::string& name);

#endif // MULTIPLANAR_PROGRAM_TRIANGULATE_FACES_H
