// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "joint_geometry.h"

#include <CGAL/centroid.h>

#include <algorithm>
#include <map>
#include <set>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// What the joints of all edges have used: a slot or a connector that nothing uses is a fault too.
struct Used
{
  std::map<std::string, std::string> edge_of_connector;
  std::set<std::pair<const Written_part*, std::size_t>> slots;
};

std::vector<const Written_part*> parts_of_panel(const Written_model& model, int panel)
{
  std::vector<const Written_part*> parts;
  for (const Written_part& part : model.parts)
    if (model.panel_of_part(part) == panel) parts.push_back(&part);
  return parts;
}

/// The hole that a tab lies in. A panel that fills a hole of its neighbour has its slots over that hole too, so the
/// tightest one counts.
struct Slot_of_tab
{
  const Written_part* part = nullptr; ///< null: there is none
  std::size_t hole = 0;
  int side = 0; ///< of the edge
  double play = 1e300;
  Tab_section section;
  std::string complaint; ///< if there is none although the tab is at a panel
};

/// Looks for the slot of one tab in the parts of one panel.
void find_slot(const Written_part& connector, std::size_t tab, const std::vector<const Written_part*>& parts, int side,
               double thickness, Slot_of_tab& slot)
{
  for (const Written_part* part : parts) {
    const Tab_section section = tab_in_part(connector, tab, *part, thickness);
    if (section.points.empty()) continue;
    if (slot.complaint.empty()) slot.complaint = "does not lie in a slot of " + part->id;
    for (std::size_t h = 0; h < part->holes.size(); ++h) {
      if (!section_in_hole(section, part->holes[h])) continue;
      const double play = play_in_hole(section, part->holes[h]);
      if (play < slot.play) slot = {part, h, side, play, section, slot.complaint};
    }
  }
}

/// What is wrong with the way a tab lies in its slot; empty if nothing is.
std::string fault_of(const Slot_of_tab& slot, double thickness)
{
  if (slot.section.low > 0.1 * thickness || slot.section.high < 0.9 * thickness)
    return "does not go through " + slot.part->id + ": it fills " + shown(slot.section.high - slot.section.low) +
           " of its " + shown(thickness) + " mm";
  if (slot.play > largest_play) return "has " + shown(slot.play) + " mm of play in its slot in " + slot.part->id;
  return "";
}

void check_connector(const Written_model& model, const Written_edge& edge, const Written_part& connector, Used& used,
                     Report& report)
{
  const auto claimed = used.edge_of_connector.emplace(connector.id, edge.id);
  if (!claimed.second)
    report.violation("connector " + connector.id + " is claimed by the edges " + claimed.first->second + " and " +
                     edge.id);
  std::array<bool, 2> joined = {false, false};
  std::vector<std::string> complaints;
  for (std::size_t tab = 0; tab < connector.tabs.size(); ++tab) {
    Slot_of_tab slot;
    for (int side = 0; side < 2; ++side)
      find_slot(connector, tab, parts_of_panel(model, model.panel_index(edge.panels[side])), side, model.thickness,
                slot);
    std::string complaint;
    if (slot.part) {
      used.slots.insert({slot.part, slot.hole});
      joined[slot.side] = true;
      complaint = fault_of(slot, model.thickness);
    } else {
      complaint = slot.complaint;
      if (complaint.empty()) complaint = "reaches neither " + edge.panels[0] + " nor " + edge.panels[1];
    }
    if (!complaint.empty()) complaints.push_back("tab " + std::to_string(tab + 1) + " " + complaint);
  }
  for (int side = 0; side < 2; ++side)
    if (!joined[side]) complaints.push_back("no tab of it lies in a slot of " + edge.panels[side]);
  for (const std::string& complaint : complaints)
    report.violation("edge " + edge.id + ", connector " + connector.id + ": " + complaint);
}

