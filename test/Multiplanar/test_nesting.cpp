// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_shapes.h"

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/nesting.h>
#include <CGAL/Multiplanar/row_packing.h>
#include <CGAL/Multiplanar/utilisation.h>

#include <gtest/gtest.h>

// Parts laid densely: they keep apart, inside, and lie the same on every machine.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

namespace {

std::vector<Part> stars(unsigned seed, int count, double least, double most)
{
  std::mt19937_64 random(seed);
  std::vector<Part> parts;
  for (int i = 0; i < count; ++i)
    parts.push_back(
        part("P" + std::to_string(i),
             random_star(random, 3 + int(random() % 9), least + double(random() % 1000) / 1000 * (most - least))));
  return parts;
}

/// Exactly: the cuts, each grown by half the gap less a little, are disjoint, and inside of the border.
void expect_apart_and_inside(const std::vector<Sheet>& sheets, const std::vector<Part>& parts, const Sheet_options& o)
{
  std::vector<int> times(parts.size(), 0);
  for (const Sheet& sheet : sheets) {
    EXPECT_EQ(sheet.width, o.width);
    EXPECT_EQ(sheet.height, o.height);
    Exact_polygon_set taken;
    double sum = 0;
    const double border = o.border - 1e-4;
    Exact_polygon_set usable(
        internal::exact_loop({Point_2(border, border), Point_2(o.width - border, border),
                              Point_2(o.width - border, o.height - border), Point_2(border, o.height - border)}));
    for (const Placement& p : sheet.placements) {
      ++times[p.part];
      const auto place = [&](Outline outline) {
        for (Point_2& q : outline) q = p(q);
        if (p.mirrored) std::reverse(outline.begin(), outline.end());
        return outline;
      };
      const Part& nominal = parts[p.part];
      std::vector<Outline> holes;
      for (const Outline& hole : nominal.holes) holes.push_back(place(hole));
      const Outline outline = place(press_fit_outline(nominal, o.fit));
      Exact_polygon_set cut(internal::exact_loop(compensate_kerf(outline, {}, o.kerf).outer));
      cut.difference(usable);
      EXPECT_TRUE(cut.is_empty()) << nominal.id;
      const Cut_paths grown = compensate_kerf(outline, holes, o.kerf + o.gap - 2e-4);
      Exact_polygon region(internal::exact_loop(grown.outer));
      for (const Outline& hole : grown.inner) region.add_hole(internal::exact_loop(hole));
      EXPECT_FALSE(taken.do_intersect(region)) << nominal.id;
      taken.join(region);
      sum += internal::area(region);
    }
    double joined = 0;
    for (const Exact_polygon& polygon : internal::polygons_of(taken)) joined += internal::area(polygon);
    EXPECT_NEAR(joined, sum, 1e-6);
  }
  EXPECT_EQ(times, std::vector<int>(parts.size(), 1));
}

Sheet_options small_sheet()
{
  Sheet_options o;
  o.width = 300, o.height = 200, o.kerf = 0.3, o.insertions = 60;
  return o;
}

} // namespace

TEST(Nesting, parts_keep_apart_and_inside)
{
  const unsigned seed = 99;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<Part> parts = stars(seed, 40, 8, 45);
  for (const bool mirrored : {false, true}) {
    Sheet_options o = small_sheet();
    o.mirrored = mirrored;
    const std::vector<Sheet> sheets = nest_parts(parts, o);
    expect_apart_and_inside(sheets, parts, o);
    EXPECT_GT(utilisation(sheets, parts, o.border).of_used(),
              utilisation(pack_in_rows(parts, o), parts, o.border).of_used() * 1.3);
  }
}

TEST(Nesting, gap_and_margin_are_kept_on_many_sheets_of_either_orientation)
{
  const std::vector<Part> parts = stars(7, 24, 15, 40);
  for (const bool tall : {false, true}) {
    Sheet_options o = small_sheet();
    o.width = tall ? 110 : 160, o.height = tall ? 160 : 110;
    o.border = 12, o.gap = 5, o.rotations = 5;
    const std::vector<Sheet> sheets = nest_parts(parts, o);
    EXPECT_GT(sheets.size(), 1u);
    expect_apart_and_inside(sheets, parts, o);
  }
}

TEST(Nesting, a_tall_sheet_is_a_wide_one_on_its_side)
{
  const std::vector<Part> parts = stars(8, 20, 10, 40);
  Sheet_options wide = small_sheet(), tall = wide;
  std::swap(tall.width, tall.height);
  const auto a = nest_parts(parts, wide), b = nest_parts(parts, tall);
  EXPECT_NEAR(utilisation(a, parts, 5).used_length, utilisation(b, parts, 5).used_length, 1e-9);
}

TEST(Nesting, small_parts_go_into_the_holes_of_large_ones)
{
  std::vector<Part> parts = {part("P1", rectangle(280, 180))};
  parts[0].holes = {reversed(moved(rectangle(240, 140), 20, 20))};
  for (int i = 0; i < 30; ++i) parts.push_back(part("C" + std::to_string(i), rectangle(38, 20)));
  Sheet_options o = small_sheet();
  const auto sheets = nest_parts(parts, o);
  EXPECT_EQ(sheets.size(), 1u);
  expect_apart_and_inside(sheets, parts, o);
}

