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

/// A labelling and what one needs to expand its labels one after the other. Costs of all labels are looked up once, to
/// find where expansions may start; after that, an expansion costs no more than the part of the graph that it touches.
template <class DataCost>
class Alpha_expander
{
public:
  /// \param labelling is changed by `expand`. It, `graph` and `cost` must outlive this object.
  Alpha_expander(const Potts_graph& graph, int labels, const DataCost& cost, std::vector<int>& labelling,
                 double tolerance, int threads)
      : graph(graph), cost(cost), labelling(labelling), tolerance(tolerance), problem(graph, labels, labelling),
        data(current_costs()), candidates(cost, labels, bounds(), threads), renewed_at(graph.nodes(), 0),
        expanded_at(labels, -1), current_energy(recomputed_energy())
  {
  }

  /// Gives alpha to the nodes for which that lowers the energy most. True if the energy fell by more than the tolerance
  /// (relative to the new energy); otherwise the labelling is left as it was.
  bool expand(int alpha)
  {
    if (last_change <= expanded_at[alpha]) return false; // nothing at all is new
    ++clock;
    const std::vector<int>& ones = problem.solve(
        alpha, [&](int p) { return cost(p, alpha) - data[p]; }, candidates[alpha],
        [&](int p) { return renewed_at[p] > expanded_at[alpha]; });
    survivor_count += problem.survivors();
    const double fall = -problem.energy_change();
    const bool accepted = fall > tolerance * std::abs(current_energy - fall);
    if (accepted || ones.empty()) expanded_at[alpha] = clock; // too small a fall is offered again, with what adds to it
    if (!accepted) return false;
    apply(alpha, ones);
    current_energy -= fall;
    CGAL_assertion(fall > 0);
    CGAL_assertion(std::abs(recomputed_energy() - current_energy) <= 1e-9 * (std::abs(current_energy) + fall));
    return true;
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
    for (int p = 0; p < graph.nodes(); ++p) {
      costs[p] = cost(p, labelling[p]);
      CGAL_precondition(std::isfinite(costs[p]));
    }
    return costs;
  }

  // No label that costs as much has a_p < 0 (Expansion_graph): D_p(f_p) plus the weights of the edges cut at p.
  double bound(int p) const
  {
    double sum = data[p];
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a)
      if (labelling[graph.adjacent[a]] != labelling[p]) sum += graph.weight[a];
    return sum;
  }

  std::vector<double> bounds() const
  {
    std::vector<double> result(graph.nodes());
    for (int p = 0; p < graph.nodes(); ++p) result[p] = bound(p);
    return result;
  }

  void apply(int alpha, const std::vector<int>& ones)
  {
    for (int p : ones) {
      labelling[p] = alpha;
      data[p] = cost(p, alpha);
    }
    for (int p : ones) {
      renew(p);
      for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a) renew(graph.adjacent[a]);
    }
    last_change = clock;
  }

  // After a change of label at p or at a neighbour of p.
  void renew(int p)
  {
    if (renewed_at[p] == clock) return;
    renewed_at[p] = clock;
    candidates.raise(p, bound(p));
  }

  const Potts_graph& graph;
  const DataCost& cost;
  std::vector<int>& labelling;
  double tolerance;
  Expansion_graph problem;
  std::vector<double> data; // D_p(f_p)
  Label_candidates<DataCost> candidates;
  std::vector<long long> renewed_at, expanded_at; // by node, by label, on the clock of expansions
  long long clock = 0, last_change = 0;
  double current_energy;
  std::size_t survivor_count = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ALPHA_EXPANDER_H
