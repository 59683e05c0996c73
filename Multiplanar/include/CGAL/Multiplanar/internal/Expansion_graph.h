// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H
#define CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/max_flow.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The binary problem of one alpha-expansion, pruned.
///
/// Notation. f is the labelling, D_p(f) the data cost, w_pq the Potts weight; x_p = 1 means that p takes alpha, x_p = 0
/// that it keeps f_p. Nodes that hold alpha already keep it. With u_p = D_p(alpha) - D_p(f_p) the energy changes by
///
///   sum_p u_p x_p  +  sum over edges pq of
///     w |x_p - x_q|                        if f_p = f_q,
///     w (1 - x_p x_q) - w                  if f_p, f_q and alpha are three labels,
///     -w x_p                               if f_q = alpha.
///
/// Kolmogorov and Zabih (2004): a submodular term of two variables needs no auxiliary node. Since
/// -w x_p x_q = w/2 |x_p - x_q| - w/2 x_p - w/2 x_q, the whole is, up to a constant, the binary energy
///
///   sum_p a_p x_p + sum_pq c_pq |x_p - x_q|   with c_pq = w if f_p = f_q, else w/2,
///   a_p = u_p - sum_{q: f_q = alpha} w - sum_{q: f_q != alpha, f_q != f_p} w/2.
///
/// Pruning. b_p = a_p - sum_q c_pq bounds from below what p adds when it takes alpha, whatever the others do. If
/// b_p >= 0, then setting x_p from 1 to 0 raises the energy of no labelling, so x_p = 0 in the smallest minimiser (were
/// it 1, then putting it to 0 would give a smaller minimiser). Fixing x_p = 0 turns c_pq |x_p - x_q| into c_pq x_q,
/// which raises b_q by 2 c_pq, and the argument repeats on the rest, whose smallest minimiser is unchanged. Pruning
/// therefore changes neither the optimum nor which optimum is found. In terms of the input: at first b_p = u_p - W_p,
/// where W_p is the sum of the weights at p, and a pruned neighbour adds 2w if the labels agree, w otherwise.
class Expansion_graph
{
public:
  Expansion_graph(const Potts_graph& graph, const std::vector<int>& labelling)
      : graph(graph), labelling(labelling), weight_sum(graph.nodes(), 0), slot(graph.nodes(), none)
  {
    for (int p = 0; p < graph.nodes(); ++p)
      for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) weight_sum[p] += graph.weight[a];
  }

  /// W_p, the sum of the weights of all edges at p.
  const std::vector<double>& weight_sums() const { return weight_sum; }

  /// Begins the expansion of label `to`.
  void start(int to)
  {
    for (const Open& o : open) slot[o.node] = none;
    open.clear();
    alpha = to;
  }

  /// Offers node p, which does not hold alpha, with u_p = `change`. Nodes that are not offered must have b_p >= 0.
  void offer(int p, double change)
  {
    CGAL_precondition(labelling[p] != alpha && slot[p] == none);
    const double bound = change - weight_sum[p];
    if (bound >= 0) return;
    slot[p] = int(open.size());
    open.push_back({p, change, bound});
  }

  /// Prunes until every bound is negative; what remains are the survivors. Linear in the nodes offered.
  void prune()
  {
    pruned.clear();
    for (Open& o : open) {
      for_each_arc(o.node, [&](int q, double w) {
        if (slot[q] == none && labelling[q] != alpha) o.bound += raise_by(o.node, q, w);
      });
      if (o.bound >= 0) pruned.push_back(o.node);
    }
    for (std::size_t next = 0; next < pruned.size(); ++next) propagate(pruned[next]);
    for (int p : pruned) slot[p] = none;
    compact();
  }

  std::size_t survivors() const { return open.size(); }

  /// Drops every survivor that no path of survivors joins to a node for which `fresh(p)` holds, or to a neighbour of
  /// one. Such a piece has the same subproblem as when this label was last expanded, and keeps its labels again.
  template <class Fresh>
  void keep_fresh(const Fresh& fresh)
  {
    std::vector<int>& reached = pruned; // scratch
    reached.clear();
    kept.assign(open.size(), false);
    for (std::size_t i = 0; i < open.size(); ++i) {
      bool start_here = fresh(open[i].node);
      for_each_arc(open[i].node, [&](int q, double) { start_here = start_here || fresh(q); });
      if (start_here) reach(int(i), reached);
    }
    for (std::size_t next = 0; next < reached.size(); ++next)
      for_each_arc(open[reached[next]].node, [&](int q, double) {
        if (slot[q] != none) reach(slot[q], reached);
      });
    for (std::size_t i = 0; i < open.size(); ++i)
      if (!kept[i]) slot[open[i].node] = none;
    compact();
  }

  /// The binary energy of the survivors, all other nodes being fixed at x = 0. Variable i is survivor i.
  const Binary_energy& energy()
  {
    binary.clear();
    for (int i = 0; i < int(open.size()); ++i) {
      const int p = open[i].node;
      double a = open[i].change;
      for_each_arc(p, [&](int q, double w) {
        const bool agree = labelling[p] == labelling[q];
        if (labelling[q] == alpha) {
          a -= w;
        } else if (slot[q] == none) {
          if (agree) a += w; // -w/2 + w/2 otherwise
        } else {
          if (!agree) a -= w / 2;
          if (i < slot[q]) binary.terms.push_back({i, slot[q], agree ? w : w / 2});
        }
      });
      binary.unary.push_back(a);
    }
    return binary;
  }

  int node(int i) const { return open[i].node; }

  /// The exact change of the energy of eq. 1 when the survivors i with `ones[i]` take alpha.
  double energy_change(const std::vector<char>& ones) const
  {
    double sum = 0;
    for (int i = 0; i < int(open.size()); ++i) {
      if (!ones[i]) continue;
      const int p = open[i].node;
      sum += open[i].change;
      for_each_arc(p, [&](int q, double w) {
        const double old_cost = labelling[q] != labelling[p] ? w : 0;
        if (slot[q] != none && ones[slot[q]]) sum -= old_cost / 2; // met from either end
        else sum += (labelling[q] != alpha ? w : 0) - old_cost;
      });
    }
    return sum;
  }

