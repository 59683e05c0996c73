// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_POLYHEDRA_H
#define MULTIPLANAR_TEST_POLYHEDRA_H

#include "meshes.h"

#include <CGAL/Multiplanar/make_panel_complex.h>

#include <CGAL/convex_hull_3.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

/// Closed polygon meshes in mm, as panel complexes.
namespace Multiplanar_test {

using CGAL::Multiplanar::Panel_complex;
using Loops = std::vector<std::vector<int>>; ///< of one panel
using CGAL::Multiplanar::make_panel_complex_from_polygons;

inline double radians(double degrees) { return degrees * std::acos(-1.0) / 180; }

/// Uniform in (0, 1); the same on every platform.
inline double uniform(std::mt19937_64& random) { return (double(random() >> 11) + 0.5) / 9007199254740992.0; }

/// The triangles of a mesh, each a panel, scaled.
inline Panel_complex triangle_panels(const Mesh& mesh, double scale)
{
  std::vector<Loops> panels;
  for (const auto& t : mesh.triangles) panels.push_back({{t[0], t[1], t[2]}});
  return make_panel_complex_from_polygons(
      mapped(mesh, [scale](const Point_3& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); }).points, panels);
}

/// A prism of height h over a polygon with holes in the plane z = 0. Panels: bottom, top, then the sides, side i
/// between corners i and i + 1, loop after loop.
inline Panel_complex prism(const std::vector<std::vector<std::array<double, 2>>>& loops, double h)
{
  Points points;
  for (double z : {0.0, h})
    for (const auto& loop : loops)
      for (const auto& p : loop) points.emplace_back(p[0], p[1], z);
  const int n = int(points.size()) / 2;
  Loops bottom, top;
  std::vector<Loops> sides;
  int first = 0;
  for (const auto& loop : loops) {
    const int m = int(loop.size());
    bottom.emplace_back();
    top.emplace_back();
    for (int i = 0; i < m; ++i) {
      const int a = first + i, b = first + (i + 1) % m;
      top.back().push_back(n + a);
      bottom.back().push_back(first + m - 1 - i);
      sides.push_back({{a, b, n + b, n + a}});
    }
    first += m;
  }
  std::vector<Loops> panels{bottom, top};
  panels.insert(panels.end(), sides.begin(), sides.end());
  return make_panel_complex_from_polygons(points, panels);
}

inline Panel_complex box(double x, double y, double z) { return prism({{{0, 0}, {x, 0}, {x, y}, {0, y}}}, z); }

/// A square ring: genus 1, its top and bottom have a hole.
inline Panel_complex ring(double outer, double inner, double h)
{
  const double a = (outer - inner) / 2, b = (outer + inner) / 2;
  return prism({{{0, 0}, {outer, 0}, {outer, outer}, {0, outer}}, {{a, a}, {a, b}, {b, b}, {b, a}}}, h);
}

inline Panel_complex l_prism(double s, double h)
{
  return prism({{{0, 0}, {2 * s, 0}, {2 * s, s}, {s, s}, {s, 2 * s}, {0, 2 * s}}}, h);
}

/// A prism with interior angle `degrees` at the origin between panel 2 (along +x) and the last panel; `arm` long on
/// either side. The angle lies at the edge over the origin.
inline Panel_complex wedge(double degrees, double arm, double h)
{
  std::vector<std::array<double, 2>> polygon{{0, 0}, {arm, 0}};
  for (double a = 40; degrees > 100 && a < degrees - 20; a += 40)
    polygon.push_back({3 * arm * std::cos(radians(a)), 3 * arm * std::sin(radians(a))});
  polygon.push_back({arm * std::cos(radians(degrees)), arm * std::sin(radians(degrees))});
  return prism({polygon}, h);
}

