// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangulate_faces.h"
#include "failure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;   // info: corner of the face
using Info_face_base = CGAL::Triangulation_face_base_with_info_2<bool, Kernel>; // info: outside the polygon
using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel, Info_face_base>;
using Triangulation_data = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Triangulation_data, CGAL::No_constraint_intersection_tag>;

/// Newell's normal of a polygon, relative to its first vertex.
std::array<double, 3> mean_normal(const Polygon_soup& soup, int f)
{
  const int n = soup.face_size(f);
  const auto& o = soup.points[soup.face(f)[0]];
  std::array<double, 3> normal{};
  for (int i = 1; i + 1 < n; ++i) {
    const auto &p = soup.points[soup.face(f)[i]], &q = soup.points[soup.face(f)[i + 1]];
    for (int k = 0; k < 3; ++k) {
      const int u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] += (p[u] - o[u]) * (q[v] - o[v]) - (p[v] - o[v]) * (q[u] - o[u]);
    }
  }
  return normal;
}

/// The face seen along the coordinate axis nearest to its normal; exact copies of two coordinates, counter-clockwise.
std::vector<Point_2> project(const Polygon_soup& soup, int f)
{
  const std::array<double, 3> normal = mean_normal(soup, f);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Point_2> polygon;
  for (int i = 0; i < soup.face_size(f); ++i) {
    const auto& p = soup.points[soup.face(f)[i]];
    polygon.emplace_back(p[u], p[v]);
  }
  return polygon;
}

/// Marks what can be reached from the infinite face without crossing the polygon.
void mark_outside(Triangulation& t)
{
  for (auto face : t.all_face_handles()) face->info() = false;
  std::vector<Triangulation::Face_handle> stack(1, t.infinite_face());
  while (!stack.empty()) {
    const auto face = stack.back();
    stack.pop_back();
    if (face->info()) continue;
    face->info() = true;
    for (int i = 0; i < 3; ++i)
      if (!face->is_constrained(i)) stack.push_back(face->neighbor(i));
  }
}

/// \param corners of face `f`, counted from 0
void add_triangle(const Polygon_soup& soup, int f, const std::array<int, 3>& corners, Triangulated_faces& result)
{
  const int* face = soup.face(f);
  const int first = int(soup.face_begin[f]);
  result.triangles.push_back({face[corners[0]], face[corners[1]], face[corners[2]]});
  result.corners.push_back({first + corners[0], first + corners[1], first + corners[2]});
  result.face_of_triangle.push_back(f);
}

void split_face(const Polygon_soup& soup, int f, const std::string& name, Triangulated_faces& result)
{
  const std::vector<Point_2> polygon = project(soup, f);
  const CGAL::Polygon_2<Kernel> outline(polygon.begin(), polygon.end());
  if (!outline.is_simple() || !outline.is_counterclockwise_oriented())
    throw input_error(name + ": face " + std::to_string(f) + " with " + std::to_string(polygon.size()) +
                      " vertices cannot be triangulated: it crosses itself or has no area: split it first");
  Triangulation t;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    vertices.push_back(t.insert(polygon[i]));
    vertices.back()->info() = int(i);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    t.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  mark_outside(t);
  for (auto face : t.finite_face_handles())
    if (!face->info())
      add_triangle(soup, f, {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}, result);
}

} // namespace

Triangulated_faces triangulate_faces(const Polygon_soup& soup, const std::string& name)
{
  Triangulated_faces result;
  result.triangles.reserve(soup.number_of_faces());
  result.face_of_triangle.reserve(soup.number_of_faces());
  result.corners.reserve(soup.number_of_faces());
  for (int f = 0; f < soup.number_of_faces(); ++f)
    if (soup.face_size(f) == 3) add_triangle(soup, f, {0, 1, 2}, result);
    else split_face(soup, f, name, result);
  return result;
}
