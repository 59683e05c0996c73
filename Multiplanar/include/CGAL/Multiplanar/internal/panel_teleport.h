// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_TELEPORT_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_TELEPORT_H

#include <CGAL/Multiplanar/internal/panel_splitting.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

// Panels move from where they are needed least to where the error is largest: two are merged, another is split
// ("teleportation" in Cohen-Steiner, Alliez, Desbrun: Variational Shape Approximation, 2004).

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The panels of largest data cost, at most `count`, largest first.
inline std::vector<int> costliest_panels(Panel_work& work, int count)
{
  std::vector<std::pair<double, int>> order;
  for (int p = 0; p < work.panels.number_of_labels(); ++p)
    if (!work.panels.faces(p).empty()) order.emplace_back(-work.fits.cost(p), p);
  const int n = (std::min)(count, int(order.size()));
  std::partial_sort(order.begin(), order.begin() + n, order.end());
  std::vector<int> result;
  for (int i = 0; i < n; ++i) result.push_back(order[i].second);
  return result;
}

/// Merges `pair` and splits a costly panel. \return whether that lowered the data cost; if not, all is as before
template <class Accept>
bool teleport(Panel_work& work, const Merge_queue::Pair& pair, Accept accept)
{
  const std::size_t mark = work.panels.mark();
  const double cost = work.fits.total();
  const int panels = work.panels.number_of_panels(), relabelled = work.relabelled;
  if (!merge_soundly(work, pair.p, pair.q) || work.panels.number_of_panels() != panels - 1) {
    work.panels.roll_back(mark);
    return false;
  }
  const std::size_t merged = work.panels.mark();
  for (int p : costliest_panels(work, 4)) {
    if (work.fits.cost(p) <= pair.cost) break; // no split gains more than all that the panel costs
    if (split_soundly(work, p, accept) != -1 && work.fits.total() < (1 - 1e-6) * cost) return true;
    work.panels.roll_back(merged);
  }
  work.panels.roll_back(mark);
  work.relabelled = relabelled;
  return false;
}

/// Teleports panels of a sound labelling, which stays sound, while that lowers the data cost.
/// \param most the number of teleports at most
/// \return their number
template <class Accept>
int teleport_panels(Panel_work& work, int most, Accept accept)
{
  int teleports = 0, failures = 0;
  if (most <= 0) return 0;
  Merge_queue queue(work.panels, work.fits);
  Merge_queue::Pair pair;
  while (teleports < most && failures < 6 && queue.pop(pair)) {
    const std::size_t mark = work.panels.mark();
    if (!teleport(work, pair, accept)) {
      ++failures;
      continue;
    }
    ++teleports;
    std::vector<int> changed = changed_panels(work.panels, mark);
    for (int p : {pair.p, pair.q}) changed.push_back(p);
    for (int p : changed) queue.update(p);
    work.panels.commit();
  }
  return teleports;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_TELEPORT_H
