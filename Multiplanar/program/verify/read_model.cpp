// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "written_model.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

using Json = nlohmann::json;

/// A value together with its place in the file, so that every complaint says where.
class Value
{
public:
  Value(const Json& json, std::string place) : json(json), place(std::move(place)) {}

  [[noreturn]] void fail(const std::string& what) const { throw Unreadable("model.json: " + place + " " + what); }

  bool has(const char* key) const { return json.is_object() && json.contains(key) && !json[key].is_null(); }
  Value operator[](const char* key) const
  {
    if (!json.is_object()) fail("should be an object");
    if (!json.contains(key)) fail(std::string("lacks \"") + key + "\"");
    return Value(json[key], place.empty() ? key : place + "." + key);
  }
  std::size_t size() const
  {
    if (!json.is_array()) fail("should be a list");
    return json.size();
  }
  Value operator[](std::size_t i) const { return Value(json[i], place + "[" + std::to_string(i) + "]"); }

  double number(double most = 1e9) const
  {
    if (!json.is_number()) fail("should be a number");
    const double x = json.get<double>();
    if (!std::isfinite(x) || std::abs(x) > most) fail("is out of range");
    return x;
  }
  int integer() const
  {
    if (!json.is_number_integer()) fail("should be an integer");
    const auto x = json.get<std::int64_t>();
    if (x < -1000000000 || x > 1000000000) fail("is out of range");
    return int(x);
  }
  bool boolean() const
  {
    if (!json.is_boolean()) fail("should be true or false");
    return json.get<bool>();
  }
  std::string text() const
  {
    if (!json.is_string()) fail("should be a text");
    return json.get<std::string>();
  }
  std::array<double, 3> triple() const
  {
    if (size() != 3) fail("should have three coordinates");
    return {(*this)[std::size_t(0)].number(), (*this)[1].number(), (*this)[2].number()};
  }
  Point_3 point_3() const
  {
    const auto c = triple();
    return Point_3(c[0], c[1], c[2]);
  }
  Vector_3 vector_3() const
  {
    const auto c = triple();
    return Vector_3(c[0], c[1], c[2]);
  }
  Point_2 point_2() const
  {
    if (size() != 2) fail("should have two coordinates");
    return Point_2((*this)[std::size_t(0)].number(), (*this)[1].number());
  }

private:
  const Json& json;
  std::string place;
};

/// f(element) for every element of the list `key`, if there is one.
template <class F>
void for_each(const Value& object, const char* key, F f)
{
  if (!object.has(key)) return;
  const Value list = object[key];
  for (std::size_t i = 0; i < list.size(); ++i) f(list[i]);
}

std::vector<std::string> read_texts(const Value& object, const char* key)
{
  std::vector<std::string> texts;
  for_each(object, key, [&](const Value& v) { texts.push_back(v.text()); });
  return texts;
}

std::array<int, 2> read_pair(const Value& v)
{
  if (v.size() != 2) v.fail("should have two entries");
  return {v[std::size_t(0)].integer(), v[1].integer()};
}

Loop read_loop(const Value& v)
{
  Loop loop;
  for (std::size_t i = 0; i < v.size(); ++i) loop.push_back(v[i].point_2());
  return loop;
}

int read_corner(const Value& v, std::size_t corners)
{
  const int corner = v.integer();
  if (corner < 0 || corner >= int(corners)) v.fail("is no corner");
  return corner;
}

Written_panel read_panel(const Value& v, std::size_t corners)
{
  Written_panel panel;
  panel.id = v["id"].text();
  panel.normal = v["normal"].vector_3();
  panel.offset = v["offset"].number();
  const Value loops = v["loops"];
  for (std::size_t i = 0; i < loops.size(); ++i) {
    panel.loops.emplace_back();
    for (std::size_t j = 0; j < loops[i].size(); ++j) panel.loops.back().push_back(read_corner(loops[i][j], corners));
  }
  return panel;
}

Written_edge read_edge(const Value& v, std::size_t corners)
{
  Written_edge edge;
  edge.id = v["id"].text();
  const Value panels = v["panels"], ends = v["corners"];
  if (panels.size() != 2) panels.fail("should have two entries");
  if (ends.size() != 2) ends.fail("should have two entries");
  for (std::size_t i = 0; i < 2; ++i) {
    edge.panels[i] = panels[i].text();
    edge.corners[i] = read_corner(ends[i], corners);
  }
  if (v.has("dihedral")) edge.dihedral = v["dihedral"].number();
  edge.joint = v["joint"].text();
  if (v.has("reason")) edge.reason = v["reason"].text();
  edge.parts = read_texts(v, "parts");
  return edge;
}

