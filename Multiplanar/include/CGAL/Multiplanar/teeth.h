// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TEETH_H
#define CGAL_MULTIPLANAR_TEETH_H

#include <CGAL/Multiplanar/internal/Alternation.h>
#include <CGAL/Multiplanar/internal/slot_room.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Teeth at a convex edge (paper, section 3.2.4, fig. 5). The sheets of the two panels overlap along the edge; where
// they do, the material belongs to the one panel or to the other, alternately. Notation: theta interior dihedral angle,
// t thickness, a the strip that both panels lose, b the strip that the panel which gives way loses: a tooth is b - a
// deep.

namespace CGAL {
namespace Multiplanar {

/// Where teeth lie, in mm from the edge.
struct Tooth_strip
{
  double near;                                ///< where they begin: beyond what both panels lose
  double far;                                 ///< where the deepest gap ends
  double depth() const { return far - near; } ///< of a tooth, in mm
};

/// \pre 0 < theta < pi, in radians
inline Tooth_strip tooth_strip(double theta, double thickness)
{
  CGAL_precondition(theta > 0 && theta < 3.14159265358979323846);
  if (theta < 1.57079632679489661923) return {thickness / std::tan(theta), thickness / std::tan(theta / 2)};
  return {0, thickness * std::sin(theta)};
}

namespace internal {

/// The intervals of positions along the edge where a panel has material at a distance from it, ascending and disjoint.
inline std::vector<Interval> material_along(const std::vector<Flat_polygon>& pieces, const Edge_in_panel& edge,
                                            double distance)
{
  std::vector<double> crossings;
  for (const Flat_polygon& piece : pieces)
    for_each_side(piece, [&](const Point_2& a, const Point_2& b) {
      const double da = edge.distance(a) - distance, db = edge.distance(b) - distance;
      if ((da < 0) != (db < 0)) crossings.push_back(edge.position(a + da / (da - db) * (b - a)));
    });
  std::sort(crossings.begin(), crossings.end());
  std::vector<Interval> result;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) result.push_back({crossings[i], crossings[i + 1]});
  return result;
}

inline std::vector<Interval> intersection(const std::vector<Interval>& a, const std::vector<Interval>& b)
{
  std::vector<Interval> result;
  for (const Interval& i : a)
    for (const Interval& j : b) {
      const double low = (std::max)(i[0], j[0]), high = (std::min)(i[1], j[1]);
      if (low < high) result.push_back({low, high});
    }
  return result;
}

/// Teeth in a stretch of an edge that has `before` and `after` mm more on its ends, where the other panel may have its
/// material: about two thicknesses wide with gaps as wide, or one that is at least a thickness (and a bit) wide; half a
/// thickness is left to the other panel before the first and after the last. None if there is no room.
inline std::vector<Interval> teeth_in(const Interval& stretch, double before, double after, double thickness)
{
  const double low = stretch[0] + (std::max)(0.0, thickness / 2 - before);
  const double high = stretch[1] - (std::max)(0.0, thickness / 2 - after), length = high - low;
  if (length < 1.02 * thickness) return {};
  const int count = (std::max)(1, int((length / thickness + 2) / 4));
  const double width = count == 1 ? (std::min)(length, 2 * thickness) : length / (2 * count - 1);
  const double first = count == 1 ? (low + high - width) / 2 : low;
  std::vector<Interval> result;
  for (int i = 0; i < count; ++i) result.push_back({first + 2 * i * width, first + (2 * i + 1) * width});
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TEETH_H
