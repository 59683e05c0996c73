// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_shapes.h"

#include <CGAL/Multiplanar/Sheet_drawing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

// Where the beam goes: kerf, and tabs that hold by friction.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

TEST(Kerf, a_convex_part_grows_by_the_rounded_offset)
{
  const double kerf = 0.4, r = kerf / 2;
  const Cut_paths paths = compensate_kerf(rectangle(30, 20), {}, kerf);
  EXPECT_TRUE(paths.inner.empty());
  EXPECT_TRUE(is_simple_outline(paths.outer));
  const double short_of_arc = 0.01 * 0.01 / (4 * kerf), area = 600 + 100 * r + pi * r * r; // Steiner's formula
  EXPECT_LE(twice_signed_area(paths.outer) / 2, area);
  EXPECT_GE(twice_signed_area(paths.outer) / 2, area - 101 * short_of_arc);
  EXPECT_NEAR(length(paths.outer), 100 + 2 * pi * r, 1e-3);
}

TEST(Kerf, no_kerf_changes_nothing)
{
  const Outline outline = rectangle(30, 20), hole = reversed(moved(rectangle(5, 5), 3, 3));
  const Cut_paths paths = compensate_kerf(outline, {hole}, 0);
  EXPECT_EQ(paths.outer, outline);
  ASSERT_EQ(paths.inner.size(), 1u);
  EXPECT_EQ(paths.inner[0], hole);
}

TEST(Kerf, holes_shrink_with_sharp_corners_and_narrow_ones_vanish)
{
  const double kerf = 0.5;
  const Cut_paths paths =
      compensate_kerf(rectangle(30, 20), {moved(rectangle(6, 3), 2, 2), moved(rectangle(0.4, 6), 15, 5)}, kerf);
  ASSERT_EQ(paths.inner.size(), 1u);
  EXPECT_NEAR(twice_signed_area(paths.inner[0]) / 2, -(5.5 * 2.5), 1e-2);
  EXPECT_LT(twice_signed_area(paths.inner[0]), 0);
}

TEST(Kerf, every_point_of_a_path_keeps_half_the_kerf_from_the_part)
{
  const unsigned seed = 4242;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 30; ++round) {
    const Outline outline = random_star(random, 5 + int(random() % 20), 20);
    const std::vector<Outline> holes = {moved(rectangle(1, 1.5), -0.5, -0.75)};
    std::vector<Outline> loops = holes;
    loops.push_back(outline);
    const double kerf = 0.05 + double(random() % 100) / 200, r = kerf / 2;
    const Cut_paths paths = compensate_kerf(outline, holes, kerf);
    std::vector<Outline> cuts = paths.inner;
    cuts.push_back(paths.outer);
    EXPECT_EQ(cuts.size(), 2u);
    for (const Outline& cut : cuts) {
      EXPECT_TRUE(is_simple_outline(cut));
      for (std::size_t i = 0; i < cut.size(); ++i) {
        const Point_2 middle = CGAL::midpoint(cut[i], cut[(i + 1) % cut.size()]);
        for (const Point_2& p : {cut[i], middle})
          EXPECT_NEAR(std::sqrt(squared_distance_to(p, loops)), r, 0.01 * 0.01 / (4 * kerf) + 1e-9);
      }
    }
  }
}

TEST(Kerf, arcs_have_short_chords)
{
  const Cut_paths paths = compensate_kerf(rectangle(30, 20), {}, 0.8);
  int chords = 0;
  for (std::size_t i = 0; i < paths.outer.size(); ++i) {
    const double side = std::sqrt(CGAL::squared_distance(paths.outer[i], paths.outer[(i + 1) % paths.outer.size()]));
    if (side < 10) {
      EXPECT_LT(side, 0.01);
      ++chords;
    }
  }
  EXPECT_GT(chords, 200); // a full turn of radius 0.4
}

namespace {

/// A rectangle of 30 x 20 with a tab of 8 x 3 on its upper side; the tab is tabs[0].
Part tabbed_part()
{
  Part result = part("C1", {Point_2(0, 0), Point_2(30, 0), Point_2(30, 20), Point_2(19, 20), Point_2(19, 23),
                            Point_2(11, 23), Point_2(11, 20), Point_2(0, 20)});
  result.tabs = {{3, 6}};
  return result;
}

} // namespace

TEST(Press_fit, a_tab_grows_on_both_flanks_and_no_longer)
{
  const double fit = 0.1;
  const Outline grown = press_fit_outline(tabbed_part(), fit);
  EXPECT_TRUE(is_simple_outline(grown));
  EXPECT_NEAR(twice_signed_area(grown) / 2, 624 + 3 * fit, 1e-9);
  double left = 1e9, right = -1e9, high = 0;
  for (const Point_2& p : grown)
    if (p.y() > 20.5) left = std::min(left, p.x()), right = std::max(right, p.x()), high = std::max(high, p.y());
  EXPECT_NEAR(right - left, 8 + fit, 1e-9);
  EXPECT_NEAR(left + right, 30, 1e-9);
  EXPECT_EQ(high, 23);
}

TEST(Press_fit, a_turned_tab_grows_as_much)
{
  for (int degrees = 0; degrees < 360; degrees += 7) {
    Placement turn;
    turn.rotation = degrees;
    Part turned = tabbed_part();
    for (Point_2& p : turned.outline) p = turn(p);
    std::rotate(turned.outline.begin(), turned.outline.begin() + 5, turned.outline.end()); // the range wraps around
    turned.tabs = {{6, 1}};
    const Outline grown = press_fit_outline(turned, 0.1);
    EXPECT_NEAR(twice_signed_area(grown) / 2, 624.3, 1e-9) << degrees;
    const Cut_paths paths = compensate_kerf(grown, {}, 0.2);
    EXPECT_TRUE(paths.inner.empty());
    EXPECT_TRUE(is_simple_outline(paths.outer));
  }
}

TEST(Press_fit, without_fit_or_tabs_nothing_changes)
{
  Part part = tabbed_part();
  EXPECT_EQ(press_fit_outline(part, 0), part.outline);
  part.tabs.clear();
  EXPECT_EQ(press_fit_outline(part, 0.1), part.outline);
}

TEST(Press_fit, drawings_have_it_where_the_part_has_tabs)
{
  const std::vector<Part> parts = {tabbed_part()};
  Sheet sheet;
  sheet.width = 100, sheet.height = 100;
  sheet.placements.resize(1);
  sheet.placements[0].part = 0;
  const auto drawn = [&](double fit) {
    return twice_signed_area(draw_sheet(sheet, parts, 0.2, fit).parts[0].outer[0]) / 2;
  };
  EXPECT_NEAR(drawn(0.1) - drawn(0), 0.1 * 3, 1e-3);
}
