// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_TOUCHES_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_TOUCHES_H

#include <CGAL/Multiplanar/internal/panel_fit.h>
#include <CGAL/Multiplanar/internal/panel_flips.h>
#include <CGAL/Multiplanar/internal/panel_labelling.h>
#include <CGAL/Multiplanar/internal/panel_pieces.h>

#include <cstddef>
#include <vector>

// Vertices where a panel touches itself: the gap is closed, or one of the runs is given away.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Whether the faces of label `p` are connected over edges; false if there are none. Linear time in its faces.
inline bool is_connected_panel(const Panel_labelling& panels, int p)
{
  const std::vector<int>& faces = panels.faces(p);
  if (faces.empty()) return false;
  std::vector<char> seen(faces.size(), 0);
  std::vector<int> stack{faces[0]};
  seen[panels.place(faces[0])] = 1;
  std::size_t reached = 0;
  while (!stack.empty()) {
    const int f = stack.back();
    stack.pop_back();
    ++reached;
    for (int g : panels.connectivity().neighbours[f])
      if (panels.label(g) == p && !seen[panels.place(g)]) seen[panels.place(g)] = 1, stack.push_back(g);
  }
  return reached == faces.size();
}

/// Tries a handover in full, whatever it does to the topology. \return whether it removed touches and left the panel
/// that gave connected; if not, it is taken back
inline bool removes_touches(Panel_labelling& panels, const Handover& h)
{
  const int giver = panels.label(h.faces[0]), before = panels.number_of_touches();
  const std::size_t mark = panels.mark();
  panels.relabel(h.faces, h.panel);
  if (panels.number_of_touches() < before && is_connected_panel(panels, giver)) return true;
  panels.roll_back(mark);
  return false;
}

/// Merges the two panels at `v` that cost least together, one of them touching itself.
inline void merge_at_touch(Panel_labelling& panels, Panel_fits& fits, int v)
{
  const std::vector<Run> runs = runs_around(panels, v);
  int p = -1, q = -1;
  double least = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const int a = runs[i].label, b = runs[(i + 1) % runs.size()].label;
    const double cost = fits.merge_cost(a, b);
    if (p == -1 || cost < least) p = a, q = b, least = cost;
  }
  join_panels(panels, p, q);
}

/// Removes one or more touches at `v` as cheaply as possible: a run changes hands, or, where that would tear a panel or
/// make as many new touches, two panels are merged.
/// \return false if panels were merged
inline bool repair_touch(Panel_labelling& panels, Panel_fits& fits, int v)
{
  std::vector<Handover> handovers;
  handovers_around(panels, v, handovers);
  const Handover* best = nullptr;
  double least = 0;
  for (const Handover& h : handovers) {
    const double cost = handover_cost(panels, fits, h);
    if (best && cost >= least) continue;
    const std::size_t mark = panels.mark();
    if (!removes_touches(panels, h)) continue;
    panels.roll_back(mark);
    best = &h;
    least = cost;
  }
  if (best) panels.relabel(best->faces, best->panel);
  else merge_at_touch(panels, fits, v);
  return best != nullptr;
}

/// Removes all touches at `vertices` and those that come up under way. Every step removes a touch or a panel.
/// \return the number of panels lost
inline int repair_touches(Panel_labelling& panels, Panel_fits& fits, std::vector<int> vertices)
{
  int merges = 0;
  while (panels.number_of_touches() > 0 && !vertices.empty()) {
    const int v = vertices.back();
    if (panels.touches_of(v) == 0) {
      vertices.pop_back();
      continue;
    }
    const std::size_t mark = panels.mark();
    merges += !repair_touch(panels, fits, v);
    for (int f : panels.changed_faces(mark))
      for (int w : panels.connectivity().triangles[f])
        if (panels.touches_of(w) > 0) vertices.push_back(w);
  }
  return merges;
}

/// Removes all touches. \return the number of panels lost
inline int repair_touches(Panel_labelling& panels, Panel_fits& fits)
{
  std::vector<int> vertices;
  for (int v = panels.connectivity().number_of_vertices(); v-- > 0;)
    if (panels.touches_of(v) > 0) vertices.push_back(v);
  const int merges = repair_touches(panels, fits, std::move(vertices));
  CGAL_postcondition(panels.number_of_touches() == 0);
  return merges;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_TOUCHES_H
