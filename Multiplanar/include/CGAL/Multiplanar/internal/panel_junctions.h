// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_JUNCTIONS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_JUNCTIONS_H

#include <CGAL/Multiplanar/internal/panel_flips.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <cstddef>
#include <vector>

// Corners of four or more panels fall apart into corners of three where a few faces can change hands.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// By how many panels the corners among some vertices exceed three.
inline int excess_valence(const Panel_labelling& panels, const std::vector<int>& vertices)
{
  int n = 0;
  for (int v : vertices) n += (std::max)(0, int(panels.labels_at(v).size()) - 3);
  return n;
}

/// The vertices of faces, each once.
inline std::vector<int> vertices_of(const Connectivity& c, const std::vector<int>& faces)
{
  std::vector<int> vertices;
  for (int f : faces) vertices.insert(vertices.end(), c.triangles[f].begin(), c.triangles[f].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Lowers the valence of the corner at `v` by the cheapest handover that adds no problem and no valence elsewhere.
inline bool simplify_corner(Panel_work& work, int v)
{
  std::vector<Handover> handovers;
  handovers_around(work.panels, v, handovers);
  const int problems = work.panels.number_of_local_problems();
  const Handover* best = nullptr;
  double least = 0;
  for (const Handover& h : handovers) {
    const double cost = handover_cost(work.panels, work.fits, h);
    if (best && cost >= least) continue;
    const std::vector<int> vertices = vertices_of(work.panels.connectivity(), h.faces);
    const int before = excess_valence(work.panels, vertices);
    const std::size_t mark = work.panels.mark();
    const bool good = flip_all(work.panels, h.faces, h.panel) && work.panels.number_of_local_problems() <= problems &&
                      excess_valence(work.panels, vertices) < before;
    work.panels.roll_back(mark);
    if (good) best = &h, least = cost;
  }
  if (!best) return false;
  work.relabelled += int(best->faces.size());
  return flip_all(work.panels, best->faces, best->panel);
}

/// Simplifies corners until no handover does any more.
inline void simplify_corners(Panel_work& work)
{
  for (bool changed = true; changed;) { // the sum of excess valences falls in each round
    changed = false;
    for (int v = 0; v < work.panels.connectivity().number_of_vertices(); ++v)
      while (work.panels.labels_at(v).size() > 3 && simplify_corner(work, v)) changed = true;
  }
  work.panels.commit();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_JUNCTIONS_H
