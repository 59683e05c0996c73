// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_JOINTS_H
#define CGAL_MULTIPLANAR_JOINTS_H

#include <CGAL/Multiplanar/Joint_options.h>
#include <CGAL/Multiplanar/internal/Tooth_planner.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Every candidate edge with the priority of its two panels swapped along all of it.
inline std::vector<Alternation> everywhere(const std::vector<int>& edges)
{
  std::vector<Alternation> result;
  for (int e : edges) {
    result.emplace_back();
    result.back().edge = e;
    result.back().intervals = {{-1e6, 1e6}};
  }
  return result;
}

/// The panels that teeth brought too close to a slot, or into the way of a connector.
inline std::vector<int> disturbed_panels(const Connector_placer& placer, const Truncation& truncation, double thickness)
{
  std::vector<int> result;
  const auto sheets = sheet_blocks(truncation, thickness);
  for (const Placed_connector& c : placer.connectors()) {
    const Block body(c.frame, c.profile.body, 0, thickness);
    for (int p = 0; p < int(sheets.size()); ++p) {
      const auto& sides = placer.view(c.edge).sides;
      const int side = sides[0].panel == p ? 0 : sides[1].panel == p ? 1 : -1;
      if (side < 0
              ? exactly_apart(body, sheets[p])
              : Slotted_panel(truncation.panels[p].pieces)
                        .piece_with_room(sides[side],
                                         {c.position, c.position + thickness, c.profile.slot_start, c.profile.slot_end},
                                         1.5 * thickness) >= 0)
        continue;
      result.push_back(p);
    }
  }
  return result;
}

inline bool is_at(const Panel_complex& complex, int e, const std::vector<int>& panels)
{
  return std::any_of(panels.begin(), panels.end(),
                     [&](int p) { return complex.edges[e].panels[0] == p || complex.edges[e].panels[1] == p; });
}

inline bool share_a_panel(const Panel_complex& complex, int e, int f)
{
  return is_at(complex, e, {complex.edges[f].panels[0], complex.edges[f].panels[1]});
}

/// Of edges whose teeth fail, those to give up first: the shortest around each panel. Teeth take room from each other,
/// so that the others may hold without them.
inline std::vector<int> first_to_give_up(const Panel_complex& complex, const std::vector<int>& failing)
{
  const auto is_before = [&](int e, int f) {
    const double a = complex.edge_length(e), b = complex.edge_length(f);
    return a != b ? a < b : e < f;
  };
  std::vector<int> result;
  for (int e : failing)
    if (std::none_of(failing.begin(), failing.end(),
                     [&](int f) { return f != e && share_a_panel(complex, e, f) && is_before(f, e); }))
      result.push_back(e);
  return result;
}

/// Cuts teeth where they have room, and leaves out those that do not hold or disturb a connector.
inline void make_teeth(const Panel_complex& complex, const Joint_options& options, Truncator& truncator,
                       const Connector_placer& placer, Tooth_planner& planner, Joints& result)
{
  const auto candidates = planner.candidates();
  if (candidates.empty()) return;
  const Truncation usual = result.truncation, reversed = truncator.truncation(everywhere(candidates));
  for (int e : candidates) {
    Alternation teeth = planner.plan(e, usual, reversed);
    if (!teeth.intervals.empty()) result.teeth.push_back(std::move(teeth));
  }
  for (;;) {
    result.truncation = result.teeth.empty() ? usual : truncator.truncation(result.teeth);
    const auto disturbed = disturbed_panels(placer, result.truncation, options.thickness);
    std::vector<int> failing;
    for (const Alternation& teeth : result.teeth)
      if (!planner.interlocks(teeth, result.truncation) || is_at(complex, teeth.edge, disturbed))
        failing.push_back(teeth.edge);
    if (failing.empty() && !disturbed.empty()) // by teeth farther away: any may be
      for (const Alternation& teeth : result.teeth) failing.push_back(teeth.edge);
    if (failing.empty()) return;
    const auto given_up = first_to_give_up(complex, failing);
    const auto fails = [&](const Alternation& teeth) {
      return std::find(given_up.begin(), given_up.end(), teeth.edge) != given_up.end();
    };
    result.teeth.erase(std::remove_if(result.teeth.begin(), result.teeth.end(), fails), result.teeth.end());
  }
}

