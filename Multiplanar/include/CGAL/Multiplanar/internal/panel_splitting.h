// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SPLITTING_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SPLITTING_H

#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

// A panel is cut into connected parts that grow from seeds.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The part (an index into `seeds`) of each face of panel `p`, by its place in `panels.faces(p)`. Parts grow from their
/// seeds over edges, the face of least `priority(part, face, priority of the face it is reached from)` first; so each
/// is connected. `order`, if given, receives the faces in the order in which they are reached. \pre seeds are distinct
/// faces of p. O(n log n) time.
template <class Priority>
std::vector<int> grow_parts(const Panel_labelling& panels, int p, const std::vector<int>& seeds, Priority priority,
                            std::vector<int>* order = nullptr)
{
  using Entry = std::tuple<double, int, int, int>; // priority, face, part, the face it is reached from
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<int> part(panels.faces(p).size(), -1);
  for (int i = 0; i < int(seeds.size()); ++i) queue.emplace(-1, seeds[i], i, seeds[i]);
  while (!queue.empty()) {
    const auto [value, f, i, from] = queue.top();
    queue.pop();
    if (part[panels.place(f)] != -1) continue;
    part[panels.place(f)] = i;
    if (order) order->push_back(f);
    for (int g : panels.connectivity().neighbours[f])
      if (panels.label(g) == p && part[panels.place(g)] == -1)
        queue.emplace(priority(i, g, f, (std::max)(value, 0.)), g, i, f);
  }
  return part;
}

/// Growth by distance over the surface, from centroid to centroid.
inline auto geodesic_priority(const Label_costs& costs)
{
  return [&costs](int, int g, int f, double value) {
    return value + std::sqrt(CGAL::squared_distance(costs.centroid(f), costs.centroid(g)));
  };
}

/// Cuts panel `p` into the parts found by `grow_parts()`; part 0 keeps the label.
inline void apply_parts(Panel_labelling& panels, int p, const std::vector<int>& part, int parts)
{
  std::vector<std::vector<int>> faces(parts);
  for (int f : panels.faces(p)) faces[part[panels.place(f)]].push_back(f);
  for (int i = 1; i < parts; ++i) panels.relabel(faces[i], panels.unused_label());
}

/// Cuts a panel into connected parts around seeds, nearest seed over the surface.
inline void split_geodesically(Panel_work& work, int p, const std::vector<int>& seeds)
{
  const std::vector<int> part = grow_parts(work.panels, p, seeds, geodesic_priority(work.fits.costs()));
  apply_parts(work.panels, p, part, int(seeds.size()));
}

/// The face of panel `p` farthest over the surface from face `from`.
inline int farthest_face(const Panel_work& work, int p, int from)
{
  std::vector<int> order;
  grow_parts(work.panels, p, {from}, geodesic_priority(work.fits.costs()), &order);
  return order.back();
}

/// Two faces of panel `p` that lie far apart.
inline std::vector<int> far_faces(const Panel_work& work, int p)
{
  const std::vector<int>& faces = work.panels.faces(p);
  const int first = farthest_face(work, p, *std::min_element(faces.begin(), faces.end()));
  return {first, farthest_face(work, p, first)};
}

/// Two parts of panel `p` by plane: as in variational shape approximation, parts grow from seeds where they suit the
/// seeds' planes best, planes are refitted, and the faces that suit them best are the next seeds.
inline std::vector<int> two_plane_parts(Panel_work& work, int p, std::vector<int> seeds, int rounds = 4)
{
  const Label_costs& costs = work.fits.costs();
  const std::vector<int>& faces = work.panels.faces(p);
  std::vector<Plane> planes{costs.plane_of(seeds[0]), costs.plane_of(seeds[1])};
  std::vector<int> part;
  for (int round = 0; round < rounds; ++round) {
    part = grow_parts(work.panels, p, seeds, [&](int i, int g, int, double) {
      return costs.area(g) > 0 ? costs.data_cost(g, planes[i]) / costs.area(g) : 0;
    });
    Plane_sums sums[2];
    for (int f : faces) sums[part[work.panels.place(f)]].add(costs, f);
    double least[2] = {(std::numeric_limits<double>::max)(), (std::numeric_limits<double>::max)()};
    for (int i : {0, 1}) planes[i] = fitted_plane(costs, sums[i]);
    for (int f : faces) {
      const int i = part[work.panels.place(f)];
      const double cost = costs.area(f) > 0 ? costs.data_cost(f, planes[i]) / costs.area(f) : 0;
      if (cost < least[i]) least[i] = cost, seeds[i] = f;
    }
  }
  return part;
}

