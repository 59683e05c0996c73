// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guide_text.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

using namespace CGAL::Multiplanar;

namespace {

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments)
{
  char text[400];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

std::string joined(const std::vector<std::string>& words, const char* between = " ")
{
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : between) + word;
  return result;
}

/// The connectors of a step by the panel that they lead to: "C012 C013 towards P07, C020 towards P09".
std::string mounted_connectors(const Assembly_guide& guide, const Assembly_step& step)
{
  const int panel = guide.panel[step.parts[0]];
  std::map<int, std::vector<std::string>> towards;
  for (std::size_t i = 1; i < step.parts.size(); ++i)
    towards[guide.other_end(step.parts[i], panel)].push_back(guide.model.parts[step.parts[i]].id);
  std::vector<std::string> groups;
  for (const auto& group : towards) groups.push_back(joined(group.second) + " towards " + guide.panel_id(group.first));
  return joined(groups, ", ");
}

/// Neighbours that are placed before the step.
struct Placed_neighbours
{
  std::vector<std::string> all, glued;
};

Placed_neighbours placed_neighbours(const Assembly_guide& guide, int panel, int step)
{
  Placed_neighbours result;
  std::set<int> seen, glued;
  for (const Guide_neighbour& n : guide.neighbours[panel]) {
    const auto& parts = guide.parts_of_panel[n.panel];
    if (std::none_of(parts.begin(), parts.end(), [&](int i) { return guide.step[i] >= 0 && guide.step[i] < step; }))
      continue;
    if (seen.insert(n.panel).second) result.all.push_back(guide.panel_id(n.panel));
    if (guide.model.joints[n.edge].kind == Edge_joint::Kind::none && glued.insert(n.panel).second)
      result.glued.push_back(guide.panel_id(n.panel));
  }
  return result;
}

} // namespace

std::string facts_in_words(const Assembly_guide& guide)
{
  const Model& model = guide.model;
  CGAL::Bbox_3 box;
  for (const auto& corner : model.complex.corners) box += corner.point.bbox();
  return formatted("%d panels, %d connectors, %zu sheet%s of %g mm, %.0f × %.0f × %.0f mm", guide.count_panels(),
                   guide.count_connectors(), model.sheets.size(), model.sheets.size() == 1 ? "" : "s",
                   model.settings.thickness, box.x_span(), box.y_span(), box.z_span());
}

std::string step_text(const Assembly_guide& guide, int s)
{
  const Assembly_step& step = guide.model.assembly[s];
  const int first = step.parts[0];
  if (!guide.is_panel(first)) return "Push " + guide.model.parts[first].id + " from inside into its slot.";
  std::string text;
  if (step.parts.size() > 1) text = "Mount " + mounted_connectors(guide, step) + " on its inside. ";
  if (s == 0) return text + "Lay it on the table, inside up.";
  const Placed_neighbours placed = placed_neighbours(guide, guide.panel[first], s);
  text += placed.all.empty() ? "Put it in its place." : "Put it on next to " + joined(placed.all) + ".";
  if (!placed.glued.empty()) text += " Glue towards " + joined(placed.glued) + ".";
  if (!step.approach)
    text += formatted(" No straight way leads there: tilt it in; the last %g mm are straight.", step.travel);
  return text;
}

std::vector<std::string> glued_edges(const Assembly_guide& guide)
{
  std::vector<std::string> result;
  const Panel_complex& complex = guide.model.complex;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const auto& panels = complex.edges[e].panels;
    if (guide.model.joints[e].kind != Edge_joint::Kind::none || guide.parts_of_panel[panels[0]].empty() ||
        guide.parts_of_panel[panels[1]].empty())
      continue;
    result.push_back(guide.panel_id((std::min)(panels[0], panels[1])) + "-" +
                     guide.panel_id((std::max)(panels[0], panels[1])));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::string> materials_in_words(const Assembly_guide& guide)
{
  const Model& model = guide.model;
  std::vector<std::string> lines;
  std::map<std::pair<double, double>, int> sizes;
  for (const Sheet& sheet : model.sheets) ++sizes[{sheet.width, sheet.height}];
  for (const auto& size : sizes)
    lines.push_back(formatted("%d sheet%s of %g × %g mm, %g mm thick (measure it: stock varies by a tenth)",
                              size.second, size.second == 1 ? "" : "s", size.first.first, size.first.second,
                              model.settings.thickness));
  lines.push_back(formatted("%d panels and %d connectors to cut from them: sheets/sheet-1.svg, .dxf or .pdf and on",
                            guide.count_panels(), guide.count_connectors()));
  lines.push_back(formatted("drawn for a beam %g mm wide, tabs %g mm wider than their slots", model.settings.kerf,
                            model.settings.fit));
  return lines;
}

std::vector<std::string> tools_in_words(const Assembly_guide& guide)
{
  std::vector<std::string> lines = {"a laser cutter", "masking tape, to hold panels until their neighbours do"};
  if (guide.model.settings.fit > 0) lines.push_back("a soft mallet, for tabs that are tight");
  if (!glued_edges(guide).empty() || guide.model.settings.fit <= 0) lines.push_back("glue that suits the material");
  lines.push_back("a file or sandpaper, for tabs that are too tight");
  return lines;
}

std::vector<std::string> hints_in_words(const Assembly_guide& guide)
{
  std::vector<std::string> lines = {
      "Every part bears its id, panels on their inside. The last pages show where each lies on its sheet.",
      "A panel goes on from outside, straight along the direction that it faces: the arrow of its step.",
      "Connectors are mounted first, from inside, on the panel of their step. Their other tab points to the panel that "
      "the step names; its slot takes it when that panel comes.",
      "Connectors with the same angle look alike and may be swapped; others may not."};
  const auto glued = glued_edges(guide);
  if (!glued.empty()) lines.push_back("Edges that nothing joins, to be glued: " + joined(glued, ", ") + ".");
  return lines;
}
