// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MAP_TO_PANELS_H
#define CGAL_MULTIPLANAR_INTERNAL_MAP_TO_PANELS_H

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/internal/flat_ears.h>
#include <CGAL/Multiplanar/internal/panel_targets.h>
#include <CGAL/Multiplanar/internal/slide_boundaries.h>
#include <CGAL/Multiplanar/internal/transfer_geometry.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

// Not every triangulation can be drawn in every polygon: a face with two sides on the boundary cannot lie at a corner
// with an angle over 180 degrees (see flat_ears.h, which comes first), and an edge across the panel needs its ends to see
// each other. What fails is mended in two ways. The vertices of a chain slide along their edge; and faces along the boundary are given to the panel
// across it, or get company from there, as long as the complex stays the same: corners, edges and panels, only the mesh
// vertices that they stand on may change.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A mesh mapped onto flat panels, as far as possible.
class Panel_mapping
{
public:
  /// \param shape positions that lengths and triangle shapes are taken from
  /// \param labels the panel of every face
  /// \param complex made from `labels`, with flat panels
  Panel_mapping(const Connectivity& c, const Points& shape, std::vector<int> labels, Panel_complex complex)
      : c(c), shape(shape), local(c.number_of_vertices(), -1)
  {
    state.labels = std::move(labels);
    state.complex = std::move(complex);
    changes = mend_flat_ears(c, shape, state.labels, state.complex);
    std::vector<int> failed;
    state.targets = panel_targets(c, shape, state.labels, state.complex, failed);
    for (int p = 0; p < state.complex.number_of_panels(); ++p) state.inverted.push_back(count_inverted(state, p));
  }

  /// Mends until every face is positive or nothing helps.
  /// \return whether every face is
  bool repair(int max_changes = 100)
  {
    std::set<int> hopeless;
    for (int n = 0; n < max_changes; ++n) {
      int p = 0;
      while (p < int(state.inverted.size()) && (state.inverted[p] == 0 || hopeless.count(p))) ++p;
      if (p == int(state.inverted.size())) break;
      if (improve(p)) // what was hopeless may not be so next to something new
        for (int q : state.complex.neighbours(p)) hopeless.erase(q);
      else hopeless.insert(p);
    }
    return failed().empty();
  }

  const Points& targets() const { return state.targets; }
  const std::vector<int>& labels() const { return state.labels; }
  const Panel_complex& complex() const { return state.complex; }
  int relabelled_faces() const { return changes; }

  /// The panels with faces that are not positive, those with most of them first.
  std::vector<int> failed() const
  {
    std::vector<int> result;
    for (int p = 0; p < int(state.inverted.size()); ++p)
      if (state.inverted[p] > 0) result.push_back(p);
    std::stable_sort(result.begin(), result.end(), [&](int p, int q) { return state.inverted[p] > state.inverted[q]; });
    return result;
  }

private:
  struct State
  {
    std::vector<int> labels;
    Panel_complex complex;
    Points targets;
    std::vector<int> inverted; // faces of each panel
    int total() const
    {
      int n = 0;
      for (int i : inverted) n += i;
      return n;
    }
  };

  using Change = std::pair<std::vector<int>, int>; // faces and the panel that they are given to

  bool is_inverted(const State& s, int f, int p) const
  {
    return !(area_vector(c, s.targets, f) * s.complex.panels[p].plane.normal > least_doubled_area(s.complex, p));
  }

  int count_inverted(const State& s, int p) const
  {
    int n = 0;
    for (int f : s.complex.panels[p].faces) n += is_inverted(s, f, p);
    return n;
  }

  /// Makes some mending of panel `p` that leaves fewer inverted faces. \return false if none was found
  bool improve(int p)
  {
    if (slide(p, state)) return true;
    if (state.inverted[p] > most_changed) return false;
    std::vector<std::pair<int, State>> worse; // what changes alone did not mend, for sliding
    for (const Change& change : possible_changes(p)) {
      std::optional<State> next = changed(state, change);
      if (!next) continue;
      const int gain = state.total() - next->total();
      if (gain > 0) return accept(*next);
      worse.emplace_back(-gain, std::move(*next));
    }
    std::stable_sort(worse.begin(), worse.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < worse.size() && i < 6; ++i) {
      State& next = worse[i].second;
      for (int q = 0; q < int(next.inverted.size()); ++q)
        if (next.inverted[q] > state.inverted[q] || q == p) slide(q, next);
      if (next.total() < state.total()) return accept(next);
    }
    return false;
  }

