// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_POLYGON_SOUP_H
#define MULTIPLANAR_PROGRAM_POLYGON_SOUP_H

#include "Soup_appearance.h"

#include <array>
#include <map>
#include <string>
#include <vector>

/// What a mesh file says, in its order, with nothing judged yet but that indices and coordinates make sense.
struct Polygon_soup
{
  std::vector<std::array<double, 3>> points; ///< finite
  std::vector<int> indices;                  ///< of the vertices of all faces, one face after the other
  std::vector<std::size_t> face_begin{0};    ///< where each face begins in `indices`, and the end
  std::map<std::string, std::vector<double>> face_properties; ///< those asked for, one value a face

  Soup_appearance appearance;

  int number_of_faces() const { return int(face_begin.size()) - 1; }
  int face_size(int f) const { return int(face_begin[f + 1] - face_begin[f]); }
  const int* face(int f) const { return indices.data() + face_begin[f]; }
  /// The indices pushed since the last call are a face.
  void close_face() { face_begin.push_back(indices.size()); }
};

#endif // MULTIPLANAR_PROGRAM_POLYGON_SOUP_H
