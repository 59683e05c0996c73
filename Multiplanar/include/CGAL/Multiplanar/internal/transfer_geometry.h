// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRANSFER_GEOMETRY_H
#define CGAL_MULTIPLANAR_INTERNAL_TRANSFER_GEOMETRY_H

#include <CGAL/Multiplanar/Panel_complex.h>

#include <algorithm>
#include <map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The panels around a corner, counter-clockwise, beginning where the sequence is least.
inline std::vector<int> canonical_cycle(std::vector<int> panels)
{
  std::vector<int> best = panels;
  for (std::size_t i = 1; i < panels.size(); ++i) {
    std::rotate(panels.begin(), panels.begin() + 1, panels.end());
    if (panels < best) best = panels;
  }
  return best;
}

using Corners_by_cycle = std::map<std::vector<int>, std::vector<int>>;

inline Corners_by_cycle corners_by_cycle(const Panel_complex& complex)
{
  Corners_by_cycle result;
  for (int i = 0; i < complex.number_of_corners(); ++i) result[canonical_cycle(complex.corners[i].panels)].push_back(i);
  return result;
}

/// How many edges run between each two corners and panels, named by the corners of `names`.
inline std::map<std::array<int, 4>, int> edge_census(const Panel_complex& complex, const std::vector<int>& name)
{
  std::map<std::array<int, 4>, int> result;
  for (const auto& e : complex.edges) {
    std::array<int, 4> key{name[e.corners[0]], name[e.corners[1]], e.panels[0], e.panels[1]};
    if (key[2] > key[3]) std::swap(key[0], key[1]), std::swap(key[2], key[3]);
    ++result[key];
  }
  return result;
}

/// Gives the corners and panels of `to` the points and planes of `from`, if both complexes have the same panels, corners
/// and edges (a corner is recognised by the panels around it; of several with the same, by the nearest point).
/// \return false, with `to` as it was, if they differ
inline bool transfer_geometry(const Panel_complex& from, Panel_complex& to)
{
  if (from.number_of_panels() != to.number_of_panels() || from.number_of_corners() != to.number_of_corners() ||
      from.number_of_edges() != to.number_of_edges())
    return false;
  for (int p = 0; p < from.number_of_panels(); ++p)
    if (from.panels[p].loops.size() != to.panels[p].loops.size() || from.panels[p].euler != to.panels[p].euler)
      return false;
  for (const auto& e : to.edges)
    if (e.is_closed()) return false;
  const Corners_by_cycle old_corners = corners_by_cycle(from), new_corners = corners_by_cycle(to);
  std::vector<int> counterpart(to.number_of_corners(), -1);
  for (const auto& group : new_corners) {
    const auto found = old_corners.find(group.first);
    if (found == old_corners.end() || found->second.size() != group.second.size()) return false;
    std::vector<int> candidates = found->second;
    for (int i : group.second) {
      const auto nearest = std::min_element(candidates.begin(), candidates.end(), [&](int a, int b) {
        return CGAL::has_smaller_distance_to_point(to.corners[i].point, from.corners[a].point, from.corners[b].point);
      });
      counterpart[i] = *nearest;
      candidates.erase(nearest);
    }
  }
  std::vector<int> own(from.number_of_corners());
  for (int i = 0; i < from.number_of_corners(); ++i) own[i] = i;
  if (edge_census(from, own) != edge_census(to, counterpart)) return false;
  for (int i = 0; i < to.number_of_corners(); ++i) to.corners[i].point = from.corners[counterpart[i]].point;
  for (int p = 0; p < to.number_of_panels(); ++p) {
    to.panels[p].plane = from.panels[p].plane;
    std::size_t outer = 0; // the loop with the largest area leads, by the new points
    double largest = 0;
    for (std::size_t l = 0; l < to.panels[p].loops.size(); ++l) {
      const double a = to.loop_area_vector(to.panels[p].loops[l]) * to.panels[p].plane.normal;
      if (l == 0 || a > largest) largest = a, outer = l;
    }
    std::swap(to.panels[p].loops[0], to.panels[p].loops[outer]);
  }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRANSFER_GEOMETRY_H
