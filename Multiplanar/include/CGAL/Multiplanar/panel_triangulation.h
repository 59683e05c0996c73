// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_TRIANGULATION_H
#define CGAL_MULTIPLANAR_PANEL_TRIANGULATION_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/simple_polygons.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The constrained Delaunay triangles of a polygon with holes, as positions in the concatenation of its loops.
/// \pre `is_polygon_with_holes(loops)`
inline std::vector<std::array<int, 3>> triangulate_polygon(const std::vector<Polygon_loop>& loops)
{
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
  Triangulation cdt;
  std::set<std::pair<int, int>> sides; // directed, polygon on the left
  int first = 0;
  for (const auto& loop : loops) {
    std::vector<Triangulation::Vertex_handle> handles;
    const int n = int(loop.size());
    for (int i = 0; i < n; ++i) {
      handles.push_back(cdt.insert(loop[i]));
      handles.back()->info() = first + i;
    }
    for (int i = 0; i < n; ++i) {
      cdt.insert_constraint(handles[i], handles[(i + 1) % n]);
      sides.insert({first + i, first + (i + 1) % n});
    }
    first += n;
  }
  // The faces inside are those reached from the left of a side without crossing one.
  std::set<Triangulation::Face_handle> inside;
  std::vector<Triangulation::Face_handle> stack;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    for (int i = 0; i < 3; ++i)
      if (sides.count({f->vertex(cdt.ccw(i))->info(), f->vertex(cdt.cw(i))->info()}) && inside.insert(f).second)
        stack.push_back(f);
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
      if (!f->is_constrained(i) && inside.insert(f->neighbor(i)).second) stack.push_back(f->neighbor(i));
  }
  std::vector<std::array<int, 3>> result;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (inside.count(f)) result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

/// The corners of panel `p`, projected along its normal's largest coordinate.
inline std::vector<Polygon_loop> projected_loops(const Panel_complex& complex, int p)
{
  const Vector_3& n = complex.panels[p].plane.normal;
  const Axis_projection project(Vec3(n.x(), n.y(), n.z()));
  std::vector<Polygon_loop> loops;
  for (const auto& loop : complex.panels[p].loops) {
    loops.emplace_back();
    for (int c : complex.loop_corners(loop)) loops.back().push_back(project(as_vec(complex.corners[c].point)));
  }
  return loops;
}

} // namespace internal

/// \ingroup PkgMultiplanarComplex
/// Is panel `p` a polygon with holes, counter-clockwise seen from outside? Decided exactly on the corners as written,
/// seen along the largest coordinate of the panel's normal.
inline bool is_simple_panel(const Panel_complex& complex, int p)
{
  for (const auto& loop : complex.panels[p].loops)
    if (complex.edges[loop[0].edge].is_closed()) return false;
  return internal::is_polygon_with_holes(internal::projected_loops(complex, p));
}

/// Triangles over the corners of a complex, and the panel that each belongs to.
struct Panel_triangulation
{
  std::vector<std::array<int, 3>> triangles; ///< over the corners of the complex, counter-clockwise from outside
  std::vector<int> panels;                   ///< by triangle
};

/*!
\ingroup PkgMultiplanarComplex

Triangulates all panels (constrained Delaunay, no new vertices): the result is combinatorially closed, each edge of the
complex lying between two triangles.

\pre `is_simple_panel()` for every panel

Expected n log n in the number of corners.
*/
inline Panel_triangulation triangulate_panels(const Panel_complex& complex)
{
  Panel_triangulation result;
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    CGAL_precondition(is_simple_panel(complex, p));
    std::vector<int> corners;
    for (const auto& loop : complex.panels[p].loops)
      for (int c : complex.loop_corners(loop)) corners.push_back(c);
    for (const auto& t : internal::triangulate_polygon(internal::projected_loops(complex, p))) {
      result.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
      result.panels.push_back(p);
    }
  }
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_TRIANGULATION_H
