// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_GUARD_FUZZ_MESHES_H
#define MULTIPLANAR_TEST_GUARD_FUZZ_MESHES_H

#include "meshes.h"

#include <cmath>
#include <vector>

/// Small embedded meshes whose triangles are close to each other, to degeneracy, or to both. All coordinates are
/// multiples of a power of two with few bits.
namespace Multiplanar_test {

inline Mesh rounded(Mesh mesh, double scale)
{
  return mapped(std::move(mesh), [scale](const Point_3& p) {
    return Point_3(std::round(p.x() * scale), std::round(p.y() * scale), std::round(p.z() * scale));
  });
}

/// Two apexes over a polygon of 2n vertices that almost lies on a line: every triangle of the two stars is a needle,
/// neighbours are almost coplanar, and the whole is 2 units thick and `length` long.
inline Mesh needle_star(int n, int length)
{
  Mesh mesh;
  for (int side : {-1, 1})
    for (int i = 0; i < n; ++i) {
      const int j = side < 0 ? i : n - 1 - i;
      // A slight bulge, so that no three consecutive vertices of the polygon are on a line.
      mesh.points.emplace_back(j * length, side * (2 + j * (n - 1 - j)), (i % 3) - 1);
    }
  const int top = int(mesh.points.size()), bottom = top + 1;
  mesh.points.emplace_back((n - 1) * length / 2, 0, 3);
  mesh.points.emplace_back((n - 1) * length / 2, 0, -3);
  for (int i = 0; i < 2 * n; ++i) {
    mesh.triangles.push_back({i, (i + 1) % (2 * n), top});
    mesh.triangles.push_back({(i + 1) % (2 * n), i, bottom});
  }
  return mesh;
}

/// A place of a ribbon: its left and right ends in the plane z = 0.
struct Section
{
  double left[2], right[2];
};

/// A closed tube of four sides through `sections`, from z = 0 to `height`.
inline Mesh ribbon(const std::vector<Section>& sections, double height)
{
  Mesh mesh;
  for (const Section& s : sections) {
    mesh.points.emplace_back(s.left[0], s.left[1], 0);
    mesh.points.emplace_back(s.right[0], s.right[1], 0);
    mesh.points.emplace_back(s.right[0], s.right[1], height);
    mesh.points.emplace_back(s.left[0], s.left[1], height);
  }
  const int end = 4 * (int(sections.size()) - 1);
  for (int s = 0; s < end; s += 4)
    for (int i = 0; i < 4; ++i) {
      const int a = s + i, b = s + (i + 1) % 4, c = b + 4, d = a + 4;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  mesh.triangles.push_back({0, 2, 1});
  mesh.triangles.push_back({0, 3, 2});
  mesh.triangles.push_back({end, end + 1, end + 2});
  mesh.triangles.push_back({end, end + 2, end + 3});
  return mesh;
}

/// A ribbon folded onto itself: `layers` sheets of thickness `width`, the same distance apart, `length` long.
inline Mesh folded_sheet(int layers, double length, double width)
{
  std::vector<Section> sections;
  double turn = 1; // +1 where the ribbon goes towards +x, its right side below
  for (int i = 0; i < layers; ++i, turn = -turn) {
    const double low = 2 * width * i, high = low + width;
    const double left = turn > 0 ? high : low, right = turn > 0 ? low : high;
    const double from = turn > 0 ? 0 : length, to = length - from;
    for (double x : {from, length / 2, to}) sections.push_back({{x, left}, {x, right}});
    if (i + 1 == layers) break;
    const double inner = to + turn * width, outer = to + turn * 3 * width, middle = high + width / 2;
    if (turn > 0) sections.push_back({{inner, middle}, {outer, middle}});
    else sections.push_back({{outer, middle}, {inner, middle}});
  }
  return ribbon(sections, length);
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_GUARD_FUZZ_MESHES_H
