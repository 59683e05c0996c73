// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_LOOPS_H
#define MULTIPLANAR_VERIFY_LOOPS_H

#include "written_model.h"

#include <CGAL/Bbox_2.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

// Closed polygons in the plane. The decisions are exact.

/// Have the sides nothing in common but the common ends of neighbours?
bool is_simple(const Loop& loop);

/// \pre `loop` is simple
bool is_counter_clockwise(const Loop& loop);

/// Where a point lies: 1 inside, 0 on the boundary, -1 outside. \pre `loop` is simple
int side_of(const Loop& loop, const Point_2& p);

/// Do the boundaries of two loops meet?
bool boundaries_meet(const Loop& a, const Loop& b);

/// What keeps an outline with holes from bounding a region, in words; empty if nothing does. Any orientation will do.
std::string problem_of_region(const Loop& outline, const std::vector<Loop>& holes);

/// Triangles that fill a region, as positions in the list that has the vertices of the outline first, then those of the
/// holes; counter-clockwise. \pre `problem_of_region` is empty
std::vector<std::array<int, 3>> triangulate_region(const Loop& outline, const std::vector<Loop>& holes);

// In doubles, for comparisons with tolerances.

CGAL::Bbox_2 box_of(const Loop& loop);
double signed_area(const Loop& loop);
double distance(const Point_2& p, const Point_2& a, const Point_2& b);                   ///< to the segment ab
double distance(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d); ///< of segments ab and cd
double distance_to_boundary(const Point_2& p, const Loop& loop);

/// The loop, turned around if need be, with what it bounds on its left (`counter_clockwise`) or on its right.
/// \pre `loop` is simple
Loop oriented(Loop loop, bool counter_clockwise);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_LOOPS_H
