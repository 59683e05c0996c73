// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ELIMINATION_ORDER_H
#define CGAL_MULTIPLANAR_INTERNAL_ELIMINATION_ORDER_H

#include <CGAL/Multiplanar/internal/Cholmod.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/serial_libraries.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The neighbours of each vertex, sorted, without the vertex itself: those of v are
/// `neighbours[begin[v]]` .. `neighbours[begin[v + 1] - 1]`.
struct Vertex_graph
{
  std::vector<int> begin;
  std::vector<int> neighbours;

  int number_of_vertices() const { return int(begin.size()) - 1; }
  boost::iterator_range<const int*> adjacent(int v) const
  {
    return {neighbours.data() + begin[v], neighbours.data() + begin[v + 1]};
  }
};

/// Vertices that share an edge of the mesh, or, with `rings` = 2, that have a common neighbour as well: those that meet
/// in an objective on triangles (paper, equations 6 and 8), on a vertex and its neighbours (9).
inline Vertex_graph vertex_graph(const Connectivity& c, int rings)
{
  CGAL_precondition(rings == 1 || rings == 2);
  Vertex_graph graph;
  graph.begin.push_back(0);
  std::vector<int> found;
  const auto append_ring = [&](int v) {
    for (int f : c.star(v)) found.push_back(c.triangles[f][(c.corner_of(f, v) + 1) % 3]);
  };
  for (int v = 0; v < c.number_of_vertices(); ++v) {
    found.clear();
    append_ring(v);
    if (rings == 2)
      for (std::size_t i = 0, n = found.size(); i < n; ++i) append_ring(found[i]);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (int u : found)
      if (u != v) graph.neighbours.push_back(u);
    graph.begin.push_back(int(graph.neighbours.size()));
  }
  return graph;
}

/// An order of the vertices in which a Cholesky factorisation over `graph` fills in little: nested dissection (METIS)
/// or minimum degree (AMD), whichever gives the sparser factor; in postorder of the elimination tree, so that columns
/// of equal structure are next to each other. Returns the vertices in order; empty if CHOLMOD fails (memory).
///
/// With three unknowns a vertex, the order of the 3n unknowns is this one with each vertex replaced by its three: a
/// graph of n vertices is ordered in a fraction of the time of one with 3n.
inline std::vector<int> elimination_order(const Vertex_graph& graph)
{
  const int n = graph.number_of_vertices();
  std::vector<int> column_begin = {0}, rows;
  rows.reserve(n + graph.neighbours.size() / 2);
  for (int v = 0; v < n; ++v) {
    rows.push_back(v);
    for (int u : graph.adjacent(v))
      if (u > v) rows.push_back(u);
    column_begin.push_back(int(rows.size()));
  }
  cholmod_sparse pattern = lower_triangle_view(n, column_begin.data(), rows.data(), nullptr);

  // METIS draws from the C library's one random sequence after seeding it: two at once would disturb each other.
  static std::mutex metis_mutex;
  std::lock_guard<std::mutex> lock(metis_mutex);
  Serial_libraries serial;
  Cholmod cholmod;
  cholmod->nmethods = 2;
  cholmod->method[0].ordering = CHOLMOD_METIS;
  cholmod->method[1].ordering = CHOLMOD_AMD;
  cholmod->supernodal = CHOLMOD_SIMPLICIAL;
  cholmod->postorder = 1;
  const Cholmod_factor factor(cholmod_analyze(&pattern, cholmod.get()), Free_cholmod_factor{&cholmod});
  if (factor == nullptr) return {};
  const int* order = static_cast<const int*>(factor->Perm);
  return std::vector<int>(order, order + n);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ELIMINATION_ORDER_H
