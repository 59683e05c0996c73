// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_PLACES_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_PLACES_H

#include <CGAL/Multiplanar/Panel_complex.h>

#include <cstdio>
#include <string>
#include <vector>

// Where things are, for notes that a person reads.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// "near (1.25, 3, -0.5)": the middle of some points, to four digits.
inline std::string near_points(const std::vector<Point_3>& points)
{
  double sum[3] = {0, 0, 0};
  for (const Point_3& x : points)
    for (int axis = 0; axis < 3; ++axis) sum[axis] += x[axis];
  const double n = points.empty() ? 1 : double(points.size());
  char text[96];
  std::snprintf(text, sizeof text, "near (%.4g, %.4g, %.4g)", sum[0] / n, sum[1] / n, sum[2] / n);
  return text;
}

inline std::string near_corners(const Panel_complex& complex, const std::vector<int>& corners)
{
  std::vector<Point_3> points;
  for (int c : corners) points.push_back(complex.corners[c].point);
  return near_points(points);
}

inline std::string near_panel(const Panel_complex& complex, int panel)
{
  return near_corners(complex, complex.loop_corners(complex.panels[panel].loops[0]));
}

/// The first few places, and how many more there are.
inline std::string some_of(const std::vector<std::string>& places)
{
  const std::size_t shown = 5;
  std::string list;
  for (std::size_t i = 0; i < places.size() && i < shown; ++i) list += (i == 0 ? "" : ", ") + places[i];
  if (places.size() > shown) list += " and " + std::to_string(places.size() - shown) + " more";
  return list;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_PLACES_H
