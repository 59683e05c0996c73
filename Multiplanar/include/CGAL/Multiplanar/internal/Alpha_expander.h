// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ALPHA_EXPANDER_H
#define CGAL_MULTIPLANAR_INTERNAL_ALPHA_EXPANDER_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Potts_graph.h>
#include <CGAL/Multiplanar/internal/Expansion_graph.h>
#include <CGAL/Multiplanar/internal/Label_candidates.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A labelling and what one needs to expand its labels one after the other.
///
/// Nothing that an expansion cannot change is looked at twice: costs are evaluated once, an expansion of alpha visits
/// only the nodes whose cost of alpha is low enough to matter, and a piece of survivors none of which (and none of
/// whose neighbours) changed its label since alpha was last expanded is left alone.
template <class DataCost>
class Alpha_expander
{
public:
  /// \param labelling is changed by `expand`. It, `graph` and `cost` must outlive this object.
  Alpha_expander(const Potts_graph& graph, int labels, const DataCost& cost, std::vector<int>& labelling,
                 double tolerance, int threads)
      : graph(graph), cost(cost), labelling(labelling), tolerance(tolerance), problem(graph, labelling),
        data(current_costs()), candidates(cost, labels, bounds(), threads), changed_at(graph.nodes(), 0),
        expanded_at(labels, -1), current_energy(recomputed_energy())
  {
  }

  /// Gives alpha to the nodes for which that lowers the energy most. True if the energy fell by more than the tolerance
  /// (relative to the new energy); otherwise the labelling is left as it was.
  bool expand(int alpha)
  {
    if (last_change <= expanded_at[alpha]) return false; // nothing at all is new
    ++clock;
    problem.start(alpha);
    for (const auto& candidate : candidates[alpha])
      if (labelling[candidate.node] != alpha) problem.offer(candidate.node, candidate.cost - data[candidate.node]);
    problem.prune();
    survivor_count += problem.survivors();
    problem.keep_fresh([&](int p) { return changed_at[p] > expanded_at[alpha]; });
    if (problem.survivors() == 0) {
      expanded_at[alpha] = clock;
      return false;
    }
    return accept(alpha, cut.smallest_minimiser(problem.energy()));
  }

  double energy() const { return current_energy; }
  double recomputed_energy() const
  {
    double sum = 0;
    for (double d : data) sum += d;
    return sum + cut_weight(graph, labelling);
  }
  std::size_t survivors() const { return survivor_count; }

private:
  std::vector<double> current_costs() const
  {
    std::vector<double> costs(labelling.size());
    for (int p = 0; p < graph.nodes(); ++p) fill_block(cost, labelling[p], p, p + 1, &costs[p]);
    return costs;
  }

  // A node may take a label only if that costs less than its own label and all its edges together (Expansion_graph).
  std::vector<double> bounds() const
  {
    std::vector<double> result(data);
    for (int p = 0; p < graph.nodes(); ++p) result[p] += problem.weight_sums()[p];
    return result;
  }

  bool accept(int alpha, const std::vector<char>& ones)
  {
    const double change = problem.energy_change(ones);
    if (!(-change > tolerance * std::abs(current_energy + change))) {
      if (change >= 0) expanded_at[alpha] = clock; // a fall too small is offered again, with what adds to it by then
      return false;
    }
    for (int i = 0; i < int(problem.survivors()); ++i)
      if (ones[i]) set_label(problem.node(i), alpha);
    current_energy += change;
    last_change = expanded_at[alpha] = clock;
    CGAL_assertion(change < 0);
#ifdef CGAL_MULTIPLANAR_CHECK_EXPENSIVE
    CGAL_assertion(std::abs(recomputed_energy() - current_energy) <= 1e-9 * std::abs(current_energy));
#endif
    return true;
  }

  void set_label(int p, int alpha)
  {
    labelling[p] = alpha;
    fill_block(cost, alpha, p, p + 1, &data[p]);
    candidates.raise(p, data[p] + problem.weight_sums()[p]);
    changed_at[p] = clock;
  }

  const Potts_graph& graph;
  const DataCost& cost;
  std::vector<int>& labelling;
  double tolerance;
  Expansion_graph problem;
  Minimum_cut cut;
  std::vector<double> data; // D_p(f_p)
  Label_candidates<DataCost> candidates;
  std::vector<long long> changed_at, expanded_at; // by node, by label, on the clock of expansions
  long long clock = 0, last_change = 0;
  double current_energy;
  std::size_t survivor_count = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ALPHA_EXPANDER_H
