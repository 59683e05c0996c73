// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_shapes.h"

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/Free_positions.h>
#include <CGAL/Multiplanar/internal/Nesting_shape.h>

#include <CGAL/minkowski_sum_2.h>

#include <gtest/gtest.h>

// What parts may not cover: no-fit polygons, free positions, outlines that only grow; each beside a slow twin.

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;

namespace {

/// A star with whole coordinates up to about `size`.
Outline whole_star(std::mt19937_64& random, int n, int size)
{
  for (;;) {
    Outline outline = random_star(random, n, size);
    for (Point_2& p : outline) p = Point_2(std::round(p.x()), std::round(p.y()));
    if (is_simple_outline(outline) && twice_signed_area(outline) > 0) return outline;
  }
}

/// The pieces as they are, a unit of the grid being 1.
std::vector<Convex_piece> grid_pieces(const Outline& outline, const std::vector<Outline>& holes = {})
{
  std::vector<Convex_piece> result;
  for (const Outline& piece : convex_pieces(outline, holes)) {
    std::vector<Grid_point> points;
    for (const Point_2& p : piece) points.push_back({std::int64_t(p.x()), std::int64_t(p.y())});
    result.emplace_back(convex_hull(points));
  }
  return result;
}

std::vector<Convex_piece> negated_pieces(const std::vector<Convex_piece>& pieces)
{
  std::vector<Convex_piece> result;
  for (const Convex_piece& piece : pieces) result.emplace_back(negated(piece.polygon));
  return result;
}

bool is_forbidden(const std::vector<Convex_grid_polygon>& members, const Grid_point& p)
{
  for (const Convex_grid_polygon& member : members)
    if (is_inside(member, p)) return true;
  return false;
}

bool overlap(const Exact_polygon& a, const Outline& b, const Grid_point& at)
{
  Exact_polygon_set set(a);
  set.intersection(exact_loop(moved(b, double(at.x), double(at.y))));
  return !set.is_empty();
}

Outline negative(const Outline& outline)
{
  Outline result;
  for (const Point_2& p : outline) result.emplace_back(-p.x(), -p.y());
  return result;
}

} // namespace

TEST(No_fit_polygon, forbids_exactly_where_interiors_meet)
{
  const unsigned seed = 31;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  int forbidden = 0, allowed = 0;
  for (int round = 0; round < 12; ++round) {
    const Outline a = whole_star(random, 3 + int(random() % 8), 12), b = whole_star(random, 3 + int(random() % 6), 8);
    const auto members = no_fit_polygon(grid_pieces(a), negated_pieces(grid_pieces(b)), {0, 0});
    for (int x = -22; x <= 22; x += 2)
      for (int y = -22; y <= 22; y += 3) {
        const bool meets = overlap(Exact_polygon(exact_loop(a)), b, {x, y});
        EXPECT_EQ(is_forbidden(members, {x, y}), meets) << round << ": " << x << ", " << y;
        ++(meets ? forbidden : allowed);
      }
  }
  EXPECT_GT(forbidden, 500);
  EXPECT_GT(allowed, 500);
}

TEST(No_fit_polygon, its_members_cover_the_minkowski_sum_of_cgal)
{
  const unsigned seed = 77;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 20; ++round) {
    const Outline a = whole_star(random, 4 + int(random() % 9), 40), b = whole_star(random, 3 + int(random() % 7), 25);
    Exact_polygon_set members;
    for (const auto& member : no_fit_polygon(grid_pieces(a), negated_pieces(grid_pieces(b)), {0, 0})) {
      Exact_loop loop;
      for (const Grid_point& p : member) loop.push_back(Exact_point_2(double(p.x), double(p.y)));
      EXPECT_TRUE(loop.is_convex());
      EXPECT_EQ(loop.orientation(), CGAL::COUNTERCLOCKWISE);
      members.join(loop);
    }
    Exact_polygon_set difference(CGAL::minkowski_sum_2(exact_loop(a), exact_loop(negative(b))));
    difference.symmetric_difference(members);
    EXPECT_TRUE(difference.is_empty()) << round;
  }
}

