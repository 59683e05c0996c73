// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CLOSE_PAIRS_H
#define CGAL_MULTIPLANAR_INTERNAL_CLOSE_PAIRS_H

#include <CGAL/assertions.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/clearance.h>
#include <CGAL/Multiplanar/internal/parallel_ranges.h>
#include <CGAL/Multiplanar/internal/swept_aabb_tree.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The pairs of faces that might touch outside their shared simplex in some state of a pass, whatever the order of its
/// moves. A state is any choice of one point on the way of each vertex, off it by rounding at most.
///
/// A pair is left out if its swept boxes are disjoint, or if `clearance.h` proves that the two faces meet in their
/// shared simplex only in all states. Of these the second is what makes passes of small moves nearly free.
class Close_pairs
{
public:
  /// Collects the pairs for a pass from `from` to `to`, for states whose vertices are off their ways by at most `drift`
  /// per coordinate (and never leave the box of the two positions). The result does not depend on `threads`. Expected
  /// O(F log F) for displacements of the order of an edge.
  void find(const Connectivity& connectivity, const Points& from, const Points& to, double drift, int threads = 1)
  {
    CGAL_precondition(from.size() == to.size() && int(from.size()) == connectivity.number_of_vertices());
    sweep(connectivity, from, to, drift);
    build_swept_tree(tree_, boxes_);
    // In the order of the tree: faces that are asked for in turn are near each other in space, and in the cache.
    order_.clear();
    tree_.all_intersected_primitives(tree_.bbox(), std::back_inserter(order_));
    constexpr int worth_a_thread = 1000; // faces: half a millisecond
    const int parts = (std::max)(1, (std::min)(threads, int(order_.size()) / worth_a_thread));
    found_.resize(parts);
    parallel_ranges(int(order_.size()), parts, [&](int part, int first, int last) {
      found_[part].clear();
      for (int i = first; i < last; ++i)
        if (is_moving_[order_[i]]) find_partners(connectivity, from, to, order_[i], found_[part]);
    });
    collect();
    sort_by_face(connectivity.number_of_faces());
  }

  /// The faces that `f` might touch, in no particular but deterministic order.
  boost::iterator_range<const int*> partners(int f) const
  {
    return {partners_.data() + begin_[f], partners_.data() + begin_[f + 1]};
  }

  /// Pairs with overlapping swept boxes of which at least one face moves, before the clearance test.
  std::size_t number_of_candidates() const { return candidates_; }
  std::size_t size() const { return pairs_.size(); }

  /// Swept boxes by face, as of the last call of `find()`.
  const std::vector<CGAL::Bbox_3>& boxes() const { return boxes_; }

private:
  void sweep(const Connectivity& connectivity, const Points& from, const Points& to, double drift)
  {
    const int faces = connectivity.number_of_faces();
    boxes_.resize(faces);
    is_moving_.resize(faces);
    double largest = 0;
    for (int f = 0; f < faces; ++f) {
      boxes_[f] = swept_box(connectivity, from, to, f);
      is_moving_[f] = false;
      for (int v : connectivity.triangles[f])
        if (from[v] != to[v]) is_moving_[f] = true;
      for (int i = 0; i < 3; ++i)
        largest = (std::max)(largest, (std::max)(std::abs(boxes_[f].min(i)), std::abs(boxes_[f].max(i))));
    }
    slack_ = projection_slack(largest, drift);
    find_normals(connectivity, from, to, drift);
  }

  void find_normals(const Connectivity& connectivity, const Points& from, const Points& to, double drift)
  {
    ways_.resize(from.size());
    for (std::size_t v = 0; v < from.size(); ++v)
      ways_[v] = std::sqrt(CGAL::squared_distance(from[v], to[v])) * (1 + 1e-12) + 2 * drift;
    normals_.resize(connectivity.number_of_faces());
    for (int f = 0; f < connectivity.number_of_faces(); ++f) {
      const auto& t = connectivity.triangles[f];
      normals_[f] = make_normal_cone(from[t[0]], from[t[1]], from[t[2]], ways_[t[0]], ways_[t[1]], ways_[t[2]]);
    }
  }

  /// What one thread found.
  struct Found
  {
    std::size_t candidates = 0;
    std::vector<std::pair<int, int>> pairs;
    void clear() { candidates = 0, pairs.clear(); }
  };

  void find_partners(const Connectivity& connectivity, const Points& from, const Points& to, int f, Found& found) const
  {
    const auto test = [&](int g) {
      if (g == f || (is_moving_[g] && g < f)) return;
      ++found.candidates;
      if (!are_clear(connectivity, from, to, f, g)) found.pairs.emplace_back(f, g);
    };
    tree_.all_intersected_primitives(boxes_[f], boost::make_function_output_iterator(test));
  }

  bool are_clear(const Connectivity& connectivity, const Points& from, const Points& to, int f, int g) const
  {
    const auto &t = connectivity.triangles[f], &s = connectivity.triangles[g];
    int shared = 0, i = 0, j = 0;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (t[k] == s[l]) ++shared, i = k, j = l;
    if (shared == 0) {
      const Point_3 a[6] = {from[t[0]], from[t[1]], from[t[2]], to[t[0]], to[t[1]], to[t[2]]};
      const Point_3 b[6] = {from[s[0]], from[s[1]], from[s[2]], to[s[0]], to[s[1]], to[s[2]]};
      return are_separated(a, 6, b, 6, slack_);
    }
    if (shared == 1) {
      const auto way = [&](int v) { return Moving_point{from[v], to[v]}; };
      return are_separated_at_vertex(way(t[i]), way(t[(i + 1) % 3]), way(t[(i + 2) % 3]), way(s[(j + 1) % 3]),
                                     way(s[(j + 2) % 3]), slack_);
    }
    return shared == 2 && are_unfolded(normals_[f], normals_[g]);
  }

  /// Joins what the threads found, in the order of the tree.
  void collect()
  {
    candidates_ = 0;
    pairs_.clear();
    for (const Found& found : found_) {
      candidates_ += found.candidates;
      pairs_.insert(pairs_.end(), found.pairs.begin(), found.pairs.end());
    }
  }

  /// Lists each pair under both its faces.
  void sort_by_face(int faces)
  {
    begin_.assign(faces + 2, 0);
    for (const auto& pair : pairs_) ++begin_[pair.first + 2], ++begin_[pair.second + 2];
    for (int f = 0; f < faces; ++f) begin_[f + 2] += begin_[f + 1];
    partners_.resize(2 * pairs_.size());
    for (const auto& pair : pairs_) {
      partners_[begin_[pair.first + 1]++] = pair.second;
      partners_[begin_[pair.second + 1]++] = pair.first;
    }
  }

  std::vector<CGAL::Bbox_3> boxes_;
  std::vector<char> is_moving_; // by face: does one of its vertices move?
  std::vector<double> ways_;    // by vertex: bound of the displacement
  std::vector<Normal_cone> normals_;
  double slack_ = 0;
  Swept_aabb_tree tree_;
  std::vector<int> order_;   // all faces
  std::vector<Found> found_; // by thread
  std::size_t candidates_ = 0;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<std::size_t>
      begin_; // size: faces + 2; partners of f are partners_[begin_[f]] .. partners_[begin_[f + 1]]
  std::vector<int> partners_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CLOSE_PAIRS_H
