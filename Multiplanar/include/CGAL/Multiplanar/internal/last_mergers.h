// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_LAST_MERGERS_H
#define CGAL_MULTIPLANAR_INTERNAL_LAST_MERGERS_H

#include <CGAL/Multiplanar/internal/merge_rounds.h>
#include <CGAL/Multiplanar/internal/panel_edits.h>
#include <CGAL/Multiplanar/internal/sets_to_merge.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Makes a model without faults one of fewer panels, one step at a time, where pairs of neighbours are not enough. A
/// step merges a set of panels (`Sets_to_merge`), shares a panel out among its neighbours, or gives a hole one wall
/// less. The set whose panels lie in the thinnest slab comes first.
class Last_mergers
{
public:
  using Test = std::function<bool(Panel_model&)>;

  /// \param usable may change a model that it is asked of; what it does not want is not taken
  Last_mergers(const Panel_modeller& modeller, const Accuracy_options& accuracy, Test usable)
      : modeller(modeller), c(modeller.connectivity()), edits(modeller, 0.02), accuracy(accuracy),
        usable(std::move(usable))
  {
  }

  /// Steps that take corners far from the mesh come last.
  /// \return false if no step leads to at most `panels`; `m` is then the smallest model found
  bool run(int panels, Panel_model& m, const Panels_left& asked = {})
  {
    go_on = asked;
    const double work = double(c.number_of_faces()) * (std::max)(1.0, m.panels() / 400.0); // of an attempt
    left = (std::max)(1000, int(most_work / work));
    for (double distance : {0.02, 0.05, 0.15, 1.0}) {
      farthest = distance;
      failed.clear();
      bool any = false; // steps since `failed` was empty
      while (m.panels() > panels && left > 0) {
        if (step(m) || dissolve(m) || turn_walls(m)) any = true;
        else if (!any) break;
        else failed.clear(), any = false, improve(m); // what is around them has changed
      }
    }
    return m.panels() <= panels;
  }

private:
  using Set = Sets_to_merge::Set;

  bool step(Panel_model& m)
  {
    const std::vector<std::vector<int>> faces = Panel_edits::faces_of_panels(m);
    std::vector<std::pair<double, Set>> order;
    for (const Set& set : Sets_to_merge(*m.topology).all()) order.emplace_back(edits.thickness(m, faces, set), set);
    std::stable_sort(order.begin(), order.end());
    for (const auto& entry : order) {
      if (left <= 0) return false;
      const Set key = name(faces, entry.second);
      if (failed.count(key)) continue;
      Label_edit edit = merging(m, entry.second);
      if (accept(m, edit)) return true;
      edit.near_old = false;
      if (accept_clipped(m, edit)) return true;
      failed.insert(key);
    }
    return false;
  }

  bool dissolve(Panel_model& m)
  {
    std::vector<std::pair<double, int>> order;
    for (int p = 0; p < m.panels(); ++p) order.emplace_back(m.moments[p].area, p);
    std::sort(order.begin(), order.end());
    for (const auto& entry : order) {
      if (left <= 0) return false;
      Label_edit edit = edits.dissolve(m, entry.second);
      if (accept_clipped(m, edit)) return true;
    }
    return false;
  }

  /// Gives a hole fewer walls, which all may turn: no two neighbours of five walls are near one plane.
  bool turn_walls(Panel_model& m)
  {
    const Sets_to_merge sets(*m.topology);
    for (int p = 0; p < m.panels(); ++p)
      for (std::size_t l = 1; l < m.topology->loops[p].size(); ++l) {
        const Set along = sets.walls(p, m.topology->loops[p][l]);
        if (along.size() < 4) continue;
        for (int gone : along) {
          if (left <= 0) return false;
          Label_edit edit = edits.divide_among_others(m, along, gone);
          if (accept_clipped(m, edit)) return true;
        }
      }
    return false;
  }

  void improve(Panel_model& m) const
  {
    if (m.panels() > most_improved) return;
    Panel_model improved = m;
    modeller.improve_all(improved, accuracy);
    if (improved.faults == 0 && usable(improved)) m = std::move(improved);
  }

  bool accept(Panel_model& m, const Label_edit& edit)
  {
    --left;
    if (go_on && !go_on(m.panels())) left = 0;
    Panel_model result;
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, result, touched) || result.faults > 0) return false;
    if (modeller.largest_displacement(result) > (std::max)(farthest, modeller.largest_displacement(m))) return false;
    if (!usable(result)) return false;
    m = std::move(result);
    return true;
  }

  bool accept_clipped(Panel_model& m, Label_edit& edit)
  {
    clip_ears(c, edit.labels);
    std::vector<char> used(edit.old_panel.size(), 0);
    for (int label : edit.labels) used[label] = 1;
    return std::find(used.begin(), used.end(), 0) == used.end() && accept(m, edit);
  }

  /// The set, whatever the numbers of its panels.
  static Set name(const std::vector<std::vector<int>>& faces, const Set& set)
  {
    std::vector<std::pair<int, int>> parts;
    for (int p : set) parts.emplace_back(faces[p].front(), int(faces[p].size()));
    std::sort(parts.begin(), parts.end());
    Set result;
    for (const auto& part : parts) result.push_back(part.first), result.push_back(part.second);
    return result;
  }

  /// All of the set go into the largest.
  static Label_edit merging(const Panel_model& m, const Set& set)
  {
    int largest = set[0];
    for (int p : set)
      if (m.moments[p].area > m.moments[largest].area) largest = p;
    std::vector<int> into(m.panels());
    std::iota(into.begin(), into.end(), 0);
    for (int p : set) into[p] = largest;
    Label_edit edit = merge_panels(m.labels, into);
    edit.near_old = true;
    for (int p = 0; p < int(edit.old_panel.size()); ++p) edit.refit[p] = edit.old_panel[p] == largest;
    return edit;
  }

  static constexpr int most_improved = 400; ///< panels: all of them at a time take time with their third power
  static constexpr double most_work = 4e8;  ///< in faces looked at

  const Panel_modeller& modeller;
  const Connectivity& c;
  Panel_edits edits;
  Accuracy_options accuracy;
  Test usable;
  Panels_left go_on;
  std::set<Set> failed;
  int left = 0;        ///< attempts
  double farthest = 1; ///< that a corner may be from its vertex, in diagonals
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_LAST_MERGERS_H
