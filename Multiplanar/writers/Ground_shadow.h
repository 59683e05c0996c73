// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_GROUND_SHADOW_H
#define MULTIPLANAR_WRITERS_GROUND_SHADOW_H

#include "Camera.h"
#include "Scene.h"

#include <vector>

/// How much of a wide sky a scene hides from the ground under it: dark and sharp where it stands, faint where it
/// floats.
class Ground_shadow
{
public:
  /// The ground is the level of the scene's lowest point along its `up`.
  explicit Ground_shadow(const Scene& scene);

  /// The share of light, 0..1, at the place of the ground that is seen at (x, y), 1 where no ground is seen.
  double operator()(const Camera& camera, double x, double y) const;

private:
  static constexpr int cells = 256;

  void cast(const Scene_triangle& triangle, std::vector<float>& lowest) const;
  void blur(std::vector<float>& grid, int radius) const;

  CGAL::Multiplanar::Point_3 origin = CGAL::Multiplanar::Point_3(0, 0, 0);
  CGAL::Multiplanar::Vector_3 u, v, up;
  double size = 1; ///< of the square that the grid covers, its middle at the origin
  std::vector<float> shade;
};

#endif // MULTIPLANAR_WRITERS_GROUND_SHADOW_H
