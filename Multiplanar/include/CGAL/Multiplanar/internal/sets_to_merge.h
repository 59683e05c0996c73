// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SETS_TO_MERGE_H
#define CGAL_MULTIPLANAR_INTERNAL_SETS_TO_MERGE_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Sets of panels that may have to go together into one, for no part of them can: two planes enclose no pit.
class Sets_to_merge
{
public:
  using Set = std::vector<int>; ///< panels

  explicit Sets_to_merge(const Complex_topology& topology) : t(topology), neighbours(t.number_of_panels())
  {
    for (const auto& e : t.edges)
      for (int i : {0, 1}) neighbours[e.panels[i]].push_back(e.panels[1 - i]);
    for (Set& around : neighbours) around = sorted(std::move(around));
  }

  /// Two panels at a corner, all around a corner or an edge, and what `enclosed()`, `steps()` and `strips()` find: each
  /// set ascending.
  std::set<Set> all() const
  {
    std::set<Set> sets;
    const auto add = [&](Set set) {
      set = sorted(std::move(set));
      if (set.size() >= 2 && int(set.size()) + 3 <= t.number_of_panels()) sets.insert(std::move(set));
    };
    for (const auto& around : t.corner_panels) {
      add(around);
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 1; j < around.size(); ++j) add({around[i], around[j]});
    }
    for (const auto& e : t.edges) {
      Set both;
      for (int x : e.corners) both.insert(both.end(), t.corner_panels[x].begin(), t.corner_panels[x].end());
      add(std::move(both));
    }
    for (int p = 0; p < t.number_of_panels(); ++p) {
      for (std::size_t l = 1; l < t.loops[p].size(); ++l) {
        add(enclosed(p, t.loops[p][l]));
        for (Set& step : steps(p, t.loops[p][l])) add(std::move(step));
      }
      for (int q : beyond(p))
        for (Set& strip : strips(p, q)) add(std::move(strip));
    }
    return sets;
  }

  /// The panels along the hole `loop` of panel `p`: none if they are many.
  Set walls(int p, const std::vector<int>& loop) const
  {
    Set result;
    for (int x : loop)
      for (int q : t.corner_panels[x])
        if (q != p) result.push_back(q);
    result = sorted(std::move(result));
    return result.size() <= most ? result : Set();
  }

  /// Panel `p` and all panels behind its hole `loop`, if these are few; or else nothing.
  Set enclosed(int p, const std::vector<int>& loop) const
  {
    std::set<int> found{p};
    Set open;
    for (int x : loop)
      for (int q : t.corner_panels[x])
        if (found.insert(q).second) open.push_back(q);
    while (!open.empty()) {
      const int q = open.back();
      open.pop_back();
      for (int r : neighbours[q])
        if (found.insert(r).second) open.push_back(r);
      if (found.size() > most) return {};
    }
    return {found.begin(), found.end()};
  }

  /// Panel `p` and the walls along its hole `loop`, alone or with a panel at their other end: the step of a hole that
  /// goes on narrower or wider.
  std::vector<Set> steps(int p, const std::vector<int>& loop) const
  {
    const Set along = walls(p, loop);
    if (along.empty()) return {};
    std::set<int> ends;
    for (int wall : along)
      for (int q : neighbours[wall])
        if (q != p && !std::binary_search(along.begin(), along.end(), q)) ends.insert(q);
    std::vector<Set> result{along};
    result[0].push_back(p);
    for (int q : ends) {
      result.push_back(result[0]);
      result.back().push_back(q);
    }
    return result;
  }

  /// Panels `p` and `q` with a strip of panels between them that all have both as neighbours: the riser of a step.
  std::vector<Set> strips(int p, int q) const
  {
    Set common;
    std::set_intersection(neighbours[p].begin(), neighbours[p].end(), neighbours[q].begin(), neighbours[q].end(),
                          std::back_inserter(common));
    std::vector<Set> result;
    while (common.size() > 1) {
      Set strip{common.back()};
      common.pop_back();
      for (std::size_t i = 0; i < strip.size(); ++i) {
        const Set& beside = neighbours[strip[i]];
        const auto first = std::stable_partition(
            common.begin(), common.end(), [&](int r) { return !std::binary_search(beside.begin(), beside.end(), r); });
        strip.insert(strip.end(), first, common.end());
        common.erase(first, common.end());
      }
      if (strip.size() < 2 || strip.size() > most) continue;
      strip.push_back(p), strip.push_back(q);
      result.push_back(std::move(strip));
    }
    return result;
  }

private:
  /// The neighbours of neighbours of `p`, each once, up to `p`.
  std::set<int> beyond(int p) const
  {
    std::set<int> result;
    for (int q : neighbours[p])
      result.insert(neighbours[q].begin(), std::lower_bound(neighbours[q].begin(), neighbours[q].end(), p));
    return result;
  }

  static constexpr std::size_t most = 12; ///< panels that are enclosed, or along a hole, or in a strip

  static Set sorted(Set set)
  {
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    return set;
  }

  const Complex_topology& t;
  std::vector<Set> neighbours;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SETS_TO_MERGE_H
