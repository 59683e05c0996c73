// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRACE_TOPOLOGY_H
#define CGAL_MULTIPLANAR_INTERNAL_TRACE_TOPOLOGY_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/Flat_state.h>
#include <CGAL/Multiplanar/internal/transfer_geometry.h>
#include <CGAL/Multiplanar/make_panel_complex.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The combinatorics of a labelled mesh without its geometry: what `make_panel_complex()` and
/// `panel_complex_problems()` say, in a small fraction of their time, for a search that asks thousands of times.
class Topology_tracer
{
public:
  /// \pre labels are 0 .. panels - 1
  Topology_tracer(const Connectivity& connectivity, const std::vector<int>& labels, int panels)
      : c(connectivity), labels(labels), panels(panels), walk(connectivity, labels)
  {
  }

  /// \param corner_vertex receives the mesh vertex of every corner
  /// \return false if the panels cannot all be flat polygons: see `Panel_problem`; then the rest is unspecified
  bool trace(Complex_topology& t, std::vector<int>& corner_vertex)
  {
    t = Complex_topology();
    corner_vertex.clear();
    return every_panel_is_one_piece() && find_corners(t, corner_vertex) && trace_loops(t, corner_vertex) &&
           are_planar_domains(t) && have_distinct_ends(t) && have_distinct_corners(t);
  }

private:
  bool every_panel_is_one_piece() const
  {
    std::vector<char> seen(labels.size(), 0), found(panels, 0);
    std::vector<int> stack;
    int pieces = 0;
    for (int f = 0; f < c.number_of_faces(); ++f) {
      if (seen[f]) continue;
      if (found[labels[f]]) return false;
      found[labels[f]] = 1, seen[f] = 1, ++pieces;
      stack.push_back(f);
      while (!stack.empty()) {
        const int g = stack.back();
        stack.pop_back();
        for (int h : c.neighbours[g])
          if (!seen[h] && labels[h] == labels[f]) seen[h] = 1, stack.push_back(h);
      }
    }
    return pieces == panels;
  }

  /// Corners, in the order of their vertices, and the panels around them.
  bool find_corners(Complex_topology& t, std::vector<int>& corner_vertex)
  {
    runs.assign(c.number_of_vertices(), 0);
    boundary.clear();
    for (int f = 0; f < c.number_of_faces(); ++f)
      for (int i = 0; i < 3; ++i)
        if (labels[f] != labels[c.neighbours[f][i]]) {
          boundary.push_back(3 * f + i);
          ++runs[c.triangles[f][i]];
        }
    corner_at.assign(c.number_of_vertices(), -1);
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      if (runs[v] < 3) continue;
      corner_at[v] = int(corner_vertex.size());
      corner_vertex.push_back(v);
      std::vector<int> around;
      const auto star = c.star(v);
      int previous = labels[*(star.end() - 1)];
      for (int f : star) {
        if (labels[f] != previous) around.push_back(labels[f]);
        previous = labels[f];
      }
      std::vector<int> sorted = around;
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
      t.corner_panels.push_back(std::move(around));
    }
    return true;
  }

  bool trace_loops(Complex_topology& t, const std::vector<int>& corner_vertex)
  {
    t.loops.resize(panels);
    std::vector<char> seen(3 * std::size_t(c.number_of_faces()), 0);
    std::size_t visited = 0;
    std::vector<int> neighbours;
    for (int start : boundary) {
      if (seen[start] || corner_at[walk.source(start)] < 0) continue;
      const int p = labels[start / 3];
      std::vector<int> loop;
      neighbours.clear();
      int from = -1;
      for (int h = start; !seen[h]; h = walk.next(h)) {
        seen[h] = 1, ++visited;
        const int corner = corner_at[walk.source(h)];
        if (corner < 0) continue;
        const int q = labels[c.neighbours[h / 3][h % 3]];
        if (from >= 0 && p < neighbours.back()) t.edges.push_back({{from, corner}, {p, neighbours.back()}});
        loop.push_back(corner);
        neighbours.push_back(q);
        from = corner;
      }
      if (p < neighbours.back()) t.edges.push_back({{from, loop.front()}, {p, neighbours.back()}});
      std::sort(neighbours.begin(), neighbours.end());
      if (std::unique(neighbours.begin(), neighbours.end()) - neighbours.begin() < 3) return false;
      t.loops[p].push_back(std::move(loop));
    }
    (void)corner_vertex;
    return visited == boundary.size(); // or else some boundary passes no corner
  }

  /// With F faces, B boundary edges and I vertices inside, a panel's Euler characteristic is I + (B - F) / 2.
  bool are_planar_domains(const Complex_topology& t) const
  {
    std::vector<int> twice(panels, 0);
    for (int f = 0; f < c.number_of_faces(); ++f) --twice[labels[f]];
    for (int h : boundary) ++twice[labels[h / 3]];
    for (int v = 0; v < c.number_of_vertices(); ++v)
      if (runs[v] == 0) twice[labels[c.star(v)[0]]] += 2;
    for (int p = 0; p < panels; ++p)
      if (twice[p] != 2 * (2 - int(t.loops[p].size()))) return false;
    return true;
  }

  bool have_distinct_ends(const Complex_topology& t) const
  {
    std::set<std::pair<int, int>> ends;
    for (const auto& e : t.edges)
      if (e.corners[0] == e.corners[1] ||
          !ends.insert({(std::min)(e.corners[0], e.corners[1]), (std::max)(e.corners[0], e.corners[1])}).second)
        return false;
    return true;
  }

  /// Three planes meet in one point: no three panels may meet at two corners.
  bool have_distinct_corners(const Complex_topology& t) const
  {
    std::set<std::array<int, 3>> triples;
    for (std::vector<int> a : t.corner_panels) {
      std::sort(a.begin(), a.end());
      for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = i + 1; j < a.size(); ++j)
          for (std::size_t k = j + 1; k < a.size(); ++k)
            if (!triples.insert(std::array<int, 3>{{a[i], a[j], a[k]}}).second) return false;
    }
    return true;
  }

  const Connectivity& c;
  const std::vector<int>& labels;
  int panels;
  Boundary_walk walk;
  std::vector<int> runs, corner_at, boundary;
};

/// Whether two topologies are of one complex: the same panels between the same corners. Corners are known by the panels
/// around them, for no three panels meet at two.
/// \param now receives the number in `b` of each corner of `a`
inline bool same_complex(const Complex_topology& a, const Complex_topology& b, std::vector<int>& now)
{
  if (a.number_of_panels() != b.number_of_panels() || a.number_of_corners() != b.number_of_corners() ||
      a.edges.size() != b.edges.size())
    return false;
  std::map<std::vector<int>, int> corners;
  for (int i = 0; i < b.number_of_corners(); ++i) corners[canonical_cycle(b.corner_panels[i])] = i;
  now.clear();
  for (const auto& around : a.corner_panels) {
    const auto found = corners.find(canonical_cycle(around));
    if (found == corners.end()) return false;
    now.push_back(found->second);
  }
  std::set<std::array<int, 4>> edges;
  const auto name = [](int p, int q, int i, int j) {
    return p < q ? std::array<int, 4>{p, q, i, j} : std::array<int, 4>{q, p, j, i};
  };
  for (const auto& e : b.edges) edges.insert(name(e.panels[0], e.panels[1], e.corners[0], e.corners[1]));
  for (const auto& e : a.edges)
    if (!edges.count(name(e.panels[0], e.panels[1], now[e.corners[0]], now[e.corners[1]]))) return false;
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRACE_TOPOLOGY_H