void check_connectors(const Written_model& model, const Written_edge& edge, Used& used, Report& report)
{
  if (edge.parts.empty()) report.violation("edge " + edge.id + " has the joint \"connector\" but names no connector");
  for (const std::string& id : edge.parts) {
    const int index = model.part_index(id);
    if (index < 0) report.violation("edge " + edge.id + " names the connector " + id + ", which is no part");
    else if (model.parts[index].is_panel)
      report.violation("edge " + edge.id + " names " + id + " as a connector, which is a panel");
    else check_connector(model, edge, model.parts[index], used, report);
  }
}

void check_teeth(const Written_model& model, const Written_edge& edge, Report& report)
{
  const int p = model.panel_index(edge.panels[0]), q = model.panel_index(edge.panels[1]);
  if (p < 0 || q < 0) return; // said already
  const Joint_line line = line_in_overlap(model.panels[p], model.panels[q], model.corners[edge.corners[0]],
                                          model.corners[edge.corners[1]], model.thickness);
  if (!line.exists) {
    report.violation("edge " + edge.id + " has the joint \"teeth\", but its panels do not overlap inside");
    return;
  }
  if (line.tooth_depth < 0.8 - erosion_depth)
    report.violation("edge " + edge.id + ": its teeth are only " + shown(line.tooth_depth) + " mm deep");
  const auto owners = owners_along(line, parts_of_panel(model, p), parts_of_panel(model, q));
  const double width = widest_held_tooth(owners);
  if (width <= 0)
    report.violation("edge " + edge.id + ": no tooth of " + edge.panels[0] + " or " + edge.panels[1] +
                     " lies between two of the other: the teeth do not interlock");
  else if (width < model.thickness - erosion_depth)
    report.violation("edge " + edge.id + ": its widest tooth between two others is only " + shown(width) +
                     " mm wide, less than the thickness");
}

/// Does a panel reach through the hole of another one's part? The middle of the hole, halfway through the sheet, tells.
bool makes_way_for_a_panel(const Written_model& model, const Written_part& part, const Loop& hole)
{
  const Point_2 c = CGAL::centroid(hole.begin(), hole.end());
  const Written_frame& f = part.frame;
  const Point_3 middle = f.origin + c.x() * f.u + c.y() * f.v - model.thickness / 2 * f.normal;
  return std::any_of(model.parts.begin(), model.parts.end(), [&](const Written_part& other) {
    return &other != &part && other.is_panel && reaches(other, middle, model.thickness);
  });
}

void check_empty_slots(const Written_model& model, const Used& used, Report& report)
{
  for (const Written_part& part : model.parts)
    for (std::size_t h = 0; h < part.holes.size() && part.is_panel; ++h)
      if (!used.slots.count({&part, h}) && is_slot(part.holes[h], model.thickness) &&
          !makes_way_for_a_panel(model, part, part.holes[h]))
        report.violation("part " + part.id + " has a slot at " + shown(part.holes[h][0]) + " that holds no tab");
}

} // namespace

void check_joints(const Written_model& model, Report& report)
{
  report.begin("joints");
  bool claims = false;
  for (const Written_edge& edge : model.edges) claims = claims || edge.joint != "none" || !edge.reason.empty();
  for (const Written_part& part : model.parts) claims = claims || !part.is_panel;
  if (!claims) return report.not_claimed("no edge has a joint or a reason for having none");

  Used used;
  std::map<std::string, int> count;
  for (const Written_edge& edge : model.edges) {
    ++count[edge.joint];
    if (edge.joint == "connector") check_connectors(model, edge, used, report);
    else if (edge.joint == "teeth") check_teeth(model, edge, report);
    else if (edge.joint != "none")
      report.violation("edge " + edge.id + " has a joint of the unknown kind \"" + edge.joint + "\"");
    else if (edge.reason.empty()) report.violation("edge " + edge.id + " has no joint and gives no reason");
  }
  for (const Written_part& part : model.parts)
    if (!part.is_panel && !used.edge_of_connector.count(part.id))
      report.violation("connector " + part.id + " belongs to no edge");
  check_empty_slots(model, used, report);
  report.checked(counted(count["connector"], "edge") + " with connectors through both panels, " +
                 std::to_string(count["teeth"]) + " with teeth that interlock, " + std::to_string(count["none"]) +
                 " without joint and with a reason");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
