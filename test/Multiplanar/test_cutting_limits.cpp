// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/internal/cutting_limits.h>

#include <gtest/gtest.h>

#include <vector>

using namespace CGAL::Multiplanar::internal;

namespace {

/// Is there a hair in a polygon with these loops?
bool hair(const std::vector<std::vector<Vec3>>& polygon)
{
  Flat_state s;
  std::vector<std::vector<int>> loops;
  for (const auto& loop : polygon) {
    loops.emplace_back();
    for (const Vec3& x : loop) loops.back().push_back(int(s.corner.size())), s.corner.push_back(x);
  }
  return has_hair(loops, s);
}

const double thin = width_of_hair / 2, wide = 2 * width_of_hair;

} // namespace

TEST(Cutting_limits, plain_polygons_have_no_hair)
{
  EXPECT_FALSE(hair({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
  EXPECT_FALSE(hair({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

TEST(Cutting_limits, needles_spikes_and_necks_are_hairs)
{
  for (double w : {thin, wide}) {
    EXPECT_EQ(hair({{{0, 0, 0}, {1, 0, 0}, {0, w, 0}, {-1, 1, 0}}}), w == thin) << "spike";
    EXPECT_EQ(hair({{{0, 0, 0}, {1, 0, 0}, {1, w, 0}, {0, w, 0}}}), false) << "narrow as a whole: other limits";
    EXPECT_EQ(hair({{{0, 0, 0}, {1, 0.5 - w, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.5, 0}, {0, 1, 0}}}), w == thin) << "neck";
  }
}

TEST(Cutting_limits, webs_beside_holes_are_hairs)
{
  for (double w : {thin, wide})
    EXPECT_EQ(hair({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0.5, w, 0}, {0.4, 0.5, 0}, {0.6, 0.5, 0}}}),
              w == thin);
}

TEST(Cutting_limits, a_short_side_is_no_hair)
{
  EXPECT_FALSE(hair({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {thin, 1, 0}, {0, 1 - thin, 0}}}));
}