  bool accept(State& next)
  {
    state = std::move(next);
    ++changes;
    return true;
  }

  /// Lets the boundaries between `p` and its neighbours slide, with what is near in the neighbours or, if that does not
  /// help, with all that is in them. \return whether fewer faces are inverted
  bool slide(int p, State& s) const
  {
    return slide_with(p, vertices_near_panel(c, s.complex, p, 2), s) ||
           slide_with(p, std::vector<char>(c.number_of_vertices(), 1), s);
  }

  bool slide_with(int p, const std::vector<char>& movable, State& s) const
  {
    std::set<int> members{p};
    for (int q : s.complex.neighbours(p)) members.insert(q);
    Sliding_panels sliding(c, s.labels, s.complex, members, movable, s.targets);
    const int before = sliding.count_inverted();
    sliding.run();
    if (sliding.count_inverted() >= before) return false;
    sliding.write(s.targets);
    for (int q : members) s.inverted[q] = count_inverted(s, q);
    return true;
  }

  /// Single faces near the inverted ones of panel `p`, and all faces of one panel around one of their vertices, with
  /// the panel that they could be given to: one of both is `p`. Single faces come first.
  std::vector<Change> possible_changes(int p) const
  {
    std::set<int> near, corners;
    int taken = 0;
    for (int f : state.complex.panels[p].faces)
      if (is_inverted(state, f, p) && taken++ < 8)
        for (int v : c.triangles[f]) corners.insert(v);
    for (int v : corners) near.insert(c.star(v).begin(), c.star(v).end());
    std::set<Change> single, stars;
    for (int f : near)
      for (int g : c.neighbours[f])
        if (state.labels[g] != state.labels[f] && (state.labels[f] == p || state.labels[g] == p))
          single.insert({{f}, state.labels[g]});
    for (int v : corners) {
      std::map<int, std::vector<int>> by_panel;
      for (int f : c.star(v)) by_panel[state.labels[f]].push_back(f);
      for (const auto& from : by_panel)
        for (const auto& to : by_panel)
          if (from.first != to.first && (from.first == p || to.first == p) && from.second.size() > 1)
            stars.insert({from.second, to.first});
    }
    std::vector<Change> result(single.begin(), single.end());
    result.insert(result.end(), stars.begin(), stars.end());
    return result;
  }

  /// The state after a change, or nothing if the complex would not be the same.
  std::optional<State> changed(const State& s, const Change& change)
  {
    std::set<int> affected;
    State next;
    next.labels = s.labels;
    for (int f : change.first) {
      next.labels[f] = change.second;
      for (int v : c.triangles[f])
        for (int g : c.star(v)) affected.insert(s.labels[g]);
    }
    try {
      next.complex = make_panel_complex(c, shape, next.labels, s.complex.number_of_panels());
    } catch (const std::invalid_argument&) {
      return {};
    }
    if (!transfer_geometry(s.complex, next.complex)) return {};
    next.targets = s.targets;
    next.inverted = s.inverted;
    for (const auto& e : next.complex.edges)
      if (affected.count(e.panels[0]) && affected.count(e.panels[1]))
        place_chain(e.chain, shape, next.complex.corners[e.corners[0]].point, next.complex.corners[e.corners[1]].point,
                    next.targets);
    for (int p : affected) place_panel(c, shape, next.labels, next.complex, p, local, next.targets);
    for (int p = 0; p < int(next.inverted.size()); ++p) next.inverted[p] = count_inverted(next, p);
    return next;
  }

  /// Changes mend one place; a panel with more inverted faces than this is of the wrong shape.
  static constexpr int most_changed = 12;

  const Connectivity& c;
  const Points& shape;
  std::vector<int> local;
  State state;
  int changes = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MAP_TO_PANELS_H
