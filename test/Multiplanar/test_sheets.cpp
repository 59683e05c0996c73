// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/engrave_ids.h>
#include <CGAL/Multiplanar/row_packing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

// Parts on sheets: where they are laid, where the beam goes, and where their ids stand.

using namespace CGAL::Multiplanar;

namespace {

constexpr double pi = 3.14159265358979323846;

Outline rectangle(double w, double h) { return {Point_2(0, 0), Point_2(w, 0), Point_2(w, h), Point_2(0, h)}; }

Outline reversed(Outline outline)
{
  std::reverse(outline.begin(), outline.end());
  return outline;
}

Outline moved(Outline outline, double x, double y)
{
  for (Point_2& p : outline) p = Point_2(p.x() + x, p.y() + y);
  return outline;
}

/// A star-shaped polygon: simple, concave as a rule.
Outline random_star(std::mt19937_64& random, int n, double size)
{
  Outline outline;
  for (int i = 0; i < n; ++i) {
    const double radius = size * (0.2 + double(random() % 1000) / 1250), angle = 2 * pi * i / n;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

Part part(const std::string& id, const Outline& outline)
{
  Part p;
  p.id = id;
  p.outline = outline;
  return p;
}

double squared_distance_to(const Point_2& p, const std::vector<Outline>& loops)
{
  double nearest = 1e300;
  for (const Outline& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      nearest = std::min(nearest, CGAL::squared_distance(p, Kernel::Segment_2(loop[i], loop[(i + 1) % loop.size()])));
  return nearest;
}

double squared_distance_between(const Outline& a, const Outline& b)
{
  double nearest = 1e300;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      nearest = std::min(nearest, CGAL::squared_distance(Kernel::Segment_2(a[i], a[(i + 1) % a.size()]),
                                                         Kernel::Segment_2(b[j], b[(j + 1) % b.size()])));
  return nearest;
}

bool contains(const Outline& loop, const Point_2& p)
{
  return CGAL::bounded_side_2(loop.begin(), loop.end(), p, Kernel()) == CGAL::ON_BOUNDED_SIDE;
}

double length(const Outline& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(loop[i], loop[(i + 1) % loop.size()]));
  return sum;
}

} // namespace

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

TEST(Row_packing, parts_keep_their_distance_from_each_other_and_from_the_border)
{
  const unsigned seed = 99;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::vector<Part> parts;
  for (int i = 0; i < 60; ++i)
    parts.push_back(part("P" + std::to_string(i), random_star(random, 3 + int(random() % 9), 10 + int(random() % 40))));
  for (const bool mirrored : {false, true}) {
    Sheet_options options;
    options.width = 300, options.height = 200, options.kerf = 0.3, options.mirrored = mirrored;
    const std::vector<Sheet> sheets = pack_in_rows(parts, options);
    std::vector<int> times(parts.size(), 0);
    for (const Sheet& sheet : sheets) {
      std::vector<Outline> cuts;
      for (const Part_drawing& drawing : draw_sheet(sheet, parts, options.kerf).parts) cuts.push_back(drawing.outer[0]);
      for (const Placement& p : sheet.placements) ++times[p.part];
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        for (const Point_2& p : cuts[i]) {
          EXPECT_GE(p.x(), options.border - 1e-4);
          EXPECT_LE(p.x(), options.width - options.border + 1e-4);
          EXPECT_GE(p.y(), options.border - 1e-4);
          EXPECT_LE(p.y(), options.height - options.border + 1e-4);
        }
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GE(squared_distance_between(cuts[i], cuts[j]), std::pow(options.gap - 1e-4, 2));
          EXPECT_FALSE(contains(cuts[i], cuts[j][0]) || contains(cuts[j], cuts[i][0]));
        }
      }
    }
    EXPECT_EQ(times, std::vector<int>(parts.size(), 1));
    EXPECT_GT(utilisation(sheets, parts), 0.2);
    EXPECT_LT(utilisation(sheets, parts), 1);
  }
}

TEST(Row_packing, a_rectangle_is_laid_along_the_sheet)
{
  Outline turned;
  for (const Point_2& p : rectangle(100, 40)) turned.emplace_back(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
  Sheet_options options;
  options.width = 112, options.height = 52;
  const auto sheets = pack_in_rows({part("A", turned)}, options);
  ASSERT_EQ(sheets.size(), 1u);
  for (const Point_2& p : turned) EXPECT_LE(sheets[0].placements[0](p).y(), 5 + 40 + 1e-9);
}

TEST(Row_packing, a_long_part_may_lie_along_the_diagonal)
{
  Sheet_options options;
  options.width = 100, options.height = 100, options.border = 0;
  EXPECT_EQ(pack_in_rows({part("A", rectangle(130, 2))}, options).size(), 1u);
}

TEST(Row_packing, a_part_too_large_says_what_would_fit)
{
  Sheet_options options;
  options.width = 110, options.height = 60;
  std::vector<Part> parts = {part("A", rectangle(10, 10)), part("B", rectangle(300, 40)),
                             part("C", rectangle(200, 90))};
  double factor = 0;
  try {
    pack_in_rows(parts, options);
    FAIL() << "B and C are too large";
  } catch (const Part_too_large& error) {
    EXPECT_EQ(error.id, "B");
    EXPECT_NEAR(error.width, 300, 1e-9);
    EXPECT_NEAR(error.height, 40, 1e-9);
    factor = error.factor;
  }
  const auto scaled_parts = [&](double s) {
    std::vector<Part> result = parts;
    for (Part& p : result)
      for (Point_2& q : p.outline) q = Point_2(s * q.x(), s * q.y());
    return result;
  };
  EXPECT_NO_THROW(pack_in_rows(scaled_parts(factor * (1 - 1e-9)), options));
  EXPECT_THROW(pack_in_rows(scaled_parts(factor * 1.001), options), Part_too_large);
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
