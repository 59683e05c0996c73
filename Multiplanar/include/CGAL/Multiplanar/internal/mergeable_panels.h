// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MERGEABLE_PANELS_H
#define CGAL_MULTIPLANAR_INTERNAL_MERGEABLE_PANELS_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Which neighbouring panels can become one without breaking what `Topology_tracer` asks for, decided from what is
/// around them. Only neighbours along a single edge are considered.
class Mergeable_panels
{
public:
  explicit Mergeable_panels(const Complex_topology& topology)
      : t(topology), edges_of(t.number_of_panels()), corners_of(t.number_of_panels())
  {
    for (int e = 0; e < int(t.edges.size()); ++e)
      for (int p : t.edges[e].panels) edges_of[p].push_back(e);
    for (int c = 0; c < t.number_of_corners(); ++c)
      for (int p : t.corner_panels[c]) corners_of[p].push_back(c);
  }

  bool operator()(int p, int q) const
  {
    const int e = common_edge(p, q);
    if (e < 0 || !touch_at_edge_only(p, q, e)) return false;
    return keeps_neighbours(p, q) && keeps_ends_distinct(p, q, e) && keeps_corners_distinct(p, q, e);
  }

  /// All panels that share a corner with one of `panels`, and these, ascending.
  std::vector<int> around(const std::vector<int>& panels) const
  {
    std::vector<int> result(panels);
    for (int p : panels)
      for (int c : corners_of[p]) result.insert(result.end(), t.corner_panels[c].begin(), t.corner_panels[c].end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  int other(int e, int p) const { return t.edges[e].panels[t.edges[e].panels[0] == p ? 1 : 0]; }
  std::pair<int, int> ends_of(int e) const
  {
    const auto& c = t.edges[e].corners;
    return {(std::min)(c[0], c[1]), (std::max)(c[0], c[1])};
  }
  bool vanishes(int c) const { return t.corner_panels[c].size() == 3; } ///< if two of its panels become one

  /// The only edge of both panels, or -1.
  int common_edge(int p, int q) const
  {
    int found = -1;
    for (int e : edges_of[p]) {
      if (other(e, p) != q) continue;
      if (found >= 0) return -1;
      found = e;
    }
    return found;
  }

  bool touch_at_edge_only(int p, int q, int e) const
  {
    int common = 0;
    for (int c : corners_of[p]) {
      const auto& around = t.corner_panels[c];
      common += std::find(around.begin(), around.end(), q) != around.end();
    }
    return common == 2 && t.edges[e].corners[0] != t.edges[e].corners[1];
  }

  std::set<int> neighbours(int p) const
  {
    std::set<int> result;
    for (int e : edges_of[p]) result.insert(other(e, p));
    return result;
  }

  /// Do the merged panel, and those that lose a corner to it, still have three different neighbours?
  bool keeps_neighbours(int p, int q) const
  {
    std::set<int> merged = neighbours(p);
    for (int r : neighbours(q)) merged.insert(r);
    merged.erase(p), merged.erase(q);
    if (merged.size() < 3) return false;
    for (int r : merged) {
      const std::set<int> around = neighbours(r);
      if (around.count(p) && around.count(q) && around.size() < 4) return false;
    }
    return true;
  }

  /// Edges between the same corners: the edges of a third panel along `p` and `q` become one where a corner between
  /// them vanishes.
  bool keeps_ends_distinct(int p, int q, int e) const
  {
    std::vector<std::pair<int, int>> joined;
    for (int c : t.edges[e].corners) {
      if (!vanishes(c)) continue;
      std::vector<int> far; // the other ends of the two edges that become one
      for (int r : t.corner_panels[c])
        if (r != p && r != q)
          for (int i : edges_of[r]) {
            const auto& edge = t.edges[i];
            if (other(i, r) != p && other(i, r) != q) continue;
            if (edge.corners[0] == c) far.push_back(edge.corners[1]);
            else if (edge.corners[1] == c) far.push_back(edge.corners[0]);
          }
      if (far.size() != 2 || far[0] == far[1]) return false;
      joined.push_back({(std::min)(far[0], far[1]), (std::max)(far[0], far[1])});
    }
    if (joined.size() == 2 && joined[0] == joined[1]) return false;
    for (const auto& ij : joined)
      for (int r : t.corner_panels[ij.first])
        for (int i : edges_of[r])
          if (ends_of(i) == ij) return false;
    return true;
  }

  /// Would no three panels meet at two corners?
  bool keeps_corners_distinct(int p, int q, int e) const
  {
    std::set<std::pair<int, int>> pairs;
    for (int owner : {p, q})
      for (int c : corners_of[owner]) {
        const bool at_edge = c == t.edges[e].corners[0] || c == t.edges[e].corners[1];
        if (at_edge && (owner == q || vanishes(c))) continue;
        std::vector<int> around;
        for (int r : t.corner_panels[c])
          if (r != p && r != q) around.push_back(r);
        std::sort(around.begin(), around.end());
        for (std::size_t i = 0; i < around.size(); ++i)
          for (std::size_t j = i + 1; j < around.size(); ++j)
            if (!pairs.insert({around[i], around[j]}).second) return false;
      }
    return true;
  }

  const Complex_topology& t;
  std::vector<std::vector<int>> edges_of, corners_of;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MERGEABLE_PANELS_H
