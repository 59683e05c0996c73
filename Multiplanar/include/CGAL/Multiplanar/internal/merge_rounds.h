// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MERGE_ROUNDS_H
#define CGAL_MULTIPLANAR_INTERNAL_MERGE_ROUNDS_H

#include <CGAL/Multiplanar/internal/mergeable_panels.h>
#include <CGAL/Multiplanar/internal/panel_edits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Names the panels of a model without faults that are of no use. To have fewer of them it may change the model, but
/// not the panels' number and order.
using Unusable_panels = std::function<std::vector<int>(Panel_model&)>;

/// Told now and then how many panels are left; false ends the work.
using Panels_left = std::function<bool(int)>;

/// Merges neighbouring panels of a model without faults, many far from each other at a time, so that it stays without
/// faults. Started at a panel for each triangle, where nothing is to be made flat, every step has a model that is flat
/// and embedded to go back to.
class Merge_rounds
{
public:
  /// \param unusable a merger that makes panels of no use is taken back
  explicit Merge_rounds(const Panel_modeller& modeller, Unusable_panels unusable = {})
      : modeller(modeller), edits(modeller, 1), unusable(std::move(unusable))
  {
  }

  /// Merges until at most `panels` are left. \return false if no more can be merged before, or it is stopped
  bool run(int panels, Panel_model& m, const Panels_left& go_on = {})
  {
    bool any = false; // merged since `failed` was empty
    while (m.panels() > panels) {
      if (go_on && !go_on(m.panels())) return false;
      std::vector<Merger> chosen = choose(m, m.panels() - panels);
      if (!chosen.empty()) any = merge_some(m, std::move(chosen)) || any;
      else if (!any || failed.empty()) return false;
      else failed.clear(), any = false; // what is around them has changed
    }
    return true;
  }

private:
  struct Merger
  {
    int p, q;               ///< q goes into p
    std::vector<int> ring;  ///< all panels that share a corner with one of them, and both
    std::vector<int> reach; ///< all panels that share a corner with one of the ring: what may change
  };
  using Key = std::array<int, 4>;

  /// Merges those that can be; the others have failed.
  bool merge_some(Panel_model& m, std::vector<Merger> chosen)
  {
    while (!chosen.empty()) {
      Panel_model merged;
      std::vector<int> guilty; // panels of m that do not fit, or have faults
      if (merge(m, chosen, merged, guilty)) {
        m = std::move(merged);
        return true;
      }
      drop(m, guilty, chosen);
    }
    return false;
  }

  /// Mergers that have nothing to do with each other, cheap ones first.
  std::vector<Merger> choose(const Panel_model& m, int most) const
  {
    const Mergeable_panels mergeable(*m.topology);
    std::vector<std::pair<double, std::pair<int, int>>> order;
    for (const Merge_candidate& pair : edits.merges(m)) {
      // Equally flat panels grow evenly.
      const double size = std::sqrt(m.moments[pair.p].area + m.moments[pair.q].area);
      order.push_back({pair.error + 0.01 * size, {pair.p, pair.q}});
    }
    std::stable_sort(order.begin(), order.end());
    const std::size_t cheap = (std::max)(std::size_t(32), order.size() / 4);
    std::vector<char> taken(m.panels(), 0);
    std::vector<Merger> result;
    std::size_t seen = 0;
    for (const auto& entry : order) {
      if (int(result.size()) == most || (seen == cheap && !result.empty())) break;
      Merger merger{entry.second.first, entry.second.second, {}, {}};
      if (failed.count(key(m, merger))) continue;
      if (!mergeable(merger.p, merger.q)) continue;
      ++seen;
      if (corners(m, merger.p) < corners(m, merger.q)) std::swap(merger.p, merger.q);
      merger.ring = mergeable.around({merger.p, merger.q});
      if (std::any_of(merger.ring.begin(), merger.ring.end(), [&](int p) { return taken[p]; })) continue;
      merger.reach = mergeable.around(merger.ring);
      for (int p : merger.reach) taken[p] = 1;
      result.push_back(std::move(merger));
    }
    return result;
  }