/// The polyhedron { x : n_i . x <= 1 } scaled by `scale`, for directions whose convex hull contains the origin inside.
/// Corners with more than three panels come out as one.
inline Panel_complex dual_polyhedron(const Points& directions, double scale)
{
  using Hull = CGAL::Surface_mesh<Point_3>;
  Hull hull;
  CGAL::convex_hull_3(directions.begin(), directions.end(), hull);
  Points corners;
  std::map<Hull::Face_index, int> corner_of;
  for (auto f : hull.faces()) {
    std::vector<Vector_3> n;
    for (auto v : hull.vertices_around_face(hull.halfedge(f))) n.push_back(hull.point(v) - CGAL::ORIGIN);
    // n_i . x = 1, i = 0, 1, 2
    const double d = CGAL::determinant(n[0], n[1], n[2]);
    const Point_3 p = CGAL::ORIGIN + (CGAL::cross_product(n[1], n[2]) + CGAL::cross_product(n[2], n[0]) +
                                      CGAL::cross_product(n[0], n[1])) *
                                         (scale / d);
    int found = -1;
    for (std::size_t i = 0; i < corners.size() && found < 0; ++i)
      if (CGAL::squared_distance(corners[i], p) < 1e-18 * scale * scale) found = int(i);
    if (found < 0) found = int(corners.size()), corners.push_back(p);
    corner_of[f] = found;
  }
  std::vector<Loops> panels;
  for (auto v : hull.vertices()) {
    std::vector<int> loop; // faces around v clockwise as seen from outside
    for (auto f : hull.faces_around_target(hull.halfedge(v)))
      if (loop.empty() || (loop.back() != corner_of[f] && loop.front() != corner_of[f])) loop.push_back(corner_of[f]);
    panels.push_back({{loop.rbegin(), loop.rend()}});
  }
  return make_panel_complex_from_polygons(corners, panels);
}

/// n planes tangent to a sphere of radius r.
inline Panel_complex random_convex(int n, double r, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  Points directions;
  while (int(directions.size()) < n) {
    const Vector_3 v(2 * uniform(random) - 1, 2 * uniform(random) - 1, 2 * uniform(random) - 1);
    const double l = std::sqrt(v.squared_length());
    if (l > 0.1 && l < 1) directions.push_back(CGAL::ORIGIN + v / l);
  }
  return dual_polyhedron(directions, r);
}

inline Panel_complex dodecahedron(double r) { return dual_polyhedron(icosahedron().points, r); }

/// n planes spread evenly over the sphere: hexagons and pentagons of about equal size.
inline Panel_complex even_convex(int n, double r)
{
  Points directions;
  for (int i = 0; i < n; ++i) { // Fibonacci's spiral
    const double z = 1 - (2 * i + 1.0) / n, a = i * std::acos(-1.0) * (3 - std::sqrt(5.0)), s = std::sqrt(1 - z * z);
    directions.emplace_back(s * std::cos(a), s * std::sin(a), z);
  }
  return dual_polyhedron(directions, r);
}

/// The octahedron with a pyramid of height `height` on every face: stars for heights above 0.3 r. Every panel is a
/// triangle; the old edges are reflex when the pyramids are steep.
inline Panel_complex stellated(const Mesh& mesh, double height, double r)
{
  Mesh result{mesh.points, {}};
  for (const auto& t : mesh.triangles) {
    const Point_3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vector_3 n = CGAL::cross_product(b - a, c - a);
    const int tip = int(result.points.size());
    result.points.push_back(CGAL::centroid(a, b, c) + n * (height / std::sqrt(n.squared_length())));
    for (int i = 0; i < 3; ++i) result.triangles.push_back({t[i], t[(i + 1) % 3], tip});
  }
  return triangle_panels(result, r);
}

/// The same model turned, so that nothing is parallel to an axis.
inline Panel_complex turned(Panel_complex complex)
{
  const double a = 0.7, b = 0.4;
  const auto turn = [&](const Vector_3& v) {
    const Vector_3 w(std::cos(a) * v.x() - std::sin(a) * v.y(), std::sin(a) * v.x() + std::cos(a) * v.y(), v.z());
    return Vector_3(w.x(), std::cos(b) * w.y() - std::sin(b) * w.z(), std::sin(b) * w.y() + std::cos(b) * w.z());
  };
  for (auto& c : complex.corners) c.point = CGAL::ORIGIN + turn(c.point - CGAL::ORIGIN) + Vector_3(3, 5, -7);
  for (auto& p : complex.panels) {
    p.plane.normal = turn(p.plane.normal);
    const auto corner = complex.corners[complex.source(p.loops[0][0])].point;
    p.plane.offset = p.plane.normal * (corner - CGAL::ORIGIN);
  }
  return complex;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_POLYHEDRA_H
