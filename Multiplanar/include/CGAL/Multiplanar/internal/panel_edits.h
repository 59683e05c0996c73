// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_EDITS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_EDITS_H

#include <CGAL/Multiplanar/internal/Panel_modeller.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A pair of neighbours and what their merger would cost.
struct Merge_candidate
{
  int p, q;
  double error; ///< half the width of the slab that holds both, in the direction of their common plane
};

/// Ways to change the labelling of a model. None of them looks at whether the result can be flat.
class Panel_edits
{
public:
  Panel_edits(const Panel_modeller& modeller, double unit)
      : modeller(modeller), in(modeller.input()), c(modeller.connectivity()), cost(in, unit)
  {
  }

  void set_unit(double unit) { cost.set_unit(unit); }

  static std::vector<int> neighbours(const Panel_model& m, int p)
  {
    std::vector<int> result;
    for (const auto& edge : m.topology->edges)
      for (int i = 0; i < 2; ++i)
        if (edge.panels[i] == p) result.push_back(edge.panels[1 - i]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Panel `p` divided in two, one grown from `face`.
  Label_edit split(const Panel_model& m, int p, int face) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    const std::vector<int> region = faces_of(m, {p});
    if (m.labels[face] != p) face = region.front();
    lloyd(region, {plane_of(m, p), plane_of_face(face)}, {p, m.panels()}, {-1, face}, e, 4);
    e.old_panel.push_back(-1), e.refit.push_back(1), e.refit[p] = 1;
    return e;
  }

  /// The faces of `panels` shared out anew among them by their present planes.
  Label_edit share(const Panel_model& m, const std::vector<int>& panels) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    std::vector<Proxy> proxies;
    for (int q : panels) proxies.push_back(plane_of(m, q));
    lloyd(faces_of(m, panels), proxies, panels, std::vector<int>(panels.size(), -1), e, 1);
    return e;
  }

