// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/internal/outline_cleaning.h>

#include <gtest/gtest.h>

// What Boolean operations leave that no machine can cut.

using namespace CGAL::Multiplanar;

namespace {

const double width = 0.5;

Outline rectangle(double x0, double y0, double x1, double y1)
{
  return {Point_2(x0, y0), Point_2(x1, y0), Point_2(x1, y1), Point_2(x0, y1)};
}

std::vector<Flat_polygon> cleaned(const Outline& outline, const std::vector<Outline>& cuts)
{
  Exact_polygon_set set(internal::exact_loop(outline));
  for (const Outline& cut : cuts) set.difference(internal::exact_loop(cut));
  double lost = 0;
  auto pieces = internal::cleaned_pieces(set, width, lost);
  EXPECT_EQ(lost, 0);
  for (const Flat_polygon& piece : pieces) EXPECT_TRUE(internal::is_valid(piece));
  return pieces;
}

double total_area(const std::vector<Flat_polygon>& pieces)
{
  double sum = 0;
  for (const Flat_polygon& piece : pieces) sum += piece.area();
  return sum;
}

/// A gap between teeth was closed by a web of 20 micrometres along the outline: the verifier saw a slot without a tab,
/// and nobody could have cut it.
TEST(Thin_webs, a_gap_behind_a_web_is_a_notch)
{
  for (double web : {0.002, 0.02, 0.2, 0.49}) {
    SCOPED_TRACE(web);
    const auto pieces = cleaned(rectangle(0, 0, 40, 40), {rectangle(10, web, 16, 3)});
    ASSERT_FALSE(pieces.empty());
    for (const Flat_polygon& piece : pieces) EXPECT_TRUE(piece.holes.empty());
    const double notched = 1600 - 6 * 3;
    EXPECT_GT(pieces[0].area(), notched - 1);
    EXPECT_LE(total_area(pieces), 1600 - 6 * (3 - web));
  }
}

TEST(Thin_webs, what_is_wide_enough_stays)
{
  const auto pieces = cleaned(rectangle(0, 0, 40, 40), {rectangle(10, 0.51, 16, 3)});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].holes.size(), 1u);
  EXPECT_NEAR(pieces[0].area(), 1600 - 6 * 2.49, 1e-9);
}

TEST(Thin_webs, between_two_holes)
{
  const auto pieces = cleaned(rectangle(0, 0, 40, 40), {rectangle(10, 10, 14, 14), rectangle(14.1, 10, 18, 14)});
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces[0].holes.size(), 1u) << "one hole where two were";
}

TEST(Thin_webs, a_neck_is_cut_through)
{
  const auto pieces = cleaned(rectangle(0, 0, 40, 10), {rectangle(18, 0, 22, 4.9), rectangle(18, 5.1, 22, 10)});
  std::vector<double> areas;
  for (const Flat_polygon& piece : pieces) areas.push_back(piece.area());
  std::sort(areas.rbegin(), areas.rend());
  ASSERT_GE(areas.size(), 2u);
  EXPECT_NEAR(areas[0], 180, 0.5);
  EXPECT_NEAR(areas[1], 180, 0.5);
}

TEST(Thin_webs, corners_are_no_webs)
{
  // a sharp tip, and a corner cut off by 0.2 mm
  const Outline tip{Point_2(0, 0), Point_2(40, 0), Point_2(0, 8)};
  const Outline blunt{Point_2(0, 0), Point_2(39.8, 0), Point_2(40, 0.2), Point_2(40, 40), Point_2(0, 40)};
  for (const Outline& outline : {tip, blunt}) {
    const auto pieces = cleaned(outline, {});
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].outline, outline);
  }
}

TEST(Thin_webs, pinholes_become_wide_enough_to_cut)
{
  const Outline hole{Point_2(20, 20), Point_2(20.3, 20), Point_2(20, 20.2)};
  const auto pieces = cleaned(rectangle(0, 0, 40, 40), {hole});
  ASSERT_EQ(pieces.size(), 1u);
  ASSERT_EQ(pieces[0].holes.size(), 1u);
  const auto box = CGAL::bbox_2(pieces[0].holes[0].begin(), pieces[0].holes[0].end());
  EXPECT_GE(box.xmax() - box.xmin(), width);
  EXPECT_GE(box.ymax() - box.ymin(), width);
  for (const Point_2& p : hole) EXPECT_FALSE(internal::contains(pieces[0], p)) << "only ever wider";
}

} // namespace
