// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_shapes.h"

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/row_packing.h>
#include <CGAL/Multiplanar/utilisation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

// Parts in rows of boxes.

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

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
    EXPECT_GT(utilisation(sheets, parts).of_sheets(), 0.2);
    EXPECT_LT(utilisation(sheets, parts).of_sheets(), 1);
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
