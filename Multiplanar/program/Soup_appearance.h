// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SOUP_APPEARANCE_H
#define MULTIPLANAR_PROGRAM_SOUP_APPEARANCE_H

#include <CGAL/Multiplanar/Linear_colour.h>
#include <CGAL/Multiplanar/Texture.h>

#include <limits>
#include <string>
#include <vector>

/// A material as a file describes it; its picture is not read yet.
struct Soup_material
{
  std::string name;
  CGAL::Multiplanar::Linear_colour colour{{0.6f, 0.6f, 0.6f}}; ///< where there is no texture
  CGAL::Multiplanar::Linear_colour tint{{1, 1, 1}};            ///< multiplies the texture
  std::string texture_file;                                    ///< to be read, or empty
  std::string texture_bytes;                                   ///< a PNG or JPEG inside the mesh file, or empty
  CGAL::Multiplanar::Texture_wrap wrap_s = CGAL::Multiplanar::Texture_wrap::repeat;
  CGAL::Multiplanar::Texture_wrap wrap_t = CGAL::Multiplanar::Texture_wrap::repeat;
  CGAL::Multiplanar::Texture_point scale{{1, 1}}, offset{{0, 0}}; ///< of the texture points, in this order
  bool ignores_alpha = false;

  bool has_texture() const { return !texture_file.empty() || !texture_bytes.empty(); }
};

/// The texture point of a corner that has none.
inline CGAL::Multiplanar::Texture_point no_texture_point()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return {nan, nan};
}

/// How the faces of a soup look: lists by corner run parallel to `Polygon_soup::indices`, so that joining vertices
/// leaves them valid. Any of them may be empty.
struct Soup_appearance
{
  std::vector<CGAL::Multiplanar::Texture_point> texture_points; ///< by corner
  std::vector<CGAL::Multiplanar::Linear_colour> corner_colours; ///< by corner
  std::vector<CGAL::Multiplanar::Linear_colour> vertex_colours; ///< by vertex of the file, until spread to corners
  std::vector<int> face_materials;                              ///< by face; -1: none
  std::vector<Soup_material> materials;
  bool colours_multiply = false;  ///< colours of corners multiply those of materials, or else take their place
  std::vector<std::string> notes; ///< what could not be found or read
};

#endif // MULTIPLANAR_PROGRAM_SOUP_APPEARANCE_H
