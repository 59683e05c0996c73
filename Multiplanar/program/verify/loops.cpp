// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "loops.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Multiplanar {
namespace verification {

bool is_simple(const Loop& loop)
{
  if (loop.size() < 3) return false;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (loop[i] == loop[(i + 1) % loop.size()]) return false;
  return CGAL::Polygon_2<Kernel>(loop.begin(), loop.end()).is_simple();
}

bool is_counter_clockwise(const Loop& loop)
{
  return CGAL::orientation_2(loop.begin(), loop.end(), Kernel()) == CGAL::COUNTERCLOCKWISE;
}

int side_of(const Loop& loop, const Point_2& p)
{
  switch (CGAL::bounded_side_2(loop.begin(), loop.end(), p, Kernel())) {
  case CGAL::ON_BOUNDED_SIDE:
    return 1;
  case CGAL::ON_BOUNDARY:
    return 0;
  default:
    return -1;
  }
}

bool boundaries_meet(const Loop& a, const Loop& b)
{
  if (!CGAL::do_overlap(box_of(a), box_of(b))) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Kernel::Segment_2 s(a[i], a[(i + 1) % a.size()]);
    const CGAL::Bbox_2 box = s.bbox();
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Kernel::Segment_2 t(b[j], b[(j + 1) % b.size()]);
      if (CGAL::do_overlap(box, t.bbox()) && CGAL::do_intersect(s, t)) return true;
    }
  }
  return false;
}

std::string problem_of_region(const Loop& outline, const std::vector<Loop>& holes)
{
  if (!is_simple(outline)) return "the outline is not a simple polygon";
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string name = "hole " + std::to_string(i + 1);
    if (!is_simple(holes[i])) return name + " is not a simple polygon";
    if (boundaries_meet(outline, holes[i])) return name + " meets the outline";
    if (side_of(outline, holes[i][0]) != 1) return name + " lies outside the outline";
    for (std::size_t j = 0; j < i; ++j)
      if (boundaries_meet(holes[i], holes[j]) || side_of(holes[i], holes[j][0]) == 1 ||
          side_of(holes[j], holes[i][0]) == 1)
        return name + " meets hole " + std::to_string(j + 1);
  }
  return "";
}

namespace {

using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face_info = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel, Face_info>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                               CGAL::No_constraint_intersection_tag>;

void insert_loop(Triangulation& t, const Loop& loop, int first)
{
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    vertices.push_back(t.insert(loop[i]));
    vertices.back()->info() = first + int(i);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    t.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
}

/// Writes into every face 1 if an odd number of constraints parts it from infinity, else 0: inside or outside.
void find_inside(Triangulation& t)
{
  for (auto f : t.all_face_handles()) f->info() = -1;
  std::vector<Triangulation::Face_handle> stack = {t.infinite_face()};
  t.infinite_face()->info() = 0;
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto g = f->neighbor(i);
      if (g->info() >= 0) continue;
      g->info() = f->is_constrained(i) ? 1 - f->info() : f->info();
      stack.push_back(g);
    }
  }
}

} // namespace

std::vector<std::array<int, 3>> triangulate_region(const Loop& outline, const std::vector<Loop>& holes)
{
  Triangulation t;
  insert_loop(t, outline, 0);
  int first = int(outline.size());
  for (const Loop& hole : holes) {
    insert_loop(t, hole, first);
    first += int(hole.size());
  }
  find_inside(t);
  std::vector<std::array<int, 3>> triangles;
  for (auto f : t.finite_face_handles())
    if (f->info() == 1) triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

CGAL::Bbox_2 box_of(const Loop& loop) { return loop.empty() ? CGAL::Bbox_2() : CGAL::bbox_2(loop.begin(), loop.end()); }

double signed_area(const Loop& loop)
{
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += (loop[i].x() - loop[0].x()) * (loop[i + 1].y() - loop[0].y()) -
           (loop[i].y() - loop[0].y()) * (loop[i + 1].x() - loop[0].x());
  return sum / 2;
}

double distance(const Point_2& p, const Point_2& a, const Point_2& b)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), px = p.x() - a.x(), py = p.y() - a.y();
  const double length2 = dx * dx + dy * dy;
  const double s = length2 > 0 ? (std::min)(1.0, (std::max)(0.0, (px * dx + py * dy) / length2)) : 0.0;
  return std::hypot(px - s * dx, py - s * dy);
}

double distance(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d)
{
  if (CGAL::do_intersect(Kernel::Segment_2(a, b), Kernel::Segment_2(c, d))) return 0;
  return (std::min)({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

double distance_to_boundary(const Point_2& p, const Loop& loop)
{
  double least = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i)
    least = (std::min)(least, distance(p, loop[i], loop[(i + 1) % loop.size()]));
  return least;
}

Loop oriented(Loop loop, bool counter_clockwise)
{
  if (is_counter_clockwise(loop) != counter_clockwise) std::reverse(loop.begin(), loop.end());
  return loop;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
