// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_EXAMPLES_SHAPES_H
#define MULTIPLANAR_EXAMPLES_SHAPES_H

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <cmath>
#include <vector>

// Closed triangle meshes made in code, so that the examples need no files.

/// Distance of a pebble's surface from its centre in the direction (x, y, z), which has length 1.
inline double pebble_radius(double x, double y, double z)
{
  return 1 + 0.25 * std::sin(3 * x + 1) * std::cos(2 * y) + 0.15 * std::sin(4 * z + x);
}

/// A bumpy pebble of 8 n^2 triangles, as any model of `MutableFaceGraph`.
template <class Mesh, class Point>
Mesh pebble(int n)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::vector<std::size_t>> row; // of the octahedron |x| + |y| + |z| = n, from its top
  for (int level = 0; level <= 2 * n; ++level) {
    const int z = n - level, side = n - std::abs(z);
    row.emplace_back();
    for (int i = 0; i < (side == 0 ? 1 : 4 * side); ++i) {
      const int s = side == 0 ? 0 : i / side, k = side == 0 ? 0 : i % side;
      const double x = s == 0 ? side - k : s == 1 ? -k : s == 2 ? k - side : k;
      const double y = s == 0 ? k : s == 1 ? side - k : s == 2 ? -k : k - side;
      const double length = std::sqrt(x * x + y * y + double(z) * z);
      const double r = pebble_radius(x / length, y / length, z / length) / length;
      row.back().push_back(points.size());
      points.emplace_back(r * x, r * y, r * z);
    }
  }
  for (int level = 0; level < 2 * n; ++level) {
    const bool down = level < n; // rows grow
    const auto &small = row[down ? level : level + 1], &large = row[down ? level + 1 : level];
    const std::size_t side = large.size() / 4;
    for (std::size_t i = 0; i < large.size(); ++i) {
      const std::size_t s = i / side, k = i % side, a = s * (side - 1) + k;
      const std::size_t p = small[a % small.size()], l0 = large[i], l1 = large[(i + 1) % large.size()];
      if (down) triangles.push_back({p, l0, l1});
      else triangles.push_back({p, l1, l0});
      if (k + 1 == side) continue;
      const std::size_t q = small[(a + 1) % small.size()];
      if (down) triangles.push_back({p, l1, q});
      else triangles.push_back({p, q, l1});
    }
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

#endif // MULTIPLANAR_EXAMPLES_SHAPES_H
