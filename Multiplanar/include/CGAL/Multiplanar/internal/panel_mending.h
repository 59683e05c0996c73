// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_MENDING_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_MENDING_H

#include <CGAL/Multiplanar/internal/panel_fit.h>
#include <CGAL/Multiplanar/internal/panel_flips.h>
#include <CGAL/Multiplanar/internal/panel_labelling.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// Chords and repeated corners are removed by relabelling few faces.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The part of a panel on the side of face `f` of the inner edge between `f` and `g`, cut off there.
/// \return empty if it has more than `limit` faces or goes around the edge
inline std::vector<int> cut_off_part(const Panel_labelling& panels, int f, int g, std::size_t limit)
{
  const Connectivity& c = panels.connectivity();
  std::vector<int> part{f};
  for (std::size_t i = 0; i < part.size(); ++i)
    for (int h : c.neighbours[part[i]]) {
      if (panels.label(h) != panels.label(f) || (part[i] == f && h == g)) continue;
      if (h == g || part.size() >= limit) return {};
      if (std::find(part.begin(), part.end(), h) == part.end()) part.push_back(h);
    }
  return part;
}

/// Removes local problems (see `Panel_labelling`) near given vertices by handovers that are simple flips, so panels
/// keep their topology. Each accepted step lowers the number of problems: it cannot cycle.
class Panel_mender
{
public:
  Panel_mender(Panel_labelling& panels, Panel_fits& fits)
      : panels(panels), fits(fits), waiting(panels.connectivity().number_of_vertices(), 0)
  {
  }

  /// Largest part of a panel that is given away behind a chord.
  std::size_t largest_part = 48;

  /// \pre no panel touches itself
  /// \return the number of faces that changed hands
  int mend(const std::vector<int>& vertices)
  {
    for (int v : vertices) enqueue(v);
    int relabelled = 0;
    while (!queue.empty()) {
      const int v = queue.back();
      queue.pop_back();
      waiting[v] = 0;
      while (has_problem(v)) {
        const std::size_t mark = panels.mark();
        if (!step(v)) break;
        const std::vector<int> changed = panels.changed_faces(mark);
        relabelled += int(changed.size());
        for (int f : changed)
          for (int w : panels.connectivity().triangles[f]) enqueue(w);
      }
    }
    return relabelled;
  }

  int mend_all()
  {
    std::vector<int> vertices(panels.connectivity().number_of_vertices());
    for (int v = 0; v < int(vertices.size()); ++v) vertices[v] = int(vertices.size()) - 1 - v;
    return mend(vertices);
  }

  bool has_problem(int v) const
  {
    if (panels.labels_at(v).size() < 2) return false;
    return has_chord(v) || repeats(v);
  }

private:
  bool has_chord(int v) const
  {
    bool found = false;
    panels.for_each_chord(v, [&](int) { found = true; });
    return found;
  }

  bool repeats(int v) const
  {
    if (panels.number_of_repeated_corners() == 0) return false;
    const Label_set& s = panels.labels_at(v);
    for (std::size_t i = 0; i + 2 < s.size(); ++i)
      for (std::size_t j = i + 1; j + 1 < s.size(); ++j)
        for (std::size_t k = j + 1; k < s.size(); ++k)
          if (panels.is_repeated(s[i], s[j], s[k])) return true;
    return false;
  }

  void enqueue(int v)
  {
    if (waiting[v] || !has_problem(v)) return;
    waiting[v] = 1;
    queue.push_back(v);
  }

  /// What may be tried against the problems at `v`.
  std::vector<Handover> candidates(int v) const
  {
    std::vector<Handover> result;
    handovers_around(panels, v, result);
    panels.for_each_chord(v, [&](int w) {
      parts_behind_chord(v, w, result);
      handovers_around(panels, w, result);
    });
    return result;
  }

  void parts_behind_chord(int v, int w, std::vector<Handover>& result) const
  {
    const Connectivity& c = panels.connectivity();
    for (int f : c.star(v)) {
      const int g = c.neighbours[f][c.corner_of(f, v)]; // across the edge that leaves v
      if (c.triangles[f][(c.corner_of(f, v) + 1) % 3] != w) continue;
      for (const auto& side : {std::make_pair(f, g), std::make_pair(g, f)}) {
        const std::vector<int> part = cut_off_part(panels, side.first, side.second, largest_part);
        if (part.empty()) continue;
        for (int q : panels.labels_at(v))
          if (q != panels.label(f) && contains(panels.labels_at(w), q)) result.push_back({part, q});
      }
    }
  }

  /// Takes the handover that removes most problems, the cheapest of equals; a pair of handovers if no single one helps.
  bool step(int v)
  {
    const std::vector<Handover> first = candidates(v);
    const std::size_t mark = panels.mark();
    if (take_best(first)) return true;
    const int before = panels.number_of_local_problems();
    for (const Handover& h : first) {
      if (flip_all(panels, h.faces, h.panel) && panels.number_of_local_problems() <= before + allowed_rise) {
        std::vector<Handover> second = candidates(v);
        const std::size_t middle = panels.mark();
        if (take_best(second, before)) return true;
        panels.roll_back(middle);
      }
      panels.roll_back(mark);
    }
    return false;
  }

  bool take_best(const std::vector<Handover>& handovers)
  {
    return take_best(handovers, panels.number_of_local_problems());
  }

  bool take_best(const std::vector<Handover>& handovers, int bound)
  {
    const Handover* best = nullptr;
    int fewest = bound;
    double least = 0;
    for (const Handover& h : handovers) {
      const std::size_t mark = panels.mark();
      const double cost = handover_cost(panels, fits, h);
      const bool done = flip_all(panels, h.faces, h.panel);
      const int problems = panels.number_of_local_problems();
      panels.roll_back(mark);
      if (!done || problems > fewest || problems >= bound) continue;
      if (problems == fewest && best && cost >= least) continue;
      best = &h;
      fewest = problems;
      least = cost;
    }
    if (best) flip_all(panels, best->faces, best->panel);
    return best != nullptr;
  }

  static constexpr int allowed_rise = 2; // problems that the first handover of a pair may add

  Panel_labelling& panels;
  Panel_fits& fits;
  std::vector<int> queue;
  std::vector<char> waiting;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_MENDING_H
