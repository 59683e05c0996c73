// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ALPHA_EXPANSION_H
#define CGAL_MULTIPLANAR_ALPHA_EXPANSION_H

#include <CGAL/assertions.h>
#include <CGAL/use.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/Alpha_expander.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// A dense data cost, as `alpha_expansion()` takes it: node-major, `values[node * labels + label]`.
struct Dense_data_cost
{
  std::vector<double> values; ///< size: nodes times labels
  int labels;                 ///< how many there are

  /// The cost of a label at a node.
  double operator()(int node, int label) const { return values[std::size_t(node) * labels + label]; }
};
/// When `alpha_expansion()` ends, and what it counts as a gain.
struct Alpha_expansion_options
{
  /// Passes over all labels at most. Whatever it is, the labelling is valid and no worse than the initial one.
  int maximal_sweeps = (std::numeric_limits<int>::max)();
  /// Threads for the evaluation of the data costs, 0: all of the machine. The result does not depend on it.
  int threads = 1;
  /// An expansion is accepted if the energy falls by more than this, relative to the new energy.
  double tolerance = 1e-10;
};
/// How `alpha_expansion()` ended.
struct Alpha_expansion_result
{
  double energy = 0;          ///< of the final labelling (eq. 1)
  int sweeps = 0;             ///< passes over all labels, the last one without success included
  std::size_t expansions = 0; ///< accepted expansions
  std::size_t survivors = 0;  ///< nodes that the flows looked at, summed over all expansions
  bool converged = false;     ///< a whole sweep found nothing to improve
};

/// Lowers the energy  sum_p D_p(f_p) + sum over edges pq with f_p != f_q of w_pq  by alpha-expansion (Boykov, Veksler,
/// Zabih 2001) until no expansion of any label lowers it. Where all data costs are >= 0, the energy is then at most
/// twice the global minimum.
///
/// Labels are expanded in the order 0, 1, ..., and sweeps are repeated until one changes nothing, as in
/// `CGAL::alpha_expansion_graphcut()`. The result is the same local minimum (exact ties, which that function's flow
/// decides either way, keep the old label here), some hundred times sooner where few nodes are in doubt, as in the
/// segmentation of surfaces. `internal::Expansion_graph` explains how, and why nothing is lost.
///
/// \tparam DataCost `double operator()(int node, int label) const`, callable from several threads at once; finite, or
///   +infinity for a label that a node must not take. Optional: `void block(int label, int first, int last, double*
///   out) const`, which writes the costs of `label` for nodes `first` .. `last` - 1 to `out`; it is then used wherever
///   all costs are needed.
/// \param graph nodes, edges and their weights w_pq >= 0
/// \param labels how many there are: 0 .. `labels` - 1
/// \param cost the data costs D_p(f)
/// \param options when to end
/// \param labelling the initial label of each node, replaced by the final one. A labelling of an earlier run, or
///   `cheapest_labels()`, is a good start.
/// \pre labels >= 1; each initial label is in 0 .. `labels` - 1 and has a finite cost.
///
/// Complexity: all nodes x labels data costs once; after that, an expansion costs as much as a maximal flow between the
/// nodes that gain by the new label and those near by that make up for it. Memory is linear in the graph and in the
/// number of pairs (node, label) where the label costs less than the present one and the edges cut at the node
/// together.
template <class DataCost>
Alpha_expansion_result alpha_expansion(const Potts_graph& graph, int labels, const DataCost& cost,
                                       std::vector<int>& labelling, const Alpha_expansion_options& options = {})
{
  CGAL_precondition(labels >= 1);
  CGAL_precondition(labelling.size() == std::size_t(graph.nodes()));
  for (int label : labelling) {
    CGAL_precondition(0 <= label && label < labels);
    CGAL_USE(label);
  }
  internal::Alpha_expander<DataCost> expander(graph, labels, cost, labelling, options.tolerance, options.threads);
  Alpha_expansion_result result;
  while (!result.converged && result.sweeps < options.maximal_sweeps) {
    ++result.sweeps;
    result.converged = true;
    for (int alpha = 0; alpha < labels; ++alpha)
      if (expander.expand(alpha)) {
        ++result.expansions;
        result.converged = false;
      }
  }
  result.energy = expander.recomputed_energy();
  result.survivors = expander.survivors();
  return result;
}

/// The label of least data cost for each node, the smallest such label on a tie: the minimum of the energy without
/// edges, and the usual start of an alpha-expansion. nodes x labels evaluations. Any number of threads gives the same.
template <class DataCost>
std::vector<int> cheapest_labels(int nodes, int labels, const DataCost& cost, int threads = 1)
{
  CGAL_precondition(labels >= 1);
  std::vector<int> cheapest(nodes, 0);
  internal::parallel_ranges(nodes, internal::useful_threads(threads, nodes, labels), [&](int, int first, int last) {
    std::vector<double> least(last - first);
    internal::for_each_tile(cost, labels, first, last, [&](int label, int begin, int end, const double* costs) {
      for (int p = begin; p < end; ++p)
        if (label == 0 || costs[p - begin] < least[p - first]) {
          least[p - first] = costs[p - begin];
          cheapest[p] = label;
        }
    });
  });
  return cheapest;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ALPHA_EXPANSION_H