/// What joins edge `e`, or why nothing does.
inline Edge_joint edge_joint(int e, const Joints& joints, const Connector_placer& placer, const Tooth_planner& planner)
{
  Edge_joint joint;
  for (std::size_t i = 0; i < joints.connectors.size(); ++i)
    if (joints.connectors[i].edge == e) joint.parts.push_back(connector_id(int(i), joints.connectors.size()));
  if (!joint.parts.empty()) {
    joint.kind = Edge_joint::Kind::connector;
    return joint;
  }
  for (const Alternation& teeth : joints.teeth)
    if (teeth.edge == e) joint.kind = Edge_joint::Kind::teeth;
  if (joint.kind == Edge_joint::Kind::teeth) return joint;
  const std::string why_no_teeth = planner.reason(e).empty() ? "teeth would disturb connectors" : planner.reason(e);
  joint.reason = placer.reason(e) == why_no_teeth ? why_no_teeth : placer.reason(e) + "; " + why_no_teeth;
  return joint;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarParts

Truncates the panels of a closed polygon mesh for sheets of one thickness (`truncate_panels()`) and joins them, edge by
edge (section 3.2.4 of the paper).

 - *Connectors*: flat parts of the same sheet perpendicular to the edge, with a tab through a slot in either panel.
   Slots keep 1.5 thicknesses from every outline and from each other; a connector's body runs into no panel and no other
   connector (exact). Reflex edges can have them up to 270 degrees and a little more. An edge has one for every
   `options.spacing` thicknesses of its length.
 - *Teeth*, where no connector fits, on convex edges: the two panels give way to each other alternately. At least one
   tooth is as wide as the sheet is thick, at least 0.8 mm deep, and held between two of the other panel.
 - Edges with neither get a reason.

\param complex flat panels, in mm, outward oriented
\param options the thickness of the sheet in mm, what joints are wanted, edge by edge if need be, and their measures
\return the truncated panels, connectors in their places, teeth, and for every edge its joint or the reason why it has
        none. All measures are nominal: a tab is as large as its slot. The same for the same input, on every machine.
\throws std::invalid_argument as `truncate_panels()`, if `options.mode_of_edge` has a wrong length, or if
        `options.sizes` is empty

A few truncations, and for every edge as many trials as it has places an eighth of a thickness apart; 20 to 40
milliseconds a panel.
*/
inline Joints make_joints(const Panel_complex& complex, const Joint_options& options)
{
  if (!options.mode_of_edge.empty() && int(options.mode_of_edge.size()) != complex.number_of_edges())
    throw std::invalid_argument("one joint mode per edge is needed");
  if (options.sizes.empty()) throw std::invalid_argument("at least one size of connectors is needed");
  internal::Truncator truncator(complex, options);
  Joints result;
  result.truncation = truncator.truncation();
  internal::Connector_placer placer(complex, result.truncation, options);
  placer.place_all();
  internal::Tooth_planner planner(complex, options, placer, result.truncation.order);
  internal::make_teeth(complex, options, truncator, placer, planner, result);
  result.connectors = placer.connectors();
  for (Placed_connector& c : result.connectors)
    for (int i = 0; i < 2; ++i) {
      const auto& side = placer.view(c.edge).sides[i];
      c.pieces[i] =
          internal::Slotted_panel(result.truncation.panels[side.panel].pieces)
              .piece_with_room(side,
                               {c.position, c.position + options.thickness, c.profile.slot_start, c.profile.slot_end},
                               1.5 * options.thickness);
      CGAL_postcondition(c.pieces[i] >= 0);
    }
  for (int e = 0; e < complex.number_of_edges(); ++e)
    result.joints.push_back(internal::edge_joint(e, result, placer, planner));
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_JOINTS_H
