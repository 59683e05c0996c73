// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FLAT_TRIANGLES_H
#define CGAL_MULTIPLANAR_INTERNAL_FLAT_TRIANGLES_H

#include <CGAL/Multiplanar/Surface_appearance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The larger singular value of a 2 x 2 matrix ((a, b), (c, d)).
inline double largest_singular_value(double a, double b, double c, double d)
{
  const double e = (a + d) / 2, f = (a - d) / 2, g = (c + b) / 2, h = (c - b) / 2;
  return std::hypot(e, h) + std::hypot(f, g);
}

/// The smaller one; not negative.
inline double smallest_singular_value(double a, double b, double c, double d)
{
  const double e = (a + d) / 2, f = (a - d) / 2, g = (c + b) / 2, h = (c - b) / 2;
  return std::abs(std::hypot(e, h) - std::hypot(f, g));
}

/// A triangle of the mesh in the plane of its panel, in pixels: x to the right, y downward.
struct Flat_triangle
{
  int face = -1;
  std::array<double, 3> x{}, y{};

  /// To be called when the corners are known.
  void prepare()
  {
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      dx[k] = (y[a] - y[b]) / area;
      dy[k] = (x[b] - x[a]) / area;
    }
  }
  bool has_area() const { return area != 0 && std::isfinite(dx[0] + dx[1] + dx[2] + dy[0] + dy[1] + dy[2]); }

  /// Barycentric coordinates of (px, py).
  std::array<double, 3> coordinates(double px, double py) const
  {
    std::array<double, 3> b;
    b[1] = (px - x[0]) * dx[1] + (py - y[0]) * dy[1];
    b[2] = (px - x[0]) * dx[2] + (py - y[0]) * dy[2];
    b[0] = 1 - b[1] - b[2];
    return b;
  }

  /// How many texels lie along a pixel, where most do. 0 without a texture.
  double texels_per_pixel(const Surface_appearance& looks) const
  {
    const Texture* texture = looks.texture(face);
    if (!texture) return 0;
    double j[2][2] = {{0, 0}, {0, 0}}; // of texels by pixels
    const double size[2] = {double(texture->width()), double(texture->height())};
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) {
        j[i][0] += size[i] * looks.texture_points[face][k][i] * dx[k];
        j[i][1] += size[i] * looks.texture_points[face][k][i] * dy[k];
      }
    return largest_singular_value(j[0][0], j[0][1], j[1][0], j[1][1]);
  }

  double area = 0;                  ///< twice, signed
  std::array<double, 3> dx{}, dy{}; ///< how the barycentric coordinates grow
};

/// A side of a triangle where the panel ends.
struct Border
{
  int triangle; ///< position in the list of the panel's triangles
  int side;     ///< from corner `side` to the next
};

/// The triangles of one panel.
struct Flat_triangles
{
  std::vector<Flat_triangle> triangles;
  std::vector<Border> borders;
  double mm_per_pixel = 1;
};

/// The sides that only one of `faces` has.
inline std::vector<Border> borders_of(const std::vector<int>& faces, const std::vector<std::array<int, 3>>& triangles)
{
  std::map<std::pair<int, int>, int> count;
  for (int f : faces)
    for (int i = 0; i < 3; ++i) ++count[std::minmax(triangles[f][i], triangles[f][(i + 1) % 3])];
  std::vector<Border> borders;
  for (int k = 0; k < int(faces.size()); ++k)
    for (int i = 0; i < 3; ++i) {
      const auto& t = triangles[faces[k]];
      if (count[std::minmax(t[i], t[(i + 1) % 3])] == 1) borders.push_back({k, i});
    }
  return borders;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FLAT_TRIANGLES_H
