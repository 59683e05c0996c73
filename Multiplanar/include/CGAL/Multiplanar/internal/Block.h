// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_BLOCK_H
#define CGAL_MULTIPLANAR_INTERNAL_BLOCK_H

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/slab_projection.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <vector>

// Do flat parts run into each other in space? The part of a block that lies in another block's slab, projected along
// that slab's normal, is a convex polygon; the blocks overlap iff it overlaps one of the other's polygons. The question
// is asked in doubles, with a clearance to spare, to find places, and exactly to confirm them.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Convex polygons in one frame times a range of depths.
struct Block
{
  Frame frame;
  std::vector<Outline> pieces;
  double low, high;
  CGAL::Bbox_3 box;

  Block(const Frame& frame, std::vector<Outline> convex_pieces, double low, double high)
      : frame(frame), pieces(std::move(convex_pieces)), low(low), high(high)
  {
    for (const Outline& piece : pieces)
      for (const Point_2& p : piece)
        box += (frame(p) - low * frame.normal).bbox() + (frame(p) - high * frame.normal).bbox();
  }
};

inline bool boxes_meet(const Block& a, const Block& b, double reach)
{
  for (int i = 0; i < 3; ++i)
    if ((a.box.min)(i) > (b.box.max)(i) + reach || (b.box.min)(i) > (a.box.max)(i) + reach) return false;
  return !a.pieces.empty() && !b.pieces.empty();
}

/// Is there a side of `a` with all of `b` at least `clearance` beyond it?
inline bool has_separating_side(const Outline& a, const Outline& b, double clearance)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point_2 &p = a[i], &q = a[(i + 1) % a.size()];
    const double dx = q.x() - p.x(), dy = q.y() - p.y(), limit = -clearance * std::hypot(dx, dy);
    bool separates = dx != 0 || dy != 0;
    for (std::size_t j = 0; separates && j < b.size(); ++j)
      separates = dx * (b[j].y() - p.y()) - dy * (b[j].x() - p.x()) <= limit;
    if (separates) return true;
  }
  return false;
}

/// Exactly: is there a side of `a` with nothing of `b` in front of it?
inline bool has_separating_side(const Convex_polygon<Exact_kernel>& a, const Convex_polygon<Exact_kernel>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    bool separates = true;
    for (std::size_t j = 0; separates && j < b.size(); ++j)
      separates = CGAL::orientation(a[i], a[(i + 1) % a.size()], b[j]) != CGAL::LEFT_TURN;
    if (separates) return true;
  }
  return false;
}

/// In doubles: do the blocks keep at least about `clearance` from each other? May say no where the answer is yes.
inline bool surely_apart(const Block& a, const Block& b, double clearance)
{
  if (!boxes_meet(a, b, clearance)) return true;
  const auto map = slab_to_slab<double>(a.frame, b.frame);
  for (const Outline& piece : a.pieces) {
    const Outline shadow =
        slab_projection<Kernel>(piece, {a.low, a.high}, map, {b.low - clearance, b.high + clearance});
    if (shadow.empty()) continue;
    for (const Outline& other : b.pieces)
      if (!has_separating_side(shadow, other, clearance) && !has_separating_side(other, shadow, clearance))
        return false;
  }
  return true;
}

/// Exactly, on the doubles given: are the interiors disjoint?
inline bool exactly_apart(const Block& a, const Block& b)
{
  if (!boxes_meet(a, b, 1e-6)) return true;
  using Exact_number = Exact_kernel::FT;
  const auto exact = [](const Outline& polygon) {
    Convex_polygon<Exact_kernel> result;
    for (const Point_2& p : polygon) result.emplace_back(p.x(), p.y());
    return result;
  };
  const auto map = slab_to_slab<Exact_number>(a.frame, b.frame);
  for (const Outline& piece : a.pieces) {
    const auto shadow = slab_projection<Exact_kernel>(exact(piece), {Exact_number(a.low), Exact_number(a.high)}, map,
                                                      {Exact_number(b.low), Exact_number(b.high)});
    if (shadow.empty()) continue;
    for (const Outline& other : b.pieces) {
      const auto polygon = exact(other);
      if (!has_separating_side(shadow, polygon) && !has_separating_side(polygon, shadow)) return false;
    }
  }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_BLOCK_H
