// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_SCENE_H
#define MULTIPLANAR_WRITERS_SCENE_H

#include <CGAL/Multiplanar/Texture.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <array>
#include <vector>

/// A triangle of a scene; what differs from corner to corner is interpolated.
struct Scene_triangle
{
  std::array<CGAL::Multiplanar::Point_3, 3> points;
  std::array<CGAL::Multiplanar::Vector_3, 3> normals; ///< unit, outward
  std::array<CGAL::Multiplanar::Linear_colour, 3> colours;
  const CGAL::Multiplanar::Texture* texture = nullptr; ///< multiplies the colours if there is one
  std::array<CGAL::Multiplanar::Texture_point, 3> texture_points{};
};

/// A line drawn where the surface does not hide it.
struct Scene_line
{
  CGAL::Multiplanar::Point_3 a, b;
  double width = 1; ///< in pixels of the picture
  CGAL::Multiplanar::Linear_colour colour{};
};

/// What a picture shows.
struct Scene
{
  std::vector<Scene_triangle> triangles;
  std::vector<Scene_line> lines;
  CGAL::Multiplanar::Vector_3 up = CGAL::Multiplanar::Vector_3(0, 1, 0);
  bool has_ground = true; ///< a shadow falls on the level of the lowest point
};

/// All corners of the triangles, for the camera.
inline CGAL::Multiplanar::Points points_of(const Scene& scene)
{
  CGAL::Multiplanar::Points points;
  points.reserve(3 * scene.triangles.size());
  for (const Scene_triangle& t : scene.triangles) points.insert(points.end(), t.points.begin(), t.points.end());
  return points;
}

#endif // MULTIPLANAR_WRITERS_SCENE_H
