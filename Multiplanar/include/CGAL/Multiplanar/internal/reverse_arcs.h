// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_REVERSE_ARCS_H
#define CGAL_MULTIPLANAR_INTERNAL_REVERSE_ARCS_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Potts_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// For each arc of the graph the arc that comes back; of parallel edges the j-th arc goes with the j-th. Linear time.
inline std::vector<int> reverse_arcs(const Potts_graph& graph)
{
  const std::size_t arcs = graph.adjacent.size();
  std::vector<int> incoming(arcs), outgoing(arcs), source(arcs), fill(graph.begin.begin(), graph.begin.end() - 1);
  // The arcs that enter each node, in the order of their sources.
  for (int p = 0; p < graph.nodes(); ++p)
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) {
      source[a] = p;
      incoming[fill[graph.adjacent[a]]++] = a;
    }
  // Taken node by node, these are all arcs in the order of their targets: so are the arcs that leave each node.
  fill.assign(graph.begin.begin(), graph.begin.end() - 1);
  for (int a : incoming) outgoing[fill[source[a]]++] = a;

  std::vector<int> reverse(arcs);
  for (std::size_t i = 0; i < arcs; ++i) {
    CGAL_precondition(source[incoming[i]] == graph.adjacent[outgoing[i]]); // each edge stands in the graph twice
    CGAL_precondition(graph.weight[incoming[i]] == graph.weight[outgoing[i]]);
    reverse[incoming[i]] = outgoing[i];
  }
  return reverse;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_REVERSE_ARCS_H
