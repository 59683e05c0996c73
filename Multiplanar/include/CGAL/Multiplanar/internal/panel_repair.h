// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_REPAIR_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_REPAIR_H

#include <CGAL/Multiplanar/internal/panel_splitting.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

// From connected panels to panels without problems: topology first, then what few faces can mend, then larger parts,
// mergers and splits. The number of panels may rise; `merge_down_to()` brings it down again.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The used labels, ascending.
inline std::vector<int> used_labels(const Panel_labelling& panels)
{
  std::vector<int> result;
  for (int p = 0; p < panels.number_of_labels(); ++p)
    if (!panels.faces(p).empty()) result.push_back(p);
  return result;
}

/// Repairs one labelling. Every step is a local repair, a merger or a split; their number is bounded.
class Panel_repair
{
public:
  explicit Panel_repair(Panel_work& work) : work(work), panels(work.panels), fits(work.fits) {}

  int merges = 0, splits = 0;

  /// \return whether no problem is left
  bool run()
  {
    int budget = 16 * panels.number_of_panels() + 64;
    absorptions = panels.number_of_panels();
    most_panels = 4 * panels.number_of_panels() + 64;
    mend_everywhere();
    while (budget-- > 0) {
      if (split_a_handle() || open_a_closed_boundary()) continue;
      if (panels.number_of_local_problems() == 0) return true;
      if (!resolve_a_local_problem()) return false;
    }
    return false;
  }

private:
  void mend_everywhere()
  {
    repair_touches(panels, fits);
    work.relabelled += work.mender.mend_all();
    panels.commit();
  }

  void finish_step(std::size_t mark)
  {
    settle(work, mark);
    panels.commit();
  }

  /// A panel without problems of topology that has not changed since gets one only when the panel around it changes,
  /// which then has the same problem.
  bool is_known_good(int p) const { return p < int(good_at.size()) && good_at[p] == panels.changes(p); }

  void remember_as_good(int p)
  {
    if (int(good_at.size()) <= p) good_at.resize(p + 1, -1);
    good_at[p] = panels.changes(p);
  }

  /// Splits a panel that is not a planar domain. Parts halve, so this ends: single faces are planar.
  bool split_a_handle()
  {
    for (int p : used_labels(panels)) {
      if (is_known_good(p)) continue;
      const Panel_topology topology = panel_topology(panels, p);
      if ((topology.handles == 0 && topology.loops > 0) || panels.faces(p).size() < 2) continue;
      const std::size_t mark = panels.mark();
      split_geodesically(work, p, far_faces(work, p));
      ++splits;
      finish_step(mark);
      return true;
    }
    return false;
  }

  /// Where one panel lies wholly along another: merges them if that costs no more than the two panels that it saves, or
  /// else splits one of them in three along the boundary.
  bool open_a_closed_boundary()
  {
    for (int p : used_labels(panels)) {
      if (is_known_good(p)) continue;
      const Panel_topology topology = panel_topology(panels, p);
      if (topology.problems() == 0) remember_as_good(p);
      if (topology.closed.empty()) continue;
      const Closed_boundary& boundary = topology.closed[0];
      const int q = panels.label(across(boundary[0]));
      const std::size_t mark = panels.mark();
      if (topology.loops == 1 && absorptions > 0 && panels.number_of_panels() > 4 &&
          fits.merge_cost(p, q) <= 2 * price_of_a_panel()) {
        --absorptions;
        join_panels(panels, p, q);
        ++merges;
      } else {
        const bool keeps_p = topology.loops > 1 && panel_topology(panels, q).loops == 1;
        split_along(keeps_p ? q : p, boundary, keeps_p);
      }
      finish_step(mark);
      return true;
    }
    return false;
  }

  int across(int h) const { return panels.connectivity().neighbours[h / 3][h % 3]; }

  /// What a panel is worth: the mean data cost of a panel.
  double price_of_a_panel() { return fits.total() / (std::max)(1, panels.number_of_panels()); }

  /// Splits panel `p` in three from seeds spread along a boundary, given by its half-edges on either side.
  void split_along(int p, const Closed_boundary& boundary, bool other_side)
  {
    std::vector<int> seeds;
    for (std::size_t i = 0; i < 3; ++i) {
      const int h = boundary[i * boundary.size() / 3], f = other_side ? across(h) : h / 3;
      if (std::find(seeds.begin(), seeds.end(), f) == seeds.end()) seeds.push_back(f);
    }
    if (seeds.size() < 2) {
      join_panels(panels, p, panels.label(other_side ? boundary[0] / 3 : across(boundary[0])));
      ++merges;
      return;
    }
    split_geodesically(work, p, seeds);
    splits += int(seeds.size()) - 1;
  }

  /// A way to resolve a problem: a merger of two panels, a split of one, or a handover of faces.
  struct Remedy
  {
    enum Kind
    {
      merger,
      split,
      handover
    } kind;
    int p = -1, q = -1;
    std::vector<int> faces; // seeds of the split, or the faces handed over
  };

  void apply(const Remedy& r)
  {
    switch (r.kind) {
    case Remedy::merger:
      join_panels(panels, r.p, r.q);
      break;
    case Remedy::split:
      split_geodesically(work, r.p, r.faces);
      break;
    case Remedy::handover:
      flip_all(panels, r.faces, r.p);
      break;
    }
  }

  /// What a remedy would do.
  struct Outcome
  {
    int local = 0, topology = 0; // problems
    double cost = 0;             // rise of the data cost, panels priced
  };

