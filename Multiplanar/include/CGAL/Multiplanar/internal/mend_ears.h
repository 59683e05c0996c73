// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MEND_EARS_H
#define CGAL_MULTIPLANAR_INTERNAL_MEND_EARS_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/Panel_model.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Changes labels of a model so that the mesh has no flat ears in it (see flat_ears.h): single faces go to another
/// panel, where the complex stays what it is and only the vertices change that its corners and edges stand on. Unlike
/// `mend_flat_ears()` it looks at nothing but the surroundings of the ears.
class Ear_mender
{
public:
  Ear_mender(const Connectivity& c, const Panel_model& m) : labels(m.labels), c(c)
  {
    for (int i = 0; i < m.topology->number_of_corners(); ++i)
      corner_of_panels[sorted(m.topology->corner_panels[i])] = i;
    find_convex(m);
  }

  std::vector<int> labels;

  /// Mends the ears of the panels named. \return whether any label was changed
  bool run(const std::vector<int>& panels)
  {
    const std::set<int> wanted(panels.begin(), panels.end());
    std::vector<int> open;
    for (int f = 0; f < c.number_of_faces(); ++f)
      if (wanted.count(labels[f]) && flat_ear(f) >= 0) open.push_back(f);
    bool any = false;
    for (int left = 16 * int(open.size()); !open.empty() && left > 0; --left) {
      const int f = open.back();
      open.pop_back();
      const int position = flat_ear(f);
      if (position < 0) continue;
      const int changed = mend(f, position);
      if (changed < 0) continue;
      any = true;
      for (int g : around(changed))
        if (flat_ear(g) >= 0) open.push_back(g);
    }
    return any;
  }

private:
  using Labels = std::vector<int>;

  static Labels sorted(Labels panels)
  {
    std::sort(panels.begin(), panels.end());
    return panels;
  }

  void find_convex(const Panel_model& m)
  {
    for (int p = 0; p < m.panels(); ++p)
      for (const auto& loop : m.topology->loops[p]) {
        const int n = int(loop.size());
        for (int i = 0; i < n; ++i) {
          const Vec3 &a = m.state.corner[loop[(i + n - 1) % n]], &b = m.state.corner[loop[i]],
                     &d = m.state.corner[loop[(i + 1) % n]];
          if ((b - a).cross(d - b).dot(m.state.normal[p]) > 0) convex.insert({loop[i], p});
        }
      }
  }

  /// The labels around a vertex, one for each run of faces, ascending.
  Labels runs(int v) const
  {
    Labels result;
    const auto star = c.star(v);
    int previous = labels[*(star.end() - 1)];
    for (int f : star) {
      if (labels[f] != previous) result.push_back(labels[f]);
      previous = labels[f];
    }
    return sorted(std::move(result));
  }

  /// The position of the vertex where face `f` is a flat ear, or -1.
  int flat_ear(int f) const
  {
    for (int i = 0; i < 3; ++i) {
      if (labels[c.neighbours[f][i]] == labels[f] || labels[c.neighbours[f][(i + 2) % 3]] == labels[f]) continue;
      const auto corner = corner_of_panels.find(runs(c.triangles[f][i]));
      if (corner == corner_of_panels.end() || !convex.count({corner->second, labels[f]})) return i;
    }
    return -1;
  }

  /// All faces with a vertex of `f`.
  std::set<int> around(int f) const
  {
    std::set<int> result;
    for (int v : c.triangles[f])
      for (int g : c.star(v)) result.insert(g);
    return result;
  }

  int ears_around(int f) const
  {
    int ears = 0;
    for (int g : around(f)) ears += flat_ear(g) >= 0;
    return ears;
  }

  /// Gives the ear a neighbour for company, or to a neighbour. \return the face whose label has changed, or -1
  int mend(int f, int position)
  {
    const int sides[2] = {c.neighbours[f][position], c.neighbours[f][(position + 2) % 3]};
    for (const auto& change : {std::pair<int, int>{f, labels[sides[0]]},
                               {f, labels[sides[1]]},
                               {sides[0], labels[f]},
                               {sides[1], labels[f]}}) {
      const int ears = ears_around(change.first), before = labels[change.first];
      if (!relabel(change.first, change.second)) continue;
      if (ears_around(change.first) < ears) return change.first;
      labels[change.first] = before;
    }
    return -1;
  }

  /// Gives a face to the panel of a neighbour if the complex stays the same: each panel a connected piece that
  /// surrounds what it did, and the same corners. What is around the face decides that.
  bool relabel(int f, int p)
  {
    const int before = labels[f];
    const auto& n = c.neighbours[f];
    if (labels[n[0]] != before && labels[n[1]] != before && labels[n[2]] != before) return false; // its only face
    const std::multiset<Labels> corners = corners_of(f);
    labels[f] = p;
    bool same = true;
    for (int v : c.triangles[f]) {
      const Labels labels_now = runs(v);
      same = same && std::adjacent_find(labels_now.begin(), labels_now.end()) == labels_now.end();
    }
    if (same && corners_of(f) == corners) return true;
    labels[f] = before;
    return false;
  }

  std::multiset<Labels> corners_of(int f) const
  {
    std::multiset<Labels> result;
    for (int v : c.triangles[f]) {
      Labels around = runs(v);
      if (around.size() > 2) result.insert(std::move(around));
    }
    return result;
  }

  const Connectivity& c;
  std::map<Labels, int> corner_of_panels;
  std::set<std::pair<int, int>> convex; ///< corners where a panel has less than 180 degrees
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MEND_EARS_H
