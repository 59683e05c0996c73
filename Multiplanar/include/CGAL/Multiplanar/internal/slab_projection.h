// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLAB_PROJECTION_H
#define CGAL_MULTIPLANAR_INTERNAL_SLAB_PROJECTION_H

#include <CGAL/Multiplanar/internal/Slab_frame.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <vector>

// The overlap of two slabs as the plane of one of them sees it. A *block* is a convex polygon times a range of depths
// in the slab of one part. What of it lies within a range of depths of another part's slab is a convex polytope, and
// its projection along that other slab's normal is the convex hull of the projections of its vertices: those of the
// block in the range, and the points where the block's edges cross the ends of the range.

namespace CGAL {
namespace Multiplanar {
namespace internal {

template <class FT>
struct Depths
{
  FT low, high;
};

/// A convex polygon, counter-clockwise.
template <class K>
using Convex_polygon = std::vector<typename K::Point_2>;

/// Adds what the edge ab leaves of itself in low <= z <= high, as its projected end points; b itself is left to the
/// next edge unless the range cuts it off.
template <class K>
void project_edge(const Triple<typename K::FT>& a, const Triple<typename K::FT>& b, const Depths<typename K::FT>& range,
                  std::vector<typename K::Point_2>& points)
{
  const auto cross = [&](const typename K::FT& z) {
    const typename K::FT s = (z - a[2]) / (b[2] - a[2]);
    points.emplace_back(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]));
  };
  if ((a[2] < range.low && b[2] > range.low) || (b[2] < range.low && a[2] > range.low)) cross(range.low);
  if ((a[2] < range.high && b[2] > range.high) || (b[2] < range.high && a[2] > range.high)) cross(range.high);
}

/// The projection of (`polygon` x `block`) within the depths `range` of another slab. `map` takes the slab coordinates
/// of the block to those of the other slab. Empty if the projection has no area; `block.low == block.high` is allowed.
template <class K>
Convex_polygon<K> slab_projection(const Convex_polygon<K>& polygon, const Depths<typename K::FT>& block,
                                  const Affine_map<typename K::FT>& map, const Depths<typename K::FT>& range)
{
  using FT = typename K::FT;
  const std::size_t n = polygon.size();
  const bool flat = block.low == block.high;
  std::vector<Triple<FT>> low, high;
  bool above = true, below = true;
  const auto see = [&](const Triple<FT>& p) {
    above = above && !(p[2] < range.high);
    below = below && !(p[2] > range.low);
  };
  for (const auto& p : polygon) {
    low.push_back(map({p.x(), p.y(), block.low}));
    see(low.back());
    if (flat) continue;
    high.push_back(map({p.x(), p.y(), block.high}));
    see(high.back());
  }
  if (above || below) return {};

  std::vector<typename K::Point_2> points;
  const auto keep = [&](const Triple<FT>& p) {
    if (p[2] >= range.low && p[2] <= range.high) points.emplace_back(p[0], p[1]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    keep(low[i]);
    project_edge<K>(low[i], low[j], range, points);
    if (flat) continue;
    keep(high[i]);
    project_edge<K>(high[i], high[j], range, points);
    project_edge<K>(low[i], high[i], range, points);
  }
  Convex_polygon<K> hull;
  if (points.size() >= 3) CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull), K());
  if (hull.size() < 3) hull.clear();
  return hull;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLAB_PROJECTION_H
