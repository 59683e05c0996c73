// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_checks.h"
#include "sheet_shapes.h"

#include <CGAL/Multiplanar/engrave_parts.h>
#include <CGAL/Multiplanar/fit_test.h>
#include <CGAL/Multiplanar/io/write_parts_csv.h>
#include <CGAL/Multiplanar/nesting.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

// What stands on parts: all that is needed to put them together, off every cut, or else in the part list.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

namespace {

Model engraved_model(const Panel_complex& complex, const Vector_3& up, bool inside = true)
{
  Model model;
  model.complex = complex;
  Joined_parts joined = make_joined_parts(complex, options_for(Joint_mode::automatic));
  model.parts = joined.parts;
  model.joints = joined.joints;
  Sheet_options sheet;
  sheet.insertions = 0;
  sheet.mirrored = inside;
  model.sheets = nest_parts(model.parts, sheet);
  Engraving_options options;
  options.up = up;
  engrave_parts(model, options);
  return model;
}

bool has_text(const Part& part, const std::string& text)
{
  return std::any_of(part.engraving.begin(), part.engraving.end(), [&](const Engraving& e) { return e.text == text; });
}

bool is_missed(const Part& part, const std::string& text)
{
  return std::count(part.not_engraved.begin(), part.not_engraved.end(), text) > 0;
}

void expect_said(const Part& part, const std::string& text)
{
  EXPECT_NE(has_text(part, text), is_missed(part, text)) << part.id << ": " << text;
}

const std::string arrow = "\xe2\x86\x91", degree = "\xc2\xb0";

/// All strokes of the text of a part in its own coordinates, as they are drawn when it lies as it is.
std::vector<Stroke> strokes_of(const Part& part)
{
  std::vector<Stroke> strokes;
  for (const Engraving& e : part.engraving) internal::draw_text(e, Placement(), strokes);
  return strokes;
}

void expect_text_off_the_cuts(const Part& part, double clearance)
{
  std::vector<Outline> loops = part.holes;
  loops.push_back(part.outline);
  for (const Stroke& stroke : strokes_of(part))
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      EXPECT_TRUE(contains(part.outline, stroke[i])) << part.id;
      for (const Outline& hole : part.holes) EXPECT_FALSE(contains(hole, stroke[i])) << part.id;
      if (i == 0) continue;
      for (const Outline& loop : loops)
        EXPECT_GE(squared_distance_between({stroke[i - 1], stroke[i]}, loop), std::pow(clearance - 1e-3, 2)) << part.id;
    }
}

} // namespace

TEST(Engraving, every_panel_says_its_id_its_neighbours_and_where_up_is)
{
  for (const bool inside : {false, true}) {
    const Model model = engraved_model(dodecahedron(60), Vector_3(0, 0, 1), inside);
    int complete = 0;
    for (const Part& part : model.parts) {
      expect_text_off_the_cuts(part, Engraving_options().clearance);
      if (part.kind != Part::Kind::panel) continue;
      EXPECT_TRUE(has_text(part, part.id));
      EXPECT_TRUE(has_text(part, arrow) || has_text(part, "TOP") || has_text(part, "BOTTOM"));
      for (const auto& side : model.complex.panels[panel_number(part)].loops[0]) {
        const std::string text = panel_id(model.complex, model.complex.neighbour(side)) + " 117" + degree + " " +
                                 edge_id(model.complex, side.edge);
        expect_said(part, text);
        complete += has_text(part, text);
      }
    }
    EXPECT_EQ(complete, 60);
  }
}

TEST(Engraving, connectors_say_their_id_and_both_panels_beside_the_right_tab)
{
  const Model model = engraved_model(dodecahedron(60), Vector_3(0, 0, 1));
  int connectors = 0, complete = 0;
  for (std::size_t e = 0; e < model.joints.size(); ++e)
    for (const std::string& id : model.joints[e].parts) {
      const auto part = std::find_if(model.parts.begin(), model.parts.end(), [&](const Part& p) { return p.id == id; });
      ASSERT_NE(part, model.parts.end());
      ++connectors;
      EXPECT_TRUE(has_text(*part, id));
      bool all = true;
      for (int k = 0; k < 2; ++k) {
        const std::string name = panel_id(model.complex, model.complex.edges[e].panels[k]);
        expect_said(*part, name);
        all = all && has_text(*part, name);
        for (const Engraving& text : part->engraving)
          if (text.text == name) { // nearer to its panel than to the other
            const Point_3 p = part->frame(text.at);
            const auto off = [&](int q) {
              return std::abs(signed_distance(model.complex.panels[model.complex.edges[e].panels[q]].plane, p));
            };
            EXPECT_LT(off(k), off(1 - k)) << id;
          }
      }
      complete += all;
    }
  EXPECT_GE(connectors, 30);
  EXPECT_EQ(complete, connectors);
}

TEST(Engraving, arrows_point_up_on_the_model)
{
  const Vector_3 up(0.3, -0.5, 0.8);
  const Model model = engraved_model(random_convex(14, 80, 5), up);
  int arrows = 0;
  for (const Part& part : model.parts)
    for (const Engraving& e : part.engraving) {
      if (e.text != arrow) continue;
      ++arrows;
      const double a = e.angle * pi / 180;
      const Vector_3 letters_up = -std::sin(a) * part.frame.u + std::cos(a) * part.frame.v;
      const Vector_3 in_plane = up - (up * part.frame.normal) * part.frame.normal;
      EXPECT_NEAR(letters_up * in_plane, std::sqrt(in_plane.squared_length()), 1e-9);
    }
  EXPECT_GE(arrows, 12);
}

