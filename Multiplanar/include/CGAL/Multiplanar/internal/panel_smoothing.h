// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SMOOTHING_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SMOOTHING_H

#include <CGAL/Multiplanar/internal/panel_flips.h>
#include <CGAL/Multiplanar/internal/panel_junctions.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <cstddef>
#include <vector>

// Boundaries that mergers, splits and repairs left ragged are drawn tight: faces change hands where that lowers the
// energy of eq. 1 and harms nothing.

namespace CGAL {
namespace Multiplanar {
namespace internal {

class Boundary_smoother
{
public:
  Boundary_smoother(Panel_work& work, const Potts_graph& graph) : work(work), panels(work.panels), graph(graph)
  {
    for (int p = 0; p < panels.number_of_labels(); ++p)
      planes.push_back(panels.faces(p).empty() ? Plane() : work.fits.plane(p));
  }

  /// Flips single faces until none lowers the energy, planes fixed. \return the number of flips
  int run()
  {
    const Connectivity& c = panels.connectivity();
    waiting.assign(c.number_of_faces(), 0);
    for (int f = c.number_of_faces(); f-- > 0;) enqueue(f);
    int flips = 0;
    while (!queue.empty()) {
      const int f = queue.back();
      queue.pop_back();
      waiting[f] = 0;
      if (!improve(f)) continue;
      ++flips;
      for (int v : c.triangles[f])
        for (int g : c.star(v)) enqueue(g);
    }
    panels.commit();
    return flips;
  }

private:
  void enqueue(int f)
  {
    if (waiting[f]) return;
    for (int g : panels.connectivity().neighbours[f])
      if (panels.label(g) != panels.label(f)) {
        waiting[f] = 1;
        queue.push_back(f);
        return;
      }
  }

  /// Gives `f` to the neighbour that lowers the energy most.
  bool improve(int f)
  {
    int best = -1;
    double least = -1e-12 * (1 + work.fits.costs().area(f)); // flips must lower the energy, not only rounding
    for (int g : panels.connectivity().neighbours[f]) {
      const int b = panels.label(g);
      if (b == panels.label(f) || b == best || !is_simple_flip(panels, f, b)) continue;
      const double rise = energy(f, b) - energy(f, panels.label(f));
      if (rise < least && is_harmless(f, b)) best = b, least = rise;
    }
    if (best != -1) panels.relabel({f}, best);
    return best != -1;
  }

  /// What face f costs with label p, its neighbours having theirs.
  double energy(int f, int p) const
  {
    double sum = work.fits.costs().data_cost(f, planes[p]);
    for (int a = graph.begin[f]; a < graph.begin[f + 1]; ++a)
      if (panels.label(graph.adjacent[a]) != p) sum += graph.weight[a];
    return sum;
  }

  bool is_harmless(int f, int b)
  {
    const auto& t = panels.connectivity().triangles[f];
    const std::vector<int> vertices(t.begin(), t.end());
    const int problems = panels.number_of_local_problems(), excess = excess_valence(panels, vertices);
    const std::size_t mark = panels.mark();
    panels.relabel({f}, b);
    const bool harmless = panels.number_of_local_problems() <= problems && excess_valence(panels, vertices) <= excess;
    panels.roll_back(mark);
    return harmless;
  }

  Panel_work& work;
  Panel_labelling& panels;
  const Potts_graph& graph;
  std::vector<Plane> planes;
  std::vector<int> queue;
  std::vector<char> waiting;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SMOOTHING_H
