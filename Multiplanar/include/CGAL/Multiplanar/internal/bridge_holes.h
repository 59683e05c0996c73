// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_BRIDGE_HOLES_H
#define CGAL_MULTIPLANAR_INTERNAL_BRIDGE_HOLES_H

#include <CGAL/Multiplanar/Part.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A vertex of a polygon: where it lies, and which corner of the model it is.
struct Bridge_vertex
{
  Point_2 point;
  int corner;
};

using Bridge_loop = std::vector<Bridge_vertex>;

/// Does the direction from vertex `i` of `loop` to `q` point into the polygon on the left of the loop?
inline bool points_inward(const Bridge_loop& loop, std::size_t i, const Point_2& q)
{
  const Point_2& before = loop[(i + loop.size() - 1) % loop.size()].point;
  const Point_2& at = loop[i].point;
  const Point_2& after = loop[(i + 1) % loop.size()].point;
  const bool left_of_in = CGAL::left_turn(before, at, q), left_of_out = CGAL::left_turn(at, after, q);
  return CGAL::right_turn(before, at, after) ? left_of_in || left_of_out : left_of_in && left_of_out;
}

/// Does the segment ab meet a side of `loop` elsewhere than in a common end?
inline bool is_blocked(const Point_2& a, const Point_2& b, const Bridge_loop& loop)
{
  const Kernel::Segment_2 bridge(a, b);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point_2 &p = loop[i].point, &q = loop[(i + 1) % loop.size()].point;
    const bool p_is_end = p == a || p == b, q_is_end = q == a || q == b;
    if (p_is_end && q_is_end) return true;
    if (p_is_end   ? bridge.has_on(q) || Kernel::Segment_2(p, q).has_on(p == a ? b : a)
        : q_is_end ? bridge.has_on(p) || Kernel::Segment_2(p, q).has_on(q == a ? b : a)
                   : CGAL::do_intersect(bridge, Kernel::Segment_2(p, q)))
      return true;
  }
  return false;
}

/// The shortest bridge from `loop` to one of the holes that crosses nothing: positions in the loop, in the list of
/// holes and in that hole.
struct Bridge
{
  std::size_t at, hole, to;
};

inline std::optional<Bridge> shortest_bridge(const Bridge_loop& loop, const std::vector<Bridge_loop>& holes)
{
  std::vector<std::pair<double, Bridge>> candidates;
  for (std::size_t h = 0; h < holes.size(); ++h)
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (std::size_t j = 0; j < holes[h].size(); ++j)
        candidates.push_back({CGAL::squared_distance(loop[i].point, holes[h][j].point), {i, h, j}});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& candidate : candidates) {
    const Bridge& b = candidate.second;
    const Point_2 &p = loop[b.at].point, &q = holes[b.hole][b.to].point;
    if (!points_inward(loop, b.at, q) || is_blocked(p, q, loop)) continue;
    if (std::none_of(holes.begin(), holes.end(), [&](const Bridge_loop& hole) { return is_blocked(p, q, hole); }))
      return b;
  }
  return std::nullopt;
}

/*!
One closed walk around a polygon with holes: every hole is joined to the rest by a bridge that is walked there and back.

\param loop counter-clockwise, `holes` clockwise
\return the corners along the walk; if the polygon is not simple and a hole cannot be reached, that hole is left out
Cubic time in the worst case: meant for polygons of up to some hundred corners.
*/
inline std::vector<int> bridge_holes(Bridge_loop loop, std::vector<Bridge_loop> holes)
{
  while (!holes.empty()) {
    const std::optional<Bridge> bridge = shortest_bridge(loop, holes);
    if (!bridge) break;
    Bridge_loop hole = holes[bridge->hole];
    std::rotate(hole.begin(), hole.begin() + bridge->to, hole.end());
    hole.push_back(hole.front());
    hole.push_back(loop[bridge->at]);
    loop.insert(loop.begin() + bridge->at + 1, hole.begin(), hole.end());
    holes.erase(holes.begin() + bridge->hole);
  }
  std::vector<int> walk;
  for (const Bridge_vertex& v : loop) walk.push_back(v.corner);
  return walk;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_BRIDGE_HOLES_H
