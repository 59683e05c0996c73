// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_TOPOLOGY_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_TOPOLOGY_H

#include <CGAL/Multiplanar/internal/panel_labelling.h>
#include <CGAL/Multiplanar/make_panel_complex.h>

#include <algorithm>
#include <cstdlib>
#include <unordered_set>
#include <vector>

// The shape of one panel as a surface with boundary.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A boundary of a panel that passes no corner, as half-edges 3 f + i in order. The panel across is the same all along.
using Closed_boundary = std::vector<int>;

/// What is wrong with the topology of one panel.
struct Panel_topology
{
  int loops = 0;
  int handles = 0;                     ///< (2 - loops - Euler characteristic) / 2: 0 for a planar domain
  std::vector<Closed_boundary> closed; ///< its boundaries without corners

  /// A panel that is the whole surface counts as one problem, whatever its genus.
  int problems() const { return loops == 0 ? 1 : std::abs(handles) + int(closed.size()); }
};

/// The number of distinct vertices of faces.
inline int count_vertices(const Connectivity& c, const std::vector<int>& faces)
{
  std::vector<int> vertices;
  vertices.reserve(3 * faces.size());
  for (int f : faces) vertices.insert(vertices.end(), c.triangles[f].begin(), c.triangles[f].end());
  std::sort(vertices.begin(), vertices.end());
  return int(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
}

/// \pre the panel is connected, `panels` watches, and the panel touches itself nowhere. O(n log n) time for n faces.
inline Panel_topology panel_topology(const Panel_labelling& panels, int p)
{
  const Connectivity& c = panels.connectivity();
  const Boundary_walk walk(c, panels.labels());
  std::vector<int> boundary;
  for (int f : panels.faces(p))
    for (int i = 0; i < 3; ++i)
      if (panels.label(c.neighbours[f][i]) != p) boundary.push_back(3 * f + i);
  std::sort(boundary.begin(), boundary.end());

  Panel_topology result;
  std::unordered_set<int> seen;
  for (int start : boundary) {
    if (!seen.insert(start).second) continue;
    Closed_boundary loop{start};
    bool corner = panels.labels_at(walk.source(start)).size() > 2;
    for (int h = walk.next(start); h != start; h = walk.next(h)) {
      seen.insert(h);
      loop.push_back(h);
      corner = corner || panels.labels_at(walk.source(h)).size() > 2;
    }
    ++result.loops;
    if (!corner) result.closed.push_back(std::move(loop));
  }
  const int faces = int(panels.faces(p).size());
  const int edges = (3 * faces + int(boundary.size())) / 2;
  const int euler = count_vertices(c, panels.faces(p)) - edges + faces;
  result.handles = (2 - result.loops - euler) / 2;
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_TOPOLOGY_H
