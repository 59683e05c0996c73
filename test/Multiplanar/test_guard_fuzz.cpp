// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guard_brute_force.h"
#include "guard_fixtures.h"
#include "guard_fuzz_meshes.h"

#include <CGAL/Multiplanar/internal/Guarded_motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iostream>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;

/// What the guard said of random moves, and what sampling says.
struct Tally
{
  std::size_t accepted = 0, refused = 0;
  std::size_t refused_but_sampled_safe = 0; // contact between two samples, or none
  std::size_t missed_by_end_state = 0;      // refused for a contact on the way, with an embedded end state

  Tally& operator+=(const Tally& other)
  {
    accepted += other.accepted;
    refused += other.refused;
    refused_but_sampled_safe += other.refused_but_sampled_safe;
    missed_by_end_state += other.missed_by_end_state;
    return *this;
  }
  std::size_t moves() const { return accepted + refused; }
  void print(const char* name, std::uint64_t seed) const
  {
    std::cout << name << " (seed " << seed << "): " << moves() << " moves, " << accepted << " accepted, " << refused
              << " refused; of these " << refused_but_sampled_safe << " ("
              << 100. * double(refused_but_sampled_safe) / double(refused ? refused : 1)
              << "%) look safe at the sampled times; a test of end states alone would have missed "
              << missed_by_end_state << " contacts" << std::endl;
  }
};

/// Tries one full step of vertex v, and compares.
void try_move(const Connectivity& c, Guarded_motion& guard, Points& points, int v, const Point_3& to, Tally& tally)
{
  if (to == points[v]) return;
  Points targets = points;
  targets[v] = to;
  const Points before = points;
  const Guard_statistics s = guard.move(points, targets);
  ASSERT_EQ(s.moved + s.refused, 1u);
  const int contact = first_contact(c, before, v, to);
  for (std::size_t w = 0; w < points.size(); ++w)
    ASSERT_TRUE(are_same_bits(points[w], (s.moved == 1 ? targets : before)[w]));
  if (s.moved == 1) {
    ++tally.accepted;
    ASSERT_EQ(contact, 0) << "accepted, but touches at sample " << contact << " of " << samples;
    return;
  }
  ++tally.refused;
  if (contact == 0) ++tally.refused_but_sampled_safe;
  else {
    std::vector<CGAL::Bbox_3> boxes = boxes_of(c, targets);
    if (is_star_embedded<Kernel>(c, targets, v, boxes)) ++tally.missed_by_end_state;
  }
}

/// A random walk of the mesh through embedded states: `moves` tries, each a step by a random multiple of `unit` per
/// coordinate, at most `reach` of them, and restarted now and then.
Tally walk(const Mesh& mesh, int moves, int reach, double unit, std::uint64_t seed)
{
  const Connectivity c = connect(mesh);
  EXPECT_TRUE(is_embedded(c, mesh.points));
  Random_numbers random(seed);
  Guarded_motion guard(c, 0, 1);
  Tally tally;
  Points points = mesh.points;
  for (int n = 0; n < moves; ++n) {
    if (n % 400 == 399) points = mesh.points;
    const int v = random.below(int(points.size()));
    const int r = random.below(8) == 0 ? 4 * reach : reach; // now and then far
    const auto offset = [&] { return unit * random.between(-r, r); };
    try_move(c, guard, points, v, points[v] + Vector_3(offset(), offset(), offset()), tally);
    if (testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "seed " << seed << " move " << n;
      break;
    }
  }
  EXPECT_TRUE(is_embedded(c, points));
  return tally;
}

void report(const char* name, std::uint64_t seed, const Tally& tally, std::size_t enough)
{
  tally.print(name, seed);
  EXPECT_GE(tally.moves(), enough);
  EXPECT_GT(tally.accepted, tally.moves() / 50);
  EXPECT_GT(tally.refused, tally.moves() / 50);
}

// Together more than 100,000 moves.

TEST(Guard_fuzz, IntegerGrids)
{
  const std::uint64_t seed = 1;
  Tally tally;
  const Mesh meshes[] = {rounded(tetrahedron(), 3), rounded(octahedron(), 3),  rounded(octahedron(), 6),
                         rounded(cube(2), 3),       rounded(icosahedron(), 4), rounded(geodesic_sphere(2), 6),
                         rounded(torus(5, 3), 8)};
  for (const Mesh& mesh : meshes) tally += walk(mesh, 6000, 2, 1, seed);
  report("integer grids", seed, tally, 40000);
  EXPECT_GT(tally.missed_by_end_state, 100u);
}

TEST(Guard_fuzz, NearDegenerateStars)
{
  const std::uint64_t seed = 2;
  Tally tally;
  for (int n : {3, 4, 6}) {
    tally += walk(needle_star(n, 64), 4000, 2, 1, seed);
    tally += walk(needle_star(n, 8192), 4000, 4, 1, seed + 100);
    tally += walk(needle_star(n, 8192), 4000, 8, 512, seed + 200);
  }
  report("near-degenerate stars", seed, tally, 30000);
}

