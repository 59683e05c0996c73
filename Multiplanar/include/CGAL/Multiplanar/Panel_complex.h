// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_COMPLEX_H
#define CGAL_MULTIPLANAR_PANEL_COMPLEX_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarComplex

The polygons that a closed surface consists of, as seen by someone who cuts them: *panels* (polygons, possibly with
holes), *edges* (where two panels meet) and *corners* (where three or more do).

A complex is made from a labelled triangle mesh by `make_panel_complex()` or from polygons by
`make_panel_complex_from_polygons()`. Elements are numbered from 0 and refer to each other by number. The combinatorics
is fixed after construction; the points of corners and the planes of panels may be moved.

Orientation: everything is seen from outside. Outer loops run counter-clockwise, loops of holes clockwise, so that a
panel lies on the left of each of its sides.
*/
class Panel_complex
{
public:
  /// A point where at least three panels meet.
  struct Corner
  {
    Point_3 point;           ///< where it is
    int vertex = -1;         ///< the mesh vertex it stands on, -1 if there is no mesh
    std::vector<int> panels; ///< the panels around it, counter-clockwise
    std::vector<int> edges;  ///< `edges[i]` separates `panels[i]` from its successor in that order
  };

  /// A piece of boundary shared by two panels. Runs from `corners[0]` to `corners[1]` with `panels[0]` on its left.
  /// A boundary that passes no corner is an edge with corners {-1, -1}: no flat panels can have it.
  struct Edge
  {
    std::array<int, 2> corners{{-1, -1}}; ///< its ends; -1, -1 if it is closed
    std::array<int, 2> panels{{-1, -1}};  ///< on its left from the first corner to the second, and on its right
    std::vector<int> chain; ///< mesh vertices from end to end, both ends included; empty if there is no mesh

    bool is_closed() const { return corners[0] < 0; } ///< a boundary without corners?
  };

  /// An edge as one of its two panels sees it.
  struct Side
  {
    int edge = -1;     ///< of the complex
    int direction = 0; ///< 0: along the edge (the panel is `panels[0]`), 1: against it
  };

  using Loop = std::vector<Side>; ///< the sides in order, the panel on their left

  /// A polygon; `loops[0]` is the outer one.
  struct Panel
  {
    Plane plane;             ///< with the normal outward
    std::vector<Loop> loops; ///< the outer one first, then holes
    std::vector<int> faces; ///< the mesh faces it consists of; empty if there is no mesh
    int euler = 1;          ///< Euler characteristic: 2 - loops for a planar domain
  };

  int number_of_corners() const { return int(corners.size()); } ///< corners are 0 .. this - 1
  int number_of_edges() const { return int(edges.size()); }     ///< edges are 0 .. this - 1
  int number_of_panels() const { return int(panels.size()); }   ///< panels are 0 .. this - 1

  /// The corner where a side begins, walking with its panel on the left (-1 on a closed edge).
  int source(const Side& s) const { return edges[s.edge].corners[s.direction]; }
  int target(const Side& s) const { return edges[s.edge].corners[1 - s.direction]; } ///< the corner where it ends
  /// The panel that the side belongs to, and the one across it.
  int panel(const Side& s) const { return edges[s.edge].panels[s.direction]; }
  int neighbour(const Side& s) const { return edges[s.edge].panels[1 - s.direction]; } ///< the panel across it
  /// The panel that edge `e` shares with panel `p`.
  int other_panel(int e, int p) const { return edges[e].panels[0] == p ? edges[e].panels[1] : edges[e].panels[0]; }

  /// The corners of a loop, in order.
  std::vector<int> loop_corners(const Loop& loop) const
  {
    std::vector<int> result;
    result.reserve(loop.size());
    for (const Side& s : loop) result.push_back(source(s));
    return result;
  }

  /// The panels across the sides of panel `p`, each once, ascending.
  std::vector<int> neighbours(int p) const
  {
    std::vector<int> result;
    for (const Loop& loop : panels[p].loops)
      for (const Side& s : loop) result.push_back(neighbour(s));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// From `corners[0]` to `corners[1]`. \pre the edge is not closed
  Vector_3 edge_vector(int e) const
  {
    CGAL_precondition(!edges[e].is_closed());
    return corners[edges[e].corners[1]].point - corners[edges[e].corners[0]].point;
  }
  /// \pre the edge is not closed
  double edge_length(int e) const { return std::sqrt(edge_vector(e).squared_length()); }

  /// The interior dihedral angle at edge `e`, in degrees, in (0, 360): below 180 where the solid is convex. It is
  /// computed from the planes of the two panels.
  double dihedral(int e) const
  {
    const Vector_3 n0 = panels[edges[e].panels[0]].plane.normal, n1 = panels[edges[e].panels[1]].plane.normal;
    const Vector_3 d = edge_vector(e);
    const double sine = CGAL::cross_product(n0, n1) * d / std::sqrt(d.squared_length());
    return 180.0 - std::atan2(sine, n0 * n1) * 180.0 / 3.14159265358979323846;
  }

  /// Twice the vector area that a loop spans: along the outer normal for an outer loop, against it for a hole.
  Vector_3 loop_area_vector(const Loop& loop) const
  {
    Vector_3 sum(0, 0, 0);
    if (loop.empty() || edges[loop[0].edge].is_closed()) return sum;
    const Point_3 o = corners[source(loop[0])].point;
    for (const Side& s : loop) sum = sum + CGAL::cross_product(corners[source(s)].point - o, corners[target(s)].point - o);
    return sum;
  }

  /// Area of panel `p` in its plane, holes taken off.
  double area(int p) const
  {
    double sum = 0;
    for (const Loop& loop : panels[p].loops) sum += loop_area_vector(loop) * panels[p].plane.normal / 2;
    return sum;
  }

  /// The largest distance of a corner from the plane of a panel that it belongs to.
  double planarity_deviation() const
  {
    double worst = 0;
    for (const Corner& c : corners)
      for (int p : c.panels) worst = (std::max)(worst, std::abs(signed_distance(panels[p].plane, c.point)));
    return worst;
  }

  std::vector<Corner> corners; ///< where three or more panels meet
  std::vector<Edge> edges;     ///< each between two panels
  std::vector<Panel> panels;   ///< the polygons
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_COMPLEX_H
