// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PLY_LOOKS_H
#define MULTIPLANAR_PROGRAM_PLY_LOOKS_H

#include "Polygon_soup.h"
#include "ply_header.h"

#include <vector>

/// Gathers what a PLY file says of looks while its values go by: texture points of vertices (s t, u v or texture_u
/// texture_v) or of the corners of faces (texcoord), the number of a face's texture, colours of vertices or faces.
class Ply_looks
{
public:
  void begin_vertex()
  {
    in_faces = false;
    point = {0, 0};
    colour = {1, 1, 1};
  }
  void begin_face()
  {
    in_faces = true;
    corners.clear();
    colour = {1, 1, 1};
    texture = 0;
  }

  /// Takes the value of a property that is no list; those that say nothing of looks are passed over.
  void value(const Ply_property& property, double value);
  /// Takes a value of a face's list `texcoord`.
  void texture_coordinate(double value) { corners.push_back(float(value)); }

  void end_vertex();
  /// \param size the number of corners of the face
  void end_face(int size);

  /// Puts everything into the soup. \param file for messages and the place of the textures
  void finish(Polygon_soup& soup, const Ply_header& header, const std::string& file);

private:
  CGAL::Multiplanar::Texture_point point{{0, 0}};
  CGAL::Multiplanar::Linear_colour colour{{1, 1, 1}};
  std::vector<float> corners;
  int texture = 0;
  bool has_points = false, has_corners = false, has_vertex_colours = false, has_face_colours = false, in_faces = false;
  std::vector<CGAL::Multiplanar::Texture_point> vertex_points, corner_points;
  std::vector<CGAL::Multiplanar::Linear_colour> vertex_colours, face_colours;
  std::vector<int> face_textures;
};

#endif // MULTIPLANAR_PROGRAM_PLY_LOOKS_H