TEST(Engraving, the_foot_of_an_edge_text_is_toward_its_edge)
{
  const Model model = engraved_model(box(120, 90, 80), Vector_3(0, 0, 1));
  for (const Part& part : model.parts) {
    if (part.kind != Part::Kind::panel) continue;
    for (const auto& side : model.complex.panels[panel_number(part)].loops[0]) {
      const std::string text = panel_id(model.complex, model.complex.neighbour(side)) + " 90" + degree + " " +
                               edge_id(model.complex, side.edge);
      for (const Engraving& e : part.engraving) {
        if (e.text != text) continue;
        const Point_2 a = part.frame.project(model.complex.corners[model.complex.source(side)].point),
                      b = part.frame.project(model.complex.corners[model.complex.target(side)].point);
        EXPECT_LT(std::sqrt(CGAL::squared_distance(e.at, Kernel::Segment_2(a, b))), 12);
        const double angle = e.angle * pi / 180;
        const Point_2 foot(e.at.x() + std::sin(angle), e.at.y() - std::cos(angle));
        EXPECT_LT(CGAL::squared_distance(foot, Kernel::Line_2(a, b)),
                  CGAL::squared_distance(e.at, Kernel::Line_2(a, b)));
      }
      EXPECT_TRUE(has_text(part, text));
    }
  }
}

TEST(Engraving, what_does_not_fit_is_in_the_part_list)
{
  const Model model = engraved_model(dodecahedron(16), Vector_3(0, 0, 1));
  int missing = 0;
  for (const Part& part : model.parts) {
    expect_text_off_the_cuts(part, Engraving_options().clearance);
    missing += int(part.not_engraved.size());
    for (const Engraving& e : part.engraving) EXPECT_GE(e.height, Engraving_options().smallest);
    for (const std::string& text : part.not_engraved) EXPECT_FALSE(has_text(part, text));
  }
  EXPECT_GT(missing, 10);
  std::vector<Sheet_drawing> drawings;
  for (const Sheet& sheet : model.sheets) drawings.push_back(draw_sheet(sheet, model.parts, 0.2));
  std::ostringstream out;
  write_parts_csv(out, model, drawings);
  const std::string csv = out.str();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), std::ptrdiff_t(model.parts.size() + 1));
  for (const Part& part : model.parts) {
    const std::size_t at = csv.find("\n" + part.id + ",");
    ASSERT_NE(at, std::string::npos);
    const std::string line = csv.substr(at + 1, csv.find('\n', at + 1) - at - 1);
    for (const std::string& text : part.not_engraved) EXPECT_NE(line.find(text), std::string::npos) << line;
  }
}

TEST(Stroke_font, knows_degrees_and_arrows)
{
  EXPECT_EQ(text_strokes(degree).size(), 1u);
  EXPECT_EQ(text_strokes(arrow).size(), 2u);
  EXPECT_NEAR(text_width("P1" + degree), text_width("P1") + text_width(degree), 1e-12);
  for (const Stroke& stroke : text_strokes(arrow))
    for (const Point_2& p : stroke) EXPECT_LE(std::abs(p.y()), 0.5);
}

TEST(Fit_test, its_slots_and_its_bar_have_the_measures_they_say)
{
  for (const double thickness : {1.5, 3., 6.}) {
    const double kerf = 0.2;
    const Fit_test test(thickness, kerf, 0.1);
    const Sheet_drawing drawing = test.drawing();
    EXPECT_TRUE(drawing.warnings.empty());
    ASSERT_EQ(drawing.parts.size(), 3u);
    const auto size = [](const Outline& outline) {
      const CGAL::Bbox_2 box = CGAL::bbox_2(outline.begin(), outline.end());
      return std::array<double, 2>{box.xmax() - box.xmin(), box.ymax() - box.ymin()};
    };
    EXPECT_NEAR(size(drawing.parts[0].outer[0])[0], 100 + kerf, 1e-3);
    std::vector<double> lengths, widths;
    for (const Outline& slot : drawing.parts[2].inner) {
      lengths.push_back(size(slot)[0] + kerf);
      widths.push_back(size(slot)[1] + kerf);
    }
    ASSERT_EQ(lengths.size(), 14u);
    const auto near_one = [](const std::vector<double>& list, double x) {
      return std::any_of(list.begin(), list.end(), [&](double y) { return std::abs(x - y) < 1e-3; });
    };
    for (double fit : test.slot_fits()) EXPECT_TRUE(near_one(lengths, 2.5 * thickness - fit)) << fit;
    for (double width : test.slot_widths()) EXPECT_TRUE(near_one(widths, width)) << width;
    EXPECT_NEAR(*std::min_element(widths.begin(), widths.end()), 0.9 * thickness, 1e-3);
    for (const Part_drawing& part : drawing.parts)
      for (const Stroke& stroke : part.engraving)
        for (const Point_2& p : stroke) {
          EXPECT_TRUE(contains(part.outer[0], p));
          for (const Outline& slot : part.inner) EXPECT_FALSE(contains(slot, p));
        }
  }
}
