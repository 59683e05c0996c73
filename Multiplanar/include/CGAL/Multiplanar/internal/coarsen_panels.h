// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_COARSEN_PANELS_H
#define CGAL_MULTIPLANAR_INTERNAL_COARSEN_PANELS_H

#include <CGAL/Multiplanar/internal/initial_partitions.h>
#include <CGAL/Multiplanar/internal/teleport.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/panel_partition.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

// Thin and folded models have no flat panels near a partition into few pieces: polygons turn over and cut each other.
// Many small panels are easily made flat, down to one per triangle, and from there neighbours are merged, cheapest
// first, each merger only if the polygons stay simple and apart, and the caller accepts them. It is slower than
// starting with few panels, and rarely fails.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Whether a caller can use a model; an empty one: every model without faults.
using Model_test = std::function<bool(const Panel_model&)>;
/// Changes a model so that a mesh can follow it.
using Model_change = std::function<void(Panel_model&)>;

/// Faces of a mesh that merging its panels one by one takes seconds for, not minutes.
constexpr int quickly_coarsened = 3000;

/// Pieces that a larger mesh is divided into at most.
constexpr int most_pieces = 1280;

class Panel_coarsening
{
public:
  Panel_coarsening(const Panel_modeller& modeller, const Label_costs& costs, const Points& points,
                   const Accuracy_options& accuracy, std::uint64_t seed, Model_change mend = {},
                   Model_test accepted = {})
      : modeller(modeller), c(modeller.connectivity()), costs(costs), points(points), accuracy(accuracy), seed(seed),
        mend(std::move(mend)), accepted(std::move(accepted))
  {
  }

  /// A model without faults of at most `k` panels, an accepted one. \return false if none was found
  bool run(int k, Panel_model& m) const
  {
    const int most = c.number_of_faces() <= quickly_coarsened ? 32 * k : (std::min)(8 * k, most_pieces);
    for (int pieces = 4 * k; pieces <= c.number_of_faces() && pieces <= most; pieces *= 2)
      if (start(pieces, m) && reduce(k, m)) return true;
    return false;
  }

private:
  /// A faultless model of about so many panels. Given up where there are more faults than panels, or where they become
  /// fewer at less than half the speed that would do.
  bool start(int pieces, Panel_model& m) const
  {
    Face_cost cost(modeller.input(), 0.02);
    std::vector<int> labels = grow_partition(modeller.input(), modeller.moments_of_faces(), cost, pieces, seed, 1.5);
    Panel_partition_options partition;
    partition.max_panels = pieces;
    const auto report = make_panels(c, points, costs, labels, partition);
    std::vector<char> touched;
    if (!report.ok || !modeller.rebuild(nullptr, no_edit(labels, report.panels), m, touched)) return false;
    Teleport_search repairs(modeller, pieces);
    repairs.local_options = accuracy;
    const int most = pieces / 4, initial = m.faults;
    if (initial > pieces) return false;
    for (int i = 0; i < most && m.faults > 0; ++i) {
      const bool too_slow = i >= 4 && double(initial - m.faults) < double(initial) * i / most / 2;
      if (too_slow || !repairs.repair_once(m)) return false;
    }
    if (mend) mend(m);
    return is_usable(m);
  }

  /// Merges neighbours until there are at most `k` panels.
  bool reduce(int k, Panel_model& m) const
  {
    Teleport_search search(modeller, k);
    const int check = (std::max)(4, k / 4);
    for (int merges = 1; m.panels() > k; ++merges) {
      if (!merge_cheapest_pair(search, m)) return false;
      if (merges % check == 0 && m.panels() < 4 * k) {
        Accuracy_options few = accuracy;
        few.powers = {4};
        few.steps = 3;
        Panel_model improved = m;
        modeller.improve_all(improved, few);
        if (is_usable(improved)) m = std::move(improved);
      }
    }
    return m.faults == 0;
  }

  bool is_usable(const Panel_model& m) const { return m.faults == 0 && (!accepted || accepted(m)); }

  /// Mergers that leave hairs come last.
  bool merge_cheapest_pair(const Teleport_search& search, Panel_model& m) const
  {
    const auto pairs = search.cheapest_merges(m);
    const int hairs = count_hairs(m.topology->loops, m.state);
    Panel_model with_hairs;
    bool found = false;
    int later = 0;
    for (const auto& pair : pairs) {
      Panel_model merged;
      if (!merge(m, pair, merged)) continue;
      if (count_hairs(merged.topology->loops, merged.state) <= hairs) {
        m = std::move(merged);
        return true;
      }
      if (!found) with_hairs = std::move(merged), found = true;
      if (++later == 20) break;
    }
    if (found) m = std::move(with_hairs);
    return found;
  }

  bool merge(const Panel_model& m, const Merge_candidate& pair, Panel_model& merged) const
  {
    Label_edit edit = no_edit(m.labels, m.panels());
    merge_labels(edit, pair.p, pair.q);
    clip_ears(c, edit.labels);
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, merged, touched) || merged.faults > 0) return false;
    if (mend) mend(merged);
    return is_usable(merged);
  }

  const Panel_modeller& modeller;
  const Connectivity& c;
  const Label_costs& costs;
  const Points& points;
  Accuracy_options accuracy;
  std::uint64_t seed;
  Model_change mend;
  Model_test accepted;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_COARSEN_PANELS_H
