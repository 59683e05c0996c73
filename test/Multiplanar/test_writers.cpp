// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "panel_models.h"

#include <CGAL/Multiplanar/engrave_ids.h>
#include <CGAL/Multiplanar/io/write_model_json.h>
#include <CGAL/Multiplanar/io/write_panels_obj.h>
#include <CGAL/Multiplanar/io/write_report_json.h>
#include <CGAL/Multiplanar/io/write_shell_ply.h>
#include <CGAL/Multiplanar/io/write_svg.h>
#include <CGAL/Multiplanar/parts_from_panels.h>
#include <CGAL/Multiplanar/row_packing.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// What the files say, read back.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using nlohmann::json;

namespace {

/// Parts, ids and sheets of a complex that is in mm already.
Model model_of(const Panel_complex& complex)
{
  Model model;
  model.input_file = "test.off";
  model.complex = complex;
  Edge_joint none;
  none.reason = "a test";
  model.joints.assign(complex.number_of_edges(), none);
  std::vector<std::string> warnings;
  model.parts = parts_from_panels(complex, warnings);
  EXPECT_TRUE(warnings.empty());
  model.sheets = pack_in_rows(model.parts, Sheet_options());
  engrave_ids(model.parts, model.sheets, 1, 8);
  return model;
}

Panel_complex large_frame() { return scaled(picture_frame(), 20); }

template <class Writer>
std::string text_of(Writer write)
{
  std::ostringstream out;
  write(out);
  EXPECT_TRUE(out.good());
  return out.str();
}

Point_3 point_3(const json& j) { return Point_3(j[0], j[1], j[2]); }
Vector_3 vector_3(const json& j) { return Vector_3(j[0], j[1], j[2]); }

int occurrences(const std::string& text, const std::string& word)
{
  int n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

} // namespace

TEST(Number_format, numbers_read_back_and_lengths_are_short)
{
  for (double x : {0.1, 1. / 3, -1e-300, 123456789.125, 5e-324}) EXPECT_EQ(std::strtod(internal::exact_number(x).c_str(), nullptr), x);
  EXPECT_EQ(internal::drawing_number(12), "12");
  EXPECT_EQ(internal::drawing_number(120), "120");
  EXPECT_EQ(internal::drawing_number(-0.000001), "0");
  EXPECT_EQ(internal::drawing_number(0.123456), "0.12346");
  EXPECT_EQ(internal::drawing_number(-1.5), "-1.5");
}

TEST(Parts, the_frame_of_a_part_lays_its_outline_on_the_corners)
{
  const Panel_complex complex = large_frame();
  std::vector<std::string> warnings;
  const std::vector<Part> parts = parts_from_panels(complex, warnings);
  ASSERT_EQ(parts.size(), 10u);
  double area = 0;
  for (int p = 0; p < 10; ++p) {
    const Part& part = parts[p];
    const Frame& f = part.frame;
    EXPECT_NEAR((CGAL::cross_product(f.u, f.v) - f.normal).squared_length(), 0, 1e-24);
    EXPECT_NEAR(f.u * f.v, 0, 1e-15);
    EXPECT_NEAR(f.u.squared_length(), 1, 1e-15);
    EXPECT_EQ(part.holes.size(), p < 2 ? 1u : 0u);
    EXPECT_GT(twice_signed_area(part.outline), 0);
    for (const Outline& hole : part.holes) EXPECT_LT(twice_signed_area(hole), 0);
    const auto corners = complex.loop_corners(complex.panels[p].loops[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_NEAR(CGAL::squared_distance(f(part.outline[i]), complex.corners[corners[i]].point), 0, 1e-20);
      EXPECT_GE(part.outline[i].x(), -1e-9);
      EXPECT_GE(part.outline[i].y(), -1e-9);
    }
    EXPECT_NEAR(part.area(), complex.area(p), 1e-9);
    area += part.area();
  }
  EXPECT_NEAR(area, 400 * (2 * (36 - 4) + 24 + 8), 1e-8);
}

TEST(Parts, ids_are_counted_from_one_with_as_many_digits_as_needed)
{
  EXPECT_EQ(numbered_id('P', 0, 6, 2), "P01");
  EXPECT_EQ(numbered_id('P', 98, 99, 2), "P99");
  EXPECT_EQ(numbered_id('P', 0, 100, 2), "P001");
  EXPECT_EQ(numbered_id('E', 11, 1200, 3), "E0012");
}

TEST(Model_json, says_what_the_format_promises)
{
  const Model model = model_of(large_frame());
  const json j = json::parse(text_of([&](std::ostream& out) { write_model_json(out, model); }));
  EXPECT_EQ(j["format"], "multiplanar-model");
  EXPECT_EQ(j["version"], 1);
  EXPECT_EQ(j["unit"], "mm");
  EXPECT_EQ(j["corners"].size(), 16u);
  EXPECT_EQ(j["panels"].size(), 10u);
  EXPECT_EQ(j["edges"].size(), 24u);
  EXPECT_EQ(j["panels"][0]["id"], "P01");
  EXPECT_EQ(j["panels"][0]["loops"].size(), 2u);
  int convex = 0, reflex = 0;
  for (const json& edge : j["edges"]) {
    convex += std::abs(double(edge["dihedral"]) - 90) < 1e-9;
    reflex += std::abs(double(edge["dihedral"]) - 270) < 1e-9;
    EXPECT_EQ(edge["joint"], "none");
    EXPECT_EQ(edge["reason"], "a test");
    EXPECT_TRUE(edge["parts"].is_array());
    EXPECT_EQ(edge["panels"].size(), 2u);
  }
  // Convex are the outer rims and the outer uprights (12) and the inner rims (8); the inner uprights are reflex.
  EXPECT_EQ(convex, 20);
  EXPECT_EQ(reflex, 4);
  for (const json& part : j["parts"]) {
    const json& frame = part["frame"];
    for (const json& p : part["outline"]) {
      const Point_3 q =
          point_3(frame["origin"]) + double(p[0]) * vector_3(frame["u"]) + double(p[1]) * vector_3(frame["v"]);
      double nearest = 1e9;
      for (const json& corner : j["corners"]) nearest = std::min(nearest, CGAL::squared_distance(q, point_3(corner)));
      EXPECT_NEAR(nearest, 0, 1e-20);
    }
    EXPECT_EQ(part["engraving"][0]["text"], part["id"]);
  }
  std::set<std::string> placed;
  for (const json& sheet : j["sheets"])
    for (const json& placement : sheet["placements"]) {
      EXPECT_TRUE(placed.insert(placement["part"]).second);
      EXPECT_EQ(placement["mirrored"], true);
    }
  EXPECT_EQ(placed.size(), 10u);
}

TEST(Report_json, counts_joints_and_leaves_out_what_is_not_known)
{
  const Model model = model_of(large_frame());
  Report report;
  report.warnings = {"a \"quoted\" warning \xff"}; // not UTF-8
  report.seconds = {{"read", 0.5}};
  json j = json::parse(text_of([&](std::ostream& out) { write_report_json(out, report, model); }));
  EXPECT_EQ(j["joints"]["by_kind"]["none"], 24);
  EXPECT_EQ(j["joints"]["unjoined"][0]["edges"].size(), 24u);
  EXPECT_EQ(j["parts"], 10);
  EXPECT_EQ(j["sheets"], model.sheets.size());
  EXPECT_EQ(j["seconds"]["read"], 0.5);
  EXPECT_FALSE(j.contains("accuracy"));
  report.accuracy.emplace();
  report.accuracy->hausdorff = 3;
  report.input.diagonal = 150;
  j = json::parse(text_of([&](std::ostream& out) { write_report_json(out, report, model); }));
  EXPECT_DOUBLE_EQ(j["accuracy"]["hausdorff_percent"], 2);
  EXPECT_FALSE(j["accuracy"].contains("intersections")); // nothing was found to be embedded
}

TEST(Panels_obj, has_one_polygon_a_panel_with_its_holes_bridged)
{
  const Panel_complex complex = large_frame();
  std::stringstream in(text_of([&](std::ostream& out) { write_panels_obj(out, complex); }));
  std::vector<Point_3> points;
  std::vector<std::vector<int>> faces;
  for (std::string line; std::getline(in, line);) {
    std::stringstream words(line);
    std::string key;
    words >> key;
    double x, y, z;
    if (key == "v" && words >> x >> y >> z) points.emplace_back(x, y, z);
    if (key != "f") continue;
    faces.emplace_back();
    for (int v; words >> v;) faces.back().push_back(v - 1);
  }
  ASSERT_EQ(points.size(), 16u);
  ASSERT_EQ(faces.size(), 10u);
  for (int p = 0; p < 10; ++p) {
    Vector_3 twice_area(0, 0, 0);
    for (std::size_t i = 0; i < faces[p].size(); ++i)
      twice_area = twice_area + CGAL::cross_product(points[faces[p][i]] - points[0],
                                                    points[faces[p][(i + 1) % faces[p].size()]] - points[0]);
    EXPECT_NEAR(twice_area * complex.panels[p].plane.normal / 2, complex.area(p), 1e-9);
    EXPECT_EQ(faces[p].size(), p < 2 ? 10u : 4u); // 4 + 4 corners and a bridge walked twice
  }
}

TEST(Panels_obj, bridges_cross_nothing)
{
  // A plate with a row of three diamond holes: the middle one is hidden from most of the outline.
  using internal::Bridge_loop;
  int corner = 0;
  const auto loop = [&corner](const Outline& outline) {
    Bridge_loop result;
    for (const Point_2& p : outline) result.push_back({p, corner++});
    return result;
  };
  const Bridge_loop outer = loop({Point_2(0, 0), Point_2(20, 0), Point_2(20, 4), Point_2(0, 4)});
  std::vector<Bridge_loop> holes;
  for (double x : {4., 10., 16.})
    holes.push_back(loop({Point_2(x - 2, 2), Point_2(x, 3.9), Point_2(x + 2, 2), Point_2(x, 0.1)}));
  std::vector<Point_2> points;
  for (const Bridge_loop& l : {outer, holes[0], holes[1], holes[2]})
    for (const auto& v : l) points.push_back(v.point);
  const std::vector<int> walk = internal::bridge_holes(outer, holes);
  EXPECT_EQ(walk.size(), 16u + 2 * 3);
  EXPECT_EQ(std::set<int>(walk.begin(), walk.end()).size(), 16u);
  double twice_area = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const Point_2 &a = points[walk[i]], &b = points[walk[(i + 1) % walk.size()]];
    twice_area += a.x() * b.y() - a.y() * b.x();
    for (std::size_t j = 0; j < walk.size(); ++j) {
      const int c = walk[j], d = walk[(j + 1) % walk.size()];
      const int e = walk[i], f = walk[(i + 1) % walk.size()];
      if (c == e || c == f || d == e || d == f) continue;
      EXPECT_FALSE(CGAL::do_intersect(Kernel::Segment_2(a, b), Kernel::Segment_2(points[c], points[d])));
    }
  }
  EXPECT_NEAR(twice_area / 2, 80 - 3 * 4 * 3.8 / 2, 1e-12);
}

TEST(Shell_ply, reads_back_bit_by_bit_with_its_panels)
{
  const Mesh mesh = bumpy_sphere(4);
  std::vector<int> panels;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) panels.push_back(int(f % 7));
  std::istringstream in(
      text_of([&](std::ostream& out) { write_shell_ply(out, mesh.points, mesh.triangles, panels, {"a comment"}); }));
  CGAL::Surface_mesh<Point_3> read;
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(in, read, comments));
  EXPECT_EQ(comments, "a comment\n");
  ASSERT_EQ(read.number_of_vertices(), mesh.points.size());
  ASSERT_EQ(read.number_of_faces(), mesh.triangles.size());
  for (auto v : read.vertices()) EXPECT_EQ(read.point(v), mesh.points[v]);
  const auto panel = read.property_map<CGAL::Surface_mesh<Point_3>::Face_index, std::int32_t>("f:panel");
  ASSERT_TRUE(panel.second);
  for (auto f : read.faces()) {
    EXPECT_EQ(panel.first[f], panels[f]);
    std::vector<int> corners;
    for (auto v : read.vertices_around_face(read.halfedge(f))) corners.push_back(int(v));
    EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), mesh.triangles[f].begin()));
  }
}

