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
#include <set>
#include <utility>
#include <vector>

// A map of a triangulated domain into a polygon that is not convex: the polygon is cut along diagonals, from each of its
// holes and reflex corners, and the domain along paths of edges between the same vertices. The pieces are convex, where
// mean value coordinates put every triangle the right way round; see Kraevoy, Sheffer, Gotsman: Matchmaker (2003) for such
// paths. No path has an edge beside it that joins two of its vertices, so that no triangle is flat on a diagonal.

namespace CGAL {
namespace Multiplanar {
namespace internal {

class Convex_pieces_map
{
public:
  /// \param shape the vertices on the model, where lengths and weights are taken from
  /// \param points the places of all boundary vertices of what is mapped
  Convex_pieces_map(const std::vector<Eigen::Vector3d>& shape, const std::vector<Point_2d>& points)
      : shape(shape), points(points), length(points.size(), infinity), previous(points.size(), -1)
  {
  }

  /// Places the inner vertices of a planar domain. \return false if no paths were found that allow that
  bool run(const Triangles& triangles)
  {
    attempts = most_attempts;
    return map(triangles);
  }

  /// Where the vertices are.
  const std::vector<Point_2d>& places() const { return points; }

private:
  using Loop = std::vector<int>;

  /// Maps a piece, cut where it must be. Cuts that lead to a piece without a way on are made elsewhere.
  bool map(const Triangles& piece)
  {
    const std::vector<Loop> loops = boundary(piece);
    if (loops.empty()) return false;
    if (loops.size() > 1) return open_hole(piece, loops);
    const Loop& loop = loops[0];
    const int reflex = sharpest_reflex(loop);
    if (reflex < 0) return map_convex(piece, loop);
    for (const auto& path : cuts(piece, loops, 0, reflex)) {
      if (--attempts < 0) return false;
      place_on_diagonal(path);
      const auto halves = divided(piece, path);
      if (!halves.first.empty() && !halves.second.empty() && map(halves.first) && map(halves.second)) return true;
    }
    return false;
  }

  /// Joins a hole to another loop by a slit and maps what is left.
  bool open_hole(const Triangles& piece, const std::vector<Loop>& loops)
  {
    const auto smaller = [](const Loop& a, const Loop& b) { return a.size() < b.size(); };
    const int hole = int(std::min_element(loops.begin(), loops.end(), smaller) - loops.begin());
    for (int i = 0; i < int(loops[hole].size()); ++i) {
      if (std::abs(turn(loops[hole], i)) < 0.1) continue; // not a corner
      for (const auto& path : cuts(piece, loops, hole, i)) {
        if (--attempts < 0) return false;
        place_on_diagonal(path);
        if (map(slit(piece, path))) return true;
      }
    }
    return false;
  }

