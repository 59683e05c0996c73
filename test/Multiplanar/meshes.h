// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_MESHES_H
#define MULTIPLANAR_TEST_MESHES_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Closed triangle meshes for tests, all with outward orientation. Everything is computed from the arguments alone,
/// so two calls give bitwise equal meshes.
namespace Multiplanar_test {

using CGAL::Multiplanar::Point_3;
using CGAL::Multiplanar::Points;
using CGAL::Multiplanar::Vector_3;

struct Mesh
{
  Points points;
  std::vector<std::array<int, 3>> triangles;
};

/// Signed volume: positive when the triangles of a closed mesh are oriented outward.
inline double volume(const Mesh& mesh)
{
  double six_volumes = 0;
  for (const auto& t : mesh.triangles)
    six_volumes += CGAL::determinant(mesh.points[t[0]] - CGAL::ORIGIN, mesh.points[t[1]] - CGAL::ORIGIN,
                                     mesh.points[t[2]] - CGAL::ORIGIN);
  return six_volumes / 6;
}

/// Replaces every point p by f(p).
template <class F>
Mesh mapped(Mesh mesh, F f)
{
  for (Point_3& p : mesh.points) p = f(p);
  return mesh;
}

/// Scaled to unit bounding-box diagonal, centre of the box at the origin.
inline Mesh normalised(Mesh mesh)
{
  std::array<double, 3> low, high;
  low.fill(1e300);
  high.fill(-1e300);
  for (const Point_3& p : mesh.points)
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  const Point_3 a(low[0], low[1], low[2]), b(high[0], high[1], high[2]);
  const Point_3 centre = CGAL::midpoint(a, b);
  const double scale = 1 / std::sqrt(CGAL::squared_distance(a, b));
  return mapped(std::move(mesh), [&](const Point_3& p) { return CGAL::ORIGIN + scale * (p - centre); });
}

/// The corners (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1): the regular tetrahedron of edge 2 sqrt(2).
inline Mesh tetrahedron()
{
  return {{Point_3(1, 1, 1), Point_3(1, -1, -1), Point_3(-1, 1, -1), Point_3(-1, -1, 1)},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Mesh octahedron()
{
  return {
      {Point_3(1, 0, 0), Point_3(-1, 0, 0), Point_3(0, 1, 0), Point_3(0, -1, 0), Point_3(0, 0, 1), Point_3(0, 0, -1)},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// The cube [-1, 1]^3, each side an n x n grid of squares of two triangles: 12 n^2 faces. The faces of a side are
/// consecutive, in the order +x, -x, +y, -y, +z, -z: face f lies on side f / (2 n^2). The coordinates are exact
/// multiples of 2/n when n is a power of two.
inline Mesh cube(int n = 1)
{
  Mesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = index.emplace(p, int(mesh.points.size()));
    if (found.second) mesh.points.emplace_back(2. * p[0] / n - 1, 2. * p[1] / n - 1, 2. * p[2] / n - 1);
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {n, 0}) {
      // (u, v, outer normal) is right-handed on the positive side: swap u and v on the negative one.
      int u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (side == 0) std::swap(u, v);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> p;
            p[axis] = side;
            p[u] = i + di;
            p[v] = j + dj;
            return vertex(p);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
    }
  return mesh;
}

inline Mesh icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2, r = std::sqrt(1 + g * g), a = 1 / r, b = g / r;
  return {{Point_3(-a, b, 0), Point_3(a, b, 0), Point_3(-a, -b, 0), Point_3(a, -b, 0), Point_3(0, -a, b),
           Point_3(0, a, b), Point_3(0, -a, -b), Point_3(0, a, -b), Point_3(b, 0, -a), Point_3(b, 0, a),
           Point_3(-b, 0, -a), Point_3(-b, 0, a)},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Each face of `mesh` split into n^2 triangles by a regular grid; the vertices stay on the flat faces.
inline Mesh subdivided(const Mesh& mesh, int n)
{
  Mesh result;
  std::map<std::array<std::pair<int, int>, 3>, int>
      index; // (old vertex, weight) in sorted order, zero weights as (-1, 0)
  for (const auto& t : mesh.triangles) {
    const auto vertex = [&](int i, int j) { // weights n - i - j, i, j
      const std::array<int, 3> w = {n - i - j, i, j};
      std::array<std::pair<int, int>, 3> key;
      for (int k = 0; k < 3; ++k) key[k] = w[k] == 0 ? std::make_pair(-1, 0) : std::make_pair(t[k], w[k]);
      std::sort(key.begin(), key.end());
      const auto found = index.emplace(key, int(result.points.size()));
      if (found.second) {
        Vector_3 sum(0, 0, 0);
        for (const auto& k : key)
          if (k.second != 0) sum = sum + (double(k.second) / n) * (mesh.points[k.first] - CGAL::ORIGIN);
        result.points.push_back(CGAL::ORIGIN + sum);
      }
      return found.first->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        result.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < n) result.triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
  return result;
}

/// The unit sphere as an icosahedron whose faces are split into n^2 triangles each: 20 n^2 faces, 10 n^2 + 2 vertices.
inline Mesh geodesic_sphere(int n)
{
  return mapped(subdivided(icosahedron(), n), [](const Point_3& p) {
    const Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  });
}

/// The unit sphere with 20 * 4^level faces.
inline Mesh icosphere(int level) { return geodesic_sphere(1 << level); }

/// A unit sphere whose radius is modulated smoothly by `height`: no symmetry, embedded for |height| < 0.3.
inline Mesh bumpy(Mesh sphere, double height = 0.15)
{
  return mapped(std::move(sphere), [height](const Point_3& p) {
    const double bump =
        std::sin(3 * p.x() + 0.4) * std::cos(2.5 * p.y() - 0.7) + 0.6 * std::sin(4 * p.z() + 1.1 * p.x() + 0.2);
    return CGAL::ORIGIN + (1 + height * bump) * (p - CGAL::ORIGIN);
  });
}

/// `bumpy` on a geodesic sphere of 20 n^2 faces.
inline Mesh bumpy_sphere(int n, double height = 0.15) { return bumpy(geodesic_sphere(n), height); }

/// A torus around the z axis, n squares around the axis and m around the tube (n, m >= 3): 2 n m faces, genus 1.
inline Mesh torus(int n, int m, double radius = 1, double tube = 0.4)
{
  Mesh mesh;
  const double turn = 2 * std::acos(-1.);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = turn * i / n, b = turn * j / m, r = radius + tube * std::cos(b);
      mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
    }
  const auto vertex = [&](int i, int j) { return (i % n) * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

/// Reads a triangle mesh in OFF format. Comments (#) are skipped; faces with more than three vertices become fans.
/// \throws std::runtime_error if the file cannot be read.
inline Mesh read_off(const std::string& path)
{
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path);
  std::stringstream in;
  for (std::string line; std::getline(file, line);) in << line.substr(0, line.find('#')) << '\n';
  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  if (!(in >> magic >> points >> faces >> edges) || magic != "OFF")
    throw std::runtime_error("not an OFF file: " + path);
  Mesh mesh;
  mesh.points.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    double x, y, z;
    if (!(in >> x >> y >> z)) throw std::runtime_error("vertices are missing in " + path);
    mesh.points.emplace_back(x, y, z);
  }
  for (std::size_t i = 0; i < faces; ++i) {
    int size = 0;
    if (!(in >> size) || size < 3) throw std::runtime_error("faces are missing in " + path);
    std::vector<int> face(size);
    for (int& v : face)
      if (!(in >> v) || v < 0 || std::size_t(v) >= points) throw std::runtime_error("bad vertex index in " + path);
    std::string rest_of_line; // a colour may follow
    std::getline(in, rest_of_line);
    for (int j = 1; j + 1 < size; ++j) mesh.triangles.push_back({face[0], face[j], face[j + 1]});
  }
  return mesh;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_MESHES_H
