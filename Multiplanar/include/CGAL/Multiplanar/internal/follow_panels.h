// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FOLLOW_PANELS_H
#define CGAL_MULTIPLANAR_INTERNAL_FOLLOW_PANELS_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/Guarded_motion.h>

#include <cmath>
#include <vector>

// The mesh goes to its panels. All vertices move together along straight lines in small steps, each under the guard; a
// vertex that is held back is drawn towards the mean of its neighbours for a while, which opens the folds that hold it,
// and tries again.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// How a motion towards given targets ended.
struct Follow_report
{
  std::size_t held_back = 0; ///< vertices that are not at their target
  int steps = 0;
};

inline std::vector<int> vertices_away(const Points& points, const Points& targets)
{
  std::vector<int> away;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (points[v] != targets[v]) away.push_back(int(v));
  return away;
}

/// The mean of the neighbours of vertex `v`.
inline Point_3 neighbour_mean(const Connectivity& c, const Points& points, int v)
{
  Vector_3 sum(0, 0, 0);
  int n = 0;
  for (int f : c.star(v)) {
    sum = sum + (points[c.triangles[f][(c.corner_of(f, v) + 1) % 3]] - CGAL::ORIGIN);
    ++n;
  }
  return CGAL::ORIGIN + sum / n;
}

/// The vertices at most `rings` edges away from `seeds`.
inline std::vector<char> neighbourhood(const Connectivity& c, const std::vector<int>& seeds, int rings)
{
  std::vector<char> in(c.number_of_vertices(), 0);
  std::vector<int> front = seeds;
  for (int v : seeds) in[v] = 1;
  for (int r = 0; r < rings; ++r) {
    std::vector<int> next;
    for (int v : front)
      for (int f : c.star(v))
        for (int u : c.triangles[f])
          if (!in[u]) in[u] = 1, next.push_back(u);
    front.swap(next);
  }
  return in;
}

/// Smooths the surface around the vertices that are held back, under the guard.
inline void relax_around(const Connectivity& c, Guarded_motion& guard, const std::vector<int>& held_back, int rings,
                         Points& points)
{
  const std::vector<char> in = neighbourhood(c, held_back, rings);
  Points relaxed = points;
  for (int v = 0; v < c.number_of_vertices(); ++v)
    if (in[v]) relaxed[v] = CGAL::midpoint(points[v], neighbour_mean(c, points, v));
  guard.move(points, relaxed);
}

/// Moves `points` to `targets` as far as the mesh stays embedded on the way.
/// \param steps steps of the common straight motion
/// \param attempts how often vertices that are held back are relaxed and tried again
inline Follow_report follow(const Connectivity& c, Guarded_motion& guard, const Points& targets, int steps, int attempts,
                            Points& points)
{
  Follow_report report;
  const Points start = points;
  for (int s = 1; s <= steps; ++s, ++report.steps) {
    const double t = double(s) / steps;
    Points waypoint = targets;
    if (s < steps)
      for (std::size_t v = 0; v < points.size(); ++v)
        if (start[v] != targets[v]) waypoint[v] = start[v] + t * (targets[v] - start[v]);
    guard.move(points, waypoint);
  }
  for (int a = 0; a < attempts; ++a) {
    const std::vector<int> away = vertices_away(points, targets);
    if (away.empty()) break;
    relax_around(c, guard, away, 1 + a % 3, points);
    guard.move(points, targets);
    ++report.steps;
  }
  report.held_back = vertices_away(points, targets).size();
  return report;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FOLLOW_PANELS_H