TEST(Guard_fuzz, FoldedSheets)
{
  const std::uint64_t seed = 3;
  Tally tally;
  tally += walk(folded_sheet(3, 16, 1), 6000, 2, 1, seed);
  tally += walk(folded_sheet(5, 16, 1), 4000, 3, 1, seed + 100);
  tally += walk(folded_sheet(4, 16, 0.0625), 6000, 3, 0.0625, seed + 200);
  tally += walk(mapped(cube(4), [](const Point_3& p) { return Point_3(96 * p.x(), 96 * p.y(), 2 * p.z()); }), 4000, 12,
                1, seed + 300);
  report("folded sheets", seed, tally, 19000);
}

TEST(Guard_fuzz, NearContactsOfFineDoubles)
{
  const std::uint64_t seed = 4;
  Tally tally;
  const double unit = std::ldexp(1, -30);
  tally += walk(folded_sheet(3, 1, 16 * unit), 5000, 12, unit, seed);
  const auto moved = [](const Point_3& p) { return p + Vector_3(1000, -3000, 500); };
  tally += walk(mapped(folded_sheet(3, 1, 16 * unit), moved), 5000, 12, unit, seed + 100);
  tally += walk(mapped(rounded(geodesic_sphere(2), 20),
                       [&](const Point_3& p) {
                         return Point_3(p.x() * unit, p.y() * unit, p.z()); // needles along z
                       }),
                5000, 6, unit, seed + 200);
  report("near-contacts of fine doubles", seed, tally, 14000);
}

/// Coordinates with all their bits: the sampled states are formed with exact constructions.
TEST(Guard_fuzz, AllBitsOfDoubles)
{
  const std::uint64_t seed = 5;
  Random_numbers random(seed);
  Tally tally;
  for (const Mesh& mesh : {bumpy_sphere(2), mapped(bumpy_sphere(2), [](const Point_3& p) {
                             return Point_3(p.x(), p.y(), p.z() * 1e-9);
                           })}) {
    const Connectivity c = connect(mesh);
    Guarded_motion guard(c, 0, 1);
    Points points = mesh.points;
    for (int n = 0; n < 1500 && !testing::Test::HasFatalFailure(); ++n) {
      const int v = random.below(int(points.size()));
      const Point_3& other = points[random.below(int(points.size()))];
      // Towards and slightly past another vertex, along a short random way, or to an almost equal place.
      const Vector_3 way[3] = {other - points[v],
                               Vector_3(random.signed_unit(), random.signed_unit(), 1e-9 * random.signed_unit()),
                               1e-12 * Vector_3(random.signed_unit(), random.signed_unit(), random.signed_unit())};
      try_move(c, guard, points, v, points[v] + (1 + 1e-14 * random.signed_unit()) * way[n % 3], tally);
    }
    EXPECT_TRUE(is_embedded(c, points));
  }
  report("all bits of doubles", seed, tally, 2500);
}

/// Whole passes, in which partial steps, waiting vertices and the clearance test take part: every accepted move.
TEST(Guard_fuzz, WholePasses)
{
  const std::uint64_t seed = 6;
  std::size_t moves = 0, skipped = 0, candidates = 0, partial = 0, later_rounds = 0;
  const Mesh meshes[] = {rounded(geodesic_sphere(2), 1024), rounded(cube(2), 1024), rounded(torus(5, 3), 1024),
                         folded_sheet(3, 4096, 256), needle_star(5, 1024)};
  for (const Mesh& mesh : meshes) {
    const Connectivity c = connect(mesh);
    Random_numbers random(seed);
    Guarded_motion guard(c);
    for (int size : {2, 16, 64, 256, 1024})
      for (int run = 0; run < 8; ++run) {
        Points points = mesh.points;
        for (int pass = 0; pass < 3; ++pass) {
          Points targets;
          for (const Point_3& p : points) {
            const auto offset = [&] { return random.between(-size, size); };
            targets.push_back(p + Vector_3(offset(), offset(), offset()));
          }
          Points replayed = points;
          const Guard_statistics s = guard.move(points, targets, [&](int v, const Point_3& from, const Point_3& to) {
            ASSERT_TRUE(are_same_bits(from, replayed[v]));
            ASSERT_EQ(first_contact(c, replayed, v, to), 0) << "seed " << seed << " run " << run << " size " << size;
            replayed[v] = to;
            ++moves;
          });
          if (testing::Test::HasFatalFailure()) return;
          ASSERT_TRUE(is_embedded(c, points));
          skipped += s.skipped_by_clearance;
          candidates += s.candidate_pairs;
          partial += s.partial;
          later_rounds += s.rounds > 1;
        }
      }
  }
  std::cout << "whole passes (seed " << seed << "): " << moves << " accepted moves, " << skipped << " of " << candidates
            << " candidate pairs skipped, " << partial << " partial, " << later_rounds << " passes with several rounds"
            << std::endl;
  EXPECT_GT(moves, 5000u);
  EXPECT_GT(skipped, candidates / 10);
  EXPECT_LT(skipped, candidates);
  EXPECT_GT(partial, 100u);
  EXPECT_GT(later_rounds, 10u);
}

} // namespace
