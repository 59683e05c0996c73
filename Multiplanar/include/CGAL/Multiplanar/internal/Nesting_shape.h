// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_NESTING_SHAPE_H
#define CGAL_MULTIPLANAR_INTERNAL_NESTING_SHAPE_H

#include <CGAL/Multiplanar/internal/convex_pieces.h>
#include <CGAL/Multiplanar/internal/grown_outline.h>
#include <CGAL/Multiplanar/internal/no_fit_polygon.h>
#include <CGAL/Multiplanar/internal/outward_simplification.h>
#include <CGAL/Multiplanar/internal/turned_boxes.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A part at one angle, as the nesting sees it. Its origin is the lower left corner of the box around the nominal part.
struct Turned_shape
{
  Turned_box box;                            ///< of the nominal part, in mm
  std::vector<Convex_piece> pieces, negated; ///< of the grown part, and the same turned by 180 degrees
  Grid_box bounds;                           ///< of the pieces
};

/// What is the same for all parts of one shape.
struct Nesting_shape
{
  double area = 0; ///< of the grown outline, holes taken off
  std::vector<Turned_shape> turned;
};

/// Rounding to the grid moves a vertex by less than this, in mm.
constexpr double grid_slack = 0.002;

/// How much simpler a grown outline may become: by so much of its area in one step, and in all.
constexpr double simplification_step = 0.006, simplification_total = 0.02;

/// The pieces of an outline at one angle, moved to the origin of `box`. A piece rounded to the grid need not be convex
/// any more: its hull is taken, which only adds.
inline Turned_shape turned_shape(const std::vector<Outline>& pieces, const Turned_box& box, bool mirrored)
{
  Turned_shape shape;
  shape.box = box;
  Placement placement;
  placement.mirrored = mirrored;
  placement.rotation = box.rotation;
  placement.x = -box.x, placement.y = -box.y;
  for (const Outline& piece : pieces) {
    std::vector<Grid_point> points;
    for (const Point_2& p : piece) {
      const Point_2 q = placement(p);
      points.push_back(to_grid(q.x(), q.y()));
    }
    Convex_grid_polygon hull = convex_hull(std::move(points));
    if (hull.size() < 3) continue; // thinner than the slack
    shape.bounds.add(hull);
    shape.negated.emplace_back(negated(hull));
    shape.pieces.emplace_back(std::move(hull));
  }
  return shape;
}

/// The grown outline of a part, simplified, as convex pieces. \return its area too
inline std::vector<Outline> nesting_pieces(const Part& part, double distance, double smallest_hole, double& area)
{
  Grown_outline grown = grown_outline(part.outline, part.holes, distance + grid_slack, smallest_hole);
  const double full = twice_signed_area(grown.outer) / 2;
  grown.outer = Outward_simplification(grown.outer).run(simplification_step * full, simplification_total * full);
  area = twice_signed_area(grown.outer) / 2;
  for (const Outline& hole : grown.holes) area -= std::abs(twice_signed_area(hole)) / 2;
  return convex_pieces(grown.outer, grown.holes);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_NESTING_SHAPE_H
