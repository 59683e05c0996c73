// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_LABEL_EDITS_H
#define CGAL_MULTIPLANAR_INTERNAL_LABEL_EDITS_H

#include <CGAL/Multiplanar/internal/Input_surface.h>
#include <CGAL/Multiplanar/internal/first_fit.h>

#include <algorithm>
#include <queue>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A new labelling in terms of an old one.
struct Label_edit
{
  std::vector<int> labels;
  std::vector<int> old_panel; ///< of every new panel: the same panel before, or -1
  std::vector<char> refit;    ///< panels whose planes are to be fitted anew
  std::vector<char> held;     ///< panels whose planes stay even where a corner is new; empty: none
  bool near_old = false;      ///< whether new corners start where the old model has their vertices, not on the mesh

  bool is_held(int p) const { return !held.empty() && held[p]; }
};

inline Label_edit no_edit(const std::vector<int>& labels, int panels)
{
  Label_edit e;
  e.labels = labels;
  for (int p = 0; p < panels; ++p) e.old_panel.push_back(p);
  e.refit.assign(panels, 0);
  return e;
}

/// Takes the number `q`, which no face has any more, out of use: the last panel takes its place.
inline void remove_label(Label_edit& e, int q)
{
  const int last = int(e.old_panel.size()) - 1;
  if (q != last) {
    for (int& l : e.labels)
      if (l == last) l = q;
    e.old_panel[q] = e.old_panel[last];
    e.refit[q] = e.refit[last];
    if (!e.held.empty()) e.held[q] = e.held[last];
  }
  e.old_panel.pop_back();
  e.refit.pop_back();
  if (!e.held.empty()) e.held.pop_back();
}

inline void merge_labels(Label_edit& e, int p, int q)
{
  for (int& l : e.labels)
    if (l == q) l = p;
  e.refit[p] = 1;
  remove_label(e, q);
}

/// Panels put into others: `into[p]` is where panel p goes, p itself if it stays. Those that stay keep their order and
/// planes.
inline Label_edit merge_panels(const std::vector<int>& labels, const std::vector<int>& into)
{
  Label_edit e;
  std::vector<int> now(into.size(), -1);
  for (int p = 0; p < int(into.size()); ++p)
    if (into[p] == p) now[p] = int(e.old_panel.size()), e.old_panel.push_back(p);
  for (int label : labels) e.labels.push_back(now[into[label]]);
  e.refit.assign(e.old_panel.size(), 0);
  return e;
}

/// A plane that faces are compared with.
struct Proxy
{
  Vec3 normal;
  double offset;
  double weight = 1; ///< multiplies what faces cost: the higher, the smaller the region it wins
};

/// What it costs a face to lie in a plane: the squared distance of its corners in units of `unit`, and the squared
/// difference of normals, by area.
class Face_cost
{
public:
  Face_cost(const Input_surface& input, double unit) : in(input), unit(unit)
  {
    for (const auto& t : in.connectivity->triangles) {
      const Vec3 n = (in.points[t[1]] - in.points[t[0]]).cross(in.points[t[2]] - in.points[t[0]]);
      area_.push_back(n.norm() / 2);
      normal_.push_back(n.normalized());
    }
  }
  double operator()(int f, const Proxy& p) const
  {
    double d = 0;
    for (int v : in.connectivity->triangles[f]) {
      const double r = (p.normal.dot(in.points[v]) - p.offset) / unit;
      d += r * r / 3;
    }
    return p.weight * area_[f] * (d + (normal_[f] - p.normal).squaredNorm());
  }
  void set_unit(double u) { unit = u; }

private:
  const Input_surface& in;
  double unit;
  std::vector<double> area_;
  std::vector<Vec3> normal_;
};

constexpr int outside = -2;

/// Gives the faces of `region` to the labels of `proxies` by growing them from seeds, cheapest face first, so that each
/// label stays one piece. `label_of_proxy[i]` is the label of proxy i; seeds are the cheapest face of the region for
/// each proxy (among those that carry its label, if any), or `seeds[i]` where that is >= 0.
inline void flood(const Connectivity& c, const std::vector<int>& region, const std::vector<Proxy>& proxies,
                  const std::vector<int>& label_of_proxy, const std::vector<int>& seeds, const Face_cost& cost,
                  std::vector<int>& labels)
{
  struct Entry
  {
    double cost;
    int face, proxy;
    bool operator<(const Entry& o) const
    {
      return cost != o.cost ? cost > o.cost : face != o.face ? face > o.face : proxy > o.proxy;
    }
  };
  std::vector<int> start(proxies.size(), -1);
  std::vector<double> least(proxies.size(), 0);
  for (std::size_t i = 0; i < proxies.size(); ++i)
    for (int f : region) {
      if (labels[f] != label_of_proxy[i]) continue;
      const double d = cost(f, proxies[i]);
      if (start[i] < 0 || d < least[i]) start[i] = f, least[i] = d;
    }
  for (std::size_t i = 0; i < proxies.size(); ++i)
    if (seeds[i] >= 0) start[i] = seeds[i];
  for (int f : region) labels[f] = -1;
  std::priority_queue<Entry> queue;
  const auto take = [&](int f, int i) {
    labels[f] = label_of_proxy[i];
    for (int g : c.neighbours[f])
      if (labels[g] == -1) queue.push({cost(g, proxies[i]), g, i});
  };
  for (std::size_t i = 0; i < proxies.size(); ++i)
    if (start[i] >= 0 && labels[start[i]] == -1) take(start[i], int(i));
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    if (seeds[i] != outside) continue;
    for (int f : region)
      for (int g : c.neighbours[f])
        if (labels[g] == label_of_proxy[i] && labels[f] == -1) queue.push({cost(f, proxies[i]), f, int(i)});
  }
  while (!queue.empty()) {
    const Entry e = queue.top();
    queue.pop();
    if (labels[e.face] == -1) take(e.face, e.proxy);
  }
}

/// Faces between two labels whose two of three neighbours have one other label go over to it: an ear cannot be flat.
inline void clip_ears(const Connectivity& c, std::vector<int>& labels)
{
  for (int round = 0; round < 4; ++round) {
    bool changed = false;
    for (int f = 0; f < c.number_of_faces(); ++f) {
      const auto& n = c.neighbours[f];
      const int a = labels[n[0]], b = labels[n[1]], d = labels[n[2]], l = labels[f];
      const int to = a != l && (a == b || a == d) ? a : b != l && b == d ? b : -1;
      if (to >= 0) labels[f] = to, changed = true;
    }
    if (!changed) return;
  }
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_LABEL_EDITS_H
