// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_GUARDED_MOTION_H
#define CGAL_MULTIPLANAR_INTERNAL_GUARDED_MOTION_H

#include <CGAL/assertions.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/clearance.h>
#include <CGAL/Multiplanar/internal/close_pairs.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/internal/swept_tetrahedron.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What one pass of guarded motion did.
struct Guard_statistics
{
  std::size_t moved = 0;   ///< vertices that reached their targets, bitwise
  std::size_t partial = 0; ///< vertices that went a part of their ways
  std::size_t refused = 0; ///< vertices that had to stay, bitwise where they were

  std::size_t candidate_pairs = 0;      ///< pairs of faces whose swept boxes overlap
  std::size_t skipped_by_clearance = 0; ///< of these, pairs proved never to touch during the pass
  std::size_t exact_tests = 0;          ///< swept tetrahedra tested by exact predicates
  int rounds = 0;                       ///< times the list of waiting vertices was gone through

  double broad_seconds = 0;  ///< time to find the pairs
  double narrow_seconds = 0; ///< time to move the vertices
};

namespace internal {

using Multiplanar::Guard_statistics;

/// The position a `fraction` (a power of two, at most 1/2) of the way from `from` to `to`, rounded to doubles, and
/// coordinatewise between the two.
inline Point_3 step_towards(const Point_3& from, const Point_3& to, double fraction)
{
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i) {
    const double low = (std::min)(from[i], to[i]), high = (std::max)(from[i], to[i]);
    x[i] = (std::min)((std::max)(from[i] + fraction * (to[i] - from[i]), low), high);
  }
  return Point_3(x[0], x[1], x[2]);
}

/// Moves the vertices of an embedded closed mesh towards targets, one at a time along straight segments, so that the
/// mesh is embedded at every instant: what results is isotopic to what was given. Keeps its buffers between calls.
///
/// A move is accepted only if every swept tetrahedron meets every static triangle exactly in their shared simplex; see
/// `swept_tetrahedron.h` for why that suffices. Which pairs can matter at all is found once for a pass, see
/// `close_pairs.h`. Vertices are tried in the order of their numbers, and the result is the same for any number of
/// threads.
class Guarded_motion
{
public:
  /// \param connectivity must outlive the object.
  /// \param max_halvings how often a refused step is halved and tried again, before the vertex waits.
  /// \param max_rounds how often waiting vertices are tried; after the first round only those for which what blocked
  ///        them has moved since.
  /// \param threads at most this many look for the pairs that can matter; moves are made one after the other.
  Guarded_motion(const Connectivity& connectivity, int max_halvings = 3, int max_rounds = 4, int threads = 1)
      : connectivity_(connectivity), max_halvings_(max_halvings), max_rounds_(max_rounds), threads_(threads)
  {
    CGAL_precondition(max_halvings >= 0 && max_rounds >= 1 && threads >= 1);
  }

  /// Moves `points` towards `targets`. A vertex whose target is not finite stays where it is and counts as refused.
  /// \pre the mesh with `points` is embedded; one target per point.
  Guard_statistics move(Points& points, const Points& targets)
  {
    return move(points, targets, [](int, const Point_3&, const Point_3&) {});
  }

