// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_SURFACE_APPEARANCE_H
#define CGAL_MULTIPLANAR_SURFACE_APPEARANCE_H

#include <CGAL/Multiplanar/Texture.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarTextures

How a triangle mesh looks, triangle by triangle: a colour at each corner, and a texture that it multiplies, if there is
one, with a place in it for each corner. Since places belong to corners, not to vertices, a seam of the texture does not
cut the surface. What moves the vertices of the mesh leaves its looks valid.
*/
struct Surface_appearance
{
  std::vector<std::array<Linear_colour, 3>> colours;        ///< by triangle
  std::vector<std::array<Texture_point, 3>> texture_points; ///< by triangle; empty if there is no texture
  std::vector<int> texture_of_triangle;                     ///< -1: colours only; empty if there is no texture
  std::vector<Texture> textures;                            ///< each a picture with its wrap modes

  bool empty() const { return colours.empty(); } ///< nothing but plain material?
  /// The texture of triangle `f`, or null.
  const Texture* texture(int f) const
  {
    return texture_of_triangle.empty() || texture_of_triangle[f] < 0 ? nullptr : &textures[texture_of_triangle[f]];
  }

  /// The place in the texture of triangle `f` with barycentric coordinates `b`. \pre `texture(f)`
  std::array<double, 2> place(int f, const std::array<double, 3>& b) const
  {
    const auto& p = texture_points[f];
    return {b[0] * p[0][0] + b[1] * p[1][0] + b[2] * p[2][0], b[0] * p[0][1] + b[1] * p[1][1] + b[2] * p[2][1]};
  }

  /// The light of triangle `f` at barycentric coordinates `b`, the texture filtered over `footprint` texels.
  Linear_colour operator()(int f, const std::array<double, 3>& b, double footprint = 1) const
  {
    const auto& c = colours[f];
    Linear_colour light;
    for (int i = 0; i < 3; ++i) light[i] = float(b[0] * c[0][i] + b[1] * c[1][i] + b[2] * c[2][i]);
    if (const Texture* t = texture(f)) {
      const std::array<double, 2> at = place(f, b);
      const Linear_colour texel = (*t)(at[0], at[1], footprint);
      for (int i = 0; i < 3; ++i) light[i] *= texel[i];
    }
    return light;
  }
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_SURFACE_APPEARANCE_H