/// The face of `p` that suits its plane worst, and the one that suits the plane of that face worst.
inline std::vector<int> unlike_faces(Panel_work& work, int p)
{
  const Label_costs& costs = work.fits.costs();
  const auto worst = [&](const Plane& plane, int except) {
    int result = -1;
    double most = -1;
    for (int f : work.panels.faces(p)) {
      if (f == except || !(costs.area(f) > 0)) continue;
      const double cost = costs.data_cost(f, plane) / costs.area(f);
      if (cost > most || (cost == most && f < result)) most = cost, result = f;
    }
    return result;
  };
  const int first = worst(work.fits.plane(p), -1);
  if (first == -1) return far_faces(work, p);
  const int second = worst(costs.plane_of(first), first);
  if (second == -1) return far_faces(work, p);
  return {first, second};
}

/// Two panels are worth being two if that lowers the data cost by this times the smaller one's area, about what an
/// angle so large between them costs (eq. 2): no one can build less, and two nearly equal planes do not define a line.
constexpr double least_angle = 1e-3;

/// \param cost_before the cost of the panel that was split into `p` and `q`
inline bool is_worth_splitting(Panel_work& work, int p, int q, double cost_before)
{
  const double gain = (std::min)(cost_before - work.fits.cost(p) - work.fits.cost(q), work.fits.merge_cost(p, q));
  return gain > least_angle * (std::min)(work.fits.weighted_area(p), work.fits.weighted_area(q));
}

/// Splits a sound panel in two so that both are sound, as its planes suggest, or else across its length.
/// \param accept told a label, whether a part may be as it is
/// \return the label of the new part, or -1, with everything as before, if that fails
template <class Accept>
int split_soundly(Panel_work& work, int p, Accept accept)
{
  if (work.panels.faces(p).size() < 2) return -1;
  const std::size_t mark = work.panels.mark();
  const int panels = work.panels.number_of_panels(), relabelled = work.relabelled;
  const double cost = work.fits.cost(p);
  if (!(cost > 0)) return -1;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const int q = work.panels.unused_label();
    if (attempt == 0) apply_parts(work.panels, p, two_plane_parts(work, p, unlike_faces(work, p)), 2);
    else if (attempt == 1) apply_parts(work.panels, p, two_plane_parts(work, p, far_faces(work, p)), 2);
    else split_geodesically(work, p, far_faces(work, p));
    settle(work, mark);
    if (work.panels.number_of_panels() == panels + 1 && !work.panels.faces(p).empty() &&
        !work.panels.faces(q).empty() && is_sound(work, {p, q}) && accept(p) && accept(q) &&
        is_worth_splitting(work, p, q, cost))
      return q;
    work.panels.roll_back(mark);
    work.relabelled = relabelled;
  }
  return -1;
}

/// Splits where the data cost is largest until there are `target` panels or none can be split.
/// \return the number of splits
template <class Accept>
int split_up_to(Panel_work& work, int target, Accept accept)
{
  if (work.panels.number_of_panels() >= target) return 0;
  int splits = 0;
  std::priority_queue<std::pair<double, int>> queue;
  for (int p = 0; p < work.panels.number_of_labels(); ++p)
    if (!work.panels.faces(p).empty()) queue.emplace(work.fits.cost(p), -p);
  while (work.panels.number_of_panels() < target && !queue.empty()) {
    const int p = -queue.top().second;
    queue.pop();
    const int q = split_soundly(work, p, accept);
    if (q == -1) continue;
    ++splits;
    queue.emplace(work.fits.cost(p), -p);
    queue.emplace(work.fits.cost(q), -q);
    work.panels.commit();
  }
  return splits;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SPLITTING_H
