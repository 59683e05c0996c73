// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MAX_FLOW_H
#define CGAL_MULTIPLANAR_INTERNAL_MAX_FLOW_H

#include <CGAL/assertions.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The binary energy  sum_i unary[i] x_i + sum_(i,j) capacity |x_i - x_j|,  x_i in {0, 1}, capacities >= 0.
struct Binary_energy
{
  struct Term
  {
    int i, j;
    double capacity;
  };
  std::vector<double> unary;
  std::vector<Term> terms;

  void clear()
  {
    unary.clear();
    terms.clear();
  }
};

/// Finds minimisers of binary energies by maximal flow (Boykov and Kolmogorov 2004, in Boost's implementation).
///
/// The network: one node a variable, x_i = 1 on the sink's side. unary[i] >= 0 is the capacity of source -> i,
/// unary[i] < 0 that of i -> sink, and a term is an arc of its capacity either way. No auxiliary node is needed.
class Minimum_cut
{
public:
  /// The *smallest* minimiser: the one whose set of ones lies in that of every other minimiser (it exists because the
  /// energy is submodular). Its ones are the variables from which the sink can be reached when the flow is maximal.
  /// Exact up to the rounding of sums of the coefficients.
  const std::vector<char>& smallest_minimiser(const Binary_energy& energy)
  {
    build(energy);
    solve(int(energy.unary.size()));
    return ones;
  }

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, int, int>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;

  // One arc of the network and, at the same time, its reverse. Nodes: the variables, then the source, then the sink.
  void add_arcs(int u, int v, double forth, double back)
  {
    const int a = fill[u]++, b = fill[v]++;
    target[a] = v;
    target[b] = u;
    capacity[a] = forth;
    capacity[b] = back;
    reverse[a] = Edge(v, b);
    reverse[b] = Edge(u, a);
  }

  void build(const Binary_energy& energy)
  {
    const int n = int(energy.unary.size()), source = n, sink = n + 1;
    const auto terminal = [&](int i) { return energy.unary[i] < 0 ? sink : source; };
    row.assign(n + 3, 0);
    for (int i = 0; i < n; ++i) {
      ++row[i + 1];
      ++row[terminal(i) + 1];
    }
    for (const auto& t : energy.terms) {
      CGAL_precondition(t.capacity >= 0);
      ++row[t.i + 1];
      ++row[t.j + 1];
    }
    for (int i = 0; i < n + 2; ++i) row[i + 1] += row[i];
    fill.assign(row.begin(), row.end() - 1);
    const std::size_t arcs = row.back();
    target.resize(arcs);
    capacity.resize(arcs);
    residual.resize(arcs);
    reverse.resize(arcs);
    for (int i = 0; i < n; ++i)
      if (energy.unary[i] < 0) add_arcs(i, sink, -energy.unary[i], 0);
      else add_arcs(source, i, energy.unary[i], 0);
    for (const auto& t : energy.terms) add_arcs(t.i, t.j, t.capacity, t.capacity);
  }

  void solve(int n)
  {
    arc_list.clear();
    for (int u = 0; u < n + 2; ++u)
      for (int a = row[u]; a < row[u + 1]; ++a) arc_list.emplace_back(u, target[a]);
    const Graph graph(boost::edges_are_sorted, arc_list.begin(), arc_list.end(), n + 2);
    predecessor.resize(n + 2);
    colour.assign(n + 2, boost::gray_color);
    distance.resize(n + 2);
    const auto arc = get(boost::edge_index, graph);
    const auto node = get(boost::vertex_index, graph);
    boost::boykov_kolmogorov_max_flow(graph, boost::make_iterator_property_map(capacity.begin(), arc),
                                      boost::make_iterator_property_map(residual.begin(), arc),
                                      boost::make_iterator_property_map(reverse.begin(), arc),
                                      boost::make_iterator_property_map(predecessor.begin(), node),
                                      boost::make_iterator_property_map(colour.begin(), node),
                                      boost::make_iterator_property_map(distance.begin(), node), node, n, n + 1);
    ones.resize(n);
    for (int i = 0; i < n; ++i) ones[i] = colour[i] == boost::white_color; // white: in the sink's search tree
  }

  std::vector<int> row, fill, target;
  std::vector<double> capacity, residual;
  std::vector<Edge> reverse, predecessor;
  std::vector<std::pair<int, int>> arc_list;
  std::vector<boost::default_color_type> colour;
  std::vector<int> distance;
  std::vector<char> ones;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MAX_FLOW_H
