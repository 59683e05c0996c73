// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H
#define CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H

#include <CGAL/Multiplanar/internal/Panel_model.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Changes to the set of panels that keep what lowers the distance: the worst panel is split, and the pair of
/// neighbours that costs least is merged; or the panels around the worst place share their faces out anew.
class Teleport_search
{
public:
  Teleport_search(const Panel_modeller& modeller, int max_panels)
      : modeller(modeller), in(modeller.input()), c(modeller.connectivity()), cost(in, 1), max_panels(max_panels)
  {
  }

  int trials = 0;
  std::map<std::string, std::array<int, 2>> tally;

  /// Tries edits at the worst places until one lowers the merit. \return false if none does
  bool improve_once(Panel_model& m)
  {
    cost.set_unit((std::max)(m.largest, 1e-9));
    std::vector<int> order(m.panels());
    for (int p = 0; p < m.panels(); ++p) order[p] = p;
    std::stable_sort(order.begin(), order.end(), [&](int p, int q) { return m.panel_error[p] > m.panel_error[q]; });
    const auto merges = cheapest_merges(m);
    for (int place = 0; place < 3 && place < m.panels(); ++place) {
      const int p = order[place];
      if (m.panel_error[p] < 0.8 * m.largest) break;
      const int face = m.panel_worst[p];
      if (accept("share", m, share_anew(m, p, face, false))) return true;
      for (int variant = 0; variant < 2; ++variant) {
        const Label_edit split = variant == 0 ? split_panel(m, p, face) : share_anew(m, p, face, true);
        Panel_model divided;
        if (!try_edit(m, split, divided, 1)) continue;
        if (divided.panels() <= max_panels) {
          if (better(divided, m)) {
            m = std::move(divided);
            return true;
          }
          continue;
        }
        if (!(divided.merit < m.merit * 0.9995)) continue;
        int tried = 0;
        for (const auto& pair : merges) {
          if (tried >= 4) break;
          if (pair.error > 1.0 * m.largest) break;
          // The split keeps all numbers; its new panel is the last.
          if (pair.p == p || pair.q == p) continue;
          ++tried;
          Label_edit e = no_edit(divided.labels, divided.panels());
          merge_labels(e, pair.p, pair.q);
          Panel_model merged;
          const bool ok = try_edit(divided, e, merged, 1);
          tally["merge"][0]++;
          if (ok && better(merged, m)) {
            tally["merge"][1]++;
            m = std::move(merged);
            return true;
          }
        }
      }
    }
    return false;
  }

  struct Merge
  {
    int p, q;
    double error;
  };

  /// Pairs of neighbours by the largest distance of their vertices from their common plane.
  std::vector<Merge> cheapest_merges(const Panel_model& m) const
  {
    std::set<std::pair<int, int>> pairs;
    for (const auto& e : m.topology->edges) pairs.insert(std::minmax(e.panels[0], e.panels[1]));
    std::vector<std::vector<int>> faces(m.panels());
    for (int f = 0; f < c.number_of_faces(); ++f) faces[m.labels[f]].push_back(f);
    std::vector<Merge> result;
    for (const auto& pq : pairs) {
      Moments sum = m.moments[pq.first];
      sum += m.moments[pq.second];
      Proxy plane;
      fit_plane(sum, plane.normal, plane.offset);
      double low = 0, high = 0;
      for (int p : {pq.first, pq.second})
        for (int f : faces[p])
          for (int v : c.triangles[f]) {
            const double d = plane.normal.dot(in.points[v]) - plane.offset;
            low = (std::min)(low, d), high = (std::max)(high, d);
          }
      result.push_back({pq.first, pq.second, (high - low) / 2});
    }
    std::stable_sort(result.begin(), result.end(), [](const Merge& a, const Merge& b) { return a.error < b.error; });
    return result;
  }

