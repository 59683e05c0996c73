// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_MAP_H
#define CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_MAP_H

#include <CGAL/Multiplanar/internal/mean_value_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

// A map of a triangulated disk into a polygon that is not convex: the polygon is cut along diagonals, one from each of
// its reflex corners, and the disk along paths of edges between the same vertices. The pieces are convex, where mean
// value coordinates put every triangle the right way round; see Kraevoy, Sheffer, Gotsman: Matchmaker (2003) for such
// paths. No path has an edge beside it that joins two of its vertices, so that no triangle is flat on a diagonal.

namespace CGAL {
namespace Multiplanar {
namespace internal {

class Convex_pieces_map
{
public:
  /// \param shape the vertices on the model, where lengths and weights are taken from
  /// \param points the places of all boundary vertices of what is mapped; receives those of the others
  Convex_pieces_map(const std::vector<Eigen::Vector3d>& shape, std::vector<Point_2d>& points)
      : shape(shape), points(points), length(points.size(), infinity), previous(points.size(), -1)
  {
  }

  /// Places the inner vertices of a disk. \return false if it is no disk, or no path was found for some corner
  bool run(const Triangles& triangles)
  {
    std::vector<Triangles> pieces{triangles};
    while (!pieces.empty()) {
      const Triangles piece = std::move(pieces.back());
      pieces.pop_back();
      const std::vector<int> loop = boundary(piece);
      if (loop.empty()) return false;
      const int reflex = sharpest_reflex(loop);
      if (reflex < 0) {
        if (!map_convex(piece, loop)) return false;
        continue;
      }
      const std::vector<int> path = cut(piece, loop, reflex);
      if (path.empty()) return false;
      place_on_diagonal(path);
      auto halves = divided(piece, path);
      if (halves.first.empty() || halves.second.empty()) return false;
      pieces.push_back(std::move(halves.first));
      pieces.push_back(std::move(halves.second));
    }
    return true;
  }

private:
  /// The boundary of the triangles, counter-clockwise; empty if it is not one simple loop.
  static std::vector<int> boundary(const Triangles& triangles)
  {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : triangles)
      for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    std::map<int, int> next;
    for (const auto& e : edges)
      if (!edges.count({e.first.second, e.first.first}) && !next.emplace(e.first.first, e.first.second).second) return {};
    if (next.empty()) return {};
    std::vector<int> loop{next.begin()->first};
    for (int v = next.begin()->second; v != loop[0]; v = next.at(v)) loop.push_back(v);
    return loop.size() == next.size() ? loop : std::vector<int>();
  }

  /// By how much the boundary turns to the left at a position of the loop, in (-pi, pi].
  double turn(const std::vector<int>& loop, int i) const
  {
    const int n = int(loop.size());
    const Point_2d in = points[loop[i]] - points[loop[(i + n - 1) % n]], out = points[loop[(i + 1) % n]] - points[loop[i]];
    return std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
  }

  /// The position of the corner with the largest angle inside, if that is more than 180 degrees; or -1.
  int sharpest_reflex(const std::vector<int>& loop) const
  {
    int sharpest = -1;
    double least = -straight;
    for (int i = 0; i < int(loop.size()); ++i) {
      const double t = turn(loop, i);
      if (t < least) least = t, sharpest = i;
    }
    return sharpest;
  }

  bool map_convex(const Triangles& piece, const std::vector<int>& loop)
  {
    std::vector<char> fixed(points.size(), 1);
    for (const auto& t : piece)
      for (int v : t) fixed[v] = 0;
    for (int v : loop) fixed[v] = 1;
    return mean_value_map(piece, shape, fixed, points);
  }

  /// The path for the best diagonal from a reflex corner; empty if there is none. The best is short in the polygon, and
  /// about as long as the path on the model.
  std::vector<int> cut(const Triangles& piece, const std::vector<int>& loop, int reflex)
  {
    const int n = int(loop.size()), from = loop[reflex];
    find_ways(piece, loop, from);
    double polygon = 0, model = 0;
    for (int i = 0; i < n; ++i) {
      polygon += (points[loop[i]] - points[loop[(i + 1) % n]]).norm();
      model += (shape[loop[i]] - shape[loop[(i + 1) % n]]).norm();
    }
    std::vector<std::pair<double, int>> ends; // cost, position
    for (int i = 0; i < n; ++i) {
      if (length[loop[i]] == infinity || i == reflex) continue;
      const double l = (points[loop[i]] - points[from]).norm(), way = length[loop[i]] * polygon / model;
      const double ratio = (std::max)(l, way) / (std::max)((std::min)(l, way), 1e-300);
      ends.emplace_back(l * ratio * ratio, i);
    }
    std::sort(ends.begin(), ends.end());
    for (const bool convex : {true, false}) // are both angles at the corner less than 180 degrees then?
      for (const auto& end : ends)
        if (is_diagonal(loop, reflex, end.second, convex)) return way_to(loop[end.second], from);
    return {};
  }

  /// Does the segment between two corners lie inside the polygon, with a little room at its ends?
  bool is_diagonal(const std::vector<int>& loop, int a, int b, bool convex) const
  {
    const int n = int(loop.size());
    if ((a + 1) % n == b || (b + 1) % n == a) return false;
    if (!leaves_inside(loop, a, b, convex) || !leaves_inside(loop, b, a, false)) return false;
    const Point_2d &p = points[loop[a]], &q = points[loop[b]];
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      if (i == a || i == b || j == a || j == b) continue;
      const Point_2d &r = points[loop[i]], &s = points[loop[j]];
      const double d1 = doubled_area(p, q, r), d2 = doubled_area(p, q, s), d3 = doubled_area(r, s, p),
                   d4 = doubled_area(r, s, q);
      if ((d1 > 0) != (d2 > 0) && (d3 > 0) != (d4 > 0)) return false;
    }
    return true;
  }