TEST(Svg, layers_groups_and_paths_are_as_promised)
{
  const Model model = model_of(large_frame());
  const double kerf = 0.2;
  const Sheet_drawing drawing = draw_sheet(model.sheets[0], model.parts, kerf);
  EXPECT_TRUE(drawing.warnings.empty());
  const std::string svg = text_of([&](std::ostream& out) { write_svg(out, drawing); });
  EXPECT_NE(svg.find("width=\"600mm\" height=\"400mm\" viewBox=\"0 0 600 400\""), std::string::npos);
  EXPECT_EQ(svg.find("<text"), std::string::npos);
  EXPECT_EQ(occurrences(svg, "inkscape:groupmode=\"layer\""), 3);
  const std::size_t engrave = svg.find("label=\"engrave\""), inner = svg.find("label=\"inner\""),
                    outer = svg.find("label=\"outer\"");
  EXPECT_LT(engrave, inner);
  EXPECT_LT(inner, outer);
  ASSERT_NE(outer, std::string::npos);
  EXPECT_EQ(occurrences(svg, "<g"), occurrences(svg, "</g>"));
  for (const Placement& p : model.sheets[0].placements)
    EXPECT_EQ(occurrences(svg, "id=\"" + model.parts[p.part].id + "\""), 1);
  EXPECT_EQ(occurrences(svg.substr(inner), "Z\"/>"),
            int(model.sheets[0].placements.size()) + 2); // two panels with a hole
  EXPECT_EQ(occurrences(svg.substr(0, inner), "Z\"/>"), 0);

  // The enclosed areas are those of the parts and half a cut all around them.
  const std::regex path("<path d=\"M([^Z\"]*) Z\"/>"), number("(-?[0-9.]+),(-?[0-9.]+)");
  double area = 0;
  const std::string cuts = svg.substr(inner);
  for (std::sregex_iterator i(cuts.begin(), cuts.end(), path), end; i != end; ++i) {
    const std::string d = (*i)[1];
    Outline outline;
    for (std::sregex_iterator n(d.begin(), d.end(), number); n != end; ++n) {
      outline.emplace_back(std::stod((*n)[1]), std::stod((*n)[2]));
      EXPECT_GE(outline.back().x(), 0);
      EXPECT_LE(outline.back().x(), 600);
      EXPECT_GE(outline.back().y(), 0);
      EXPECT_LE(outline.back().y(), 400);
    }
    const bool is_hole = std::size_t(i->position()) < cuts.find("label=\"outer\"");
    area += (is_hole ? -1 : 1) * std::abs(twice_signed_area(outline)) / 2;
  }
  double expected = 0;
  for (const Placement& p : model.sheets[0].placements) {
    const Part& part = model.parts[p.part];
    double length = 0;
    for (std::size_t k = 0; k < part.outline.size(); ++k)
      length += std::sqrt(CGAL::squared_distance(part.outline[k], part.outline[(k + 1) % part.outline.size()]));
    for (const Outline& hole : part.holes)
      for (std::size_t k = 0; k < hole.size(); ++k)
        length += std::sqrt(CGAL::squared_distance(hole[k], hole[(k + 1) % hole.size()]));
    expected += part.area() + length * kerf / 2;
  }
  EXPECT_NEAR(area, expected, 1); // the rounded corners add less
}