  Label_edit split_panel(const Panel_model& m, int p, int face) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    std::vector<int> region;
    for (int f = 0; f < c.number_of_faces(); ++f)
      if (m.labels[f] == p) region.push_back(f);
    if (m.labels[face] != p) face = region.front();
    const int fresh = m.panels();
    std::vector<Proxy> proxies{plane_of(m, p), plane_of_face(face)};
    std::vector<int> labels{p, fresh}, seeds{-1, face};
    lloyd(region, proxies, labels, seeds, e, 4);
    e.old_panel.push_back(-1), e.refit.push_back(1), e.refit[p] = 1;
    return e;
  }

  /// The faces of `p` and its neighbours are shared out anew among them, and a fresh panel if wanted.
  Label_edit share_anew(const Panel_model& m, int p, int face, bool with_fresh) const
  {
    Label_edit e = no_edit(m.labels, m.panels());
    std::vector<char> in_set(m.panels(), 0);
    in_set[p] = 1;
    for (const auto& edge : m.topology->edges)
      for (int i = 0; i < 2; ++i)
        if (edge.panels[i] == p) in_set[edge.panels[1 - i]] = 1;
    std::vector<int> region, labels, seeds;
    for (int f = 0; f < c.number_of_faces(); ++f)
      if (in_set[m.labels[f]]) region.push_back(f);
    std::vector<Proxy> proxies;
    for (int q = 0; q < m.panels(); ++q)
      if (in_set[q])
        proxies.push_back(plane_of(m, q)), labels.push_back(q), seeds.push_back(-1), e.refit[q] = with_fresh;
    if (with_fresh) {
      proxies.push_back(plane_of_face(face)), labels.push_back(m.panels()), seeds.push_back(face);
      e.old_panel.push_back(-1), e.refit.push_back(1);
    }
    lloyd(region, proxies, labels, seeds, e, with_fresh ? 3 : 1);
    return e;
  }

  /// The model after an edit and local accuracy steps.
  bool try_edit(const Panel_model& m, Label_edit edit, Panel_model& result, int ring)
  {
    ++trials;
    clip_ears(c, edit.labels);
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, result, touched) || result.faults > m.faults) return false;
    std::vector<char> free = touched;
    for (int i = 0; i < ring; ++i) free = with_ring(*result.topology, free);
    modeller.improve(result, free, local_options);
    return result.faults <= m.faults;
  }

  bool better(const Panel_model& a, const Panel_model& b) const
  {
    return a.faults < b.faults || (a.faults == b.faults && a.merit < b.merit * 0.9995);
  }

  bool accept(const char* name, Panel_model& m, const Label_edit& edit)
  {
    Panel_model result;
    tally[name][0]++;
    if (!try_edit(m, edit, result, 1) || !better(result, m)) return false;
    tally[name][1]++;
    m = std::move(result);
    return true;
  }

  /// Removes faults: for panels with faults, edits that lower their number, cheapest first.
  bool repair_once(Panel_model& m)
  {
    std::set<int> bad;
    for (int p = 0; p < m.panels(); ++p)
      if (!m.surface->is_simple(p)) bad.insert(p);
    for (const auto& pair : m.surface->conflicts(m.state, std::vector<char>(m.panels(), 1), 100))
      bad.insert(pair[0]), bad.insert(pair[1]);
    Panel_model best;
    best.faults = m.faults;
    best.merit = 1e300;
    const auto consider = [&](const Label_edit& e) {
      Panel_model r;
      Label_edit clipped = e;
      clip_ears(c, clipped.labels);
      ++trials;
      std::vector<char> touched;
      if (!modeller.rebuild(&m, clipped, r, touched) || r.faults > best.faults || r.faults >= m.faults) return;
      modeller.measure(r, touched);
      if (r.faults < best.faults || r.merit < best.merit) best = std::move(r);
    };
    cost.set_unit(0.02);
    for (int p : bad) consider(share_anew(m, p, -1, false));
    std::set<std::pair<int, int>> pairs;
    for (const auto& e : m.topology->edges)
      if (bad.count(e.panels[0]) || bad.count(e.panels[1])) pairs.insert(std::minmax(e.panels[0], e.panels[1]));
    for (const auto& pq : pairs) {
      Label_edit e = no_edit(m.labels, m.panels());
      merge_labels(e, pq.first, pq.second);
      consider(e);
    }
    if (best.faults >= m.faults) return false;
    m = std::move(best);
    return true;
  }

  Accuracy_options local_options;

private:
  Proxy plane_of(const Panel_model& m, int p) const { return {m.state.normal[p], m.state.offset[p]}; }
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
  int max_panels;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TELEPORT_H
