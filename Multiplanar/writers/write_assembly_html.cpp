// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Assembly_guide.h"
#include "guide_files.h"
#include "guide_text.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Multiplanar/io/json_format.h>
#include <CGAL/Multiplanar/panel_triangulation.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ostream>

using namespace CGAL::Multiplanar;
using internal::Json;

namespace {

/// Micrometres are enough for the eye.
double short_number(double x) { return std::round(x * 1e3) / 1e3; }

Json short_vector(const Vector_3& v)
{
  const auto r = [](double x) { return std::round(x * 1e6) / 1e6; };
  return Json::array({r(v.x()), r(v.y()), r(v.z())});
}

Json flat(const Outline& loop)
{
  Json result = Json::array();
  for (const Point_2& p : loop) {
    result.push_back(short_number(p.x()));
    result.push_back(short_number(p.y()));
  }
  return result;
}

std::string hex(const Linear_colour& colour)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", internal::byte_of_linear(colour[0]),
                internal::byte_of_linear(colour[1]), internal::byte_of_linear(colour[2]));
  return text;
}

std::string base64(const std::string& bytes)
{
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int k = 3; k >= 0; --k) result += int(i) + 3 - k > int(bytes.size()) ? '=' : digits[group >> (6 * k) & 63];
  }
  return result;
}

Json picture(const Part_picture& p)
{
  return {{"uri", "data:image/jpeg;base64," + base64(jpeg_of_picture(p))},
          {"origin", internal::to_json(p.origin)},
          {"width", p.width},
          {"height", p.height}};
}

/// Triangles as positions in the loops one after another; none for a polygon that touches itself.
Json triangles(const std::vector<Outline>& loops)
{
  Json result = Json::array();
  if (!internal::is_polygon_with_holes(loops)) return result;
  for (const auto& t : internal::triangulate_polygon(loops))
    for (const int i : t) result.push_back(i);
  return result;
}

std::vector<Outline> oriented_loops(const Part& part)
{
  std::vector<Outline> loops{part.outline};
  loops.insert(loops.end(), part.holes.begin(), part.holes.end());
  for (std::size_t i = 0; i < loops.size(); ++i)
    if ((twice_signed_area(loops[i]) > 0) != (i == 0)) std::reverse(loops[i].begin(), loops[i].end());
  return loops;
}

/// Where the id is engraved, or the middle of the corners.
Point_2 label_place(const Part& part)
{
  if (!part.engraving.empty()) return part.engraving[0].at;
  double x = 0, y = 0;
  for (const Point_2& p : part.outline) x += p.x(), y += p.y();
  return Point_2(x / double(part.outline.size()), y / double(part.outline.size()));
}

Json part_json(const Assembly_guide& guide, int i)
{
  const Part& part = guide.model.parts[i];
  const auto loops = oriented_loops(part);
  Json holes = Json::array(), ends = Json::array();
  for (std::size_t h = 1; h < loops.size(); ++h) holes.push_back(flat(loops[h]));
  if (guide.edge[i] >= 0)
    for (const int p : guide.model.complex.edges[guide.edge[i]].panels) ends.push_back(p);
  CGAL::Bbox_2 box;
  for (const Point_2& p : part.outline) box += p.bbox();
  const Frame& f = part.frame;
  Json result = {
      {"id", part.id},
      {"kind", guide.is_panel(i) ? "panel" : "connector"},
      {"panel", guide.panel[i]},
      {"ends", ends},
      {"step", guide.step[i]},
      {"sheet", guide.sheet[i]},
      {"colour", hex(guide.colour[i])},
      {"frame", {short_vector(f.origin - CGAL::ORIGIN), short_vector(f.u), short_vector(f.v), short_vector(f.normal)}},
      {"outline", flat(loops[0])},
      {"holes", holes},
      {"triangles", triangles(loops)},
      {"label", flat({label_place(part)})},
      {"extent", {std::round(10 * (box.xmax() - box.xmin())) / 10, std::round(10 * (box.ymax() - box.ymin())) / 10}},
      {"explode", short_vector(explosion_of(guide, i))}};
  const auto found = guide.pictures.find(part.id);
  if (found != guide.pictures.end() && found->second.texture) result["texture"] = picture(found->second);
  return result;
}

