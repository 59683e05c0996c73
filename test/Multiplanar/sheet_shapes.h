// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_SHEET_SHAPES_H
#define MULTIPLANAR_TEST_SHEET_SHAPES_H

#include <CGAL/Multiplanar/Part.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

// Outlines for the tests of sheets, and what is measured on them.

namespace Multiplanar_test {

using CGAL::Multiplanar::Kernel;
using CGAL::Multiplanar::Outline;
using CGAL::Multiplanar::Part;
using CGAL::Multiplanar::Point_2;

constexpr double pi = 3.14159265358979323846;

inline Outline rectangle(double w, double h) { return {Point_2(0, 0), Point_2(w, 0), Point_2(w, h), Point_2(0, h)}; }

inline Outline reversed(Outline outline)
{
  std::reverse(outline.begin(), outline.end());
  return outline;
}

inline Outline moved(Outline outline, double x, double y)
{
  for (Point_2& p : outline) p = Point_2(p.x() + x, p.y() + y);
  return outline;
}

/// A star-shaped polygon: simple, concave as a rule.
inline Outline random_star(std::mt19937_64& random, int n, double size)
{
  Outline outline;
  for (int i = 0; i < n; ++i) {
    const double radius = size * (0.2 + double(random() % 1000) / 1250), angle = 2 * pi * i / n;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

inline Part part(const std::string& id, const Outline& outline)
{
  Part p;
  p.id = id;
  p.outline = outline;
  return p;
}

inline double squared_distance_to(const Point_2& p, const std::vector<Outline>& loops)
{
  double nearest = 1e300;
  for (const Outline& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      nearest = std::min(nearest, CGAL::squared_distance(p, Kernel::Segment_2(loop[i], loop[(i + 1) % loop.size()])));
  return nearest;
}

inline double squared_distance_between(const Outline& a, const Outline& b)
{
  double nearest = 1e300;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      nearest = std::min(nearest, CGAL::squared_distance(Kernel::Segment_2(a[i], a[(i + 1) % a.size()]),
                                                         Kernel::Segment_2(b[j], b[(j + 1) % b.size()])));
  return nearest;
}

inline bool contains(const Outline& loop, const Point_2& p)
{
  return CGAL::bounded_side_2(loop.begin(), loop.end(), p, Kernel()) == CGAL::ON_BOUNDED_SIDE;
}

inline double length(const Outline& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
  return sum;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_SHEET_SHAPES_H
