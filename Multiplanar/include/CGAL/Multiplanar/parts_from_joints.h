// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PARTS_FROM_JOINTS_H
#define CGAL_MULTIPLANAR_PARTS_FROM_JOINTS_H

#include <CGAL/Multiplanar/joints.h>

#include <algorithm>
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
  std::vector<std::array<int, 2>> overhangs; ///< panels {first, later}: these must be placed in that order
  std::vector<std::string> warnings;
};

namespace internal {

/// The run of vertices of an outline in a rectangle by an edge, if they are consecutive and at least four.
inline void add_tab(const Outline& outline, const Edge_in_panel& edge, const Slot& tooth,
                    std::vector<std::array<int, 2>>& tabs)
{
  const int n = int(outline.size());
  const double tolerance = 2e-3;
  const auto inside = [&](int i) {
    return distance_to_slot(tooth, edge.position(outline[i % n]), edge.distance(outline[i % n])) < tolerance;
  };
  for (int i = 0; i < n; ++i) {
    if (!inside(i) || inside(i + n - 1)) continue;
    int j = i;
    while (j + 1 < i + n && inside(j + 1)) ++j;
    if (j - i >= 3) tabs.push_back({i, j % n});
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
  for (int p = 0; p < int(frames.size()); ++p) {
    const auto& pieces = joints.truncation.panels[p].pieces;
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
    }
  }
  for (std::size_t i = 0; i < joints.connectors.size(); ++i) {
    result.parts.push_back(
        internal::connector_part(joints.connectors[i], connector_id(int(i), joints.connectors.size())));
    result.edge_of_part.push_back(joints.connectors[i].edge);
    result.panel_of_part.push_back(-1);
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
