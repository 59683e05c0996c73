// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SEEDS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SEEDS_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/label_costs.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

// Panels that owe nothing to a labelling: for where a labelling cannot be repaired.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Cells around `count` faces spread evenly over the surface: each seed is the face farthest from those before, each
/// face belongs to the nearest seed (over the surface, from centroid to centroid). About O(F log F log count) time.
inline std::vector<int> evenly_spread_labels(const Connectivity& c, const Label_costs& costs, int count)
{
  const int faces = c.number_of_faces();
  std::vector<double> distance(faces, (std::numeric_limits<double>::max)());
  std::vector<int> label(faces, 0);
  using Entry = std::pair<double, int>;
  int seed = 0;
  for (int i = 0; i < count && i < faces; ++i) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance[seed] = 0;
    label[seed] = i;
    queue.emplace(0, seed);
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      const int f = e.second;
      if (e.first > distance[f]) continue;
      for (int g : c.neighbours[f]) {
        const double d = e.first + std::sqrt(CGAL::squared_distance(costs.centroid(f), costs.centroid(g)));
        if (d < distance[g]) distance[g] = d, label[g] = i, queue.emplace(d, g);
      }
    }
    for (int f = 0; f < faces; ++f)
      if (distance[f] > distance[seed]) seed = f;
  }
  return label;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SEEDS_H