Json panel_json(const Assembly_guide& guide, int p)
{
  Json neighbours = Json::array();
  for (const Guide_neighbour& n : guide.neighbours[p]) {
    const Edge_joint& joint = guide.model.joints[n.edge];
    Json connectors = Json::array();
    for (int i = 0; i < int(guide.model.parts.size()); ++i)
      if (guide.edge[i] == n.edge) connectors.push_back(i);
    neighbours.push_back({{"panel", n.panel},
                          {"edge", edge_id(guide.model.complex, n.edge)},
                          {"joint", to_string(joint.kind)},
                          {"connectors", connectors}});
  }
  return {{"id", guide.panel_id(p)}, {"parts", guide.parts_of_panel[p]}, {"neighbours", neighbours}};
}

Json step_json(const Assembly_guide& guide, int s)
{
  const Assembly_step& step = guide.model.assembly[s];
  Json result = {{"parts", step.parts},
                 {"direction", short_vector(step.direction)},
                 {"travel", step.travel},
                 {"text", step_text(guide, s)}};
  if (step.approach) result["approach"] = short_vector(*step.approach);
  return result;
}

Json sheet_json(const Assembly_guide& guide, int s)
{
  const Sheet& sheet = guide.model.sheets[s];
  Json placements = Json::array();
  for (const Placement& p : sheet.placements)
    placements.push_back({{"part", p.part},
                          {"x", short_number(p.x)},
                          {"y", short_number(p.y)},
                          {"rotation", p.rotation},
                          {"mirrored", p.mirrored}});
  return {{"file", sheet_file(s, "svg")}, {"width", sheet.width}, {"height", sheet.height}, {"placements", placements}};
}

Json model_json(const Assembly_guide& guide)
{
  const Model& model = guide.model;
  CGAL::Bbox_3 box;
  for (const auto& corner : model.complex.corners) box += corner.point.bbox();
  Json json = {
      {"title", guide.title},
      {"facts", facts_in_words(guide)},
      {"thickness", model.settings.thickness},
      {"size", {box.x_span(), box.y_span(), box.z_span()}},
      {"centre", {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2}},
      {"up", short_vector(guide.up)},
      {"view", short_vector(guide.towards_viewer)}};
  for (const char* list : {"parts", "panels", "steps", "sheets"}) json[list] = Json::array();
  for (int i = 0; i < int(model.parts.size()); ++i) json["parts"].push_back(part_json(guide, i));
  for (int p = 0; p < model.complex.number_of_panels(); ++p) json["panels"].push_back(panel_json(guide, p));
  for (int i = 0; i < int(model.assembly.size()); ++i) json["steps"].push_back(step_json(guide, i));
  for (int s = 0; s < int(model.sheets.size()); ++s) json["sheets"].push_back(sheet_json(guide, s));
  return json;
}

/// Text that cannot end the element it stands in.
std::string inside_script(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string value_of(const std::string& name, const Assembly_guide& guide)
{
  if (name == "TITLE") return escaped(guide.title);
  if (name == "STYLE") return guide_files::style();
  if (name == "MODEL") return inside_script(internal::one_line(model_json(guide)), "<", "\\u003c");
  if (name == "THREE") return inside_script(guide_files::three(), "</script", "<\\/script");
  if (name == "ORBIT") return inside_script(guide_files::orbit(), "</script", "<\\/script");
  return guide_files::script();
}

} // namespace

void write_assembly_html(std::ostream& out, const Assembly_guide& guide)
{
  const std::string page = guide_files::page();
  std::size_t done = 0;
  for (std::size_t at = page.find('%'); at != std::string::npos; at = page.find('%', done)) {
    const std::size_t end = page.find('%', at + 1);
    out.write(page.data() + done, std::streamsize(at - done));
    out << value_of(page.substr(at + 1, end - at - 1), guide);
    done = end + 1;
  }
  out.write(page.data() + done, std::streamsize(page.size() - done));
}