TEST(No_fit_polygon, a_hole_offers_its_room)
{
  const std::vector<Convex_piece> frame = grid_pieces(rectangle(40, 40), {reversed(moved(rectangle(20, 20), 10, 10))});
  const auto members = no_fit_polygon(frame, negated_pieces(grid_pieces(rectangle(20, 8))), {0, 0});
  EXPECT_FALSE(is_forbidden(members, {10, 10})); // touching on three sides
  EXPECT_FALSE(is_forbidden(members, {10, 22}));
  EXPECT_TRUE(is_forbidden(members, {11, 12}));
  EXPECT_TRUE(is_forbidden(members, {10, 23}));
  EXPECT_FALSE(is_forbidden(members, {40, 0}));
}

TEST(Free_positions, the_place_found_is_free_and_as_far_left_as_any_on_the_rows)
{
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  Free_positions free;
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    const Grid_box window{int(random() % 10), int(random() % 10), 60 + int(random() % 40), 60 + int(random() % 40)};
    free.start(window);
    std::vector<Convex_grid_polygon> members;
    const auto b = negated_pieces(grid_pieces(whole_star(random, 5, 12)));
    for (int k = 0; k < 8 + int(random() % 8); ++k) {
      const auto a = grid_pieces(whole_star(random, 6, 25));
      const Grid_point at{int(random() % 110), int(random() % 110)};
      for (const Convex_piece& p : a)
        for (const Convex_piece& q : b) free.forbid(p, q, at);
      for (const auto& member : no_fit_polygon(a, b, at)) members.push_back(member);
    }
    const std::int64_t step = 1 + int(random() % 7);
    std::int64_t leftmost = window.max_x + 1; // by trying them all, but for points on a boundary, which rows may skip
    for (std::int64_t y = window.min_y; y <= window.max_y;
         y = y < window.max_y ? std::min(y + step, window.max_y) : y + 1)
      for (std::int64_t x = window.min_x; x < leftmost; ++x) {
        const bool is_free = !is_forbidden(members, {x, y});
        EXPECT_EQ(free.is_free({x, y}), is_free);
        if (is_free && !is_forbidden(members, {x + 1, y})) leftmost = std::min(leftmost, x + 1);
      }
    const auto place = free.leftmost(step);
    if (!place) {
      EXPECT_GE(leftmost, window.max_x);
      continue;
    }
    ++found;
    EXPECT_FALSE(is_forbidden(members, *place));
    EXPECT_LE(place->x, leftmost);
    for (const Grid_point& d : {Grid_point{-1, 0}, Grid_point{0, -1}}) { // it cannot be pushed on
      const Grid_point next = *place + d;
      EXPECT_TRUE(next.x < window.min_x || next.y < window.min_y || is_forbidden(members, next));
    }
  }
  EXPECT_GT(found, 150);
}

TEST(Free_positions, a_part_as_large_as_its_hole_fits)
{
  Free_positions free;
  free.start({0, 0, 0, 0});
  EXPECT_TRUE(free.is_free({0, 0}));
  const auto place = free.leftmost(3);
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE(*place == (Grid_point{0, 0}));
}

TEST(Outward_simplification, only_grows_and_stays_simple)
{
  const unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  int fewer = 0;
  for (int round = 0; round < 60; ++round) {
    const Outline outline = random_star(random, 5 + int(random() % 40), 50);
    const double area = twice_signed_area(outline) / 2;
    const Outline simple = Outward_simplification(outline).run(0.05 * area, 0.2 * area);
    ASSERT_TRUE(is_simple_outline(simple));
    fewer += simple.size() < outline.size();
    EXPECT_LE(twice_signed_area(simple) / 2, 1.2 * area);
    Exact_polygon_set lost(exact_loop(outline));
    lost.difference(exact_loop(simple));
    double out = 0; // rounding of vertices that are constructed
    for (const Exact_polygon& p : polygons_of(lost)) out += internal::area(p);
    EXPECT_LT(out, 1e-9) << round;
  }
  EXPECT_GT(fewer, 50);
}

TEST(Outward_simplification, never_fills_more_than_it_may)
{
  Outline comb = {Point_2(0, 0), Point_2(100, 0)};
  for (int i = 9; i >= 0; --i) {
    comb.emplace_back(10 * i + 10, 50);
    comb.emplace_back(10 * i + 5, 10);
  }
  comb.emplace_back(0, 50);
  ASSERT_TRUE(is_simple_outline(comb));
  EXPECT_EQ(Outward_simplification(comb).run(1, 1000), comb);
  EXPECT_LT(Outward_simplification(comb).run(1000, 5000).size(), comb.size());
}