  /// The faces of `panels` shared out among them and a new panel that starts at `face`, planes fitted in between.
  Label_edit share_with_fresh(const Panel_model& m, std::vector<int> panels, int face) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    const std::vector<int> region = faces_of(m, panels);
    std::vector<Proxy> proxies;
    std::vector<int> seeds(panels.size(), -1);
    for (int q : panels) proxies.push_back(plane_of(m, q)), e.refit[q] = 1;
    proxies.push_back(plane_of_face(face));
    panels.push_back(m.panels());
    seeds.push_back(face);
    e.old_panel.push_back(-1), e.refit.push_back(1);
    lloyd(region, proxies, panels, seeds, e, 3);
    return e;
  }

  /// The faces of `p` and `q` divided anew: one part grows from `face`, the other from the face that suits it least.
  Label_edit divide_anew(const Panel_model& m, int p, int q, int face) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    const std::vector<int> region = faces_of(m, {p, q});
    const Proxy first = plane_of_face(face);
    int other = region.front();
    double worst = -1;
    for (int f : region) {
      const double area = modeller.moments_of_faces()[f].area, d = area > 0 ? cost(f, first) / area : 0;
      if (d > worst) worst = d, other = f;
    }
    lloyd(region, {first, plane_of_face(other)}, {p, q}, {face, other}, e, 5);
    e.refit[p] = e.refit[q] = 1;
    return e;
  }

  Label_edit merge(const Panel_model& m, int p, int q) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    merge_labels(e, p, q);
    return e;
  }

  /// The faces of `p` given to its neighbours, whose planes stay.
  Label_edit dissolve(const Panel_model& m, int p) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    const std::vector<int> around = neighbours(m, p);
    std::vector<Proxy> proxies;
    for (int q : around) proxies.push_back(plane_of(m, q));
    flood(c, faces_of(m, {p}), proxies, around, std::vector<int>(around.size(), outside), cost, e.labels);
    remove_label(e, p);
    return e;
  }

  /// The faces of `panels` divided anew among all of them but `gone`.
  Label_edit divide_among_others(const Panel_model& m, const std::vector<int>& panels, int gone) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    std::vector<Proxy> proxies;
    std::vector<int> others;
    for (int q : panels)
      if (q != gone) others.push_back(q), proxies.push_back(plane_of(m, q)), e.refit[q] = 1;
    lloyd(faces_of(m, panels), proxies, others, std::vector<int>(others.size(), -1), e, 5);
    remove_label(e, gone);
    return e;
  }

  /// Edge e between panels A and B ends between C and D: gives C the faces of A and B along it, so that C and D meet
  /// and A and B part. \param end which of the edge's corners C is at \return false if that end has more than three
  /// panels
  bool flip(const Panel_model& m, int e, int end, Label_edit& edit) const
  {
    const auto& edge = m.topology->edges[e];
    int third = -1;
    if (m.topology->corner_panels[edge.corners[end]].size() != 3) return false;
    for (int p : m.topology->corner_panels[edge.corners[end]])
      if (p != edge.panels[0] && p != edge.panels[1]) third = p;
    edit = no_edit(m.labels, m.panels());
    for (int v : chain(m, e))
      for (int f : c.star(v))
        if (m.labels[f] == edge.panels[0] || m.labels[f] == edge.panels[1]) edit.labels[f] = third;
    return true;
  }

  /// The mesh vertices along an edge of the complex.
  std::vector<int> chain(const Panel_model& m, int e) const
  {
    const auto& edge = m.topology->edges[e];
    const Boundary_walk walk(c, m.labels);
    const int from = m.corner_vertex[edge.corners[0]], to = m.corner_vertex[edge.corners[1]];
    std::vector<int> result{from};
    for (int f : c.star(from)) {
      const int h = 3 * f + c.corner_of(f, from);
      if (m.labels[f] != edge.panels[0] || m.labels[c.neighbours[f][h % 3]] != edge.panels[1]) continue;
      for (int i = h;; i = walk.next(i)) {
        result.push_back(walk.target(i));
        if (result.back() == to) return result;
        if (walk.runs(result.back()) != 2) break; // another edge of the same two panels
      }
      result.resize(1);
    }
    return result;
  }

  static std::vector<std::vector<int>> faces_of_panels(const Panel_model& m)
  {
    std::vector<std::vector<int>> faces(m.panels());
    for (int f = 0; f < int(m.labels.size()); ++f) faces[m.labels[f]].push_back(f);
    return faces;
  }

  /// Half the width of the slab around the common plane of `panels` that holds all their faces.
  /// \param faces see `faces_of_panels()`
  double thickness(const Panel_model& m, const std::vector<std::vector<int>>& faces,
                   const std::vector<int>& panels) const
  {
    Moments sum;
    for (int p : panels) sum += m.moments[p];
    Proxy plane;
    fit_plane(sum, plane.normal, plane.offset);
    double low = 1e300, high = -1e300;
    for (int p : panels)
      for (int f : faces[p])
        for (int v : c.triangles[f]) {
          const double d = plane.normal.dot(in.points[v]) - plane.offset;
          low = (std::min)(low, d), high = (std::max)(high, d);
        }
    return (high - low) / 2;
  }

  /// All pairs of neighbours, cheapest first.
  std::vector<Merge_candidate> merges(const Panel_model& m) const
  {
    std::set<std::pair<int, int>> pairs;
    for (const auto& e : m.topology->edges) pairs.insert(std::minmax({e.panels[0], e.panels[1]}));
    const std::vector<std::vector<int>> faces = faces_of_panels(m);
    std::vector<Merge_candidate> result;
    for (const auto& pq : pairs) result.push_back({pq.first, pq.second, thickness(m, faces, {pq.first, pq.second})});
    std::stable_sort(result.begin(), result.end(),
                     [](const Merge_candidate& a, const Merge_candidate& b) { return a.error < b.error; });
    return result;
  }

private:
  std::vector<int> faces_of(const Panel_model& m, const std::vector<int>& panels) const
  {
    std::vector<char> wanted(m.panels(), 0);
    for (int p : panels) wanted[p] = 1;
    std::vector<int> result;
    for (int f = 0; f < c.number_of_faces(); ++f)
      if (wanted[m.labels[f]]) result.push_back(f);
    return result;
  }

  static Proxy plane_of(const Panel_model& m, int p) { return {m.state.normal[p], m.state.offset[p]}; }

  Proxy plane_of_face(int f) const
  {
    const auto& t = c.triangles[f];
    const Vec3 n = (in.points[t[1]] - in.points[t[0]]).cross(in.points[t[2]] - in.points[t[0]]).normalized();
    return {n, n.dot(in.points[t[0]])};
  }

  void lloyd(const std::vector<int>& region, std::vector<Proxy> proxies, const std::vector<int>& labels,
             std::vector<int> seeds, Label_edit& e, int rounds) const
  {
    for (int i = 0; i < rounds; ++i) {
      flood(c, region, proxies, labels, seeds, cost, e.labels);
      if (i + 1 == rounds) break;
      for (std::size_t j = 0; j < proxies.size(); ++j) {
        Moments sum;
        for (int f : region)
          if (e.labels[f] == labels[j]) sum += modeller.moments_of_faces()[f];
        if (sum.area > 0) fit_plane(sum, proxies[j].normal, proxies[j].offset);
        seeds[j] = -1;
      }
    }
  }

  const Panel_modeller& modeller;
  const Input_surface& in;
  const Connectivity& c;
  Face_cost cost;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_EDITS_H