TEST(Nesting, tabs_count_with_their_fit)
{
  Part tabbed = part("C1", {Point_2(0, 0), Point_2(30, 0), Point_2(30, 20), Point_2(19, 20), Point_2(19, 23),
                            Point_2(11, 23), Point_2(11, 20), Point_2(0, 20)});
  tabbed.tabs = {{3, 6}};
  const std::vector<Part> parts(20, tabbed);
  Sheet_options o = small_sheet();
  o.fit = 1, o.gap = 0.5;
  expect_apart_and_inside(nest_parts(parts, o), parts, o);
}

TEST(Nesting, angles_are_steps_from_the_flattest_box)
{
  const std::vector<Part> parts = stars(3, 15, 10, 30);
  Sheet_options o = small_sheet();
  for (const int rotations : {1, 2, 4}) {
    o.rotations = rotations;
    for (const Sheet& sheet : nest_parts(parts, o))
      for (const Placement& p : sheet.placements) {
        const auto boxes = internal::turned_boxes(parts[p.part], o.mirrored).along_sides;
        const double base = std::min_element(boxes.begin(), boxes.end(), internal::smaller_box)->rotation;
        const double steps = (p.rotation - base) * rotations / 360;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
      }
  }
}

TEST(Nesting, a_long_part_lies_along_the_diagonal_if_it_must)
{
  Sheet_options o;
  o.width = 100, o.height = 100, o.border = 0, o.rotations = 4;
  const std::vector<Part> parts = {part("A", rectangle(130, 2)), part("B", rectangle(30, 30))};
  const auto sheets = nest_parts(parts, o);
  EXPECT_EQ(sheets.size(), 1u);
  expect_apart_and_inside(sheets, parts, o);
}

TEST(Nesting, a_part_as_large_as_the_sheet_fits)
{
  Sheet_options o;
  o.width = 110, o.height = 60, o.kerf = 0.25;
  EXPECT_EQ(nest_parts({part("A", rectangle(99.75, 49.75)), part("B", rectangle(49.75, 99.75))}, o).size(), 2u);
}

TEST(Nesting, a_part_too_large_says_what_would_fit)
{
  Sheet_options o;
  o.width = 110, o.height = 60;
  const std::vector<Part> parts = {part("A", rectangle(10, 10)), part("B", rectangle(300, 40))};
  try {
    nest_parts(parts, o);
    FAIL() << "B is too large";
  } catch (const Part_too_large& error) {
    EXPECT_EQ(error.id, "B");
    EXPECT_NEAR(error.width, 300, 1e-9);
    EXPECT_NEAR(error.height, 40, 1e-9);
    std::vector<Part> scaled = parts;
    for (Part& p : scaled)
      for (Point_2& q : p.outline) q = Point_2(error.factor * (1 - 1e-9) * q.x(), error.factor * (1 - 1e-9) * q.y());
    EXPECT_NO_THROW(nest_parts(scaled, o));
  }
}

TEST(Nesting, the_same_for_any_number_of_threads)
{
  const std::vector<Part> parts = stars(21, 25, 10, 40);
  Sheet_options o = small_sheet();
  o.threads = 1;
  const auto one = nest_parts(parts, o);
  for (const int threads : {2, 3, 8}) {
    o.threads = threads;
    const auto many = nest_parts(parts, o);
    ASSERT_EQ(one.size(), many.size());
    for (std::size_t s = 0; s < one.size(); ++s)
      for (std::size_t i = 0; i < one[s].placements.size(); ++i) {
        const Placement &a = one[s].placements[i], &b = many[s].placements[i];
        EXPECT_EQ(a.part, b.part);
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
        EXPECT_EQ(a.rotation, b.rotation);
      }
  }
}

TEST(Nesting, more_search_is_never_worse)
{
  const std::vector<Part> parts = stars(22, 30, 10, 40);
  Sheet_options o = small_sheet();
  const auto value = [&](int insertions, double seconds) {
    o.insertions = insertions, o.seconds = seconds;
    const internal::Nesting_problem problem = internal::make_nesting_problem(parts, o);
    const internal::Nest nest = internal::best_nest(problem, o);
    EXPECT_TRUE(internal::is_nest_valid(problem, nest));
    return internal::Nest_search(problem, 1, 0).value(nest);
  };
  const double none = value(0, -1), by_seconds = value(0, 0.5);
  EXPECT_EQ(none, value(1000000, 0)); // no seconds: no search
  EXPECT_LE(by_seconds, none);
  EXPECT_LT(value(600, -1), none);
}

TEST(Utilisation, counts_the_last_sheet_up_to_its_last_part)
{
  const std::vector<Part> parts = {part("A", rectangle(90, 90)), part("B", rectangle(40, 20))};
  Sheet full{200, 100, {}}, last = full;
  full.placements.resize(1), last.placements.resize(1);
  full.placements[0].part = 0, last.placements[0].part = 1;
  last.placements[0].x = 5;
  const Utilisation u = utilisation({full, last}, parts, 5);
  EXPECT_DOUBLE_EQ(u.parts, 8900);
  EXPECT_DOUBLE_EQ(u.sheets, 40000);
  EXPECT_DOUBLE_EQ(u.used_length, 50);
  EXPECT_DOUBLE_EQ(u.used, 20000 + 5000);
}
