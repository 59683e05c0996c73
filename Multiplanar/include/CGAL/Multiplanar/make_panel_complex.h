// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_MAKE_PANEL_COMPLEX_H
#define CGAL_MULTIPLANAR_MAKE_PANEL_COMPLEX_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Walks the boundaries between labels. A *boundary half-edge* is edge i of face f where the neighbour has another
/// label; it is named by 3 f + i and has its own panel on the left.
class Boundary_walk
{
public:
  Boundary_walk(const Connectivity& c, const std::vector<int>& labels) : c(c), labels(labels) {}

  bool is_boundary(int h) const { return labels[h / 3] != labels[c.neighbours[h / 3][h % 3]]; }
  int source(int h) const { return c.triangles[h / 3][h % 3]; }
  int target(int h) const { return c.triangles[h / 3][(h % 3 + 1) % 3]; }
  int opposite(int h) const
  {
    const int g = c.neighbours[h / 3][h % 3], b = target(h);
    return 3 * g + c.corner_of(g, b);
  }
  int next_in_face(int h) const { return h / 3 * 3 + (h % 3 + 1) % 3; }

  /// The boundary half-edge that follows `h` along the same panel.
  int next(int h) const
  {
    h = next_in_face(h);
    while (!is_boundary(h)) h = next_in_face(opposite(h));
    return h;
  }

  /// How many runs of equal labels lie around vertex `v` (0 inside a panel, 2 inside a chain, 3 or more at a corner).
  int runs(int v) const
  {
    int n = 0;
    const auto star = c.star(v);
    int previous = labels[*(star.end() - 1)];
    for (int f : star) {
      n += labels[f] != previous;
      previous = labels[f];
    }
    return n;
  }

private:
  const Connectivity& c;
  const std::vector<int>& labels;
};

/// Euler characteristic of each panel as a surface with boundary; a vertex where a panel touches itself counts once
/// for every run.
inline std::vector<int> panel_euler_characteristics(const Connectivity& c, const std::vector<int>& labels, int panels)
{
  std::vector<int> twice(panels, 0); // counts doubled, so that an inner edge is seen once from each side
  for (int f = 0; f < c.number_of_faces(); ++f) {
    twice[labels[f]] += 2;
    for (int g : c.neighbours[f]) twice[labels[f]] -= labels[g] == labels[f] ? 1 : 2;
  }
  for (int v = 0; v < c.number_of_vertices(); ++v) {
    const auto star = c.star(v);
    int previous = labels[*(star.end() - 1)];
    bool changed = false;
    for (int f : star) {
      if (labels[f] != previous) twice[labels[f]] += 2, changed = true;
      previous = labels[f];
    }
    if (!changed) twice[previous] += 2;
  }
  for (int& x : twice) x /= 2;
  return twice;
}

/// The plane of each panel: area-weighted mean normal and centroid of its faces.
inline Plane mean_plane(const Connectivity& c, const Points& points, const std::vector<int>& faces)
{
  Vector_3 normal(0, 0, 0), centre(0, 0, 0);
  double area = 0;
  for (int f : faces) {
    const Vector_3 a = area_vector(c, points, f);
    const double w = std::sqrt(a.squared_length());
    const auto& t = c.triangles[f];
    normal = normal + a;
    for (int v : t) centre = centre + (points[v] - CGAL::ORIGIN) * (w / 3);
    area += w;
  }
  const double length = std::sqrt(normal.squared_length());
  if (!(length > 0) || !(area > 0)) return Plane();
  Plane plane;
  plane.normal = normal / length;
  plane.offset = plane.normal * (centre / area);
  return plane;
}

/// Puts the loop that spans the largest area along the panel's normal first.
inline void put_outer_loop_first(Panel_complex& complex, Panel_complex::Panel& panel)
{
  std::size_t best = 0;
  double largest = 0;
  for (std::size_t i = 0; i < panel.loops.size(); ++i) {
    const double a = complex.loop_area_vector(panel.loops[i]) * panel.plane.normal;
    if (i == 0 || a > largest) largest = a, best = i;
  }
  if (best > 0) std::swap(panel.loops[0], panel.loops[best]);
}

