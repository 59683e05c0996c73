// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SURGERY_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SURGERY_H

#include <CGAL/Multiplanar/internal/panel_fit.h>
#include <CGAL/Multiplanar/internal/panel_labelling.h>
#include <CGAL/Multiplanar/internal/panel_mending.h>
#include <CGAL/Multiplanar/internal/panel_pieces.h>
#include <CGAL/Multiplanar/internal/panel_topology.h>
#include <CGAL/Multiplanar/internal/panel_touches.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A labelling under repair, with what all repairs share.
struct Panel_work
{
  /// \param realisable whether panels must become ones that can be flat, or only connected ones without touches
  Panel_work(const Label_costs& costs, Panel_labelling initial, bool realisable)
      : panels(std::move(initial)), fits(costs, panels), mender(panels, fits), realisable(realisable)
  {
    panels.start_watching();
  }
  Panel_work(const Panel_work&) = delete; // its parts refer to each other

  Panel_labelling panels;
  Panel_fits fits;
  Panel_mender mender;
  bool realisable;
  int relabelled = 0; ///< faces that changed hands in local repairs that stand
};

/// The topological problems of some panels.
inline int topology_problems(const Panel_labelling& panels, const std::vector<int>& which)
{
  int n = 0;
  for (int p : which) n += panel_topology(panels, p).problems();
  return n;
}

/// Whether everything is as it must be, if it was before the topology of the given panels changed.
inline bool is_sound(const Panel_work& work, const std::vector<int>& changed)
{
  if (!work.realisable) return work.panels.number_of_touches() == 0;
  return work.panels.number_of_local_problems() == 0 && topology_problems(work.panels, changed) == 0;
}

/// The distinct labels of the faces that changed since `mark`.
inline std::vector<int> changed_panels(const Panel_labelling& panels, std::size_t mark)
{
  std::vector<int> result;
  for (int f : panels.changed_faces(mark)) result.push_back(panels.label(f));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Removes touches, chords and repeated corners around the faces changed since `mark`, as far as it can.
inline void settle(Panel_work& work, std::size_t mark)
{
  std::vector<int> vertices;
  const auto collect = [&] {
    vertices.clear();
    for (int f : work.panels.changed_faces(mark))
      for (int v : work.panels.connectivity().triangles[f])
        if (work.panels.labels_at(v).size() > 1) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  };
  collect();
  if (work.panels.number_of_touches() > 0) {
    repair_touches(work.panels, work.fits, vertices);
    collect();
  }
  if (work.realisable && work.panels.number_of_touches() == 0) work.relabelled += work.mender.mend(vertices);
}

/// Pairs of panels whose merger may resolve a problem left by the changes since `mark`, cheapest first.
inline std::vector<std::pair<int, int>> culprits(Panel_work& work, std::size_t mark)
{
  std::set<std::pair<int, int>> pairs;
  const Panel_labelling& panels = work.panels;
  const Connectivity& c = panels.connectivity();
  for (int p : changed_panels(panels, mark))
    for (const Closed_boundary& b : panel_topology(panels, p).closed)
      pairs.insert(std::minmax(p, panels.label(c.neighbours[b[0] / 3][b[0] % 3])));
  std::set<int> vertices;
  for (int f : panels.changed_faces(mark))
    for (int v : c.triangles[f])
      if (panels.labels_at(v).size() > 2) vertices.insert(v);
  for (int v : vertices) {
    const Label_set& s = panels.labels_at(v);
    for (std::size_t i = 0; i + 2 < s.size(); ++i)
      for (std::size_t j = i + 1; j + 1 < s.size(); ++j)
        for (std::size_t k = j + 1; k < s.size(); ++k)
          if (panels.is_repeated(s[i], s[j], s[k])) {
            pairs.insert({s[i], s[j]});
            pairs.insert({s[i], s[k]});
            pairs.insert({s[j], s[k]});
          }
  }
  std::vector<std::tuple<double, int, int>> priced;
  for (const auto& pair : pairs)
    priced.emplace_back(work.fits.merge_cost(pair.first, pair.second), pair.first, pair.second);
  std::sort(priced.begin(), priced.end());
  std::vector<std::pair<int, int>> result;
  for (const auto& e : priced) result.emplace_back(std::get<1>(e), std::get<2>(e));
  return result;
}

/// Merges two neighbouring panels of a sound labelling so that it stays sound; up to `depth` further
/// panels around the place are merged in if need be (a panel left with two neighbours goes to one of them, and so on).
/// \return false, with everything as before, if that fails
inline bool merge_soundly(Panel_work& work, int p, int q, int depth, std::size_t mark)
{
  if (!are_neighbours(work.panels, p, q)) return false;
  const std::size_t here = work.panels.mark();
  const int relabelled = work.relabelled;
  join_panels(work.panels, p, q);
  settle(work, here);
  if (is_sound(work, changed_panels(work.panels, mark))) return true;
  if (depth > 0)
    for (const auto& pair : culprits(work, mark))
      if (merge_soundly(work, pair.first, pair.second, depth - 1, mark)) return true;
  work.panels.roll_back(here);
  work.relabelled = relabelled;
  return false;
}

inline bool merge_soundly(Panel_work& work, int p, int q, int depth = 0)
{
  return merge_soundly(work, p, q, depth, work.panels.mark());
}

/// Merges at least cost until at most `target` panels are left, from a sound labelling to a sound one.
/// \return the number of merges; the target may be missed if no more panels can be merged
inline int merge_down_to(Panel_work& work, int target)
{
  const int before = work.panels.number_of_panels();
  for (int depth = 0; depth <= 4 && work.panels.number_of_panels() > target;) {
    const int at_start = work.panels.number_of_panels();
    Merge_queue queue(work.panels, work.fits);
    Merge_queue::Pair pair;
    while (work.panels.number_of_panels() > target && queue.pop(pair)) {
      const std::size_t mark = work.panels.mark();
      if (!merge_soundly(work, pair.p, pair.q, depth)) continue;
      queue.update(pair.p);
      queue.update(pair.q);
      for (int r : changed_panels(work.panels, mark))
        if (r != pair.p && r != pair.q && depth > 0) queue.update(r);
      work.panels.commit();
      if (depth > 0) break; // plain merges first
    }
    depth = work.panels.number_of_panels() < at_start ? 0 : depth + 1;
  }
  return before - work.panels.number_of_panels();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SURGERY_H
