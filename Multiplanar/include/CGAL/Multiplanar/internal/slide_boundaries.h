// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLIDE_BOUNDARIES_H
#define CGAL_MULTIPLANAR_INTERNAL_SLIDE_BOUNDARIES_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/local_untangling.h>
#include <CGAL/Multiplanar/internal/panel_targets.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// A map into a polygon can fail because of where the vertices of a chain lie on their edge: an edge of the mesh between
// two sides of a polygon needs ends that see each other. Here the panel and its neighbours are mapped together, and the
// vertices of the edges between them slide.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The vertices of panel `p` and those within so many triangles of it.
inline std::vector<char> vertices_near_panel(const Connectivity& c, const Panel_complex& complex, int p, int rings)
{
  std::vector<char> near(c.number_of_vertices(), 0);
  std::vector<int> front;
  const auto reach = [&](int f) {
    for (int v : c.triangles[f])
      if (!near[v]) near[v] = 1, front.push_back(v);
  };
  for (int f : complex.panels[p].faces) reach(f);
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<int> last = std::move(front);
    front.clear();
    for (int v : last)
      for (int f : c.star(v)) reach(f);
  }
  return near;
}

/// The panels `members` as one planar complex: each in its own plane, with the vertices of edges between two of them
/// sliding and those of other edges fixed. Of what is not `movable`, all is fixed.
class Sliding_panels
{
public:
  Sliding_panels(const Connectivity& c, const std::vector<int>& labels, const Panel_complex& complex,
                 const std::set<int>& members, const std::vector<char>& movable, const Points& targets)
      : c(c), complex(complex), movable(movable), edge_at(c.number_of_vertices(), -1),
        unknown_at(c.number_of_vertices(), -1)
  {
    for (int e = 0; e < complex.number_of_edges(); ++e) {
      const auto& edge = complex.edges[e];
      for (std::size_t i = 1; i + 1 < edge.chain.size(); ++i) {
        const int v = edge.chain[i];
        edge_at[v] = e;
        if (!movable[v] || !members.count(edge.panels[0]) || !members.count(edge.panels[1])) continue;
        const Vector_3 d = complex.edge_vector(e);
        unknown_at[v] = int(x.size());
        x.push_back((targets[v] - complex.corners[edge.corners[0]].point) * d / d.squared_length());
        moving.push_back(v);
      }
    }
    for (int p : members) add_panel(p, labels, targets);
    planar.unknowns = int(x.size());
    mean_area /= double((std::max)(std::size_t(1), planar.triangles.size()));
  }

  int count_inverted() const { return planar.count_inverted(x.data()); }
  bool run() { return untangle(planar, mean_area, x); }

  void write(Points& targets) const
  {
    for (int v : moving)
      if (edge_at[v] >= 0) {
        const auto& edge = complex.edges[edge_at[v]];
        targets[v] = complex.corners[edge.corners[0]].point + x[unknown_at[v]] * complex.edge_vector(edge_at[v]);
      }
    for (const Inner& i : inner) targets[i.vertex] = to_point(i.frame.lifted({x[i.unknown], x[i.unknown + 1]}));
  }

private:
  struct Inner
  {
    int vertex, unknown;
    Plane_frame frame;
  };

  void add_panel(int p, const std::vector<int>& labels, const Points& targets)
  {
    const auto& panel = complex.panels[p];
    const Plane_frame frame(panel.plane);
    std::map<int, int> node_of;
    int members = 0;
    for (int f : panel.faces) {
      std::array<int, 3> t = c.triangles[f];
      if (!movable[t[0]] && !movable[t[1]] && !movable[t[2]]) continue;
      ++members;
      for (int i = 0; i < 3; ++i) {
        const int v = c.triangles[f][i];
        const auto found = node_of.find(v);
        t[i] = found != node_of.end() ? found->second : node_of[v] = add_node(p, v, labels, frame, targets);
      }
      planar.triangles.push_back(t);
      planar.tolerance.push_back(least_doubled_area(complex, p));
    }
    mean_area += std::abs(complex.area(p)) * members / double(panel.faces.size());
  }

  int add_node(int p, int v, const std::vector<int>& labels, const Plane_frame& frame, const Points& targets)
  {
    Planar_node node;
    node.base = frame.flat(to_eigen(targets[v]));
    bool boundary = false;
    for (int f : c.star(v)) boundary |= labels[f] != p;
    if (!boundary && movable[v]) {
      node.kind = Planar_node::Kind::free;
      node.unknown = int(x.size());
      x.push_back(node.base.x());
      x.push_back(node.base.y());
      inner.push_back({v, node.unknown, frame});
    } else if (boundary && unknown_at[v] >= 0) {
      const auto& edge = complex.edges[edge_at[v]];
      node.kind = Planar_node::Kind::sliding;
      node.unknown = unknown_at[v];
      node.base = frame.flat(to_eigen(complex.corners[edge.corners[0]].point));
      node.along = frame.flat(to_eigen(complex.corners[edge.corners[1]].point)) - node.base;
    }
    planar.nodes.push_back(node);
    return int(planar.nodes.size()) - 1;
  }

  const Connectivity& c;
  const Panel_complex& complex;
  const std::vector<char>& movable;
  std::vector<int> edge_at, unknown_at;
  std::vector<int> moving;
  std::vector<Inner> inner;
  Planar_complex planar;
  std::vector<double> x;
  double mean_area = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLIDE_BOUNDARIES_H