  Outcome try_out(const Remedy& r)
  {
    const std::size_t mark = panels.mark();
    const double cost_before = fits.total(), price = price_of_a_panel();
    const int panels_before = panels.number_of_panels(), relabelled = work.relabelled;
    apply(r);
    settle(work, mark);
    std::vector<int> changed = changed_panels(panels, mark); // no other had a problem, or could have got one alone
    if (std::find(changed.begin(), changed.end(), r.p) == changed.end() && !panels.faces(r.p).empty())
      changed.push_back(r.p);
    Outcome result{panels.number_of_local_problems(), topology_problems(panels, changed),
                   fits.total() - cost_before + price * (panels.number_of_panels() - panels_before)};
    panels.roll_back(mark);
    work.relabelled = relabelled;
    return result;
  }

  /// Applies the remedy that lowers the number of local problems at least cost and makes none of topology. If there is
  /// none, splits: panels of single faces have no problems, so enough of that succeeds.
  bool resolve_a_local_problem()
  {
    const int v = first_problem();
    if (v == -1) return false;
    const std::vector<Remedy> remedies = remedies_at(v);
    const int before = panels.number_of_local_problems();
    const Remedy *best = nullptr, *best_split = nullptr;
    Outcome best_outcome, split_outcome;
    for (const Remedy& r : remedies) {
      const Outcome o = try_out(r);
      if (o.topology == 0 && o.local < before && (!best || o.cost < best_outcome.cost)) best = &r, best_outcome = o;
      const int sum = o.local + o.topology;
      if (r.kind == Remedy::split && (!best_split || sum < split_outcome.local + split_outcome.topology))
        best_split = &r, split_outcome = o;
    }
    if (!best && panels.number_of_panels() < most_panels) best = best_split;
    const std::size_t mark = panels.mark();
    if (best) {
      apply(*best);
      merges += best->kind == Remedy::merger;
      splits += best->kind == Remedy::split;
    } else if (!merge_cheapest_at(v)) {
      return false;
    }
    finish_step(mark);
    return true;
  }

  int first_problem() const
  {
    for (int v = 0; v < panels.connectivity().number_of_vertices(); ++v)
      if (work.mender.has_problem(v)) return v;
    return -1;
  }

  bool merge_cheapest_at(int v)
  {
    const std::vector<Run> runs = runs_around(panels, v);
    if (panels.number_of_panels() <= 4 || runs.size() < 2) return false;
    merge_at_touch(panels, fits, v);
    ++merges;
    return true;
  }

  std::vector<Remedy> remedies_at(int v)
  {
    std::vector<Remedy> result;
    std::set<std::pair<int, int>> pairs;
    panels.for_each_chord(v, [&](int w) { remedies_for_chord(v, w, pairs, result); });
    remedies_for_repetition(v, pairs, result);
    for (const auto& pair : pairs) result.push_back({Remedy::merger, pair.first, pair.second, {}});
    return result;
  }

  /// The parts of the panel on both sides of the chord go to the panel across, whatever their size.
  void remedies_for_chord(int v, int w, std::set<std::pair<int, int>>& pairs, std::vector<Remedy>& result)
  {
    const Connectivity& c = panels.connectivity();
    for (int f : c.star(v)) {
      const int i = c.corner_of(f, v), g = c.neighbours[f][i];
      if (c.triangles[f][(i + 1) % 3] != w) continue;
      for (int q : panels.labels_at(v)) {
        if (q == panels.label(f) || !contains(panels.labels_at(w), q)) continue;
        pairs.insert(std::minmax(q, panels.label(f)));
        const std::size_t half = panels.faces(panels.label(f)).size() / 2 + 1;
        for (const auto& side : {std::make_pair(f, g), std::make_pair(g, f)}) {
          std::vector<int> part = cut_off_part(panels, side.first, side.second, half);
          if (!part.empty()) result.push_back({Remedy::handover, q, -1, std::move(part)});
        }
      }
    }
  }

  void remedies_for_repetition(int v, std::set<std::pair<int, int>>& pairs, std::vector<Remedy>& result)
  {
    const Label_set s = panels.labels_at(v);
    for (std::size_t i = 0; i + 2 < s.size(); ++i)
      for (std::size_t j = i + 1; j + 1 < s.size(); ++j)
        for (std::size_t k = j + 1; k < s.size(); ++k) {
          if (!panels.is_repeated(s[i], s[j], s[k])) continue;
          const int w = other_corner(v, s[i], s[j], s[k]);
          if (w == -1) continue;
          pairs.insert({s[i], s[j]});
          pairs.insert({s[i], s[k]});
          pairs.insert({s[j], s[k]});
          for (int p : {s[i], s[j], s[k]}) {
            const int f = face_of(v, p), g = face_of(w, p);
            if (f != g) result.push_back({Remedy::split, p, -1, {f, g}});
          }
        }
  }

  /// Another vertex at which the three panels meet.
  int other_corner(int v, int p, int q, int r) const
  {
    int smallest = p;
    for (int i : {q, r})
      if (panels.faces(i).size() < panels.faces(smallest).size()) smallest = i;
    int best = -1;
    for (int f : panels.faces(smallest))
      for (int w : panels.connectivity().triangles[f]) {
        const Label_set& s = panels.labels_at(w);
        if (w != v && s.size() > 2 && contains(s, p) && contains(s, q) && contains(s, r) && (best == -1 || w < best))
          best = w;
      }
    return best;
  }

  int face_of(int v, int p) const
  {
    for (int f : panels.connectivity().star(v))
      if (panels.label(f) == p) return f;
    return -1;
  }

  Panel_work& work;
  Panel_labelling& panels;
  Panel_fits& fits;
  std::vector<std::int64_t> good_at; // changes(p) when panel p was last seen without problems of topology
  int most_panels = 0;
  int absorptions =
      0; // panels that may still be merged into the one around them: after that, splits have the last word
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_REPAIR_H
