// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Multiplanar/internal/isotopic_change.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Multiplanar::internal;
using CGAL::Multiplanar::Points;

// ---- a torus of n by m squares, whose vertex (i, j) is i m + j

constexpr int n = 15, m = 12;

struct Torus
{
  Multiplanar_test::Mesh mesh = Multiplanar_test::torus(n, m);
  Connectivity c = make_connectivity(mesh.triangles, int(mesh.points.size()));

  static int vertex(int i, int j) { return (i % n + n) % n * m + (j % m + m) % m; }

  bool within_disks(const std::set<int>& moved) const
  {
    Points changed = mesh.points;
    for (int v : moved) changed[v] = changed[v] + CGAL::Multiplanar::Vector_3(0, 0, 0.01);
    return differ_within_disks(c, mesh.points, changed);
  }
};

/// The shorter way around from a to b on a circle of `size` places.
int step(int a, int b, int size)
{
  const int d = (b - a + size) % size;
  return 2 * d > size ? d - size : d;
}

/// The slow twin, for a torus: does no way through the faces around the moved vertices lead around it? Then they can be
/// unrolled into the plane without a contradiction.
bool can_be_unrolled(const Torus& t, const std::set<int>& moved)
{
  std::map<int, std::set<int>> ways;
  for (int v : moved)
    for (int f : t.c.star(v))
      for (int i = 0; i < 3; ++i) {
        const int a = t.c.triangles[f][i], b = t.c.triangles[f][(i + 1) % 3];
        ways[a].insert(b);
        ways[b].insert(a);
      }
  std::map<int, std::pair<int, int>> place;
  for (const auto& seed : ways) {
    if (place.count(seed.first)) continue;
    place[seed.first] = {0, 0};
    std::vector<int> stack{seed.first};
    while (!stack.empty()) {
      const int a = stack.back();
      stack.pop_back();
      for (int b : ways[a]) {
        const std::pair<int, int> at{place[a].first + step(a / m, b / m, n), place[a].second + step(a % m, b % m, m)};
        const auto found = place.find(b);
        if (found == place.end()) place[b] = at, stack.push_back(b);
        else if (found->second != at) return false;
      }
    }
  }
  return true;
}

} // namespace

TEST(Isotopic_change, a_few_vertices_of_a_torus_are_within_disks)
{
  const Torus t;
  EXPECT_TRUE(t.within_disks({}));
  EXPECT_TRUE(t.within_disks({t.vertex(3, 3)}));
  EXPECT_TRUE(t.within_disks({t.vertex(3, 3), t.vertex(9, 9)}));
}

TEST(Isotopic_change, patches_that_touch_in_a_vertex_are_one)
{
  const Torus t;
  EXPECT_TRUE(t.within_disks({t.vertex(3, 3), t.vertex(5, 5)}));
  EXPECT_TRUE(t.within_disks({t.vertex(3, 3), t.vertex(1, 5)}));
}

TEST(Isotopic_change, what_a_ring_encloses_belongs_to_it)
{
  const Torus t;
  std::set<int> ring;
  for (int i = -3; i <= 3; ++i)
    for (int j : {-3, 3}) ring.insert(t.vertex(6 + i, 6 + j)), ring.insert(t.vertex(6 + j, 6 + i));
  EXPECT_TRUE(t.within_disks(ring));
}

TEST(Isotopic_change, rings_around_a_torus_and_all_of_it_are_not)
{
  const Torus t;
  std::set<int> around, along, two, all;
  for (int j = 0; j < m; ++j) around.insert(t.vertex(2, j)), two.insert(t.vertex(2, j)), two.insert(t.vertex(9, j));
  for (int i = 0; i < n; ++i) along.insert(t.vertex(i, 5));
  for (int v = 0; v < n * m; ++v) all.insert(v);
  for (const auto& moved : {around, along, two, all}) EXPECT_FALSE(t.within_disks(moved));
}

TEST(Isotopic_change, agrees_with_unrolling_on_random_patches)
{
  const Torus t;
  const unsigned seed = 20261123;
  std::mt19937 random(seed);
  int yes = 0;
  for (int round = 0; round < 2000; ++round) {
    std::set<int> moved;
    const int patches = 1 + int(random() % 12);
    for (int p = 0; p < patches; ++p) {
      int v = int(random() % (n * m));
      for (int length = int(random() % 20); length >= 0; --length) {
        moved.insert(v);
        const auto star = t.c.star(v);
        v = t.c.triangles[star[random() % star.size()]][random() % 3];
      }
    }
    const bool expected = can_be_unrolled(t, moved);
    ASSERT_EQ(t.within_disks(moved), expected) << "seed " << seed << " round " << round;
    yes += expected;
  }
  EXPECT_GT(yes, 200);
  EXPECT_LT(yes, 1800);
}

TEST(Isotopic_change, a_sphere_may_go_anywhere_but_not_inside_out)
{
  const auto sphere = Multiplanar_test::bumpy_sphere(4);
  const Connectivity c = make_connectivity(sphere.triangles, int(sphere.points.size()));
  Points away, mirrored;
  for (const auto& p : sphere.points) {
    away.emplace_back(10 + p.y(), 2 * p.z(), p.x());
    mirrored.emplace_back(-p.x(), p.y(), p.z());
  }
  EXPECT_TRUE(certainly_isotopic(c, sphere.points, away));
  EXPECT_FALSE(certainly_isotopic(c, sphere.points, mirrored));
}
