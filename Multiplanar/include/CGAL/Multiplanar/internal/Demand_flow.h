// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_DEMAND_FLOW_H
#define CGAL_MULTIPLANAR_INTERNAL_DEMAND_FLOW_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/reverse_arcs.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Minimises a binary energy  sum_p a_p x_p + sum over edges pq of c_pq |x_p - x_q|,  x_p in {0, 1}, c_pq >= 0, by
/// maximal flow, without looking at more of the graph than the flow needs.
///
/// A node with a_p < 0 has the *demand* -a_p, one with a_p > 0 the *room* a_p, and c_pq is how much demand can be
/// shipped along pq either way. When as much demand as possible has been shipped into room, the nodes that can be
/// reached from unmet demand through arcs with capacity left are the ones of the *smallest* minimiser, the one
/// contained in all others (Picard and Queyranne 1980).
///
/// Augmenting paths grow from the demanding nodes only. A node that no such path reaches is not reached from unmet
/// demand either: it is zero, and it is never looked at. The search forest, with adoption of orphans, is the one of
/// Boykov and Kolmogorov (2004), grown from one side.
class Demand_flow
{
public:
  /// Works on the topology of `graph`; its weights play no role here.
  explicit Demand_flow(const Potts_graph& graph)
      : begin(graph.begin), arcs(graph.adjacent.size()), node(graph.nodes())
  {
    const std::vector<int> reverse = reverse_arcs(graph);
    for (std::size_t a = 0; a < arcs.size(); ++a) arcs[a] = {graph.adjacent[a], reverse[a], 0};
  }

  /// Begins a new energy. Constant time.
  void start()
  {
    ++round;
    known_nodes.clear();
    queue.clear();
  }

  bool knows(int p) const { return node[p].round == round; }
  const std::vector<int>& known() const { return known_nodes; }

  /// States a_p; the capacities of the arcs that leave p must be set too. Once for each node.
  void add(int p, double a)
  {
    CGAL_precondition(!knows(p));
    node[p] = {a, round, free_node, false};
    known_nodes.push_back(p);
  }
  void set_capacity(int arc, double c)
  {
    CGAL_precondition(c >= 0);
    arcs[arc].residual = c;
  }

  /// Sends out the demand of the known node p, if it has any, as soon as `run()` is called (or goes on).
  void send(int p)
  {
    if (!(node[p].room < 0) || node[p].parent != free_node) return;
    node[p].parent = root;
    activate(p);
  }

  /// Ships what can be shipped of all demand sent.
  /// \param reach `reach(q)` is called whenever an unknown node q is reached: it must `add()` it, and `send()` its
  ///   demand; it may do so for other nodes too.
  template <class Reach>
  void run(const Reach& reach)
  {
    for (std::size_t next = 0; next < queue.size(); ++next) grow(queue[next], reach);
  }

  /// After `run()`: whether p can be reached from unmet demand.
  bool is_one(int p) const { return node[p].round == round && node[p].parent != free_node; }

private:
  enum : int
  {
    free_node = -1,
    root = -2,
    orphan = -3
  };
  struct Node
  {
    double room = 0;        // what is left of a_p: room if positive, unmet demand if negative
    int round = 0;          // the energy to which the other members belong
    int parent = free_node; // the arc to the parent in the search forest, or one of the above
    bool active = false;    // in the queue
  };

  struct Arc
  {
    int target, reverse;
    double residual; // capacity left; meaningful if the arc leaves a known node
  };

  void activate(int p)
  {
    if (node[p].active) return;
    node[p].active = true;
    queue.push_back(p);
  }

  // Extends the forest from p, meeting demand on the way, until nothing more can be reached directly from p.
  template <class Reach>
  void grow(int p, const Reach& reach)
  {
    node[p].active = false;
    for (int a = begin[p]; a < begin[p + 1] && node[p].parent != free_node; ++a) {
      const int q = arcs[a].target;
      if (!(arcs[a].residual > 0)) continue;
      if (!knows(q)) reach(q);
      while (node[q].parent == free_node && node[q].room > 0 && arcs[a].residual > 0 && node[p].parent != free_node)
        augment(p, a);
      if (node[q].parent != free_node || node[p].parent == free_node || !(arcs[a].residual > 0)) continue;
      node[q].parent = arcs[a].reverse;
      activate(q);
    }
  }

  // Ships as much as fits from the root above p to p and along arc a, into the room of its end.
  void augment(int p, int a)
  {
    const int q = arcs[a].target;
    double amount = (std::min)(node[q].room, arcs[a].residual);
    int r = p;
    for (; node[r].parent != root; r = arcs[node[r].parent].target)
      amount = (std::min)(amount, capacity_against(node[r].parent));
    amount = (std::min)(amount, -node[r].room);
    CGAL_assertion(amount > 0);

    ship(a, amount);
    node[q].room -= amount;
    for (r = p; node[r].parent != root;) {
      const int up = node[r].parent;
      ship(arcs[up].reverse, amount);
      if (!(capacity_against(up) > 0)) make_orphan(r);
      r = arcs[up].target;
    }
    node[r].room += amount;
    if (!(node[r].room < 0)) make_orphan(r);
    while (!orphans.empty()) {
      const int o = orphans.back();
      orphans.pop_back();
      adopt(o);
    }
  }

  void ship(int a, double amount)
  {
    arcs[a].residual -= amount;
    arcs[arcs[a].reverse].residual += amount;
  }

  // What may still be shipped against arc a: from its end to its start.
  double capacity_against(int a) const { return arcs[arcs[a].reverse].residual; }

  void make_orphan(int p)
  {
    node[p].parent = orphan;
    orphans.push_back(p);
  }

  // Hangs orphan p under a neighbour with a live root, or sets it and its children free.
  void adopt(int p)
  {
    for (int a = begin[p]; a < begin[p + 1]; ++a) {
      const int q = arcs[a].target;
      if (is_one(q) && capacity_against(a) > 0 && has_root(q)) {
        node[p].parent = a;
        return;
      }
    }
    node[p].parent = free_node;
    for (int a = begin[p]; a < begin[p + 1]; ++a) {
      const int q = arcs[a].target;
      if (!is_one(q)) continue;
      if (node[q].parent == arcs[a].reverse) make_orphan(q);
      if (capacity_against(a) > 0) activate(q); // it may reach p again
    }
  }

  bool has_root(int p) const
  {
    while (node[p].parent >= 0) p = arcs[node[p].parent].target;
    return node[p].parent == root;
  }

  const std::vector<int>& begin; // the rows of the graph
  std::vector<Arc> arcs;
  std::vector<Node> node;
  int round = 0;
  std::vector<int> known_nodes, queue, orphans;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_DEMAND_FLOW_H