/// Fills `corners[i].panels` and `.edges` in counter-clockwise order from the loops.
inline void order_corners(Panel_complex& complex)
{
  // At a corner, the side that leaves it along panel P is followed counter-clockwise by the side of P that enters it.
  // A side is named 2 * edge + direction.
  const int sides = 2 * complex.number_of_edges();
  std::vector<int> previous_side(sides, -1);
  for (const auto& panel : complex.panels)
    for (const auto& loop : panel.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& s = loop[i];
        const auto& p = loop[(i + loop.size() - 1) % loop.size()];
        previous_side[2 * s.edge + s.direction] = 2 * p.edge + p.direction;
      }
  std::vector<bool> seen(sides, false);
  for (int h = 0; h < sides; ++h) {
    if (seen[h]) continue;
    const int corner = complex.source({h / 2, h % 2});
    if (corner < 0) continue;
    auto& c = complex.corners[corner];
    if (!c.panels.empty()) throw std::invalid_argument("a corner of the panels is not manifold");
    int s = h;
    do {
      seen[s] = true;
      c.panels.push_back(complex.panel({s / 2, s % 2}));
      const int p = previous_side[s];
      c.edges.push_back(p / 2);
      s = p ^ 1; // the same edge, seen from the panel across: it leaves the corner again
    } while (s != h);
  }
}

/// The corner vertices and edges, found by following chains from corner to corner, then around closed boundaries.
inline void trace_edges(const Connectivity& c, const Points& points, const std::vector<int>& labels,
                        const Boundary_walk& walk, Panel_complex& complex, std::vector<int>& edge_of)
{
  std::vector<int> corner_at(c.number_of_vertices(), -1);
  for (int v = 0; v < c.number_of_vertices(); ++v)
    if (walk.runs(v) >= 3) {
      corner_at[v] = complex.number_of_corners();
      Panel_complex::Corner corner;
      corner.point = points[v];
      corner.vertex = v;
      complex.corners.push_back(corner);
    }
  edge_of.assign(3 * std::size_t(c.number_of_faces()), -1);
  const auto trace = [&](int start) {
    Panel_complex::Edge edge;
    edge.panels = {labels[start / 3], labels[walk.opposite(start) / 3]};
    edge.corners[0] = corner_at[walk.source(start)];
    edge.chain.push_back(walk.source(start));
    const int id = 2 * complex.number_of_edges();
    for (int h = start;;) {
      edge_of[h] = id;
      edge_of[walk.opposite(h)] = id + 1;
      edge.chain.push_back(walk.target(h));
      edge.corners[1] = corner_at[walk.target(h)];
      if (edge.corners[1] >= 0) break;
      h = walk.next(h);
      if (h == start) break;
    }
    complex.edges.push_back(std::move(edge));
  };
  const int half_edges = 3 * c.number_of_faces();
  for (int h = 0; h < half_edges; ++h)
    if (walk.is_boundary(h) && edge_of[h] < 0 && corner_at[walk.source(h)] >= 0) trace(h);
  for (int h = 0; h < half_edges; ++h)
    if (walk.is_boundary(h) && edge_of[h] < 0) trace(h);
}

} // namespace internal

