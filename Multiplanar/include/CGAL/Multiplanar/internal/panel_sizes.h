// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SIZES_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SIZES_H

#include <CGAL/Multiplanar/internal/panel_splitting.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// Panels that are not worth a part of their own: too small, too narrow, or flush with a neighbour.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The least area of a panel, and its least width, taken as 4 area / perimeter (for a disc, its diameter); 0 for none.
struct Least_size
{
  double area = 0, width = 0;
};

inline double panel_area(const Panel_work& work, int p)
{
  double sum = 0;
  for (int f : work.panels.faces(p)) sum += work.fits.costs().area(f);
  return sum;
}

inline double panel_perimeter(const Panel_work& work, const Points& points, int p)
{
  const Connectivity& c = work.panels.connectivity();
  double sum = 0;
  for (int f : work.panels.faces(p))
    for (int i = 0; i < 3; ++i)
      if (work.panels.label(c.neighbours[f][i]) != p)
        sum += std::sqrt(CGAL::squared_distance(points[c.triangles[f][i]], points[c.triangles[f][(i + 1) % 3]]));
  return sum;
}

inline bool is_large_enough(const Panel_work& work, const Points& points, const Least_size& least, int p)
{
  if (!(least.area > 0) && !(least.width > 0)) return true;
  const double area = panel_area(work, p);
  return area >= least.area && 4 * area >= least.width * panel_perimeter(work, points, p);
}

/// Merges neighbours that lie in one plane (see `least_angle`), from a sound labelling to a sound one.
/// \return the number of panels lost
inline int merge_flush_panels(Panel_work& work)
{
  const int before = work.panels.number_of_panels();
  Merge_queue queue(work.panels, work.fits);
  Merge_queue::Pair pair;
  while (queue.pop(pair)) {
    const double area = (std::min)(work.fits.weighted_area(pair.p), work.fits.weighted_area(pair.q));
    if (pair.cost > least_angle * area || !merge_soundly(work, pair.p, pair.q)) continue;
    queue.update(pair.p);
    queue.update(pair.q);
    work.panels.commit();
  }
  return before - work.panels.number_of_panels();
}

/// Merges panel `p` with the neighbour that costs least among those with which it can be merged.
inline bool merge_with_cheapest_neighbour(Panel_work& work, int p)
{
  std::vector<std::pair<double, int>> neighbours;
  for (int q : neighbouring_panels(work.panels, p)) neighbours.emplace_back(work.fits.merge_cost(p, q), q);
  std::sort(neighbours.begin(), neighbours.end());
  for (const auto& q : neighbours)
    if (merge_soundly(work, p, q.second, 2)) {
      work.panels.commit();
      return true;
    }
  return false;
}

/// Merges panels that are too small, from a sound labelling to a sound one. A panel that can be merged with none of its
/// neighbours stays. \return the number of panels lost
inline int merge_small_panels(Panel_work& work, const Points& points, const Least_size& least)
{
  const int before = work.panels.number_of_panels();
  for (bool changed = least.area > 0 || least.width > 0; changed;) {
    changed = false;
    for (int p = 0; p < work.panels.number_of_labels(); ++p)
      if (!work.panels.faces(p).empty() && !is_large_enough(work, points, least, p))
        changed = merge_with_cheapest_neighbour(work, p) || changed;
  }
  return before - work.panels.number_of_panels();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SIZES_H
