// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cstdio>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Triangle = Repair_mesh::Triangle;

constexpr double openings = 60;  ///< the diagonal over the widest opening that the wrap does not enter
constexpr double closeness = 30; ///< that opening over the distance of the wrap

} // namespace

void wrap(Repair_mesh& mesh)
{
  std::vector<Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const Triangle& t : mesh.triangles) polygons.emplace_back(t.begin(), t.end());
  const double alpha = mesh.diagonal() / openings, offset = alpha / closeness;
  Surface_mesh surface;
  CGAL::alpha_wrap_3(points, polygons, alpha, offset, surface);

  mesh.points.clear();
  for (auto v : surface.vertices()) {
    const Point_3& p = surface.point(v);
    mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  mesh.triangles.clear();
  for (auto f : surface.faces()) {
    Triangle t{};
    std::size_t i = 0;
    for (auto v : surface.vertices_around_face(surface.halfedge(f))) t[i++ % 3] = int(v);
    mesh.triangles.push_back(t);
  }
  mesh.corners.assign(mesh.triangles.size(), {Repair_mesh::no_corner, Repair_mesh::no_corner, Repair_mesh::no_corner});
  char text[200];
  std::snprintf(text, sizeof text,
                "wrapped the mesh in a new surface of %zu triangles, %g away from it; openings narrower than %g closed",
                mesh.triangles.size(), offset, alpha);
  mesh.say(text);
}
