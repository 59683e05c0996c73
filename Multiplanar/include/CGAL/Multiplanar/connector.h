// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_CONNECTOR_H
#define CGAL_MULTIPLANAR_CONNECTOR_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// A connector is a flat part in the plane perpendicular to an edge, with one tab through each of the two panels (paper,
// section 3.2.4, fig. 4). Its *profile* lives in that plane: the origin on the edge, x along the first panel away from
// the edge, y into the solid. The first panel's sheet is 0 <= y <= t; the second panel's starts in direction
// (cos(theta), sin(theta)). The profile is its own mirror image in the bisector of the two panels.
//
// Notation: theta interior dihedral angle, t thickness, w width of a tab, b depth of the body, s = slot_start.
// Beyond the sheets' inner faces, which meet at distance t cot(theta/2) along x, lies the body; the tabs go through the
// sheets from x = s to s + w.

namespace CGAL {
namespace Multiplanar {

/// In multiples of the thickness.
struct Connector_size
{
  double tab_width = 2.5; ///< of either tab
  double depth = 2; ///< of the body, at the narrowest place
};

/// The shape of a connector, in mm, in its own plane with the edge as origin: see the notation above.
struct Connector_profile
{
  Outline outline;                        ///< counter-clockwise
  std::array<std::array<int, 2>, 2> tabs; ///< outline vertices i .. j of the tab in the first and second panel
  std::vector<Outline> body;              ///< the outline without its tabs, as convex polygons
  double slot_start = 0;                  ///< where the slot in either panel begins, in mm from the edge
  double slot_end = 0;                    ///< where it ends
};

/// Free material around a slot, in slot widths (that is, thicknesses); a hundredth of a mm more keeps rounding out.
inline double slot_margin(double thickness) { return 1.5 * thickness + 0.01; }

/// The widest strip along an edge that truncation takes off either of its panels (section 3.2.2): the formulas that
/// the general construction has at an edge; above 270 degrees, what the later panel loses to get past the other one
/// over its last `approach` mm.
inline double widest_strip(double theta, double thickness, double approach)
{
  const double right = 1.57079632679489661923, t = thickness;
  if (theta < right) return t / std::tan(theta / 2);
  if (theta < 2 * right) return t * std::sin(theta);
  if (theta <= 3 * right) return 0;
  return approach * std::tan(theta - 3 * right);
}

/// Why no connector can join panels at this angle, whatever their size; empty if one can.
inline const char* connector_obstacle(double theta, double thickness, double approach)
{
  const double right = 1.57079632679489661923;
  if (theta > 3 * right && widest_strip(theta, thickness, approach) > thickness / 2)
    return "the panels overhang each other too much for a connector";
  if (theta < right / 9) return "the angle is too narrow for a connector";
  return "";
}

namespace internal {

/// How deep the body reaches below the sheet at the outer end of a tab, so that it is `b` deep in the middle too, where
/// the straight line between the two ends passes below the meeting point of the inner faces.
inline double end_depth(double theta, double t, double b, double tab_end)
{
  if (theta >= 3.14159265358979323846) return b;
  const double s = std::sin(theta / 2), c = std::cos(theta / 2);
  const double needed = (t / s + b - tab_end * c) / s - t;
  const double most = tab_end * s / c - t; // there the two ends meet on the bisector
  return (std::min)((std::max)(needed, b / 2), (std::max)(0.98 * most, 0.0));
}

/// The mirror image in the bisector of the angle theta.
inline Point_2 mirrored(const Point_2& p, double theta)
{
  const double c = std::cos(theta), s = std::sin(theta);
  return Point_2(c * p.x() + s * p.y(), s * p.x() - c * p.y());
}

} // namespace internal

/*!
\ingroup PkgMultiplanarParts

The profile of a connector between panels at the interior angle `theta` (radians), for sheets of the given thickness. It
depends on nothing else, so that connectors of equal angles can be swapped.

\pre 0 < theta < 2 pi, `connector_obstacle()` is empty
*/
inline Connector_profile connector_profile(double theta, double thickness, double approach, const Connector_size& size)
{
  CGAL_precondition(connector_obstacle(theta, thickness, approach)[0] == 0);
  const double t = thickness, half = std::tan(theta / 2), pi = 3.14159265358979323846;
  const double start = widest_strip(theta, t, approach) + slot_margin(t), end = start + size.tab_width * t;
  const double h = t + internal::end_depth(theta, t, size.depth * t, end);
  const auto mirror = [theta](double x, double y) { return internal::mirrored(Point_2(x, y), theta); };
  const Point_2 inner(t / half, t); // where the inner faces of the sheets meet

  Connector_profile profile;
  profile.slot_start = start;
  profile.slot_end = end;
  profile.outline = {inner, Point_2(start, t), Point_2(start, 0), Point_2(end, 0), Point_2(end, t), Point_2(end, h)};
  profile.tabs[0] = {1, 4};
  if (theta > pi) profile.outline.push_back(Point_2(h / half, h));
  const int n = int(profile.outline.size());
  for (const Point_2& p : {mirror(end, h), mirror(end, t), mirror(end, 0), mirror(start, 0), mirror(start, t)})
    profile.outline.push_back(p);
  profile.tabs[1] = {n + 1, n + 4};

  if (theta > pi) {
    const Point_2 outer(h / half, h);
    profile.body = {{inner, Point_2(end, t), Point_2(end, h), outer}, {inner, outer, mirror(end, h), mirror(end, t)}};
  } else {
    profile.body = {{inner, Point_2(end, t), Point_2(end, h), mirror(end, h), mirror(end, t)}};
  }
  return profile;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_CONNECTOR_H
