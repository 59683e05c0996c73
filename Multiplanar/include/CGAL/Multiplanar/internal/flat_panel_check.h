// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FLAT_PANEL_CHECK_H
#define CGAL_MULTIPLANAR_INTERNAL_FLAT_PANEL_CHECK_H

#include <CGAL/Multiplanar/internal/Flat_polygon.h>
#include <CGAL/Multiplanar/parts_from_panels.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline double largest_distance_from_plane(const Panel_complex& complex, const Panel_complex::Panel& panel)
{
  double worst = 0;
  for (const auto& loop : panel.loops)
    for (int corner : complex.loop_corners(loop)) {
      const double off = std::abs(signed_distance(panel.plane, complex.corners[corner].point));
      if (!(off <= worst)) worst = off; // not a number counts as worse
    }
  return worst;
}

/// What keeps panel `p` from being cut out of a sheet; empty if nothing.
inline std::string problem_of_panel(const Panel_complex& complex, int p)
{
  const auto& panel = complex.panels[p];
  if (!(panel.plane.normal.squared_length() > 0)) return "its plane has no normal";
  if (!has_outline(complex, p)) return "it has no boundary with corners that spans an area";
  const double off = largest_distance_from_plane(complex, panel);
  if (!(off <= 1e-3)) return "a corner lies " + std::to_string(off) + " mm off its plane; panels must be flat";
  const Part part = part_from_panel(complex, p);
  if (!is_valid({part.outline, part.holes}))
    return "its polygon is not simple, or its loops do not run counter-clockwise (outline) and clockwise (holes)";
  return "";
}

/// \throws std::invalid_argument naming the first panel that is not a flat simple polygon
inline void require_flat_panels(const Panel_complex& complex)
{
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    const std::string problem = problem_of_panel(complex, p);
    if (!problem.empty()) throw std::invalid_argument("panel " + panel_id(complex, p) + ": " + problem);
  }
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FLAT_PANEL_CHECK_H
