// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_FRAMES_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_FRAMES_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/Flat_polygon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// "P07": the id of panel 6, as every file and message names it. Two digits at least, as many as `count` panels need.
inline std::string numbered_id(char letter, int index, int digits)
{
  char text[32];
  std::snprintf(text, sizeof text, "%c%0*d", letter, digits, index + 1);
  return text;
}
inline std::string panel_id(int panel, int count) { return numbered_id('P', panel, count >= 100 ? 3 : 2); }
inline std::string edge_id(int edge) { return numbered_id('E', edge, 3); }
inline std::string connector_id(int connector) { return numbered_id('C', connector, 3); }

namespace internal {

/// `v` made unit. \pre `v` is not zero
inline Vector_3 unit(const Vector_3& v)
{
  const double length = std::sqrt(v.squared_length());
  CGAL_precondition(length > 0);
  return v / length;
}

/// The coordinates of panel `p`: x along its longest outer side, its corners in the first quadrant, z = 0 on its plane.
inline Frame panel_frame(const Panel_complex& complex, int p)
{
  const auto& panel = complex.panels[p];
  double longest = -1;
  Vector_3 direction(1, 0, 0);
  for (const auto& side : panel.loops[0]) {
    const Vector_3 d = complex.corners[complex.target(side)].point - complex.corners[complex.source(side)].point;
    if (d.squared_length() > longest) longest = d.squared_length(), direction = d;
  }
  Frame frame;
  frame.normal = unit(panel.plane.normal);
  frame.u = unit(direction - (direction * frame.normal) * frame.normal);
  frame.v = unit(CGAL::cross_product(frame.normal, frame.u));
  frame.origin = complex.corners[complex.source(panel.loops[0][0])].point;
  frame.origin = frame.origin - signed_distance(panel.plane, frame.origin) * frame.normal;
  double x = 0, y = 0;
  for (const auto& side : panel.loops[0]) {
    const Point_2 q = frame.project(complex.corners[complex.source(side)].point);
    x = (std::min)(x, q.x());
    y = (std::min)(y, q.y());
  }
  frame.origin = frame(Point_2(x, y));
  return frame;
}

/// The panel itself in its frame.
inline Flat_polygon panel_polygon(const Panel_complex& complex, int p, const Frame& frame)
{
  Flat_polygon result;
  for (const auto& loop : complex.panels[p].loops) {
    Outline outline;
    for (int corner : complex.loop_corners(loop)) outline.push_back(frame.project(complex.corners[corner].point));
    if (&loop == &complex.panels[p].loops[0]) result.outline = std::move(outline);
    else result.holes.push_back(std::move(outline));
  }
  return result;
}

/// \throws std::invalid_argument naming the first panel that is not a flat simple polygon
inline void require_flat_panels(const Panel_complex& complex)
{
  const int n = complex.number_of_panels();
  const auto refuse = [n](int p, const std::string& what) {
    throw std::invalid_argument("panel " + panel_id(p, n) + ": " + what);
  };
  for (int p = 0; p < n; ++p) {
    const auto& panel = complex.panels[p];
    if (panel.loops.empty()) refuse(p, "it has no boundary");
    if (!(panel.plane.normal.squared_length() > 0)) refuse(p, "its plane has no normal");
    for (const auto& loop : panel.loops)
      for (const auto& side : loop) {
        if (complex.edges[side.edge].is_closed()) refuse(p, "a boundary has no corners");
        const double off = std::abs(signed_distance(panel.plane, complex.corners[complex.source(side)].point));
        if (!(off <= 1e-3))
          refuse(p, "a corner lies " + std::to_string(off) + " mm off its plane; panels must be flat");
      }
    if (!is_valid(panel_polygon(complex, p, panel_frame(complex, p))))
      refuse(p, "its polygon is not simple, or its loops are not oriented outer counter-clockwise, holes clockwise");
  }
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_FRAMES_H
