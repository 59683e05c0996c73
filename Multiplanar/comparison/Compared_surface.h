// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_COMPARISON_COMPARED_SURFACE_H
#define MULTIPLANAR_COMPARISON_COMPARED_SURFACE_H

#include <CGAL/Multiplanar/internal/kernel.h>
#include <CGAL/Multiplanar/panel_triangulation.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace comparison {

using namespace internal;

/// What a method made of a model: triangles over points, which need not be a mesh, and which points share a panel.
struct Compared_surface
{
  Points points;
  std::vector<std::array<int, 3>> triangles;
  int panels = 0;
  std::vector<std::vector<int>> flat_together; ///< lists of points that should lie in one plane
};

/// The panels of this package.
/// \pre `is_simple_panel()` for every panel
inline Compared_surface surface_of_panels(const Panel_complex& complex)
{
  Compared_surface result;
  for (const auto& corner : complex.corners) result.points.push_back(corner.point);
  result.triangles = triangulate_panels(complex).triangles;
  result.panels = complex.number_of_panels();
  for (const auto& panel : complex.panels) {
    result.flat_together.emplace_back();
    for (const auto& loop : panel.loops)
      for (int c : complex.loop_corners(loop)) result.flat_together.back().push_back(c);
  }
  return result;
}

} // namespace comparison
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_COMPARISON_COMPARED_SURFACE_H
