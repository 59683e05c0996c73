// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLOT_ROOM_H
#define CGAL_MULTIPLANAR_INTERNAL_SLOT_ROOM_H

#include <CGAL/Multiplanar/internal/Edge_view.h>
#include <CGAL/Multiplanar/internal/Flat_polygon.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Where slots have room: in a panel's material, away from its outlines and from other slots.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A rectangle by an edge, filled, as positions along it x distances from it.
struct Slot
{
  double from, to, near, far;
};

/// Distance of a point from the rectangle; all in the coordinates of the edge. 0 inside.
inline double distance_to_slot(const Slot& slot, double x, double y)
{
  const double dx = (std::max)({slot.from - x, x - slot.to, 0.0}), dy = (std::max)({slot.near - y, y - slot.far, 0.0});
  return std::sqrt(dx * dx + dy * dy);
}

/// Does the line segment enter the rectangle? (Liang and Barsky's clipping.)
inline bool enters_slot(const Slot& slot, double ax, double ay, double bx, double by)
{
  double low = 0, high = 1;
  const auto clip = [&](double start, double delta, double from, double to) {
    if (delta == 0) return start >= from && start <= to;
    const double s = (from - start) / delta, t = (to - start) / delta;
    low = (std::max)(low, (std::min)(s, t));
    high = (std::min)(high, (std::max)(s, t));
    return low <= high;
  };
  return clip(ax, bx - ax, slot.from, slot.to) && clip(ay, by - ay, slot.near, slot.far);
}

/// Distance between the rectangle and a line segment; 0 if they meet.
inline double distance_to_slot(const Slot& slot, const Edge_in_panel& edge, const Point_2& a, const Point_2& b)
{
  const double ax = edge.position(a), ay = edge.distance(a), bx = edge.position(b), by = edge.distance(b);
  if (enters_slot(slot, ax, ay, bx, by)) return 0;
  double least = (std::min)(distance_to_slot(slot, ax, ay), distance_to_slot(slot, bx, by));
  const double dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy;
  for (double x : {slot.from, slot.to})
    for (double y : {slot.near, slot.far}) {
      const double s = squared > 0 ? ((x - ax) * dx + (y - ay) * dy) / squared : 0;
      if (s > 0 && s < 1) least = (std::min)(least, std::hypot(x - ax - s * dx, y - ay - s * dy));
    }
  return least;
}

/// The material of one panel, with the slots made so far.
struct Slotted_panel
{
  std::vector<Flat_polygon> pieces;
  std::vector<std::vector<Outline>> slots; ///< by piece

  explicit Slotted_panel(const std::vector<Flat_polygon>& pieces) : pieces(pieces), slots(pieces.size()) {}

  /// The piece in which the slot lies with at least `margin` around it; -1 if there is none.
  int piece_with_room(const Edge_in_panel& edge, const Slot& slot, double margin) const
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (has_room(pieces[i], slots[i], edge, slot, margin)) return int(i);
    return -1;
  }

  /// The same as if there were no slots yet.
  int piece_with_bare_room(const Edge_in_panel& edge, const Slot& slot, double margin) const
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (has_room(pieces[i], {}, edge, slot, margin)) return int(i);
    return -1;
  }

  static bool has_room(const Flat_polygon& piece, const std::vector<Outline>& slots, const Edge_in_panel& edge,
                       const Slot& slot, double margin)
  {
    bool room = true;
    for_each_side(piece, [&](const Point_2& a, const Point_2& b) {
      room = room && distance_to_slot(slot, edge, a, b) >= margin;
    });
    for (const Outline& other : slots) room = room && keeps_from(other, edge, slot, margin);
    return room && contains(piece, edge((slot.from + slot.to) / 2, (slot.near + slot.far) / 2));
  }

  /// Does the slot keep `margin` from another one?
  static bool keeps_from(const Outline& other, const Edge_in_panel& edge, const Slot& slot, double margin)
  {
    bool room = true;
    for_each_side({{}, {other}}, [&](const Point_2& a, const Point_2& b) {
      room = room && distance_to_slot(slot, edge, a, b) >= margin;
    });
    const Point_2 middle = edge((slot.from + slot.to) / 2, (slot.near + slot.far) / 2);
    return room && CGAL::bounded_side_2(other.begin(), other.end(), middle, Kernel()) == CGAL::ON_UNBOUNDED_SIDE;
  }
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLOT_ROOM_H
