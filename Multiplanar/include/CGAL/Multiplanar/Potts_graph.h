// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_POTTS_GRAPH_H
#define CGAL_MULTIPLANAR_POTTS_GRAPH_H

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// An undirected graph with a Potts weight w_pq >= 0 on each edge: the price of giving p and q different labels.
///
/// Compressed rows: the arcs that leave node p are `begin[p]` .. `begin[p + 1]` - 1; arc a leads to `adjacent[a]` and
/// weighs `weight[a]`. Each edge stands twice, once from either end, with the same weight. Parallel edges are allowed
/// and add up; loops are not allowed.
struct Potts_graph
{
  std::vector<int> begin = {0}; ///< size: nodes + 1
  std::vector<int> adjacent;    ///< the neighbours of all nodes, one after the other
  std::vector<double> weight;   ///< w_pq of each of these, >= 0

  int nodes() const { return int(begin.size()) - 1; } ///< how many there are
};

/// Builds a Potts graph over nodes 0 .. `nodes` - 1.
/// Loops are dropped, since they never cost anything. Linear time.
/// \pre `weights` has one finite value >= 0 for each edge; the ends of all edges are nodes.
inline Potts_graph make_potts_graph(int nodes, const std::vector<std::pair<int, int>>& edges,
                                    const std::vector<double>& weights)
{
  CGAL_precondition(weights.size() == edges.size());
  Potts_graph graph;
  graph.begin.assign(std::size_t(nodes) + 1, 0);
  for (const auto& e : edges) {
    CGAL_precondition(0 <= e.first && e.first < nodes && 0 <= e.second && e.second < nodes);
    if (e.first == e.second) continue;
    ++graph.begin[e.first + 1];
    ++graph.begin[e.second + 1];
  }
  for (int p = 0; p < nodes; ++p) graph.begin[p + 1] += graph.begin[p];
  graph.adjacent.resize(graph.begin.back());
  graph.weight.resize(graph.begin.back());
  std::vector<int> fill(graph.begin.begin(), graph.begin.end() - 1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int p = edges[e].first, q = edges[e].second;
    CGAL_precondition(weights[e] >= 0 && std::isfinite(weights[e]));
    if (p == q) continue;
    for (const auto& arc : {std::make_pair(p, q), std::make_pair(q, p)}) {
      graph.adjacent[fill[arc.first]] = arc.second;
      graph.weight[fill[arc.first]++] = weights[e];
    }
  }
  return graph;
}

/// Sum of the weights of the edges between nodes of different labels.
inline double cut_weight(const Potts_graph& graph, const std::vector<int>& labelling)
{
  double sum = 0;
  for (int p = 0; p < graph.nodes(); ++p)
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a)
      if (p < graph.adjacent[a] && labelling[p] != labelling[graph.adjacent[a]]) sum += graph.weight[a];
  return sum;
}

/// The energy of eq. 1: the data costs `cost(p, labelling[p])` of all nodes p plus the cut weight. Linear time.
template <class DataCost>
double potts_energy(const Potts_graph& graph, const DataCost& cost, const std::vector<int>& labelling)
{
  CGAL_precondition(labelling.size() == std::size_t(graph.nodes()));
  double sum = 0;
  for (int p = 0; p < graph.nodes(); ++p) sum += cost(p, labelling[p]);
  return sum + cut_weight(graph, labelling);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_POTTS_GRAPH_H
