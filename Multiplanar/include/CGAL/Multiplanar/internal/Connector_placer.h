// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_PLACER_H
#define CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_PLACER_H

#include <CGAL/Multiplanar/internal/Connector_space.h>
#include <CGAL/Multiplanar/internal/slot_room.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Places connectors edge by edge: the edges that have no other joint first (reflex ones, and those too flat for
/// teeth), among equals those with the fewest places. Each takes the largest size that fits somewhere, as near as
/// possible to where it should be; places are preferred where the connector can come with either panel. Then connectors
/// that stand in the way of an edge without one are moved along their own edges, if that makes room. A last round adds
/// connectors to long edges.
class Connector_placer
{
public:
  Connector_placer(const Panel_complex& complex, const Truncation& truncation, const Joint_options& options)
      : complex(complex), options(options), space(complex, truncation, options)
  {
    std::vector<Frame> frames;
    for (const Truncated_panel& panel : truncation.panels) {
      frames.push_back(panel.frame);
      panels.emplace_back(panel.pieces);
    }
    for (int e = 0; e < complex.number_of_edges(); ++e) views.push_back(edge_view(complex, e, frames));
    reasons.resize(views.size());
  }

  void place_all()
  {
    std::vector<int> edges;
    for (int e = 0; e < int(views.size()); ++e)
      if (may_have_connectors(e)) edges.push_back(e);
    const std::vector<int> by_need = in_order_of_need(edges);
    for (int e : by_need) place_first(e);
    for (int e : by_need)
      if (!reasons[e].empty() && make_room(e)) reasons[e].clear();
    for (int e : edges)
      for (int i = 1; i < wanted(e) && reasons[e].empty(); ++i) place_near(e, target(e, i));
    std::stable_sort(placed.begin(), placed.end(), [](const Placed_connector& a, const Placed_connector& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.position < b.position;
    });
  }

  const Edge_view& view(int e) const { return views[e]; }
  const std::vector<Placed_connector>& connectors() const { return placed; }
  /// Why edge `e` has no connector; empty if it has one.
  const std::string& reason(int e) const { return reasons[e]; }
  const std::vector<Slotted_panel>& slotted_panels() const { return panels; }

private:
  double t() const { return options.thickness; }

  bool may_have_connectors(int e)
  {
    const Joint_mode mode = options.mode_at(e);
    if (mode == Joint_mode::teeth || mode == Joint_mode::none) {
      reasons[e] = "connectors were not asked for";
      return false;
    }
    for (const Edge_in_panel& side : views[e].sides)
      if (panels[side.panel].pieces.empty()) {
        reasons[e] = panel_id(complex, side.panel) + " vanished";
        return false;
      }
    reasons[e] = connector_obstacle(views[e].theta, t(), options.approach_length());
    return reasons[e].empty();
  }

  bool could_have_teeth(int e) const
  {
    return options.mode_at(e) == Joint_mode::automatic && !views[e].is_reflex() &&
           t() * std::sin(views[e].theta) >= options.shallowest_tooth;
  }

  std::vector<Connector_size> sizes_for(int e) const
  {
    std::vector<Connector_size> sizes = options.sizes;
    if (could_have_teeth(e))
      sizes.erase(std::remove_if(sizes.begin(), sizes.end(), [](const Connector_size& s) { return s.tab_width < 1; }),
                  sizes.end());
    return sizes.empty() ? options.sizes : sizes;
  }
  Connector_size smallest_size(int e) const { return sizes_for(e).back(); }

  std::vector<int> in_order_of_need(std::vector<int> edges) const
  {
    std::vector<std::pair<bool, int>> need(views.size());
    for (int e : edges) need[e] = {could_have_teeth(e), int(places_with_slots(e, smallest_size(e)).size())};
    std::stable_sort(edges.begin(), edges.end(), [&](int a, int b) { return need[a] < need[b]; });
    return edges;
  }

  int wanted(int e) const
  {
    return (std::max)(1, (std::min)(options.most_connectors, int(views[e].length / (options.spacing * t()))));
  }
  /// Where connector `i` of edge `e` should begin.
  double target(int e, int i) const { return views[e].length * (i + 0.5) / wanted(e) - t() / 2; }

  Connector_profile profile(int e, const Connector_size& size) const
  {
    return connector_profile(views[e].theta, t(), options.approach_length(), size);
  }

  Slot slot(double position, const Connector_profile& p) const
  {
    return {position, position + t(), p.slot_start, p.slot_end};
  }

  /// Between positions that are tried.
  double step() const { return t() / 8; }

  /// The positions along edge `e`, an eighth of a thickness apart, where both slots have room.
  std::vector<double> places_with_slots(int e, const Connector_size& size) const
  {
    std::vector<double> places;
    const Connector_profile p = profile(e, size);
    for (double x = 0; x + t() <= views[e].length; x += step())
      if (has_slots(e, slot(x, p))) places.push_back(x);
    return places;
  }

  bool has_slots(int e, const Slot& slot) const
  {
    for (const Edge_in_panel& side : views[e].sides)
      if (panels[side.panel].piece_with_room(side, slot, 1.5 * t()) < 0) return false;
    return true;
  }

  void place_first(int e)
  {
    if (place_near(e, target(e, 0))) return;
    reasons[e] = diagnosis(e);
  }