private:
  static constexpr int none = -1;
  struct Open
  {
    int node;
    double change, bound; // u_p, b_p
  };

  template <class Visit>
  void for_each_arc(int p, const Visit& visit) const
  {
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) visit(graph.adjacent[a], graph.weight[a]);
  }

  // 2 c_pq: what fixing p at 0 adds to the bound of q, and the reverse.
  double raise_by(int p, int q, double w) const { return labelling[p] == labelling[q] ? 2 * w : w; }

  void propagate(int p)
  {
    for_each_arc(p, [&](int q, double w) {
      if (slot[q] == none) return;
      double& bound = open[slot[q]].bound;
      if (bound >= 0) return; // pruned already
      bound += raise_by(p, q, w);
      if (bound >= 0) pruned.push_back(q);
    });
  }

  void reach(int i, std::vector<int>& reached)
  {
    if (kept[i]) return;
    kept[i] = true;
    reached.push_back(i);
  }

  // Closes the gaps left by nodes whose slot was taken away.
  void compact()
  {
    int n = 0;
    for (const Open& o : open)
      if (slot[o.node] != none) {
        slot[o.node] = n;
        open[n++] = o;
      }
    open.resize(n);
  }

  const Potts_graph& graph;
  const std::vector<int>& labelling;
  std::vector<double> weight_sum;
  std::vector<int> slot; // position in `open`, or none: fixed at x = 0, or holding alpha
  std::vector<Open> open;
  std::vector<int> pruned;
  std::vector<char> kept;
  Binary_energy binary;
  int alpha = none;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_EXPANSION_GRAPH_H
