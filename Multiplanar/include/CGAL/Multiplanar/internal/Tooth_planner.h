// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TOOTH_PLANNER_H
#define CGAL_MULTIPLANAR_INTERNAL_TOOTH_PLANNER_H

#include <CGAL/Multiplanar/Joint_options.h>
#include <CGAL/Multiplanar/internal/Connector_placer.h>
#include <CGAL/Multiplanar/internal/Truncator.h>
#include <CGAL/Multiplanar/teeth.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Finds where teeth have room along the edges without connectors, and afterwards which of them came out.
class Tooth_planner
{
public:
  Tooth_planner(const Panel_complex& complex, const Joint_options& options, const Connector_placer& connectors,
                const std::vector<int>& order)
      : complex(complex), options(options), connectors(connectors), rank(order.size())
  {
    for (int i = 0; i < int(order.size()); ++i) rank[order[i]] = i;
    reasons.resize(complex.number_of_edges());
  }

  /// The side (0 or 1) of edge `e` whose panel stays where there is no tooth of the other.
  int keeper(int e) const { return rank[complex.edges[e].panels[0]] < rank[complex.edges[e].panels[1]] ? 0 : 1; }

  /// The edges that teeth are wanted on and that their angle allows.
  std::vector<int> candidates()
  {
    std::vector<int> result;
    for (int e = 0; e < complex.number_of_edges(); ++e) {
      reasons[e] = obstacle(e);
      if (reasons[e].empty()) result.push_back(e);
    }
    return result;
  }

  /// Plans the teeth of edge `e`. `usual` is the truncation without teeth, `reversed` that with the other panel staying
  /// at every candidate: each shows how far one panel's material can reach.
  Alternation plan(int e, const Truncation& usual, const Truncation& reversed)
  {
    const Edge_in_panel &stays = side(e, true), &gives_way = side(e, false);
    const double line = middle_line(e);
    const auto rooms = intersection(material_along(usual.panels[stays.panel].pieces, stays, line),
                                    material_along(reversed.panels[gives_way.panel].pieces, gives_way, line));
    Alternation teeth;
    teeth.edge = e;
    bool near_slots = false;
    for (const Interval& room : rooms) {
      if (room[1] <= 0 || room[0] >= connectors.view(e).length) continue; // beside another edge of the two panels
      const auto stretches = away_from_slots(e, room);
      near_slots = near_slots || stretches.size() != 1 || stretches[0] != room;
      for (const Interval& s : intersection(stretches, backed_stretches(e, usual)))
        for (const Interval& tooth : teeth_in(s, s[0] - room[0], room[1] - s[1], options.thickness))
          teeth.intervals.push_back(tooth);
    }
    if (teeth.intervals.empty())
      reasons[e] = near_slots ? "teeth would come too close to slots" : "no stretch of it has room for teeth";
    return teeth;
  }

  /// Does a tooth of the panel that otherwise gives way, one thickness wide, lie between two of the other's?
  bool interlocks(const Alternation& teeth, const Truncation& result)
  {
    for (const Interval& interval : teeth.intervals)
      if (is_held(teeth.edge, interval, result)) return true;
    reasons[teeth.edge] = "other panels leave no room for teeth";
    return false;
  }

  /// Why edge `e` has no teeth; empty if nothing speaks against them.
  const std::string& reason(int e) const { return reasons[e]; }

  const Edge_in_panel& side(int e, bool of_keeper) const
  {
    return connectors.view(e).sides[of_keeper ? keeper(e) : 1 - keeper(e)];
  }

private:
  std::string obstacle(int e) const
  {
    const Joint_mode mode = options.mode_at(e);
    if (connectors.reason(e).empty()) return "it has a connector";
    if (mode == Joint_mode::connectors || mode == Joint_mode::none) return "teeth were not asked for";
    const Edge_view& view = connectors.view(e);
    if (view.is_reflex()) return "panels do not overlap at a reflex edge, so teeth cannot hold";
    if (tooth_strip(view.theta, options.thickness).depth() < options.shallowest_tooth)
      return "the angle is too flat for teeth";
    for (const Edge_in_panel& s : view.sides)
      if (connectors.slotted_panels()[s.panel].pieces.empty()) return panel_id(complex, s.panel) + " vanished";
    return "";
  }

  /// Half a thickness below either outer face: this far from the edge the overlap of the two sheets has its middle.
  double middle_line(int e) const { return options.thickness / 2 / std::tan(connectors.view(e).theta / 2); }

  /// Where both panels go on behind the teeth, so that neither a tooth nor what is left behind a gap breaks off.
  std::vector<Interval> backed_stretches(int e, const Truncation& usual) const
  {
    const double behind = tooth_strip(connectors.view(e).theta, options.thickness).far + 2 * options.thinnest;
    const Edge_in_panel &stays = side(e, true), &gives_way = side(e, false);
    return intersection(material_along(usual.panels[stays.panel].pieces, stays, behind),
                        material_along(usual.panels[gives_way.panel].pieces, gives_way, behind));
  }

  /// The panel that stays loses the strip under a tooth of the other: the stretches of `room` where that is far enough
  /// from its slots.
  std::vector<Interval> away_from_slots(int e, const Interval& room) const
  {
    const Edge_in_panel& stays = side(e, true);
    const Tooth_strip strip = tooth_strip(connectors.view(e).theta, options.thickness);
    const double margin = slot_margin(options.thickness);
    std::vector<Interval> stretches{room};
    for (const auto& slots : connectors.slotted_panels()[stays.panel].slots)
      for (const Outline& slot : slots) {
        Interval shadow{1e300, -1e300}; // the positions that a gap must not touch
        for (double position = room[0]; position <= room[1]; position += 0.25) {
          bool near = false;
          for_each_side({{}, {slot}}, [&](const Point_2& a, const Point_2& b) {
            near = near || distance_to_slot({position, position, strip.near, strip.far}, stays, a, b) < margin;
          });
          if (near) shadow = {(std::min)(shadow[0], position - 0.25), position + 0.25};
        }
        if (shadow[0] < shadow[1]) stretches = intersection(stretches, {{-1e300, shadow[0]}, {shadow[1], 1e300}});
      }
    return stretches;
  }

  bool is_held(int e, const Interval& interval, const Truncation& result) const
  {
    const Edge_in_panel &stays = side(e, true), &gives_way = side(e, false);
    const Tooth_strip strip = tooth_strip(connectors.view(e).theta, options.thickness);
    const auto& tooth_pieces = result.panels[gives_way.panel].pieces;
    const double line = middle_line(e), inset = 0.01;
    std::vector<Interval> tooth{interval};
    for (double distance : {strip.near + inset, line, strip.far - inset})
      tooth = intersection(tooth, material_along(tooth_pieces, gives_way, distance));
    const auto others = material_along(result.panels[stays.panel].pieces, stays, line);
    const auto touches = [&](double position, int end) { // does one of the others end here?
      return std::any_of(others.begin(), others.end(),
                         [&](const Interval& o) { return std::abs(o[end] - position) < 0.05 && o[1] - o[0] > 0.1; });
    };
    return std::any_of(tooth.begin(), tooth.end(), [&](const Interval& i) {
      return i[1] - i[0] >= options.thickness && touches(i[0], 1) && touches(i[1], 0);
    });
  }

  const Panel_complex& complex;
  const Joint_options& options;
  const Connector_placer& connectors;
  std::vector<int> rank;
  std::vector<std::string> reasons;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TOOTH_PLANNER_H