  /// Takes the first place with room from which the connector can come with either panel; failing that with one panel,
  /// or with none.
  bool place_near(int e, double target)
  {
    std::vector<Placed_connector> fallback;
    int freedom_of_fallback = -1;
    for (const Connector_size& size : sizes_for(e)) {
      auto places = places_with_slots(e, size);
      std::stable_sort(places.begin(), places.end(),
                       [target](double a, double b) { return std::abs(a - target) < std::abs(b - target); });
      for (double position : places) {
        const Placed_connector c = connector_at(e, size, position);
        if (!space.has_room(e, space.body_of(c.frame, c.profile))) continue;
        int freedom = 0;
        for (int side = 0; side < 2; ++side)
          freedom += space.can_come_with(e, c.frame, c.profile, views[e].theta, side);
        if (freedom > freedom_of_fallback) fallback = {c}, freedom_of_fallback = freedom;
        if (freedom == 2) break;
      }
      if (freedom_of_fallback == 2) break;
    }
    if (fallback.empty()) return false;
    place(fallback[0]);
    return true;
  }

  Placed_connector connector_at(int e, const Connector_size& size, double position) const
  {
    Placed_connector c;
    c.edge = e;
    c.position = position;
    c.profile = profile(e, size);
    c.frame = connector_frame(views[e], position, space.sheet(views[e].sides[0].panel).frame);
    return c;
  }

  void place(Placed_connector c)
  {
    const Slot s = slot(c.position, c.profile);
    for (int i = 0; i < 2; ++i) {
      const Edge_in_panel& side = views[c.edge].sides[i];
      c.pieces[i] = panels[side.panel].piece_with_room(side, s, 1.5 * t());
      c.slots[i] = side.rectangle(s.from, s.to, s.near, s.far);
      panels[side.panel].slots[c.pieces[i]].push_back(c.slots[i]);
    }
    space.add(space.body_of(c.frame, c.profile));
    placed.push_back(std::move(c));
  }

  /// Takes connector `i` out of its place.
  void remove(std::size_t i)
  {
    const Placed_connector& c = placed[i];
    for (int side = 0; side < 2; ++side) {
      auto& slots = panels[views[c.edge].sides[side].panel].slots[c.pieces[side]];
      slots.erase(std::find(slots.begin(), slots.end(), c.slots[side]));
    }
    space.remove(i);
    placed.erase(placed.begin() + std::ptrdiff_t(i));
  }

  /// The connectors that keep connector `c` from its place: by their slots or by their bodies.
  std::vector<std::size_t> in_the_way_of(const Placed_connector& c) const
  {
    std::vector<std::size_t> result = space.collisions(space.body_of(c.frame, c.profile));
    for (std::size_t i = 0; i < placed.size(); ++i)
      if (slots_too_near(c, placed[i])) result.push_back(i);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  bool slots_too_near(const Placed_connector& c, const Placed_connector& other) const
  {
    for (const Edge_in_panel& side : views[c.edge].sides)
      for (int i = 0; i < 2; ++i)
        if (views[other.edge].sides[i].panel == side.panel &&
            !Slotted_panel::keeps_from(other.slots[i], side, slot(c.position, c.profile), 1.5 * t()))
          return true;
    return false;
  }

  /// Finds a place for the smallest connector of edge `e` where at most two others stand in the way, all of which have
  /// another place.
  bool make_room(int e)
  {
    const Connector_profile p = profile(e, smallest_size(e));
    int trials = 0;
    for (double x = 0; x + t() <= views[e].length && trials < 40; x += step()) {
      bool room = true;
      for (const Edge_in_panel& side : views[e].sides)
        room = room && panels[side.panel].piece_with_bare_room(side, slot(x, p), 1.5 * t()) >= 0;
      if (!room) continue;
      const Placed_connector c = connector_at(e, smallest_size(e), x);
      if (!space.is_clear_of_panels(e, space.body_of(c.frame, c.profile))) continue;
      const auto others = in_the_way_of(c);
      if (others.size() > 2) continue;
      ++trials;
      if (place_instead(c, others)) return true;
    }
    return false;
  }

  /// Places `c`, and the connectors `others` elsewhere along their edges; if one of them has no other place, everything
  /// stays as it was.
  bool place_instead(const Placed_connector& c, const std::vector<std::size_t>& others)
  {
    const auto old_placed = placed;
    const auto old_panels = panels;
    const auto old_space = space.placed_bodies();
    for (auto i = others.rbegin(); i != others.rend(); ++i) remove(*i);
    place(c);
    const bool moved = std::all_of(others.begin(), others.end(), [&](std::size_t i) {
      return place_near(old_placed[i].edge, old_placed[i].position);
    });
    if (moved) return true;
    placed = old_placed;
    panels = old_panels;
    space.restore_bodies(old_space);
    return false;
  }

  /// Why no place was found.
  std::string diagnosis(int e) const
  {
    const Connector_profile p = profile(e, smallest_size(e));
    std::string narrow;
    for (const Edge_in_panel& side : views[e].sides) {
      bool room = false;
      for (double x = 0; !room && x + t() <= views[e].length; x += step())
        room = panels[side.panel].piece_with_room(side, slot(x, p), 1.5 * t()) >= 0;
      if (!room) narrow += (narrow.empty() ? "" : " and ") + panel_id(complex, side.panel);
    }
    if (!narrow.empty()) return "no room for a slot with its margin in " + narrow;
    if (!places_with_slots(e, smallest_size(e)).empty()) return "a connector would run into other panels or connectors";
    return "no place along the edge has room for slots in both panels";
  }

  const Panel_complex& complex;
  const Joint_options& options;
  Connector_space space;
  std::vector<Slotted_panel> panels;
  std::vector<Edge_view> views;
  std::vector<std::string> reasons;
  std::vector<Placed_connector> placed;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_PLACER_H