Written_part read_part(const Value& v)
{
  Written_part part;
  part.id = v["id"].text();
  const std::string kind = v["kind"].text();
  if (kind != "panel" && kind != "connector") v["kind"].fail("should be \"panel\" or \"connector\"");
  part.is_panel = kind == "panel";
  const Value frame = v["frame"];
  part.frame = {frame["origin"].point_3(), frame["u"].vector_3(), frame["v"].vector_3(), frame["normal"].vector_3()};
  part.outline = read_loop(v["outline"]);
  for_each(v, "holes", [&](const Value& hole) { part.holes.push_back(read_loop(hole)); });
  part.area = v["area"].number();
  for_each(v, "tabs", [&](const Value& tab) {
    part.tabs.push_back(read_pair(tab));
    for (int i : part.tabs.back())
      if (i < 0 || i >= int(part.outline.size())) tab.fail("is no range of the outline");
  });
  if (v.has("texture")) part.texture = v["texture"]["file"].text();
  return part;
}

Written_sheet read_sheet(const Value& v)
{
  Written_sheet sheet;
  sheet.file = v["file"].text();
  sheet.width = v["width"].number();
  sheet.height = v["height"].number();
  for_each(v, "placements", [&](const Value& p) {
    sheet.placements.push_back({p["part"].text(), p["x"].number(), p["y"].number(), p["rotation"].number(),
                                p.has("mirrored") && p["mirrored"].boolean()});
  });
  return sheet;
}

Written_step read_step(const Value& v)
{
  return {v["step"].integer(), read_texts(v, "parts"), v["direction"].vector_3(), v["travel"].number()};
}

void read_settings(const Value& v, Written_model& model)
{
  model.thickness = v["thickness"].number();
  if (v.has("kerf")) model.kerf = v["kerf"].number();
  if (v.has("fit")) model.fit = v["fit"].number();
  if (v.has("panels")) model.most_panels = v["panels"].integer();
  if (model.thickness <= 0) v["thickness"].fail("should be positive");
  if (model.kerf < 0) v["kerf"].fail("should not be negative");
  if (model.fit < 0) v["fit"].fail("should not be negative");
}

template <class Things>
void index_ids(const Things& things, const char* list, std::map<std::string, int>& by_id)
{
  for (std::size_t i = 0; i < things.size(); ++i)
    if (!by_id.emplace(things[i].id, int(i)).second)
      throw Unreadable(std::string("model.json: ") + list + " has \"" + things[i].id + "\" twice");
}

Json parse(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Unreadable(file.filename().string() + ": cannot be opened");
  try {
    return Json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw Unreadable(file.filename().string() + ": " + e.what());
  }
}

} // namespace

Written_model read_model(const std::filesystem::path& file)
{
  const Json json = parse(file);
  const Value top(json, "");
  if (!json.is_object() || !top.has("format") || top["format"].text() != "multiplanar-model")
    throw Unreadable("model.json: is no multiplanar-model");
  if (top["version"].integer() != 1) top["version"].fail("is unknown: this program reads version 1");
  if (top["unit"].text() != "mm") top["unit"].fail("should be \"mm\"");

  Written_model model;
  if (top.has("input") && top["input"].has("file")) model.input_file = top["input"]["file"].text();
  if (top.has("input") && top["input"].has("scale")) model.scale = top["input"]["scale"].number(1e40); // meshes may be tiny
  read_settings(top["settings"], model);
  const Value corners = top["corners"];
  for (std::size_t i = 0; i < corners.size(); ++i) model.corners.push_back(corners[i].point_3());
  const std::size_t n = model.corners.size();
  const Value panels = top["panels"];
  for (std::size_t i = 0; i < panels.size(); ++i) model.panels.push_back(read_panel(panels[i], n));
  for_each(top, "edges", [&](const Value& v) { model.edges.push_back(read_edge(v, n)); });
  for_each(top, "parts", [&](const Value& v) { model.parts.push_back(read_part(v)); });
  for_each(top, "sheets", [&](const Value& v) { model.sheets.push_back(read_sheet(v)); });
  for_each(top, "assembly", [&](const Value& v) { model.assembly.push_back(read_step(v)); });
  index_ids(model.panels, "panels", model.panel_by_id);
  index_ids(model.parts, "parts", model.part_by_id);
  std::map<std::string, int> edges;
  index_ids(model.edges, "edges", edges);
  return model;
}

double Written_model::diagonal() const
{
  if (corners.empty()) return 0;
  CGAL::Bbox_3 box;
  for (const Point_3& p : corners) box += p.bbox();
  return std::sqrt(std::pow(box.xmax() - box.xmin(), 2) + std::pow(box.ymax() - box.ymin(), 2) +
                   std::pow(box.zmax() - box.zmin(), 2));
}

int Written_model::panel_index(const std::string& id) const
{
  const auto found = panel_by_id.find(id);
  return found == panel_by_id.end() ? -1 : found->second;
}

int Written_model::part_index(const std::string& id) const
{
  const auto found = part_by_id.find(id);
  return found == part_by_id.end() ? -1 : found->second;
}

int Written_model::panel_of_part(const Written_part& part) const
{
  if (!part.is_panel) return -1;
  const int whole = panel_index(part.id);
  if (whole >= 0) return whole;
  std::string id = part.id;
  while (!id.empty() && id.back() >= 'a' && id.back() <= 'z') id.pop_back();
  return panel_index(id);
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