  /// Does the way from position `a` to `b` begin inside the angle at `a`? \param convex with less than 180 degrees on
  /// either side
  bool leaves_inside(const std::vector<int>& loop, int a, int b, bool convex) const
  {
    const int n = int(loop.size());
    const Point_2d out = points[loop[(a + 1) % n]] - points[loop[a]], way = points[loop[b]] - points[loop[a]];
    const double inside = pi - turn(loop, a);
    double angle = std::atan2(out.x() * way.y() - out.y() * way.x(), out.dot(way)); // from the outgoing side to the left
    if (angle < 0) angle += 2 * pi;
    const double room = (std::min)(0.05, inside / 8);
    if (angle < room || angle > inside - room) return false;
    return !convex || (angle < pi - straight && inside - angle < pi - straight);
  }

  /// The lengths of the shortest paths on the model through inner vertices of the piece, in `length`, and their last
  /// vertices but one, in `previous`.
  void find_ways(const Triangles& piece, const std::vector<int>& loop, int from)
  {
    for (int v : reached) length[v] = infinity;
    reached.assign(1, from);
    std::map<int, std::vector<int>> neighbours;
    for (const auto& t : piece)
      for (int i = 0; i < 3; ++i) neighbours[t[i]].push_back(t[(i + 1) % 3]);
    const int n = int(loop.size());
    std::map<int, int> position;
    for (int i = 0; i < n; ++i) position[loop[i]] = i;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    length[from] = 0;
    queue.emplace(0, from);
    while (!queue.empty()) {
      const auto [l, a] = queue.top();
      queue.pop();
      if (l > length[a] || (a != from && position.count(a))) continue;
      for (int b : neighbours[a]) {
        if (a == from && position.count(b)) { // along the boundary, or straight across
          const int gap = std::abs(position[a] - position[b]);
          if (gap == 1 || gap == n - 1) continue;
        }
        const double next = l + (shape[a] - shape[b]).norm();
        if (next >= length[b]) continue;
        if (length[b] == infinity) reached.push_back(b);
        length[b] = next;
        previous[b] = a;
        queue.emplace(next, b);
      }
    }
    near = std::move(neighbours);
  }

  /// The path found, from `from` to `to`, without detours: none of its vertices are joined by an edge beside it.
  std::vector<int> way_to(int to, int from) const
  {
    std::vector<int> path{to};
    while (path.back() != from) path.push_back(previous[path.back()]);
    std::reverse(path.begin(), path.end());
    std::vector<int> result{from};
    for (std::size_t i = 0; i + 1 < path.size();) {
      const auto& joined = near.at(path[i]);
      std::size_t next = path.size() - 1;
      while (next > i + 1 && std::find(joined.begin(), joined.end(), path[next]) == joined.end()) --next;
      result.push_back(path[next]);
      i = next;
    }
    return result;
  }

  /// Spreads the inner vertices of a path over the segment between its ends.
  void place_on_diagonal(const std::vector<int>& path)
  {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < path.size(); ++i)
      along.push_back(along.back() + (std::max)((shape[path[i]] - shape[path[i - 1]]).norm(), 1e-300));
    const Point_2d a = points[path.front()], b = points[path.back()];
    for (std::size_t i = 1; i + 1 < path.size(); ++i) points[path[i]] = a + along[i] / along.back() * (b - a);
  }

  /// The triangles on the left and on the right of a path.
  static std::pair<Triangles, Triangles> divided(const Triangles& piece, const std::vector<int>& path)
  {
    std::map<std::pair<int, int>, int> owner;
    for (int t = 0; t < int(piece.size()); ++t)
      for (int i = 0; i < 3; ++i) owner[{piece[t][i], piece[t][(i + 1) % 3]}] = t;
    std::map<std::pair<int, int>, bool> on_path;
    std::vector<char> left(piece.size(), 0);
    std::vector<int> stack;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      on_path[{path[i], path[i + 1]}] = on_path[{path[i + 1], path[i]}] = true;
      const auto found = owner.find({path[i], path[i + 1]});
      if (found != owner.end() && !left[found->second]) left[found->second] = 1, stack.push_back(found->second);
    }
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::pair<int, int> e{piece[t][i], piece[t][(i + 1) % 3]};
        const auto across = owner.find({e.second, e.first});
        if (on_path.count(e) || across == owner.end() || left[across->second]) continue;
        left[across->second] = 1;
        stack.push_back(across->second);
      }
    }
    std::pair<Triangles, Triangles> result;
    for (std::size_t t = 0; t < piece.size(); ++t) (left[t] ? result.first : result.second).push_back(piece[t]);
    return result;
  }

  static constexpr double infinity = (std::numeric_limits<double>::max)();
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double straight = 1e-6; ///< an angle that counts as none

  const std::vector<Eigen::Vector3d>& shape;
  std::vector<Point_2d>& points;
  std::vector<double> length;
  std::vector<int> previous, reached;
  std::map<int, std::vector<int>> near;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_MAP_H
