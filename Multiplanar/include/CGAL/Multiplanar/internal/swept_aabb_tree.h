// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SWEPT_AABB_TREE_H
#define CGAL_MULTIPLANAR_INTERNAL_SWEPT_AABB_TREE_H

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Object.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The box of triangle `f` in both of two states of the mesh.
///
/// It holds the triangle in every state in which each vertex lies coordinatewise between its two positions, which all
/// of the guard's states do (see `step_towards()`): whatever the order of moves, no rounding slack is needed.
inline CGAL::Bbox_3 swept_box(const Connectivity& connectivity, const Points& from, const Points& to, int f)
{
  CGAL::Bbox_3 box;
  for (int v : connectivity.triangles[f]) box += from[v].bbox() + to[v].bbox();
  return box;
}

/// A face with its swept box: a model of CGAL's concept `AABBPrimitive`, whose datum is the box.
struct Swept_primitive
{
  using Id = int;
  using Point = Point_3;
  using Datum = CGAL::Bbox_3;

  Swept_primitive() = default;
  Swept_primitive(int face, const CGAL::Bbox_3& box) : face(face), box(box) {}
  const Id& id() const { return face; }
  const Datum& datum() const { return box; }
  Point reference_point() const { return {box.xmin(), box.ymin(), box.zmin()}; }

  int face = -1;
  CGAL::Bbox_3 box;
};

/// The part of CGAL's concept `AABBTraits` that box queries use; primitives and nodes answer by box. CGAL's own
/// `AABB_traits` tests the datum itself, which here is not one triangle but all its states during a pass.
/// The base has what CGAL 6 names for the tree's distance queries, which are not used.
struct Swept_aabb_traits : CGAL::Search_traits_3<Kernel>
{
  using Primitive = Swept_primitive;
  using Bounding_box = CGAL::Bbox_3;
  using FT = Kernel::FT;
  using Point = Multiplanar::Point_3;
  using Point_3 = Multiplanar::Point_3;
  using Point_and_primitive_id = std::pair<Point_3, int>;
  using Object_and_primitive_id = std::pair<CGAL::Object, int>;
  template <class Query>
  struct Intersection_and_primitive_id
  {
    using Type = std::pair<CGAL::Bbox_3, int>;
  };

  // Named by the tree for its distance queries, which are not used.
  using Iso_cuboid_3 = Kernel::Iso_cuboid_3;
  using Sphere_3 = Kernel::Sphere_3;
  using Cartesian_const_iterator_3 = Kernel::Cartesian_const_iterator_3;
  using Construct_cartesian_const_iterator_3 = Kernel::Construct_cartesian_const_iterator_3;
  using Construct_center_3 = Kernel::Construct_center_3;
  using Compute_squared_radius_3 = Kernel::Compute_squared_radius_3;
  using Construct_min_vertex_3 = Kernel::Construct_min_vertex_3;
  using Construct_max_vertex_3 = Kernel::Construct_max_vertex_3;
  using Construct_iso_cuboid_3 = Kernel::Construct_iso_cuboid_3;

  struct Compute_bbox
  {
    template <class Iterator>
    CGAL::Bbox_3 operator()(Iterator first, Iterator beyond) const
    {
      CGAL::Bbox_3 box = first->box;
      for (++first; first != beyond; ++first) box += first->box;
      return box;
    }
  };

  /// Splits at the median of the boxes' centres along the longest axis; equal centres go by face number, so that the
  /// tree depends on nothing but the boxes.
  struct Split_primitives
  {
    template <class Iterator>
    void operator()(Iterator first, Iterator beyond, const CGAL::Bbox_3& box) const
    {
      int axis = 0;
      for (int i = 1; i < 3; ++i)
        if (box.max(i) - box.min(i) > box.max(axis) - box.min(axis)) axis = i;
      std::nth_element(first, first + (beyond - first) / 2, beyond,
                       [axis](const Swept_primitive& left, const Swept_primitive& right) {
                         const double l = left.box.min(axis) + left.box.max(axis);
                         const double r = right.box.min(axis) + right.box.max(axis);
                         return l < r || (l == r && left.face < right.face);
                       });
    }
  };

  struct Do_intersect
  {
    bool operator()(const CGAL::Bbox_3& query, const Primitive& primitive) const
    {
      return CGAL::do_overlap(query, primitive.box);
    }
    bool operator()(const CGAL::Bbox_3& query, const CGAL::Bbox_3& node) const { return CGAL::do_overlap(query, node); }
  };

  Compute_bbox compute_bbox_object() const { return {}; }
  Split_primitives split_primitives_object() const { return {}; }
  Do_intersect do_intersect_object() const { return {}; }
};

using Swept_aabb_tree = CGAL::AABB_tree<Swept_aabb_traits>;

/// Fills `tree` with the faces of `boxes`, numbered by position, and builds it. Queries on the built tree may run in
/// any number of threads. O(F log F).
inline void build_swept_tree(Swept_aabb_tree& tree, const std::vector<CGAL::Bbox_3>& boxes)
{
  tree.clear();
  for (std::size_t f = 0; f < boxes.size(); ++f) tree.insert(Swept_primitive(int(f), boxes[f]));
  tree.build();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SWEPT_AABB_TREE_H
