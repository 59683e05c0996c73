// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLAB_H
#define CGAL_MULTIPLANAR_INTERNAL_SLAB_H

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/convex_pieces.h>
#include <CGAL/Multiplanar/internal/slab_projection.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Exact_number = Exact_kernel::FT;
using Exact_convex = Convex_polygon<Exact_kernel>;

/// A sheet of polygons in one frame, as convex pieces.
struct Slab
{
  Slab(const Frame& frame, std::vector<Flat_polygon> polygons, double thickness)
      : frame(frame), polygons(std::move(polygons))
  {
    for (const Flat_polygon& polygon : this->polygons) {
      for (const Outline& piece : convex_pieces(polygon.outline, polygon.holes)) {
        pieces.emplace_back();
        for (const Point_2& p : piece) pieces.back().emplace_back(p.x(), p.y());
      }
      for (const Point_2& p : polygon.outline) box += frame(p).bbox() + (frame(p) - thickness * frame.normal).bbox();
    }
  }

  Exact_polygon_set polygon_set() const
  {
    Exact_polygon_set set;
    for (const Flat_polygon& polygon : polygons) set.join(exact_polygon(polygon.outline, polygon.holes));
    return set;
  }

  Frame frame;
  std::vector<Flat_polygon> polygons;
  std::vector<Exact_convex> pieces;
  CGAL::Bbox_3 box;
};

/// Can the slabs share a point when one of them is moved by at most `reach`? A nanometre is added for rounding.
inline bool boxes_meet(const Slab& a, const Slab& b, double reach)
{
  if (a.pieces.empty() || b.pieces.empty()) return false;
  for (int i = 0; i < 3; ++i)
    if ((a.box.min)(i) > (b.box.max)(i) + reach + 1e-6 || (b.box.min)(i) > (a.box.max)(i) + reach + 1e-6) return false;
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLAB_H
