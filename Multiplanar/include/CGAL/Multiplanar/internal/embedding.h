// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_EMBEDDING_H
#define CGAL_MULTIPLANAR_INTERNAL_EMBEDDING_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/swept_aabb_tree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// The whole-mesh check of what guarded motion promises. It shares only the box tree with it: contacts are decided by
// CGAL's own do_intersect.

/// Do the triangles (a, b, c) and (a, b, d) meet in the edge ab only?
/// \pre neither has zero area.
inline bool meet_in_edge_only(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
{
  return CGAL::orientation(a, b, c, d) != CGAL::COPLANAR || CGAL::coplanar_orientation(a, b, c, d) == CGAL::NEGATIVE;
}

/// Do the triangles (a, b, c) and (a, v, w) meet in the vertex a only?
/// A common ray from a leaves one of them first, in a point of its edge opposite a.
/// \pre neither has zero area.
inline bool meet_in_vertex_only(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& v,
                                const Point_3& w)
{
  return !CGAL::do_intersect(Kernel::Segment_3(b, c), Kernel::Triangle_3(a, v, w)) &&
         !CGAL::do_intersect(Kernel::Segment_3(v, w), Kernel::Triangle_3(a, b, c));
}

/// Do two faces meet exactly in their shared simplex? Exact.
/// \pre the faces differ and have positive area.
inline bool meet_in_shared_simplex(const Points& points, const Connectivity::Triangle& t,
                                   const Connectivity::Triangle& s)
{
  int shared = 0, sum_i = 0, sum_j = 0; // of the positions of the shared vertices
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (t[i] == s[j]) ++shared, sum_i += i, sum_j += j;
  if (shared == 0)
    return !CGAL::do_intersect(Kernel::Triangle_3(points[t[0]], points[t[1]], points[t[2]]),
                               Kernel::Triangle_3(points[s[0]], points[s[1]], points[s[2]]));
  if (shared == 1)
    return meet_in_vertex_only(points[t[sum_i]], points[t[(sum_i + 1) % 3]], points[t[(sum_i + 2) % 3]],
                               points[s[(sum_j + 1) % 3]], points[s[(sum_j + 2) % 3]]);
  if (shared == 2) {
    const int i = 3 - sum_i, j = 3 - sum_j; // the opposite vertices
    return meet_in_edge_only(points[t[(i + 1) % 3]], points[t[(i + 2) % 3]], points[t[i]], points[s[j]]);
  }
  return false;
}

/// Two faces that meet outside their shared simplex, or twice the same face if its area is zero or a coordinate is not
/// finite; nothing if the mesh is embedded. Always finds the same fault. Exact; expected O(F log F).
inline std::optional<std::pair<int, int>> find_embedding_fault(const Connectivity& connectivity, const Points& points)
{
  CGAL_precondition(int(points.size()) == connectivity.number_of_vertices());
  const int faces = connectivity.number_of_faces();
  if (faces == 0) return std::nullopt;
  for (int f = 0; f < faces; ++f) {
    const auto& t = connectivity.triangles[f];
    for (int v : t)
      for (int i = 0; i < 3; ++i)
        if (!std::isfinite(points[v][i])) return std::make_pair(f, f);
    if (CGAL::collinear(points[t[0]], points[t[1]], points[t[2]])) return std::make_pair(f, f);
  }
  std::vector<CGAL::Bbox_3> boxes(faces);
  for (int f = 0; f < faces; ++f) boxes[f] = swept_box(connectivity, points, points, f);
  Swept_aabb_tree tree;
  build_swept_tree(tree, boxes);
  std::vector<int> order; // that of the tree: faces asked for in turn are near each other, and in the cache
  tree.all_intersected_primitives(tree.bbox(), std::back_inserter(order));
  for (int f : order) {
    int fault = -1;
    const auto test = [&](int g) {
      if (g > f && fault < 0 && !meet_in_shared_simplex(points, connectivity.triangles[f], connectivity.triangles[g]))
        fault = g;
    };
    tree.all_intersected_primitives(boxes[f], boost::make_function_output_iterator(test));
    if (fault >= 0) return std::make_pair(f, fault);
  }
  return std::nullopt;
}

/// Do any two faces meet exactly in their shared simplex, and has every face a positive area? Exact.
inline bool is_embedded(const Connectivity& connectivity, const Points& points)
{
  return !find_embedding_fault(connectivity, points);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_EMBEDDING_H
