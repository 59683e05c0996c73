// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preview_scenes.h"

#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

constexpr double crease = 0.7; // cosine of the angle between faces that are shaded as one

Vector_3 unit(const Vector_3& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector_3(0, 0, 1);
}

/// The faces around each vertex: those of vertex v are list[begin[v]] .. list[begin[v + 1] - 1].
struct Stars
{
  Stars(std::size_t vertices, const std::vector<std::array<int, 3>>& triangles)
      : begin(vertices + 1, 0), list(3 * triangles.size())
  {
    for (const auto& t : triangles)
      for (int v : t) ++begin[v + 1];
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    std::vector<int> fill(begin.begin(), begin.end() - 1);
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int v : triangles[f]) list[fill[v]++] = int(f);
  }
  std::vector<int> begin, list;
};

} // namespace

Scene mesh_scene(const Points& points, const std::vector<std::array<int, 3>>& triangles, const Vector_3& up,
                 const Surface_appearance& looks)
{
  std::vector<Vector_3> area, normal;
  for (const auto& t : triangles) {
    area.push_back(CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    normal.push_back(unit(area.back()));
  }
  const Stars stars(points.size(), triangles);
  Scene scene;
  scene.up = up;
  scene.triangles.resize(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int v = triangles[f][i];
      Vector_3 sum(0, 0, 0);
      for (int k = stars.begin[v]; k < stars.begin[v + 1]; ++k)
        if (normal[stars.list[k]] * normal[f] > crease) sum = sum + area[stars.list[k]];
      scene.triangles[f].points[i] = points[v];
      scene.triangles[f].normals[i] = unit(sum);
      scene.triangles[f].colours[i] = {0.62f, 0.63f, 0.65f};
    }
  for (std::size_t f = 0; f < looks.colours.size(); ++f) {
    scene.triangles[f].colours = looks.colours[f];
    scene.triangles[f].texture = looks.texture(int(f));
    if (scene.triangles[f].texture) scene.triangles[f].texture_points = looks.texture_points[f];
  }
  return scene;
}
