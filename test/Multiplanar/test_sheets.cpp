// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_shapes.h"

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/engrave_ids.h>
#include <CGAL/Multiplanar/row_packing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

// Letters, placements, and where ids stand.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

TEST(Stroke_font, capital_letters_are_one_high_and_centred)
{
  for (const char* text : {"H", "E", "P01", "L7"}) {
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9;
    for (const Stroke& stroke : text_strokes(text)) {
      EXPECT_GE(stroke.size(), 2u);
      for (const Point_2& p : stroke) {
        low = std::min(low, p.y()), high = std::max(high, p.y());
        left = std::min(left, p.x()), right = std::max(right, p.x());
      }
    }
    EXPECT_DOUBLE_EQ(low, -0.5);
    EXPECT_DOUBLE_EQ(high, 0.5);
    EXPECT_GE(left, -text_width(text) / 2);
    EXPECT_LE(right, text_width(text) / 2);
  }
  EXPECT_TRUE(text_strokes(" ").empty());
  EXPECT_EQ(text_strokes("\xc3").size(), text_strokes("?").size());
  EXPECT_NEAR(text_width("P12"), text_width("P") + text_width("1") + text_width("2"), 1e-12);
}

TEST(Placement, mirrors_then_turns_then_shifts)
{
  Placement placement;
  placement.x = 10, placement.y = 20, placement.rotation = 90;
  const Point_2 turned = placement(Point_2(3, 1));
  EXPECT_NEAR(turned.x(), 9, 1e-12);
  EXPECT_NEAR(turned.y(), 23, 1e-12);
  placement.mirrored = true;
  const Point_2 mirrored = placement(Point_2(3, 1));
  EXPECT_NEAR(mirrored.x(), 9, 1e-12);
  EXPECT_NEAR(mirrored.y(), 17, 1e-12);
}

TEST(Labels, letters_stay_inside_the_part)
{
  const unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 40; ++round) {
    std::vector<Part> parts = {part("P17", random_star(random, 3 + int(random() % 12), 15))};
    parts[0].holes = {reversed(moved(rectangle(2, 2), -1, -1))};
    Sheet_options options;
    options.mirrored = round % 2;
    const std::vector<Sheet> sheets = pack_in_rows(parts, options);
    const auto blank = engrave_ids(parts, sheets, 0.1, 8);
    EXPECT_TRUE(blank.empty());
    const Sheet_drawing drawing = draw_sheet(sheets[0], parts, 0);
    ASSERT_EQ(drawing.parts.size(), 1u);
    const Outline &outer = drawing.parts[0].outer[0], &inner = drawing.parts[0].inner[0];
    for (const Stroke& stroke : drawing.parts[0].engraving)
      for (std::size_t i = 0; i < stroke.size(); ++i) {
        EXPECT_TRUE(contains(outer, stroke[i]));
        EXPECT_FALSE(contains(inner, stroke[i]));
        if (i > 0)
          for (const Outline* loop : {&outer, &inner})
            EXPECT_GT(squared_distance_between({stroke[i - 1], stroke[i]}, *loop), 0);
      }
  }
}

TEST(Labels, text_is_large_and_upright_where_there_is_room)
{
  for (const bool mirrored : {false, true}) {
    std::vector<Part> parts = {part("P1", rectangle(100, 60))};
    Sheet_options options;
    options.mirrored = mirrored;
    const auto sheets = pack_in_rows(parts, options);
    engrave_ids(parts, sheets, 1, 8);
    ASSERT_EQ(parts[0].engraving.size(), 1u);
    EXPECT_EQ(parts[0].engraving[0].height, 8);
    // The stem of the P, the first stroke, goes straight down and is drawn left of the digit.
    const auto strokes = draw_sheet(sheets[0], parts, 0).parts[0].engraving;
    EXPECT_NEAR(strokes[0][0].x(), strokes[0][1].x(), 1e-4);
    EXPECT_NEAR(strokes[0][0].y() - strokes[0][1].y(), 8, 1e-4);
    EXPECT_LT(strokes[0][0].x(), strokes.back()[0].x());
  }
}

TEST(Labels, a_needle_stays_blank)
{
  std::vector<Part> parts = {part("P1", rectangle(100, 0.5))};
  const auto sheets = pack_in_rows(parts, Sheet_options());
  EXPECT_EQ(engrave_ids(parts, sheets, 1.5, 8), std::vector<std::string>{"P1"});
  EXPECT_TRUE(parts[0].engraving.empty());
}

TEST(Sheet_drawing, a_part_that_crosses_itself_is_drawn_with_a_warning)
{
  const std::vector<Part> parts = {part("P1", {Point_2(0, 0), Point_2(10, 10), Point_2(10, 0), Point_2(0, 9)})};
  Sheet sheet;
  sheet.width = 100, sheet.height = 100;
  sheet.placements.resize(1);
  sheet.placements[0].part = 0;
  const Sheet_drawing drawing = draw_sheet(sheet, parts, 0.2);
  EXPECT_EQ(drawing.parts[0].outer[0].size(), 4u);
  ASSERT_FALSE(drawing.warnings.empty());
  EXPECT_NE(drawing.warnings[0].find("P1"), std::string::npos);
}
