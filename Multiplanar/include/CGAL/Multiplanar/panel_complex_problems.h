// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_COMPLEX_PROBLEMS_H
#define CGAL_MULTIPLANAR_PANEL_COMPLEX_PROBLEMS_H

#include <CGAL/Multiplanar/Panel_complex.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// Why a panel complex cannot consist of flat polygons with area, whatever its corners' coordinates.
enum class Panel_problem
{
  not_a_planar_domain, ///< Euler characteristic other than 2 - loops: disconnected, or a handle lies inside the panel
  closed_edge,         ///< a boundary without corners: one panel lies wholly inside another
  few_neighbours,      ///< a loop along fewer than three distinct panels: its lines bound no area
  touches_itself,      ///< a panel occurs twice around one corner
  shared_ends,         ///< two edges with the same two corners: they would coincide
  repeated_corner      ///< two corners have three panels in common: three planes meet in one point
};
/// The problem as the end of a sentence that begins with the panel.
inline const char* to_string(Panel_problem p)
{
  switch (p) {
  case Panel_problem::not_a_planar_domain:
    return "is not a planar domain";
  case Panel_problem::closed_edge:
    return "has a boundary without corners";
  case Panel_problem::few_neighbours:
    return "has a loop with fewer than three neighbours";
  case Panel_problem::touches_itself:
    return "touches itself at a corner";
  case Panel_problem::shared_ends:
    return "has an edge that shares both corners with another edge";
  case Panel_problem::repeated_corner:
    return "meets the same two panels at two corners";
  }
  return "";
}

/// A problem and the panel that has it.
struct Panel_complex_problem
{
  Panel_problem problem; ///< its kind
  int panel;             ///< that has it
  int element; ///< the loop, corner or edge concerned, by kind of problem; -1 if none
};

/// \ingroup PkgMultiplanarComplex
/// All combinatorial reasons why `complex` cannot be made of flat polygons with area; empty if there are none.
/// Linear time, up to a logarithm.
inline std::vector<Panel_complex_problem> panel_complex_problems(const Panel_complex& complex)
{
  std::vector<Panel_complex_problem> result;
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    const auto& panel = complex.panels[p];
    if (panel.euler != 2 - int(panel.loops.size())) result.push_back({Panel_problem::not_a_planar_domain, p, -1});
    for (int l = 0; l < int(panel.loops.size()); ++l) {
      const auto& loop = panel.loops[l];
      if (complex.edges[loop[0].edge].is_closed()) {
        result.push_back({Panel_problem::closed_edge, p, l});
        continue;
      }
      std::set<int> neighbours;
      for (const auto& s : loop) neighbours.insert(complex.neighbour(s));
      if (neighbours.size() < 3) result.push_back({Panel_problem::few_neighbours, p, l});
    }
  }
  for (int i = 0; i < complex.number_of_corners(); ++i) {
    std::vector<int> around = complex.corners[i].panels;
    std::sort(around.begin(), around.end());
    const auto twice = std::adjacent_find(around.begin(), around.end());
    if (twice != around.end()) result.push_back({Panel_problem::touches_itself, *twice, i});
  }
  std::set<std::pair<int, int>> ends;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const auto& edge = complex.edges[e];
    if (edge.is_closed()) continue;
    if (!ends.insert(std::minmax(edge.corners[0], edge.corners[1])).second || edge.corners[0] == edge.corners[1])
      result.push_back({Panel_problem::shared_ends, edge.panels[0], e});
  }
  std::set<std::array<int, 3>> triples; // of panels, at some corner
  for (int i = 0; i < complex.number_of_corners(); ++i) {
    std::vector<int> s = complex.corners[i].panels;
    std::sort(s.begin(), s.end());
    s.erase(std::unique(s.begin(), s.end()), s.end());
    for (std::size_t a = 0; a < s.size(); ++a)
      for (std::size_t b = a + 1; b < s.size(); ++b)
        for (std::size_t d = b + 1; d < s.size(); ++d)
          if (!triples.insert({s[a], s[b], s[d]}).second) result.push_back({Panel_problem::repeated_corner, s[a], i});
  }
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_COMPLEX_PROBLEMS_H
