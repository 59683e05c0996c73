// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_JOINT_GEOMETRY_H
#define MULTIPLANAR_VERIFY_JOINT_GEOMETRY_H

#include "written_model.h"

#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

// Tabs, slots and teeth, measured in doubles against tolerances of micrometres. That nothing overlaps is decided
// elsewhere, exactly; what is decided here is that things are where they hold.

constexpr double slot_tolerance = 2e-3; ///< mm: how far a nominal tab may stick out of its slot
constexpr double largest_play = 0.1;    ///< mm: how much wider than its tab a slot may be

/// The vertices of a tab or tooth, in order. A range of two vertices is its far end: its sides are the neighbours.
std::vector<int> tab_vertices(const Written_part& part, std::size_t tab);

/// The part of a tab that lies in the slab of a panel part, seen in that part's frame.
struct Tab_section
{
  std::vector<Point_2> points; ///< projected corners of it; empty if the tab does not reach the part
  double low, high;            ///< range of depth below the outer face
};

/// \pre `tab` is a position in the connector's list of tabs
Tab_section tab_in_part(const Written_part& connector, std::size_t tab, const Written_part& part, double thickness);

bool section_in_hole(const Tab_section& section, const Loop& hole);

/// How far the hole reaches beyond the convex hull of the section, at most, in mm.
double play_in_hole(const Tab_section& section, const Loop& hole);

/// Is a hole of a panel part cut for a tab: a rectangle as wide as the sheet is thick? Other holes are the panel's own,
/// or make way for a neighbour.
bool is_slot(const Loop& hole, double thickness);

/// Has the part material at a point of the model?
bool reaches(const Written_part& part, const Point_3& p, double thickness);

/// The line along an edge in the middle of where the slabs of its two panels overlap: half the thickness below either
/// outer face. At every point of it, the one, the other or no panel has its material; whoever has it there owns the
/// joint. The panels may overlap beyond the ends of the edge as well, so the line goes on.
struct Joint_line
{
  bool exists;        ///< false if the planes are parallel or the edge has no length
  Point_3 from, to;   ///< from far before the one end of the edge to far beyond the other
  double begin, end;  ///< the edge, in mm from `from`
  double tooth_depth; ///< how far the owner reaches past where the other gives way
};

Joint_line line_in_overlap(const Written_panel& p, const Written_panel& q, const Point_3& a, const Point_3& b,
                           double thickness);

/// A stretch of the line with one owner, or none.
struct Owned
{
  int owner; ///< bit 0: the first panel; bit 1: the second
  double length;
};

/// The stretches beside the edge, and on from there over gaps of less than `largest_play`.
std::vector<Owned> owners_along(const Joint_line& line, const std::vector<const Written_part*>& p,
                                const std::vector<const Written_part*>& q);

/// The length of the longest stretch of one panel between two of the other, gaps of `largest_play` allowed; 0 if there
/// is none.
double widest_held_tooth(const std::vector<Owned>& owners);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_JOINT_GEOMETRY_H
