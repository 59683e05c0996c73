// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_EROSION_H
#define MULTIPLANAR_VERIFY_EROSION_H

#include "written_model.h"

#include <array>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// A triangle of an eroded region, and the connected piece of the region that it belongs to.
struct Eroded_triangle
{
  std::array<Point_2, 3> vertices; ///< counter-clockwise
  int piece;
};

/*!
Triangles that fill a region A eroded by a small octagon K: the points x with x + K inside A.

Notation: A is bounded by `outline` and `holes`, eps = `depth`, K is a regular octagon around the origin with inradius
eps (1 + 1e-4) and circumradius r = 1.0824 eps (1 + 1e-4).

Promise: let E(d) be the points of A at distance more than d from the boundary of A. Then the interior of the result
lies in E(eps), and it covers E(r) but for slivers thinner than 1e-9. So shrinking each convex piece by itself, which is
unsound where pieces meet, is avoided: the erosion is that of A as a whole, and the triangles only fill it.

Method: the boundary of the eroded region lies on the inward translates of the sides of A by that corner of K which is
farthest inward, and on copies of arcs of K around the reflex corners of A (the reduced convolution of A's complement
with K). Their arrangement is a constrained triangulation with exact intersections; a triangle belongs to the result if
its centroid is in A and in no side + K. No triangle crosses the boundary of the result, so any of its points decides;
that the centroid is tested in doubles can only misjudge slivers. Holes that are cut through, necks that vanish and
regions that fall apart need no special care.

\pre the region has no problem (problem_of_region); depth > 0
*/
std::vector<Eroded_triangle> erode(const Loop& outline, const std::vector<Loop>& holes, double depth);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_EROSION_H
