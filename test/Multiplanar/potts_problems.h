// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_POTTS_PROBLEMS_H
#define MULTIPLANAR_TEST_POTTS_PROBLEMS_H

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/seeding.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// Labelling problems on graphs, and slow, obvious ways to solve them.
namespace Multiplanar_test {

using namespace CGAL::Multiplanar;
using Labels = std::vector<int>;

// --- Random problems ------------------------------------------------------------------------------------------------

struct Problem
{
  Potts_graph graph;
  std::vector<std::pair<int, int>> edges;
  std::vector<double> weights;
  Dense_data_cost cost;
  Labels start;
};

inline int draw(std::mt19937_64& rng, int n) { return int(rng() % n); }

// `integral`: small even integers, so that sums are exact and ties abound.
inline double draw_value(std::mt19937_64& rng, bool integral, double scale)
{
  return integral ? 2. * draw(rng, int(scale)) : scale * internal::uniform_real(rng);
}

inline Problem random_problem(std::mt19937_64& rng, int nodes, int edges, int labels, bool integral,
                              double weight_scale)
{
  Problem p;
  for (int e = 0; e < edges; ++e) { // parallel edges and loops happen
    p.edges.emplace_back(draw(rng, nodes), draw(rng, nodes));
    p.weights.push_back(draw_value(rng, integral, weight_scale));
  }
  p.graph = make_potts_graph(nodes, p.edges, p.weights);
  p.cost.labels = labels;
  for (int i = 0; i < nodes * labels; ++i) p.cost.values.push_back(draw_value(rng, integral, 10));
  for (int i = 0; i < nodes; ++i) p.start.push_back(draw(rng, labels));
  return p;
}

// --- Slow twins -----------------------------------------------------------------------------------------------------

inline double slow_energy(const Problem& p, const Labels& labelling)
{
  double sum = 0;
  for (std::size_t i = 0; i < labelling.size(); ++i) sum += p.cost(int(i), labelling[i]);
  for (std::size_t e = 0; e < p.edges.size(); ++e)
    if (labelling[p.edges[e].first] != labelling[p.edges[e].second]) sum += p.weights[e];
  return sum;
}

inline Labels moved(Labels labelling, unsigned set, int alpha)
{
  for (std::size_t i = 0; i < labelling.size(); ++i)
    if (set >> i & 1) labelling[i] = alpha;
  return labelling;
}

// The best expansion of alpha among all 2^n, and the smallest of the best: the nodes that move in all of them.
inline Labels brute_force_expansion(const Problem& p, const Labels& labelling, int alpha)
{
  const unsigned sets = 1u << labelling.size();
  double best = slow_energy(p, labelling);
  unsigned common = 0;
  for (unsigned set = 1; set < sets; ++set) {
    const double energy = slow_energy(p, moved(labelling, set, alpha));
    if (energy == best) common &= set;
    if (energy < best) {
      best = energy;
      common = set;
    }
  }
  return moved(labelling, common, alpha);
}

// The expansion of alpha by Boost's maximal flow on the whole graph, in the textbook construction with auxiliary nodes
// (Boykov, Veksler, Zabih 2001), without any pruning.
inline Labels textbook_expansion(const Problem& p, Labels labelling, int alpha)
{
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS,
      boost::property<
          boost::vertex_index_t, long,
          boost::property<boost::vertex_color_t, boost::default_color_type,
                          boost::property<boost::vertex_distance_t, long,
                                          boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>>,
      boost::property<boost::edge_capacity_t, double,
                      boost::property<boost::edge_residual_capacity_t, double,
                                      boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;
  const int n = int(labelling.size());
  Graph g(n + 2);
  const auto connect = [&](int u, int v, double forth, double back) {
    const auto a = add_edge(u, v, g).first, b = add_edge(v, u, g).first;
    put(boost::edge_capacity, g, a, forth);
    put(boost::edge_capacity, g, b, back);
    put(boost::edge_reverse, g, a, b);
    put(boost::edge_reverse, g, b, a);
  };
  const int source = n, sink = n + 1;
  for (int i = 0; i < n; ++i) {
    connect(source, i, p.cost(i, alpha), 0);
    connect(i, sink, labelling[i] == alpha ? 1e9 : p.cost(i, labelling[i]), 0);
  }
  for (std::size_t e = 0; e < p.edges.size(); ++e) {
    const int i = p.edges[e].first, j = p.edges[e].second;
    const double w = p.weights[e];
    if (i == j) continue;
    if (labelling[i] == labelling[j]) {
      connect(i, j, w, w);
    } else {
      const int between = int(add_vertex(g));
      const double wi = labelling[i] == alpha ? 0 : w, wj = labelling[j] == alpha ? 0 : w;
      connect(between, i, wi, wi);
      connect(between, j, wj, wj);
      connect(between, sink, w, 0);
    }
  }
  boost::boykov_kolmogorov_max_flow(g, source, sink);
  for (int i = 0; i < n; ++i)
    if (get(boost::vertex_color, g, i) == boost::white_color) labelling[i] = alpha;
  return labelling;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_POTTS_PROBLEMS_H
