// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PARTS_FROM_PANELS_H
#define CGAL_MULTIPLANAR_PARTS_FROM_PANELS_H

#include <CGAL/Multiplanar/Model.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A frame in the plane of panel `p`: u along its longest side, so that the part lies well on a sheet and its text
/// reads along that side. The side is projected into the plane; v completes the right-handed frame.
inline Frame panel_frame(const Panel_complex& complex, int p)
{
  const auto& panel = complex.panels[p];
  Vector_3 longest(0, 0, 0);
  for (const auto& side : panel.loops[0]) {
    const Vector_3 d = complex.corners[complex.target(side)].point - complex.corners[complex.source(side)].point;
    if (d.squared_length() > longest.squared_length()) longest = d;
  }
  Frame frame;
  const Vector_3 n = panel.plane.normal;
  frame.normal = n / std::sqrt(n.squared_length());
  const Vector_3 in_plane = longest - (longest * frame.normal) * frame.normal;
  frame.u = in_plane / std::sqrt(in_plane.squared_length());
  frame.v = CGAL::cross_product(frame.normal, frame.u);
  const Point_3 corner = complex.corners[complex.source(panel.loops[0][0])].point;
  frame.origin = corner - signed_distance(panel.plane, corner) * frame.normal;
  return frame;
}

inline Outline project_loop(const Panel_complex& complex, const Panel_complex::Loop& loop, const Frame& frame)
{
  Outline outline;
  for (int corner : complex.loop_corners(loop)) outline.push_back(frame.project(complex.corners[corner].point));
  return outline;
}

/// Moves the origin of a frame so that the outline touches both axes and has no negative coordinates.
inline void shift_to_first_quadrant(const Panel_complex& complex, int p, Frame& frame)
{
  double low_x = 0, low_y = 0;
  for (const Point_2& q : project_loop(complex, complex.panels[p].loops[0], frame))
    low_x = (std::min)(low_x, q.x()), low_y = (std::min)(low_y, q.y());
  frame.origin = frame.origin + low_x * frame.u + low_y * frame.v;
}

/// Can panel `p` be drawn: has it loops, with corners, that span an area?
inline bool has_outline(const Panel_complex& complex, int p)
{
  const auto& panel = complex.panels[p];
  if (panel.loops.empty()) return false;
  for (const auto& loop : panel.loops)
    if (loop.size() < 3 || complex.edges[loop[0].edge].is_closed()) return false;
  return complex.area(p) > 0;
}

inline Part part_from_panel(const Panel_complex& complex, int p)
{
  Part part;
  part.id = panel_id(complex, p);
  part.frame = panel_frame(complex, p);
  shift_to_first_quadrant(complex, p, part.frame);
  const auto& loops = complex.panels[p].loops;
  part.outline = project_loop(complex, loops[0], part.frame);
  for (std::size_t i = 1; i < loops.size(); ++i) part.holes.push_back(project_loop(complex, loops[i], part.frame));
  return part;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarParts

One part a panel, as it is seen on the surface: the whole polygon, with nothing taken off for the thickness of the
material. A panel without an area gives no part, and a warning.

\param complex in mm
\param warnings receives a line for everything that a person who cuts the parts should know
*/
inline std::vector<Part> parts_from_panels(const Panel_complex& complex, std::vector<std::string>& warnings)
{
  std::vector<Part> parts;
  for (int p = 0; p < complex.number_of_panels(); ++p)
    if (internal::has_outline(complex, p)) parts.push_back(internal::part_from_panel(complex, p));
    else warnings.push_back("panel " + panel_id(complex, p) + " has no area: it is not cut");
  return parts;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PARTS_FROM_PANELS_H
