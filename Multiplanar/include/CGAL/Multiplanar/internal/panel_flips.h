// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_FLIPS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_FLIPS_H

#include <CGAL/Multiplanar/internal/panel_fit.h>
#include <CGAL/Multiplanar/internal/panel_labelling.h>

#include <algorithm>
#include <vector>

// Faces that change hands between neighbouring panels without changing the topology of either.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Whether giving face `f` to panel `b` leaves both panels what they are as surfaces: connected, the same number of
/// loops and handles, no touches. \pre neither panel touches itself at a vertex of `f`
inline bool is_simple_flip(const Panel_labelling& panels, int f, int b)
{
  const Connectivity& c = panels.connectivity();
  const int a = panels.label(f);
  int in_a = 0, in_b = 0, outside_a = -1, towards_b = -1;
  for (int i = 0; i < 3; ++i) {
    const int p = panels.label(c.neighbours[f][i]);
    if (p == a) ++in_a;
    else outside_a = i;
    if (p == b) ++in_b, towards_b = i;
  }
  if (a == b || in_b == 0 || in_a == 0) return false;
  // One edge inside a: f is an ear of it. Two: a must close around the vertex between them.
  if (in_a == 2 && panels.labels_at(c.triangles[f][(outside_a + 2) % 3]).size() > 1) return false;
  // One edge towards b: b must not be at the vertex across from it.
  return in_b == 2 || !contains(panels.labels_at(c.triangles[f][(towards_b + 2) % 3]), b);
}

/// Gives all of `faces` to panel `b` by simple flips, in any order that works.
/// \return false, with some of the faces given, if there is none
inline bool flip_all(Panel_labelling& panels, std::vector<int> faces, int b)
{
  while (!faces.empty()) {
    const auto simple = std::find_if(faces.begin(), faces.end(), [&](int f) { return is_simple_flip(panels, f, b); });
    if (simple == faces.end()) return false;
    panels.relabel({*simple}, b);
    faces.erase(simple);
  }
  return true;
}

/// Faces to be given to a panel.
struct Handover
{
  std::vector<int> faces;
  int panel;
};

/// By how much the data cost (eq. 2, planes as they are) would rise.
inline double handover_cost(const Panel_labelling& panels, Panel_fits& fits, const Handover& h)
{
  double sum = 0;
  const Plane to = fits.plane(h.panel);
  for (int f : h.faces) sum += fits.costs().data_cost(f, to) - fits.costs().data_cost(f, fits.plane(panels.label(f)));
  return sum;
}

/// Consecutive faces of one label around a vertex.
struct Run
{
  int label;
  std::vector<int> faces; // counter-clockwise
};

/// The runs around `v`, counter-clockwise; a single one if all faces have one label.
inline std::vector<Run> runs_around(const Panel_labelling& panels, int v)
{
  const auto star = panels.connectivity().star(v);
  const int n = int(star.size());
  int begin = 0;
  while (begin < n && panels.label(star[begin]) == panels.label(star[(begin + n - 1) % n])) ++begin;
  std::vector<Run> runs;
  for (int i = 0; i < n; ++i) {
    const int f = star[(begin + i) % n];
    if (runs.empty() || runs.back().label != panels.label(f)) runs.push_back({panels.label(f), {}});
    runs.back().faces.push_back(f);
  }
  return runs;
}

/// What panels around `v` could hand over to their neighbours there: whole runs, and faces at the ends of runs.
inline void handovers_around(const Panel_labelling& panels, int v, std::vector<Handover>& result)
{
  const std::vector<Run> runs = runs_around(panels, v);
  const int n = int(runs.size());
  if (n < 2) return;
  for (int i = 0; i < n; ++i) {
    const Run& run = runs[i];
    const int before = runs[(i + n - 1) % n].label, after = runs[(i + 1) % n].label;
    result.push_back({run.faces, before});
    if (after != before) result.push_back({run.faces, after});
    if (run.faces.size() == 1) continue;
    result.push_back({{run.faces.front()}, before});
    result.push_back({{run.faces.back()}, after});
  }
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_FLIPS_H