  /// The boundary of the triangles, each loop with them on its left; none if two loops meet.
  static std::vector<Loop> boundary(const Triangles& triangles)
  {
    std::set<std::pair<int, int>> edges;
    for (const auto& t : triangles)
      for (int i = 0; i < 3; ++i) edges.insert({t[i], t[(i + 1) % 3]});
    std::map<int, int> next;
    for (const auto& e : edges)
      if (!edges.count({e.second, e.first}) && !next.emplace(e.first, e.second).second) return {};
    std::vector<Loop> loops;
    std::set<int> seen;
    for (const auto& start : next) {
      if (!seen.insert(start.first).second) continue;
      loops.push_back({start.first});
      for (int v = start.second; v != start.first; v = next.at(v)) loops.back().push_back(v), seen.insert(v);
    }
    return loops;
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

  bool map_convex(const Triangles& piece, const Loop& loop)
  {
    std::vector<char> fixed(points.size(), 1);
    for (const auto& t : piece)
      for (int v : t) fixed[v] = 0;
    for (int v : loop) fixed[v] = 1;
    return balanced_mean_value_map(piece, shape, fixed, points);
  }

  struct End // of a diagonal
  {
    double cost;
    int loop, position;
    std::vector<int> path;
    bool operator<(const End& other) const { return cost < other.cost; }
  };

  /// The paths for the best diagonals from a corner, to other corners of its loop if there is only that, else to the
  /// other loops. The best are short in the polygon, and about as long on the model.
  std::vector<std::vector<int>> cuts(const Triangles& piece, const std::vector<Loop>& loops, int own, int corner)
  {
    std::vector<End> ends = diagonals(piece, loops, own, corner, Cut::halving, -1);
    if (ends.empty()) {
      const std::vector<int> fan = fan_at(piece, loops[own], corner);
      for (int i = 0; i < int(fan.size()); ++i) {
        const Cut kind = i == 0 ? (fan.size() == 1 ? Cut::halving : Cut::leaves_left)
                                : (i + 1 == int(fan.size()) ? Cut::leaves_right : Cut::any);
        for (End& end : diagonals(piece, loops, own, corner, kind, fan[i])) ends.push_back(std::move(end));
      }
      std::sort(ends.begin(), ends.end());
    }
    std::vector<std::vector<int>> result;
    for (std::size_t i = 0; i < ends.size() && i < most_cuts; ++i) result.push_back(std::move(ends[i].path));
    return result;
  }

  /// What is left of a corner of more than 180 degrees after a cut: two angles of less; or, which are cut again, more on
  /// the left, on the right, or anywhere.
  enum class Cut
  {
    halving,
    leaves_left,
    leaves_right,
    any
  };

  /// The best diagonals from a corner, with their paths. \param first the vertex that the paths begin with; -1: any
  std::vector<End> diagonals(const Triangles& piece, const std::vector<Loop>& loops, int own, int corner, Cut kind,
                             int first)
  {
    const int from = loops[own][corner];
    find_ways(piece, loops, from, first);
    double polygon = 0, model = 0;
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        polygon += (points[a] - points[b]).norm();
        model += (shape[a] - shape[b]).norm();
      }
    std::vector<End> ends;
    for (int l = 0; l < int(loops.size()); ++l)
      for (int i = 0; i < int(loops[l].size()); ++i) {
        const int to = loops[l][i];
        if (to == from || length[to] == infinity || (l == own && loops.size() > 1)) continue;
        const double direct = (points[to] - points[from]).norm(), way = length[to] * polygon / model;
        const double ratio = (std::max)(direct, way) / (std::max)((std::min)(direct, way), 1e-9 * polygon);
        ends.push_back({direct * ratio * ratio, l, i, {}});
      }
    std::sort(ends.begin(), ends.end());
    std::vector<End> result;
    for (const End& end : ends) {
      if (result.size() == most_cuts) break;
      if (!is_diagonal(loops, own, corner, end.loop, end.position, kind)) continue;
      result.push_back(end);
      result.back().path = way_to(loops[end.loop][end.position], from);
    }
    return result;
  }

  /// The neighbours of a corner across edges that are not of the boundary, from its outgoing side to the left.
  static std::vector<int> fan_at(const Triangles& piece, const Loop& loop, int corner)
  {
    const int v = loop[corner];
    std::map<int, int> next;
    for (const auto& t : piece)
      for (int i = 0; i < 3; ++i)
        if (t[i] == v) next[t[(i + 1) % 3]] = t[(i + 2) % 3];
    std::vector<int> fan;
    for (auto w = next.find(loop[(std::size_t(corner) + 1) % loop.size()]); w != next.end(); w = next.find(w->second))
      fan.push_back(w->second);
    if (!fan.empty()) fan.pop_back(); // the incoming side
    return fan;
  }

  /// Does the segment between two corners lie inside the polygon, with a little room at its ends?
  bool is_diagonal(const std::vector<Loop>& loops, int loop_a, int a, int loop_b, int b, Cut kind) const
  {
    const int from = loops[loop_a][a], to = loops[loop_b][b];
    if (!leaves_inside(loops[loop_a], a, to, kind) || !leaves_inside(loops[loop_b], b, from, Cut::any)) return false;
    const Point_2d &p = points[from], &q = points[to];
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int v = loop[i], w = loop[(i + 1) % loop.size()];
        if (v == from || v == to || w == from || w == to) continue;
        const Point_2d &r = points[v], &s = points[w];
        if ((doubled_area(p, q, r) > 0) != (doubled_area(p, q, s) > 0) &&
            (doubled_area(r, s, p) > 0) != (doubled_area(r, s, q) > 0))
          return false;
      }
    return true;
  }

