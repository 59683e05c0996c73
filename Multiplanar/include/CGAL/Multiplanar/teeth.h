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
  double near, far;
  double depth() const { return far - near; }
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

/// Every second of an odd number of about equal parts of `room`, each about twice the thickness wide: there the panel
/// that elsewhere gives way has its teeth. In a short room there is one such tooth, one thickness wide and a bit. None
/// if the room is shorter than two thicknesses.
inline std::vector<Interval> alternate_parts(const Interval& room, double thickness)
{
  const double length = room[1] - room[0];
  if (length < 2 * thickness) return {};
  if (length < 3.5 * thickness) {
    const double half = thickness * 0.51, middle = (room[0] + room[1]) / 2;
    return {{middle - half, middle + half}};
  }
  const int pairs = (std::max)(1, int((length / (2 * thickness) - 1) / 2 + 0.5)), parts = 2 * pairs + 1;
  std::vector<Interval> result;
  for (int i = 1; i < parts; i += 2)
    result.push_back({room[0] + length * i / parts, room[0] + length * (i + 1) / parts});
  return result;
}

/// Is the strip of a panel over an interval of an edge filled with its material, or (`filled` false) free of it? Asked
/// at a grid of points a little inside.
inline bool strip_is(bool filled, const std::vector<Flat_polygon>& pieces, const Edge_in_panel& edge,
                     const Tooth_strip& strip, const Interval& interval)
{
  const auto inside = [&](const Point_2& p) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Flat_polygon& piece) { return contains(piece, p); });
  };
  const double dx = 0.01, dy = 0.01;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 2; ++j) {
      const double x = interval[0] + dx + (interval[1] - interval[0] - 2 * dx) * i / 8;
      const double y = strip.near + dy + (strip.depth() - 2 * dy) * j / 2;
      if (inside(edge(x, y)) != filled) return false;
    }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TEETH_H
