// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_MODEL_JSON_H
#define CGAL_MULTIPLANAR_IO_WRITE_MODEL_JSON_H

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/io/json_format.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline Json json_outline(const Outline& outline)
{
  Json result = Json::array();
  for (const Point_2& p : outline) result.push_back(to_json(p));
  return result;
}

inline Json json_settings(const Model_settings& s)
{
  return {{"panels", s.panels}, {"size", s.size}, {"thickness", s.thickness},
          {"kerf", s.kerf},     {"fit", s.fit},   {"seed", s.seed}};
}

inline Json json_panel(const Panel_complex& complex, int p)
{
  const auto& panel = complex.panels[p];
  Json loops = Json::array();
  for (const auto& loop : panel.loops) loops.push_back(complex.loop_corners(loop));
  return {{"id", panel_id(complex, p)},
          {"normal", to_json(panel.plane.normal)},
          {"offset", panel.plane.offset},
          {"loops", loops}};
}

inline Json json_edge(const Model& model, int e)
{
  const auto& edge = model.complex.edges[e];
  const Edge_joint& joint = model.joints[e];
  Json result = {{"id", edge_id(model.complex, e)},
                 {"panels", {panel_id(model.complex, edge.panels[0]), panel_id(model.complex, edge.panels[1])}},
                 {"corners", edge.corners},
                 {"dihedral", edge.is_closed() ? Json() : Json(model.complex.dihedral(e))},
                 {"joint", to_string(joint.kind)},
                 {"parts", joint.parts}};
  if (joint.kind == Edge_joint::Kind::none) result["reason"] = joint.reason;
  return result;
}

inline Json json_engraving(const Engraving& e)
{
  return {{"text", e.text}, {"at", to_json(e.at)}, {"angle", e.angle}, {"height", e.height}};
}

inline Json json_part(const Part& part)
{
  Json holes = Json::array(), tabs = Json::array(), engraving = Json::array();
  for (const Outline& hole : part.holes) holes.push_back(json_outline(hole));
  for (const auto& tab : part.tabs) tabs.push_back(tab);
  for (const Engraving& e : part.engraving) engraving.push_back(json_engraving(e));
  Json json = {{"id", part.id},
               {"kind", part.kind == Part::Kind::panel ? "panel" : "connector"},
               {"frame",
                {{"origin", to_json(part.frame.origin)},
                 {"u", to_json(part.frame.u)},
                 {"v", to_json(part.frame.v)},
                 {"normal", to_json(part.frame.normal)}}},
               {"outline", json_outline(part.outline)},
               {"holes", holes},
               {"area", part.area()},
               {"tabs", tabs},
               {"engraving", engraving}};
  if (!part.texture.file.empty())
    json["texture"] = {{"file", part.texture.file},
                       {"origin", to_json(part.texture.origin)},
                       {"mm_per_pixel", part.texture.mm_per_pixel}};
  return json;
}

inline Json json_sheet(const Model& model, int s)
{
  const Sheet& sheet = model.sheets[s];
  Json placements = Json::array();
  for (const Placement& p : sheet.placements)
    placements.push_back(
        {{"part", model.parts[p.part].id}, {"x", p.x}, {"y", p.y}, {"rotation", p.rotation}, {"mirrored", p.mirrored}});
  return {{"file", sheet_file(s, "svg")}, {"width", sheet.width}, {"height", sheet.height}, {"placements", placements}};
}

inline Json json_step(const Model& model, int s)
{
  const Assembly_step& step = model.assembly[s];
  Json parts = Json::array();
  for (const int part : step.parts) parts.push_back(model.parts[part].id);
  Json result = {{"step", s + 1}, {"parts", parts}, {"direction", to_json(step.direction)}, {"travel", step.travel}};
  if (step.approach) result["approach"] = to_json(*step.approach);
  return result;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes all that is known of a model, in mm, as `model.json`. Numbers read back as the same doubles. The caller checks
the state of `out` afterwards.

\pre one joint an edge
*/
inline void write_model_json(std::ostream& out, const Model& model)
{
  using namespace internal;
  CGAL_precondition(int(model.joints.size()) == model.complex.number_of_edges());
  Json json = {{"format", "multiplanar-model"},
               {"version", 1},
               {"unit", "mm"},
               {"input", {{"file", model.input_file}, {"scale", model.scale}}},
               {"settings", json_settings(model.settings)}};
  for (const char* key : {"corners", "panels", "edges", "parts", "sheets", "assembly"}) json[key] = Json::array();
  for (const auto& corner : model.complex.corners) json["corners"].push_back(to_json(corner.point));
  for (int p = 0; p < model.complex.number_of_panels(); ++p) json["panels"].push_back(json_panel(model.complex, p));
  for (int e = 0; e < model.complex.number_of_edges(); ++e) json["edges"].push_back(json_edge(model, e));
  for (const Part& part : model.parts) json["parts"].push_back(json_part(part));
  for (int s = 0; s < int(model.sheets.size()); ++s) json["sheets"].push_back(json_sheet(model, s));
  for (int s = 0; s < int(model.assembly.size()); ++s) json["assembly"].push_back(json_step(model, s));
  write_json(out, json);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_MODEL_JSON_H