  /// The same; calls `on_move(vertex, from, to)` before each accepted move, while `points` is still the state before.
  template <class OnMove>
  Guard_statistics move(Points& points, const Points& targets, OnMove on_move)
  {
    CGAL_precondition(points.size() == targets.size());
    CGAL_precondition(int(points.size()) == connectivity_.number_of_vertices());
#ifdef CGAL_MULTIPLANAR_CHECK_EXPENSIVE
    CGAL_precondition(is_embedded(connectivity_, points));
#endif
    statistics_ = {};
    collect(points, targets);
    const std::size_t to_move = waiting_.size();
    if (to_move > 0) {
      CGAL::Real_timer timer;
      timer.start();
      const double drift = max_rounds_ * 4 * DBL_EPSILON * largest_coordinate_;
      pairs_.find(connectivity_, points, targets_, drift, threads_);
      statistics_.candidate_pairs = pairs_.number_of_candidates();
      statistics_.skipped_by_clearance = pairs_.number_of_candidates() - pairs_.size();
      statistics_.broad_seconds = timer.time();
      timer.reset();
      run_rounds(points, on_move);
      statistics_.narrow_seconds = timer.time();
    }
    count_unfinished(points);
    statistics_.moved = to_move - waiting_.size();
    CGAL_postcondition(is_embedded(connectivity_, points)); // the whole mesh, after every pass of a debug build
    return statistics_;
  }

private:
  /// What kept a vertex from its target when it was last tried, and when that was.
  struct Obstacle
  {
    int moving_face = -1, static_face = -1;
    std::size_t tick = 0;
  };

