// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_CUT_PATHS_H
#define MULTIPLANAR_VERIFY_CUT_PATHS_H

#include "drawing.h"
#include "written_model.h"

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// How far a drawn cut may be off its nominal distance from the part, in mm: chords of arcs and rounding.
constexpr double drawing_tolerance = 2e-3;

/// A part as it lies on its sheet, with nominal measures.
struct Placed_part
{
  struct Side
  {
    Point_2 a, b;
    bool grows; ///< belongs to a tab or tooth, which may be drawn wider by half the fit
  };

  std::string id;
  Loop outline;
  std::vector<Loop> holes;
  std::vector<Side> sides;            ///< of all loops
  std::vector<std::vector<int>> tabs; ///< vertices of the outline

  bool has_material(const Point_2& p) const;
  double distance_to_boundary(const Point_2& p) const;
};

Placed_part place(const Written_part& part, const Written_placement& placement);

/*!
What is wrong with the cuts of one part, in words; empty if nothing is.

A cut has to run at kerf / 2 from the nominal part, on the side of the waste; beside a tab or tooth, whose sides grow
by fit / 2 and whose corners by a little more, it may be up to the fit farther. So every cut must keep kerf / 2 from the
part everywhere, and every stretch of it must lie that near to one side of the part. The outer cut goes around the part,
and every hole that is wider than the kerf has a cut around what falls out. At least two sides of every tab, or one if
it has fewer than three, are drawn fit / 2 wider.

All within `drawing_tolerance`. No path is constructed here to compare with: only distances are measured.
*/
std::vector<std::string> problems_of_cuts(const Placed_part& part, const std::vector<const Loop*>& outer,
                                          const std::vector<const Loop*>& inner, double kerf, double fit);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_CUT_PATHS_H
