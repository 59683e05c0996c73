// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_written_model.h"
#include "failure.h"
#include "read_mesh.h"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

using namespace CGAL::Multiplanar;

namespace {

using Json = nlohmann::json;

/// What is wrong with the file, without its name.
struct Fault : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

void expect(bool holds, const std::string& what)
{
  if (!holds) throw Fault(what);
}

Point_2 point_2(const Json& j) { return Point_2(j.at(0).get<double>(), j.at(1).get<double>()); }
Point_3 point_3(const Json& j) { return Point_3(j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()); }
Vector_3 vector_3(const Json& j) { return point_3(j) - CGAL::ORIGIN; }

Outline outline(const Json& j)
{
  Outline result;
  for (const Json& p : j) result.push_back(point_2(p));
  expect(result.size() >= 3, "an outline with fewer than three vertices");
  return result;
}

int numbered(const std::map<std::string, int>& numbers, const std::string& id)
{
  const auto found = numbers.find(id);
  expect(found != numbers.end(), quoted(id) + " is named but not there");
  return found->second;
}

/// Corners, edges and panels; a loop's sides are found by the corners that they join.
Panel_complex complex_of(const Json& json)
{
  Panel_complex complex;
  std::map<std::string, int> panels;
  for (const Json& c : json.at("corners")) complex.corners.emplace_back().point = point_3(c);
  for (const Json& p : json.at("panels")) panels.emplace(p.at("id").get<std::string>(), int(panels.size()));
  complex.panels.resize(json.at("panels").size());
  std::map<std::array<int, 3>, Panel_complex::Side> sides; // by panel, first and last corner
  for (const Json& e : json.at("edges")) {
    Panel_complex::Edge edge;
    for (int i = 0; i < 2; ++i) {
      edge.corners[i] = e.at("corners").at(i).get<int>();
      edge.panels[i] = numbered(panels, e.at("panels").at(i).get<std::string>());
      expect(edge.corners[i] >= -1 && edge.corners[i] < complex.number_of_corners(), "an edge names no corner");
    }
    const int number = complex.number_of_edges();
    sides[{edge.panels[0], edge.corners[0], edge.corners[1]}] = {number, 0};
    sides[{edge.panels[1], edge.corners[1], edge.corners[0]}] = {number, 1};
    complex.edges.push_back(std::move(edge));
  }
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    const Json& j = json.at("panels").at(p);
    complex.panels[p].plane = Plane{vector_3(j.at("normal")), j.at("offset").get<double>()};
    for (const Json& loop : j.at("loops")) {
      const std::vector<int> corners = loop.get<std::vector<int>>();
      complex.panels[p].loops.emplace_back();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto side = sides.find({p, corners[i], corners[(i + 1) % corners.size()]});
        expect(side != sides.end(), "a side of panel " + std::to_string(p + 1) + " is no edge");
        complex.panels[p].loops.back().push_back(side->second);
      }
    }
  }
  return complex;
}

Edge_joint joint_of(const Json& j)
{
  Edge_joint joint;
  const std::string kind = j.at("joint").get<std::string>();
  joint.kind = kind == "connector" ? Edge_joint::Kind::connector
               : kind == "teeth"   ? Edge_joint::Kind::teeth
                                   : Edge_joint::Kind::none;
  joint.parts = j.at("parts").get<std::vector<std::string>>();
  joint.reason = j.value("reason", "");
  return joint;
}

Part part_of(const Json& j)
{
  Part part;
  part.id = j.at("id").get<std::string>();
  part.kind = j.at("kind") == "panel" ? Part::Kind::panel : Part::Kind::connector;
  const Json& frame = j.at("frame");
  part.frame = {point_3(frame.at("origin")), vector_3(frame.at("u")), vector_3(frame.at("v")),
                vector_3(frame.at("normal"))};
  part.outline = outline(j.at("outline"));
  for (const Json& hole : j.at("holes")) part.holes.push_back(outline(hole));
  for (const Json& tab : j.at("tabs")) part.tabs.push_back(tab.get<std::array<int, 2>>());
  for (const Json& e : j.at("engraving"))
    part.engraving.push_back({e.at("text").get<std::string>(), point_2(e.at("at")), e.at("angle").get<double>(),
                              e.at("height").get<double>()});
  return part;
}

Sheet sheet_of(const Json& j, const std::map<std::string, int>& parts)
{
  Sheet sheet;
  sheet.width = j.at("width").get<double>();
  sheet.height = j.at("height").get<double>();
  for (const Json& p : j.at("placements"))
    sheet.placements.push_back({numbered(parts, p.at("part").get<std::string>()), p.at("x").get<double>(),
                                p.at("y").get<double>(), p.at("rotation").get<double>(), p.at("mirrored").get<bool>()});
  return sheet;
}

Model model_of(const Json& json)
{
  expect(json.is_object() && json.value("format", "") == "multiplanar-model", "it is no model of this program");
  Model model;
  model.input_file = json.at("input").at("file").get<std::string>();
  model.scale = json.at("input").at("scale").get<double>();
  const Json& settings = json.at("settings");
  model.settings.panels = settings.at("panels").get<int>();
  model.settings.thickness = settings.at("thickness").get<double>();
  model.settings.kerf = settings.at("kerf").get<double>();
  model.settings.fit = settings.at("fit").get<double>();
  model.complex = complex_of(json);
  for (const Json& e : json.at("edges")) model.joints.push_back(joint_of(e));
  std::map<std::string, int> parts;
  for (const Json& p : json.at("parts")) {
    model.parts.push_back(part_of(p));
    parts.emplace(model.parts.back().id, int(parts.size()));
    if (!p.contains("texture")) continue;
    const Json& t = p.at("texture");
    model.parts.back().texture = {t.at("file").get<std::string>(), point_2(t.at("origin")),
                                  t.at("mm_per_pixel").get<double>()};
  }
  for (const Json& s : json.at("sheets")) model.sheets.push_back(sheet_of(s, parts));
  return model;
}

} // namespace

Model read_written_model(const std::string& folder)
{
  const std::string file = folder + "/model.json", hint = ": give a folder that make or fabricate wrote";
  const std::string text = read_file(file);
  try {
    return model_of(Json::parse(text));
  } catch (const Json::exception& error) {
    throw input_error(file + ": " + quoted(error.what()) + hint);
  } catch (const Fault& error) {
    throw input_error(file + ": " + error.what() + hint);
  }
}