/*!
\ingroup PkgMultiplanarComplex

The panel complex of a labelled mesh: one panel a label, corners at the vertices with three or more runs of labels.

\param c the connectivity of the mesh
\param points its vertices
\param labels a panel 0 .. `panels` - 1 for every face, each used by at least one face
\param panels the number of panels

A label whose faces are not connected, or touch themselves, still gives a panel (with several outer loops or a corner
that lists it twice); `panel_complex_problems()` names what cannot be made flat. Linear time.
*/
inline Panel_complex make_panel_complex(const internal::Connectivity& c, const Points& points,
                                        const std::vector<int>& labels, int panels)
{
  CGAL_precondition(int(labels.size()) == c.number_of_faces());
  CGAL_precondition(int(points.size()) == c.number_of_vertices());
  Panel_complex complex;
  complex.panels.resize(panels);
  for (int f = 0; f < c.number_of_faces(); ++f) {
    CGAL_precondition(labels[f] >= 0 && labels[f] < panels);
    complex.panels[labels[f]].faces.push_back(f);
  }
  const internal::Boundary_walk walk(c, labels);
  std::vector<int> edge_of;
  internal::trace_edges(c, points, labels, walk, complex, edge_of);

  std::vector<bool> seen(edge_of.size(), false);
  for (int h = 0; h < int(edge_of.size()); ++h) {
    if (seen[h] || !walk.is_boundary(h)) continue;
    Panel_complex::Loop loop;
    for (int i = h; !seen[i]; i = walk.next(i)) {
      seen[i] = true;
      const Panel_complex::Side s{edge_of[i] / 2, edge_of[i] % 2};
      const bool begins = complex.edges[s.edge].is_closed() ? loop.empty()
                                                             : complex.corners[complex.source(s)].vertex == walk.source(i);
      if (begins) loop.push_back(s);
    }
    complex.panels[labels[h / 3]].loops.push_back(std::move(loop));
  }
  const auto euler = internal::panel_euler_characteristics(c, labels, panels);
  for (int p = 0; p < panels; ++p) {
    auto& panel = complex.panels[p];
    panel.euler = euler[p];
    panel.plane = internal::mean_plane(c, points, panel.faces);
    internal::put_outer_loop_first(complex, panel);
  }
  internal::order_corners(complex);
  return complex;
}

/*!
\ingroup PkgMultiplanarComplex

The panel complex of polygons that someone else made.

\param points the corners
\param polygons for every panel its loops (outer first, counter-clockwise seen from outside; holes clockwise), each a
       list of indices into `points`
\throws std::invalid_argument if a side of a polygon has no partner (the surface is not closed or not oriented), is used
       twice, or a corner is not manifold.
*/
inline Panel_complex make_panel_complex_from_polygons(const Points& points,
                                                      const std::vector<std::vector<std::vector<int>>>& polygons)
{
  Panel_complex complex;
  for (const Point_3& p : points) {
    Panel_complex::Corner corner;
    corner.point = p;
    complex.corners.push_back(corner);
  }
  std::map<std::pair<int, int>, int> panel_left_of; // of the directed side (a, b)
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (const auto& loop : polygons[p])
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (!panel_left_of.insert({{loop[i], loop[(i + 1) % loop.size()]}, int(p)}).second)
          throw std::invalid_argument("a side of a panel is used twice");
  std::map<std::pair<int, int>, int> edge_between;
  for (const auto& side : panel_left_of) {
    const int a = side.first.first, b = side.first.second;
    const auto other = panel_left_of.find({b, a});
    if (a == b || other == panel_left_of.end()) throw std::invalid_argument("a side of a panel has no partner");
    if (a > b) continue;
    edge_between[{a, b}] = complex.number_of_edges();
    Panel_complex::Edge edge;
    edge.corners = {a, b};
    edge.panels = {side.second, other->second};
    complex.edges.push_back(edge);
  }
  complex.panels.resize(polygons.size());
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    auto& panel = complex.panels[p];
    Vector_3 normal(0, 0, 0);
    for (const auto& polygon : polygons[p]) {
      Panel_complex::Loop loop;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const int a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        loop.push_back({edge_between.at({(std::min)(a, b), (std::max)(a, b)}), a < b ? 0 : 1});
      }
      panel.loops.push_back(loop);
      normal = normal + complex.loop_area_vector(loop);
    }
    panel.euler = 2 - int(polygons[p].size());
    panel.plane.normal = normal / std::sqrt(normal.squared_length());
    double sum = 0;
    int n = 0;
    for (const auto& loop : polygons[p])
      for (int v : loop) sum += panel.plane.normal * (points[v] - CGAL::ORIGIN), ++n;
    panel.plane.offset = sum / n;
    internal::put_outer_loop_first(complex, panel);
  }
  internal::order_corners(complex);
  return complex;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_MAKE_PANEL_COMPLEX_H
