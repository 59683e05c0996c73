// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_EXAMPLES_PAINTED_SPHERE_H
#define MULTIPLANAR_EXAMPLES_PAINTED_SPHERE_H

#include <CGAL/Multiplanar/internal/kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <array>
#include <cmath>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Multiplanar::Point_3>;
using Triangles = std::vector<std::array<int, 3>>;

inline Mesh unit_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, CGAL::Multiplanar::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for (auto v : mesh.vertices()) {
    const CGAL::Multiplanar::Vector_3 d = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + d / std::sqrt(d.squared_length());
  }
  return mesh;
}

/// The sphere as arrays, and for each face the height of its centroid.
struct Sphere
{
  CGAL::Multiplanar::Points points;
  Triangles triangles, half[2]; ///< all, the lower ones, the upper ones
  std::vector<double> height;

  explicit Sphere(const Mesh& mesh)
  {
    for (auto v : mesh.vertices()) points.push_back(mesh.point(v));
    for (auto f : mesh.faces()) {
      std::array<int, 3> t;
      double z = 0;
      int i = 0;
      for (auto v : vertices_around_face(mesh.halfedge(f), mesh)) {
        z += mesh.point(v).z() / 3;
        t[i++] = int(v);
      }
      triangles.push_back(t);
      half[z > 0].push_back(t);
      height.push_back(z);
    }
  }
};

#endif // MULTIPLANAR_EXAMPLES_PAINTED_SPHERE_H
