// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H
#define CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/Demand_flow.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Alpha-expansions as binary energies, solved where the labels are in doubt and nowhere else.
///
/// Notation. f is the labelling, D_p(f) the data cost, w_pq the Potts weight; x_p = 1 means that p takes alpha, x_p = 0
/// that it keeps f_p. Nodes that hold alpha already keep it. With u_p = D_p(alpha) - D_p(f_p) the energy changes by
///
///   sum_p u_p x_p  +  sum over edges pq of
///     w |x_p - x_q|     if f_p = f_q,
///     -w x_p x_q        if f_p, f_q and alpha are three labels,
///     -w x_p            if f_q = alpha.
///
/// No auxiliary nodes (Kolmogorov and Zabih 2004): since -w x_p x_q = w/2 |x_p - x_q| - w/2 x_p - w/2 x_q, this is
///
///   sum_p a_p x_p + sum_pq c_pq |x_p - x_q|   with c_pq = w if f_p = f_q, w/2 if f_p != f_q, 0 if one is alpha,
///   a_p = u_p - sum_{q: f_q = alpha} w - sum_{q: f_q != alpha, f_q != f_p} w/2,
///
/// which `Demand_flow` minimises. Its minimiser is the smallest, so ties keep the old label.
///
/// Exact pruning, in space. The flow looks at a node only if demand reaches it; all others have x_p = 0. In particular
/// a node with u_p >= the sum of its weights (a_p >= sum_q c_pq) takes in whatever comes, keeps its label, and nothing
/// behind it is looked at. Demand (a_p < 0) arises at label boundaries and where u_p < 0, and is met near by.
///
/// Exact pruning, in time. The nodes at which the last expansion of alpha looked are its region; its flow proves that
/// no set of nodes in the region gains by taking alpha. Where a connected piece of the region and its neighbours kept
/// all labels since, a_p and c_pq and therefore the proof still hold, and the piece is left alone - unless new demand
/// reaches it and takes room or capacity that the proof uses: then the whole piece is solved again. (Had the last
/// expansion been accepted with ones M: the arcs from M into the rest of the region are then full, and a_q falls by
/// exactly the flow in them when their tails take alpha, so the flow outside M is the proof for the new labels.)
///
/// What is left out changes neither the optimum nor which of several optima is found.
class Expansion_graph
{
public:
  Expansion_graph(const Potts_graph& graph, int labels, const std::vector<int>& labelling)
      : graph(graph), labelling(labelling), flow(graph), change(graph.nodes()), region_round(graph.nodes(), 0),
        regions(labels)
  {
  }

  /// Finds the smallest minimiser for label `to`.
  /// \param cost_change `double cost_change(int p)` gives u_p for any node p that does not hold alpha
  /// \param candidates nodes among which are all p with a_p < 0; others, and nodes that hold alpha, are passed over
  /// \param fresh `bool fresh(int p)`: whether p or a neighbour of p may have changed its label since the last
  /// expansion
  ///   of `to` that was accepted or found nothing. Always true before the first.
  /// \returns the nodes that take alpha
  template <class Cost_change, class Fresh>
  const std::vector<int>& solve(int to, const Cost_change& cost_change, const std::vector<int>& candidates,
                                const Fresh& fresh)
  {
    alpha = to;
    ++round;
    flow.start();
    const auto reach = [&](int p) { include(p, cost_change); };
    std::vector<int>& region = regions[alpha];
    for (int p : region) region_round[p] = round;
    for (int p : region)
      if (labelling[p] != alpha && !flow.knows(p) && fresh(p)) reach(p);
    for (int p : candidates)
      if (labelling[p] != alpha && !flow.knows(p) && fresh(p)) reach(p);
    flow.run(reach);
    update_region(region);
    ones.clear();
    for (int p : flow.known())
      if (flow.is_one(p)) ones.push_back(p);
    return ones;
  }

  /// How many nodes the last call of `solve` looked at.
  std::size_t survivors() const { return flow.known().size(); }

  /// The exact change of the energy if all nodes of the last solution take alpha.
  double energy_change() const
  {
    double sum = 0;
    for (int p : ones) {
      sum += change[p];
      for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) {
        const int q = graph.adjacent[a];
        const double w = graph.weight[a], old_cost = labelling[q] != labelling[p] ? w : 0;
        if (flow.is_one(q)) sum -= old_cost / 2; // met from either end
        else sum += (labelling[q] != alpha ? w : 0) - old_cost;
      }
    }
    return sum;
  }

private:
  // Adds p to the flow, and with it the connected piece of the region in which it lies.
  template <class Cost_change>
  void include(int p, const Cost_change& cost_change)
  {
    add(p, cost_change(p));
    if (region_round[p] != round) return;
    piece.assign(1, p);
    for (std::size_t next = 0; next < piece.size(); ++next)
      for (int a = graph.begin[piece[next]]; a < graph.begin[piece[next] + 1]; ++a) {
        const int q = graph.adjacent[a];
        if (region_round[q] != round || labelling[q] == alpha || flow.knows(q)) continue;
        add(q, cost_change(q));
        piece.push_back(q);
      }
  }

  void add(int p, double u)
  {
    change[p] = u;
    double a_p = u;
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) {
      const double w = graph.weight[a];
      const int f = labelling[graph.adjacent[a]];
      const double c = f == labelling[p] ? w : f == alpha ? 0 : w / 2;
      flow.set_capacity(a, c);
      a_p -= w - c;
    }
    flow.add(p, a_p);
    flow.send(p);
  }

  // What was solved now, and the pieces that were left alone.
  void update_region(std::vector<int>& region)
  {
    std::size_t kept = 0;
    for (int p : region)
      if (!flow.knows(p) && labelling[p] != alpha) region[kept++] = p;
    region.resize(kept);
    region.insert(region.end(), flow.known().begin(), flow.known().end());
  }

  const Potts_graph& graph;
  const std::vector<int>& labelling;
  Demand_flow flow;
  std::vector<double> change;    // u_p of the nodes that the flow knows
  std::vector<int> region_round; // the last round in whose region a node was
  std::vector<std::vector<int>> regions;
  std::vector<int> piece, ones;
  int alpha = -1, round = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H