  bool merge(const Panel_model& m, const std::vector<Merger>& mergers, Panel_model& merged,
             std::vector<int>& guilty) const
  {
    const Label_edit edit = merging(m, mergers);
    std::vector<char> touched;
    std::vector<int> unfit;
    if (!modeller.rebuild(&m, edit, merged, touched, &unfit)) {
      for (int p : unfit) guilty.push_back(edit.old_panel[p]);
      return false;
    }
    const std::vector<int> before = corners_now(merged, m);
    for (int i = 0; i < merged.topology->number_of_corners(); ++i) {
      const double was = before[i] >= 0 ? modeller.displacement(m, before[i]) : 0; // a mended ear may have put it far
      if (modeller.displacement(merged, i) > (std::max)(farthest, was))
        for (int p : merged.topology->corner_panels[i])
          if (touched[p]) guilty.push_back(edit.old_panel[p]);
    }
    if (merged.faults == 0 && guilty.empty() && unusable)
      for (int p : unusable(merged)) guilty.push_back(edit.old_panel[p]);
    if (merged.faults == 0 && guilty.empty()) return true;
    for (int p = 0; p < merged.panels(); ++p)
      if (!merged.surface->is_simple(p)) guilty.push_back(edit.old_panel[p]);
    for (const auto& contact : merged.contacts)
      for (int p : contact) guilty.push_back(edit.old_panel[p]);
    return false;
  }

  /// A large panel with many corners takes in a small one without moving.
  static Label_edit merging(const Panel_model& m, const std::vector<Merger>& mergers)
  {
    std::vector<int> into(m.panels());
    std::iota(into.begin(), into.end(), 0);
    for (const Merger& merger : mergers) into[merger.q] = merger.p;
    Label_edit edit = merge_panels(m.labels, into);
    edit.near_old = true;
    edit.held.assign(edit.old_panel.size(), 0);
    std::vector<int> now(m.panels(), -1);
    for (int p = 0; p < int(edit.old_panel.size()); ++p) now[edit.old_panel[p]] = p;
    for (const Merger& merger : mergers) {
      const bool held = corners(m, merger.p) >= many_corners && m.moments[merger.p].area > 4 * m.moments[merger.q].area;
      edit.held[now[merger.p]] = held;
      edit.refit[now[merger.p]] = !held;
    }
    return edit;
  }

  /// Drops the mergers near guilty panels; half of them if none is known to be near.
  void drop(const Panel_model& m, const std::vector<int>& guilty, std::vector<Merger>& mergers)
  {
    std::vector<char> is_guilty(m.panels(), 0);
    for (int p : guilty) is_guilty[p] = 1;
    const auto any = [&](const std::vector<int>& panels) {
      return std::any_of(panels.begin(), panels.end(), [&](int p) { return is_guilty[p]; });
    };
    if (drop_if(m, mergers, [&](const Merger& merger) { return any(merger.ring); })) return;
    if (drop_if(m, mergers, [&](const Merger& merger) { return any(merger.reach); })) return;
    if (mergers.size() == 1) failed.insert(key(m, mergers[0]));
    mergers.resize(mergers.size() / 2);
  }

  /// \return whether there were any
  template <class F>
  bool drop_if(const Panel_model& m, std::vector<Merger>& mergers, F blamed)
  {
    const auto first =
        std::stable_partition(mergers.begin(), mergers.end(), [&](const Merger& x) { return !blamed(x); });
    const bool any = first != mergers.end();
    for (auto i = first; i != mergers.end(); ++i) failed.insert(key(m, *i));
    mergers.erase(first, mergers.end());
    return any;
  }

  static int corners(const Panel_model& m, int p)
  {
    int n = 0;
    for (const auto& loop : m.topology->loops[p]) n += int(loop.size());
    return n;
  }

  /// Two panels, whatever their numbers.
  Key key(const Panel_model& m, const Merger& merger) const
  {
    if (known_labels != m.labels) {
      known_labels = m.labels;
      first_face.assign(m.panels(), -1);
      faces.assign(m.panels(), 0);
      for (int f = 0; f < int(m.labels.size()); ++f) {
        if (first_face[m.labels[f]] < 0) first_face[m.labels[f]] = f;
        ++faces[m.labels[f]];
      }
    }
    std::array<int, 2> a{first_face[merger.p], faces[merger.p]}, b{first_face[merger.q], faces[merger.q]};
    if (b < a) std::swap(a, b);
    return {a[0], a[1], b[0], b[1]};
  }

  static constexpr int many_corners = 16;
  static constexpr double farthest = 0.02; ///< that a corner may be from its vertex, in diagonals

  const Panel_modeller& modeller;
  Panel_edits edits;
  Unusable_panels unusable;
  std::set<Key> failed;
  mutable std::vector<int> known_labels, first_face, faces;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MERGE_ROUNDS_H