  void collect(const Points& points, const Points& targets)
  {
    waiting_.clear();
    largest_coordinate_ = 0;
    targets_ = targets;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points[v] == targets[v]) continue;
      const bool finite =
          std::isfinite(targets[v].x()) && std::isfinite(targets[v].y()) && std::isfinite(targets[v].z());
      if (finite) waiting_.push_back(int(v));
      else targets_[v] = points[v], ++statistics_.refused;
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      for (int i = 0; i < 3; ++i)
        largest_coordinate_ = (std::max)({largest_coordinate_, std::abs(points[v][i]), std::abs(targets_[v][i])});
    slack_ = projection_slack(largest_coordinate_);
    obstacles_.assign(points.size(), Obstacle());
    moved_at_.assign(points.size(), 0);
    tick_ = 0;
  }

  template <class OnMove>
  void run_rounds(Points& points, OnMove& on_move)
  {
    bool progress = true;
    while (progress && !waiting_.empty() && statistics_.rounds < max_rounds_) {
      progress = false;
      ++statistics_.rounds;
      still_waiting_.clear();
      for (int v : waiting_) {
        if (statistics_.rounds == 1 || has_obstacle_moved(v)) progress |= advance(points, v, on_move);
        if (points[v] != targets_[v]) still_waiting_.push_back(v);
      }
      waiting_.swap(still_waiting_);
    }
  }

  /// Tries the full step of vertex `v`, then halves. True if the vertex moved.
  template <class OnMove>
  bool advance(Points& points, int v, OnMove& on_move)
  {
    Obstacle& obstacle = obstacles_[v];
    double fraction = 1;
    for (int halvings = 0; halvings <= max_halvings_; ++halvings, fraction /= 2) {
      const Point_3 to = halvings == 0 ? targets_[v] : step_towards(points[v], targets_[v], fraction);
      if (to == points[v] || !is_clear(points, v, to, obstacle)) continue;
      on_move(v, points[v], to);
      points[v] = to;
      moved_at_[v] = obstacle.tick = ++tick_;
      return true;
    }
    obstacle.tick = tick_;
    return false;
  }

  /// May vertex `v` move to `to`? If not, `obstacle` names the two faces that would meet. Starts with the pair that it
  /// names already, since that is likely to stand in the way of the next try as well.
  bool is_clear(const Points& points, int v, const Point_3& to, Obstacle& obstacle)
  {
    if (obstacle.moving_face >= 0 && !is_pair_clear(points, v, to, obstacle.moving_face, obstacle.static_face))
      return false;
    for (int f : connectivity_.star(v)) {
      const auto partners = pairs_.partners(f);
      if (partners.empty()) continue;
      const Connectivity::Triangle t = seen_from(f, v);
      const CGAL::Bbox_3 box = points[v].bbox() + to.bbox() + points[t[1]].bbox() + points[t[2]].bbox();
      for (int g : partners) {
        const Connectivity::Triangle& s = connectivity_.triangles[g];
        if (s[0] == v || s[1] == v || s[2] == v) continue;
        if (!CGAL::do_overlap(box, points[s[0]].bbox() + points[s[1]].bbox() + points[s[2]].bbox())) continue;
        if (is_clear(points, t, to, s)) continue;
        obstacle.moving_face = f;
        obstacle.static_face = g;
        return false;
      }
    }
    return true;
  }

  bool is_pair_clear(const Points& points, int v, const Point_3& to, int f, int g)
  {
    return is_clear(points, seen_from(f, v), to, connectivity_.triangles[g]);
  }

  /// The swept tetrahedron of triangle `t`, whose vertex t[0] moves to `to`, against the static triangle `s`: in
  /// floating point with an error bound first, which answers most of them, then exactly.
  bool is_clear(const Points& points, const Connectivity::Triangle& t, const Point_3& to,
                const Connectivity::Triangle& s)
  {
    const bool has_a = s[0] == t[1] || s[1] == t[1] || s[2] == t[1];
    const bool has_b = s[0] == t[2] || s[1] == t[2] || s[2] == t[2];
    if (!has_a && !has_b && is_surely_clear(points, t, to, s)) return true;
    if (has_a && !has_b && is_surely_clear_at_vertex(points, t[0], to, t[1], t[2], s)) return true;
    if (has_b && !has_a && is_surely_clear_at_vertex(points, t[0], to, t[2], t[1], s)) return true;
    ++statistics_.exact_tests;
    return is_sweep_clear(points, t, to, s);
  }

  bool is_surely_clear(const Points& points, const Connectivity::Triangle& t, const Point_3& to,
                       const Connectivity::Triangle& s) const
  {
    const Point_3 tau[4] = {points[t[0]], to, points[t[1]], points[t[2]]};
    const Point_3 other[3] = {points[s[0]], points[s[1]], points[s[2]]};
    return are_separated(tau, 4, other, 3, slack_);
  }

  /// The triangle of the moving vertex p with a and b, against `s`, which shares a.
  bool is_surely_clear_at_vertex(const Points& points, int p, const Point_3& to, int a, int b,
                                 const Connectivity::Triangle& s) const
  {
    const int i = s[0] == a ? 0 : s[1] == a ? 1 : 2;
    const auto still = [&](int v) { return Moving_point{points[v], points[v]}; };
    return are_separated_at_vertex(still(a), {points[p], to}, still(b), still(s[(i + 1) % 3]), still(s[(i + 2) % 3]),
                                   slack_);
  }

  /// Triangle `f`, beginning with its vertex `v`.
  Connectivity::Triangle seen_from(int f, int v) const
  {
    const auto& t = connectivity_.triangles[f];
    const int i = connectivity_.corner_of(f, v);
    return {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
  }

  /// If what stood in the way of the last, smallest step has not moved, it is there for every larger step too.
  bool has_obstacle_moved(int v) const
  {
    const Obstacle& obstacle = obstacles_[v];
    if (obstacle.moving_face < 0) return false; // the last step rounded to nothing
    for (int f : {obstacle.moving_face, obstacle.static_face})
      for (int w : connectivity_.triangles[f])
        if (moved_at_[w] > obstacle.tick) return true;
    return false;
  }

  void count_unfinished(const Points& points)
  {
    for (int v : waiting_) {
      CGAL_assertion(points[v] != targets_[v]);
      if (moved_at_[v] > 0) ++statistics_.partial;
      else ++statistics_.refused;
    }
  }

  const Connectivity& connectivity_;
  int max_halvings_, max_rounds_, threads_;

  Close_pairs pairs_;
  Points targets_; // those given, with the finite ones only
  std::vector<int> waiting_, still_waiting_;
  std::vector<Obstacle> obstacles_;   // by vertex
  std::vector<std::size_t> moved_at_; // by vertex: tick of its last move, 0 before
  std::size_t tick_ = 0;              // number of moves accepted in this pass
  double largest_coordinate_ = 0, slack_ = 0;
  Guard_statistics statistics_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_GUARDED_MOTION_H
