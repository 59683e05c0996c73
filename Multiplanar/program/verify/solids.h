// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_SOLIDS_H
#define MULTIPLANAR_VERIFY_SOLIDS_H

#include "erosion.h"
#include "polytope.h"

#include <optional>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// Parts are eroded by this many mm before they are compared.
constexpr double erosion_depth = 1e-3;

/// A part as a solid, eroded from all sides, as a union of prisms over the triangles of its eroded region.
struct Solid
{
  const Written_part* part;
  double low, high; ///< the range of z left over
  std::vector<Eroded_triangle> triangles;
  std::vector<Body> bodies; ///< by triangle
  CGAL::Bbox_3 box;

  /// The prisms moved along 0..`sweep`.
  std::vector<Body> swept(const Vector_3& sweep) const;
};

/// \pre the part's region has no problem (problem_of_region)
Solid make_solid(const Written_part& part, double thickness);

/// Two bodies that meet, with how deep, for messages.
struct Contact
{
  Point_3 middle;
  double depth;
};

/// Whether bodies of the one list meet bodies of the other, and where they do so deepest.
std::optional<Contact> find_contact(const std::vector<Body>& a, const std::vector<Body>& b);

CGAL::Bbox_3 box_of(const std::vector<Body>& bodies);

/// The triangles that bound the model: the panels of model.json, each cut into triangles.
struct Boundary
{
  struct Triangle
  {
    int panel;
    std::array<int, 3> corners;
  };
  const Written_model* model;
  std::vector<Triangle> triangles;

  const Point_3& point(const Triangle& t, int i) const { return model->corners[t.corners[i]]; }
  /// Is p inside? Exact. \pre closed, free of intersections
  bool contains(const Point_3& p) const;
};

/// The projection of a panel's loops along the largest coordinate of its normal: no digits are lost, and what is
/// counter-clockwise stays so.
std::vector<Loop> projected_loops(const Written_model& model, const Written_panel& panel);

/// \pre the loops of every panel, projected, bound a region
Boundary make_boundary(const Written_model& model);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_SOLIDS_H
