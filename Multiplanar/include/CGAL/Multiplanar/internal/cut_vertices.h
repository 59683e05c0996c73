// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CUT_VERTICES_H
#define CGAL_MULTIPLANAR_INTERNAL_CUT_VERTICES_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The vertices of a graph, restricted to a set, without which a connected piece of it falls apart (Hopcroft and
/// Tarjan). Linear in the size of the graph.
class Cut_vertices
{
public:
  Cut_vertices(const std::vector<std::vector<int>>& neighbours, const std::vector<bool>& in_set)
      : neighbours(neighbours), in_set(in_set), number(neighbours.size(), -1), low(neighbours.size(), 0),
        cuts(neighbours.size(), false)
  {
    for (int v = 0; v < int(neighbours.size()); ++v)
      if (in_set[v] && number[v] < 0) visit(v, -1);
  }

  bool is_cut(int v) const { return cuts[v]; }

private:
  void visit(int v, int parent)
  {
    low[v] = number[v] = next++;
    int children = 0;
    for (const int w : neighbours[v]) {
      if (!in_set[w] || w == parent) continue;
      if (number[w] >= 0) {
        low[v] = (std::min)(low[v], number[w]);
        continue;
      }
      ++children;
      visit(w, v);
      low[v] = (std::min)(low[v], low[w]);
      if (parent >= 0 && low[w] >= number[v]) cuts[v] = true;
    }
    if (parent < 0 && children > 1) cuts[v] = true;
  }

  const std::vector<std::vector<int>>& neighbours;
  const std::vector<bool>& in_set;
  std::vector<int> number, low;
  std::vector<bool> cuts;
  int next = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CUT_VERTICES_H
