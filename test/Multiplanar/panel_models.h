// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_PANEL_MODELS_H
#define MULTIPLANAR_TEST_PANEL_MODELS_H

#include <CGAL/Multiplanar/make_panel_complex.h>

#include <vector>

/// Panel complexes written down by hand.
namespace Multiplanar_test {

using CGAL::Multiplanar::Panel_complex;

/// A box from the origin to (a, b, c): panels -z +z -y +x +y -x.
inline Panel_complex box(double a, double b, double c)
{
  using CGAL::Multiplanar::Point_3;
  return CGAL::Multiplanar::make_panel_complex_from_polygons(
      {Point_3(0, 0, 0), Point_3(a, 0, 0), Point_3(a, b, 0), Point_3(0, b, 0), Point_3(0, 0, c), Point_3(a, 0, c),
       Point_3(a, b, c), Point_3(0, b, c)},
      {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}});
}

/// A picture frame of genus 1: the square [0, 6]^2 less [2, 4]^2, from z = 0 to 1. The panels -z and +z have a hole
/// each, then follow the outer and the inner sides.
inline Panel_complex picture_frame()
{
  using CGAL::Multiplanar::Point_3;
  std::vector<Point_3> points;
  for (double z : {0., 1.})
    for (double low : {0., 2.}) {
      const double high = 6 - low;
      points.insert(points.end(),
                    {Point_3(low, low, z), Point_3(high, low, z), Point_3(high, high, z), Point_3(low, high, z)});
    }
  std::vector<std::vector<std::vector<int>>> polygons = {{{0, 3, 2, 1}, {4, 5, 6, 7}},
                                                         {{8, 9, 10, 11}, {12, 15, 14, 13}}};
  for (int i = 0; i < 4; ++i) polygons.push_back({{i, (i + 1) % 4, 8 + (i + 1) % 4, 8 + i}});
  for (int i = 0; i < 4; ++i) polygons.push_back({{4 + (i + 1) % 4, 4 + i, 12 + i, 12 + (i + 1) % 4}});
  return CGAL::Multiplanar::make_panel_complex_from_polygons(points, polygons);
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_PANEL_MODELS_H
