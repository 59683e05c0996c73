// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which panels may have to go together, on blocks whose sets are known: with a pit, with a hole, with a hole that goes
// on narrower.

#include <CGAL/Multiplanar/internal/sets_to_merge.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Multiplanar::internal;
using Set = Sets_to_merge::Set;

/// A surface of square loops one after the other, four corners each: between two neighbours four walls ('w') or a flat
/// ring ('r'); the first and the last loop are closed by a face ('f'), or joined by a ring to be one hole ('r').
struct Block
{
  explicit Block(const std::string& bands)
  {
    const int n = int(bands.size()); // one band after each loop; the last one closes
    loops = bands.back() == 'f' ? n - 1 : n;
    t.corner_panels.resize(4 * loops);
    for (int i = 0; i < n; ++i) {
      first.push_back(t.number_of_panels());
      if (bands[i] == 'f') add_panel({i == 0 ? loop(0) : loop(loops - 1)});
      else {
        const int below = bands.back() == 'f' ? i - 1 : i, above = (below + 1) % loops;
        if (bands[i] == 'r') add_panel({loop(below), loop(above)});
        else
          for (int j = 0; j < 4; ++j)
            add_panel({{4 * below + j, 4 * below + (j + 1) % 4, 4 * above + (j + 1) % 4, 4 * above + j}});
      }
    }
    find_edges();
  }

  Complex_topology t;
  std::vector<int> first; ///< panel of each band
  int loops;

  static std::vector<int> loop(int i) { return {4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}; }

private:
  void add_panel(const std::vector<std::vector<int>>& corners)
  {
    for (const auto& cycle : corners)
      for (int c : cycle) t.corner_panels[c].push_back(t.number_of_panels());
    t.loops.push_back(corners);
  }

  void find_edges()
  {
    for (int p = 0; p < t.number_of_panels(); ++p)
      for (int q = p + 1; q < t.number_of_panels(); ++q)
        for (const auto& a : t.loops[p])
          for (std::size_t i = 0; i < a.size(); ++i)
            for (const auto& b : t.loops[q])
              for (std::size_t j = 0; j < b.size(); ++j) {
                const int x = a[i], y = a[(i + 1) % a.size()], z = b[j], w = b[(j + 1) % b.size()];
                if ((x == z && y == w) || (x == w && y == z)) t.edges.push_back({{x, y}, {p, q}});
              }
  }
};

TEST(Sets_to_merge, a_pit_goes_with_its_walls_and_bottom)
{
  // Bottom, outer walls, top with a hole, inner walls, bottom of the pit.
  const Block block("fwrwf");
  ASSERT_EQ(block.t.number_of_panels(), 11);
  const Sets_to_merge sets(block.t);
  const int top = block.first[2], walls = block.first[3], floor = block.first[4];
  const std::vector<int>& hole = block.t.loops[top][1];
  EXPECT_EQ(sets.walls(top, hole), (Set{walls, walls + 1, walls + 2, walls + 3}));
  EXPECT_EQ(sets.enclosed(top, hole), (Set{top, walls, walls + 1, walls + 2, walls + 3, floor}));
  const auto all = sets.all();
  EXPECT_TRUE(all.count({top, walls, walls + 1, walls + 2, walls + 3, floor}));
  EXPECT_TRUE(all.count({walls, walls + 1}));
}

TEST(Sets_to_merge, the_step_of_a_hole_is_found_from_either_side)
{
  // Outer walls, top, wide part, ledge, narrow part, bottom.
  const Block block("wrwrwr");
  ASSERT_EQ(block.t.number_of_panels(), 15);
  const Sets_to_merge sets(block.t);
  const int top = block.first[1], wide = block.first[2], ledge = block.first[3], narrow = block.first[4];
  const Set step{top, wide, wide + 1, wide + 2, wide + 3, ledge};
  EXPECT_TRUE(sets.enclosed(top, block.t.loops[top][1]).empty()) << "behind a hole that goes through is everything";
  const auto steps = sets.steps(top, block.t.loops[top][1]);
  EXPECT_TRUE(std::any_of(steps.begin(), steps.end(), [&](Set s) {
    std::sort(s.begin(), s.end());
    return s == step;
  }));
  auto strips = sets.strips(top, ledge);
  ASSERT_EQ(strips.size(), 1u);
  std::sort(strips[0].begin(), strips[0].end());
  EXPECT_EQ(strips[0], step);
  EXPECT_TRUE(sets.all().count(step));
  EXPECT_TRUE(sets.all().count({top, wide, wide + 1, wide + 2, wide + 3}));
  EXPECT_EQ(sets.walls(ledge, block.t.loops[ledge][1]), (Set{narrow, narrow + 1, narrow + 2, narrow + 3}));
}

TEST(Sets_to_merge, there_are_no_sets_that_leave_fewer_than_four_panels)
{
  const Block cube("fwf");
  ASSERT_EQ(cube.t.number_of_panels(), 6);
  for (const Set& set : Sets_to_merge(cube.t).all()) {
    EXPECT_GE(set.size(), 2u);
    EXPECT_LE(set.size(), 3u);
    EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
  }
}

} // namespace
