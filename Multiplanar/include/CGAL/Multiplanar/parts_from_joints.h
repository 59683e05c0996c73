// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PARTS_FROM_JOINTS_H
#define CGAL_MULTIPLANAR_PARTS_FROM_JOINTS_H

#include <CGAL/Multiplanar/joints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarParts
/// Everything to be cut, and what holds it together.
struct Joined_parts
{
  std::vector<Part> parts;                   ///< panels by number and piece, then connectors
  std::vector<Edge_joint> joints;            ///< by edge of the complex
  std::vector<int> edge_of_part;             ///< by part: the edge of a connector, -1 for panels
  std::vector<int> panel_of_part;            ///< by part: the panel, -1 for connectors
  std::vector<std::array<int, 2>> hosts;     ///< by part: the parts that a connector's tabs go through, -1 for panels
  std::vector<std::array<int, 2>> overhangs; ///< panels {first, later}: these must be placed in that order
  std::vector<std::string> warnings;         ///< a sentence each
};

namespace internal {

/// The flanks of a tooth in an outline: the sides along the ends of its rectangle by the edge, at least half as long as
/// it is deep. What other panels cut obliquely is no flank: nothing there has a gap to fit into.
inline std::vector<int> tooth_flanks(const Outline& outline, const Edge_in_panel& edge, const Slot& tooth)
{
  const int n = int(outline.size());
  const double tolerance = 2e-3;
  const auto is_at = [&](const Point_2& p, double position) {
    return std::abs(edge.position(p) - position) < tolerance && edge.distance(p) > tooth.near - tolerance &&
           edge.distance(p) < tooth.far + tolerance;
  };
  std::vector<int> flanks;
  for (int i = 0; i < n; ++i) {
    const Point_2 &a = outline[i], &b = outline[(i + 1) % n];
    if (std::abs(edge.distance(b) - edge.distance(a)) < (tooth.far - tooth.near) / 2) continue;
    if ((is_at(a, tooth.from) && is_at(b, tooth.from)) || (is_at(a, tooth.to) && is_at(b, tooth.to)))
      flanks.push_back(i);
  }
  return flanks;
}

/// Adds the run of outline vertices from the one flank of a tooth to the other, if it has two and all between them
/// belongs to the tooth.
inline void add_tab(const Outline& outline, const Edge_in_panel& edge, const Slot& tooth,
                    std::vector<std::array<int, 2>>& tabs)
{
  const int n = int(outline.size());
  const std::vector<int> flanks = tooth_flanks(outline, edge, tooth);
  if (flanks.size() != 2) return;
  for (int first = 0; first < 2; ++first) {
    const int begin = flanks[first], end = (flanks[1 - first] + 1) % n;
    bool inside = begin != end;
    for (int i = begin; inside && i != end; i = (i + 1) % n)
      inside = distance_to_slot(tooth, edge.position(outline[i]), edge.distance(outline[i])) < 2e-3;
    const std::array<int, 2> tab{{begin, end}};
    if (!inside || std::find(tabs.begin(), tabs.end(), tab) != tabs.end()) continue;
    tabs.push_back(tab);
    return;
  }
}

/// The tabs that teeth make on a piece of panel `p`.
inline void add_teeth(const Panel_complex& complex, const Joints& joints, int p, const Outline& outline,
                      const std::vector<Frame>& frames, const std::vector<int>& rank, double thickness,
                      std::vector<std::array<int, 2>>& tabs)
{
  for (const Alternation& teeth : joints.teeth) {
    const auto& panels = complex.edges[teeth.edge].panels;
    if (panels[0] != p && panels[1] != p) continue;
    const Edge_view view = edge_view(complex, teeth.edge, frames);
    const int side = panels[0] == p ? 0 : 1;
    const Tooth_strip strip = tooth_strip(view.theta, thickness);
    const bool stays = rank[p] < rank[panels[1 - side]];
    for (std::size_t i = 0; i + (stays ? 1 : 0) < teeth.intervals.size(); ++i) {
      const Interval& gap = teeth.intervals[i];
      const Slot tooth = stays ? Slot{gap[1], teeth.intervals[i + 1][0], strip.near, strip.far}
                               : Slot{gap[0], gap[1], strip.near, strip.far};
      add_tab(outline, view.sides[side], tooth, tabs);
    }
  }
}

/// A piece of a panel that fell apart, with neither slots nor teeth, hangs on nothing.
inline void warn_about_loose_piece(const Part& part, std::size_t own_holes, std::vector<std::string>& warnings)
{
  if (part.tabs.empty() && part.holes.size() == own_holes)
    warnings.push_back(part.id + " has neither slots nor teeth: it must be glued");
}

inline Part connector_part(const Placed_connector& connector, const std::string& id)
{
  Part part;
  part.id = id;
  part.kind = Part::Kind::connector;
  part.frame = connector.frame;
  part.outline = connector.profile.outline;
  part.tabs.assign(connector.profile.tabs.begin(), connector.profile.tabs.end());
  return part;
}

} // namespace internal