  /// Does the way from position `a` to the vertex `to` begin inside the angle at `a`, and leave what is wanted?
  bool leaves_inside(const Loop& loop, int a, int to, Cut kind) const
  {
    const int n = int(loop.size());
    const Point_2d out = points[loop[(a + 1) % n]] - points[loop[a]], way = points[to] - points[loop[a]];
    const double inside = pi - turn(loop, a);
    double angle = std::atan2(out.x() * way.y() - out.y() * way.x(), out.dot(way)); // from the outgoing side to the left
    if (angle < 0) angle += 2 * pi;
    const double room = (std::min)(0.05, inside / 8);
    if (angle < room || angle > inside - room) return false;
    const bool right = angle < pi - straight, left = inside - angle < pi - straight; // are these angles small enough?
    return (right || kind == Cut::leaves_right || kind == Cut::any) &&
           (left || kind == Cut::leaves_left || kind == Cut::any);
  }

  /// The lengths of the shortest paths on the model through inner vertices of the piece, in `length`, and their last
  /// vertices but one, in `previous`. \param first the vertex that they begin with; -1: any
  void find_ways(const Triangles& piece, const std::vector<Loop>& loops, int from, int first)
  {
    for (int v : reached) length[v] = infinity;
    reached.assign(1, from);
    near.clear();
    for (const auto& t : piece)
      for (int i = 0; i < 3; ++i) near[t[i]].push_back(t[(i + 1) % 3]);
    std::set<int> boundary;
    std::set<std::pair<int, int>> along;
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        boundary.insert(loop[i]);
        along.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
      }
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    length[from] = 0;
    queue.emplace(0, from);
    while (!queue.empty()) {
      const auto [l, a] = queue.top();
      queue.pop();
      if (l > length[a] || (a != from && boundary.count(a))) continue;
      for (int b : near[a]) {
        if (along.count(std::minmax(a, b)) || (a == from && first >= 0 && b != first)) continue;
        const double next = l + (shape[a] - shape[b]).norm();
        if (next >= length[b]) continue;
        if (length[b] == infinity) reached.push_back(b);
        length[b] = next;
        previous[b] = a;
        queue.emplace(next, b);
      }
    }
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

  /// The triangles of a piece with the vertices of a path doubled, those on its left having the new ones.
  Triangles slit(const Triangles& piece, const std::vector<int>& path)
  {
    std::map<std::pair<int, int>, int> owner;
    std::set<std::pair<int, int>> on_path;
    for (int t = 0; t < int(piece.size()); ++t)
      for (int i = 0; i < 3; ++i) owner[{piece[t][i], piece[t][(i + 1) % 3]}] = t;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) on_path.insert(std::minmax(path[i], path[i + 1]));
    Triangles result = piece;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const int v = path[i], copy = int(points.size());
      std::vector<int> stack{owner.at(i + 1 < path.size() ? std::make_pair(v, path[i + 1]) : std::make_pair(path[i - 1], v))};
      std::set<int> left(stack.begin(), stack.end());
      while (!stack.empty()) { // round the vertex, as far as the path and the boundary let it
        const auto& t = piece[stack.back()];
        stack.pop_back();
        for (int j = 0; j < 3; ++j) {
          const int a = t[j], b = t[(j + 1) % 3];
          const auto across = owner.find({b, a});
          if ((a != v && b != v) || on_path.count(std::minmax(a, b)) || across == owner.end()) continue;
          if (left.insert(across->second).second) stack.push_back(across->second);
        }
      }
      for (int t : left) std::replace(result[t].begin(), result[t].end(), v, copy);
      const Point_2d place = points[v];
      const Eigen::Vector3d form = shape[v];
      points.push_back(place);
      shape.push_back(form);
      length.push_back(infinity);
      previous.push_back(-1);
    }
    return result;
  }

  static constexpr std::size_t most_cuts = 6; ///< tried from one corner
  static constexpr int most_attempts = 100;   ///< cuts tried altogether
  static constexpr double infinity = (std::numeric_limits<double>::max)();
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double straight = 1e-6; ///< an angle that counts as none

  std::vector<Eigen::Vector3d> shape;
  std::vector<Point_2d> points; // those of the caller, then copies along slits
  std::vector<double> length;
  std::vector<int> previous, reached;
  std::map<int, std::vector<int>> near;
  int attempts = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_MAP_H