/// \ingroup PkgMultiplanarParts
/// The parts of panels and connectors that `make_joints()` decided on.
inline Joined_parts parts_from_joints(const Panel_complex& complex, const Joints& joints, double thickness)
{
  Joined_parts result;
  result.joints = joints.joints;
  result.overhangs = joints.truncation.overhangs;
  result.warnings = joints.truncation.warnings;
  std::vector<Frame> frames;
  for (const Truncated_panel& panel : joints.truncation.panels) frames.push_back(panel.frame);
  std::vector<int> rank(frames.size());
  for (int i = 0; i < int(rank.size()); ++i) rank[joints.truncation.order[i]] = i;
  std::vector<int> first_part; // by panel
  for (int p = 0; p < int(frames.size()); ++p) {
    const auto& pieces = joints.truncation.panels[p].pieces;
    first_part.push_back(int(result.parts.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Part part;
      part.id = piece_id(complex, p, i, pieces.size());
      part.frame = frames[p];
      part.outline = pieces[i].outline;
      part.holes = pieces[i].holes;
      for (const Placed_connector& c : joints.connectors)
        for (int side = 0; side < 2; ++side)
          if (complex.edges[c.edge].panels[side] == p && c.pieces[side] == int(i)) part.holes.push_back(c.slots[side]);
      internal::add_teeth(complex, joints, p, part.outline, frames, rank, thickness, part.tabs);
      if (pieces.size() > 1) internal::warn_about_loose_piece(part, pieces[i].holes.size(), result.warnings);
      result.parts.push_back(std::move(part));
      result.edge_of_part.push_back(-1);
      result.panel_of_part.push_back(p);
      result.hosts.push_back({{-1, -1}});
    }
  }
  for (std::size_t i = 0; i < joints.connectors.size(); ++i) {
    result.parts.push_back(
        internal::connector_part(joints.connectors[i], connector_id(int(i), joints.connectors.size())));
    const Placed_connector& c = joints.connectors[i];
    const auto& panels = complex.edges[c.edge].panels;
    result.edge_of_part.push_back(c.edge);
    result.panel_of_part.push_back(-1);
    result.hosts.push_back({{first_part[panels[0]] + c.pieces[0], first_part[panels[1]] + c.pieces[1]}});
  }
  return result;
}

/*!
\ingroup PkgMultiplanarParts

From a closed polygon mesh to flat parts that go together: truncation, connectors with slots, teeth.

\param complex flat panels, in mm, outward oriented: made by this package or by `make_panel_complex_from_polygons()`
\param options the thickness of the sheet and what joints are wanted
\return nominal parts (no kerf, no interference), the joint of every edge or the reason why it has none, warnings about
        panels that vanish or fall apart. The order of the parts and all ids depend on the input alone.
\throws std::invalid_argument as `make_joints()`
*/
inline Joined_parts make_joined_parts(const Panel_complex& complex, const Joint_options& options)
{
  return parts_from_joints(complex, make_joints(complex, options), options.thickness);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PARTS_FROM_JOINTS_H
