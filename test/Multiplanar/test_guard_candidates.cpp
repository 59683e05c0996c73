// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guard_fixtures.h"

#include <CGAL/Multiplanar/internal/Guarded_motion.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/box_intersection_d.h>

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;

// ---- whole-mesh check

TEST(Embedding, AgreesWithPolygonMeshProcessing)
{
  int embedded = 0, broken = 0;
  const Mesh mesh = geodesic_sphere(4);
  const Connectivity c = connect(mesh);
  for (int seed = 0; seed < 60; ++seed) {
    const Points points = displaced(mesh.points, 0.02 + 0.004 * seed, seed);
    const bool ours = is_embedded(c, points);
    ++(ours ? embedded : broken);
    EXPECT_EQ(ours, !CGAL::Polygon_mesh_processing::does_self_intersect(surface_mesh(c, points))) << seed;
  }
  EXPECT_GT(embedded, 5);
  EXPECT_GT(broken, 5);
}

TEST(Embedding, AgreesWithPolygonMeshProcessingOnGrids)
{
  int embedded = 0, broken = 0;
  const Mesh mesh = octahedron();
  const Connectivity c = connect(mesh);
  Random_numbers random(11);
  for (int n = 0; n < 3000; ++n) {
    Points points;
    for (int v = 0; v < 6; ++v) points.emplace_back(random.below(4), random.below(4), random.below(4));
    bool degenerate = false;
    for (const auto& t : c.triangles) degenerate |= CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]);
    const bool ours = is_embedded(c, points);
    ++(ours ? embedded : broken);
    if (degenerate) EXPECT_FALSE(ours);
    else EXPECT_EQ(ours, !CGAL::Polygon_mesh_processing::does_self_intersect(surface_mesh(c, points))) << n;
  }
  EXPECT_GT(embedded, 50);
  EXPECT_GT(broken, 50);
}

TEST(Embedding, NamesTheFault)
{
  Mesh mesh = geodesic_sphere(3);
  const Connectivity c = connect(mesh);
  EXPECT_FALSE(find_embedding_fault(c, mesh.points).has_value());
  const auto& t = c.triangles[5];
  Points flat = mesh.points;
  flat[t[0]] = flat[t[1]];
  ASSERT_TRUE(find_embedding_fault(c, flat).has_value());
  EXPECT_EQ(find_embedding_fault(c, flat)->first, find_embedding_fault(c, flat)->second);
  Points infinite = mesh.points;
  infinite[t[0]] = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_FALSE(is_embedded(c, infinite));
  Points crossing = mesh.points;
  crossing[t[0]] = crossing[t[0]] + 3. * (CGAL::ORIGIN - crossing[t[0]]);
  const auto fault = find_embedding_fault(c, crossing);
  ASSERT_TRUE(fault.has_value());
  EXPECT_FALSE(meet_properly<Kernel>(c, crossing, fault->first, fault->second));
}

// Builds with assertions check the whole mesh after every pass, whoever calls: here one that was broken before.
TEST(Embedding, IsCheckedAfterEveryPass)
{
  const Mesh mesh = geodesic_sphere(3);
  const Connectivity c = connect(mesh);
  Points points = mesh.points, targets = mesh.points;
  EXPECT_NO_THROW(Guarded_motion(c).move(points, targets));
  points[0] = targets[0] = points[0] + 3. * (CGAL::ORIGIN - points[0]);
  EXPECT_THROW(Guarded_motion(c).move(points, targets), CGAL::Postcondition_exception);
}

// ---- broad phase

std::set<std::pair<int, int>> pairs_by_box_intersection(const std::vector<CGAL::Bbox_3>& boxes)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  std::vector<Box> items;
  for (std::size_t f = 0; f < boxes.size(); ++f) items.emplace_back(boxes[f], int(f));
  std::set<std::pair<int, int>> pairs;
  CGAL::box_self_intersection_d(items.begin(), items.end(), [&](const Box& a, const Box& b) {
    pairs.emplace((std::min)(a.info(), b.info()), (std::max)(a.info(), b.info()));
  });
  return pairs;
}

TEST(Close_pairs, TreeFindsWhatBoxIntersectionFinds)
{
  const Mesh mesh = bumpy_sphere(8);
  const Connectivity c = connect(mesh);
  for (double size : {0., 0.01, 0.2}) {
    const Points targets = displaced(mesh.points, size, 5);
    std::vector<CGAL::Bbox_3> boxes;
    for (int f = 0; f < c.number_of_faces(); ++f) boxes.push_back(swept_box(c, mesh.points, targets, f));
    Swept_aabb_tree tree;
    build_swept_tree(tree, boxes);
    std::set<std::pair<int, int>> pairs;
    for (int f = 0; f < c.number_of_faces(); ++f) {
      std::vector<int> hits;
      tree.all_intersected_primitives(boxes[f], std::back_inserter(hits));
      for (int g : hits)
        if (g != f) pairs.emplace((std::min)(f, g), (std::max)(f, g));
    }
    EXPECT_EQ(pairs, pairs_by_box_intersection(boxes));
    Close_pairs close;
    close.find(c, mesh.points, targets, 0);
    EXPECT_EQ(close.number_of_candidates(), size > 0 ? pairs.size() : 0);
  }
}

TEST(Close_pairs, OnlyPairsWithAMovingFaceAreCandidates)
{
  const Mesh mesh = bumpy_sphere(8);
  const Connectivity c = connect(mesh);
  Points targets = mesh.points;
  targets[7] = targets[7] + Vector_3(0.05, 0, 0);
  targets[100] = targets[100] + Vector_3(0, 0.05, 0);
  std::vector<CGAL::Bbox_3> boxes;
  for (int f = 0; f < c.number_of_faces(); ++f) boxes.push_back(swept_box(c, mesh.points, targets, f));
  const auto moves = [&](int f) {
    for (int v : c.triangles[f])
      if (v == 7 || v == 100) return true;
    return false;
  };
  std::size_t expected = 0;
  for (const auto& pair : pairs_by_box_intersection(boxes)) expected += moves(pair.first) || moves(pair.second);
  Close_pairs close;
  close.find(c, mesh.points, targets, 0);
  EXPECT_EQ(close.number_of_candidates(), expected);
}

TEST(Close_pairs, AreTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = bumpy_sphere(20);
  const Connectivity c = connect(mesh);
  const Points targets = displaced(mesh.points, 0.05, 7);
  Close_pairs one;
  one.find(c, mesh.points, targets, 1e-15);
  EXPECT_GT(one.size(), 1000u);
  for (int threads : {2, 3, 7}) {
    Close_pairs several;
    several.find(c, mesh.points, targets, 1e-15, threads);
    EXPECT_EQ(several.number_of_candidates(), one.number_of_candidates());
    ASSERT_EQ(several.size(), one.size());
    for (int f = 0; f < c.number_of_faces(); ++f) EXPECT_TRUE(several.partners(f) == one.partners(f)); // in order
  }
}

// ---- clearance: whatever is skipped must be free of contact in any mixture of states

TEST(Clearance, SkippedPairsNeverTouch)
{
  std::size_t skipped = 0, kept = 0;
  for (int seed = 0; seed < 12; ++seed) {
    const Mesh mesh = bumpy_sphere(5);
    const Connectivity c = connect(mesh);
    const Points targets = displaced(mesh.points, 0.02 * (seed + 1), seed);
    Close_pairs close;
    close.find(c, mesh.points, targets, 1e-15);
    std::set<std::pair<int, int>> dangerous;
    for (int f = 0; f < c.number_of_faces(); ++f)
      for (int g : close.partners(f)) dangerous.emplace((std::min)(f, g), (std::max)(f, g));
    EXPECT_EQ(dangerous.size(), close.size());
    kept += dangerous.size();
    Random_numbers random(seed);
    for (int state = 0; state < 12; ++state) {
      Points mixed;
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const int choice = random.below(3);
        mixed.push_back(choice == 0   ? mesh.points[v]
                        : choice == 1 ? targets[v]
                                      : step_towards(mesh.points[v], targets[v], random.unit()));
      }
      for (int f = 0; f < c.number_of_faces(); ++f)
        for (int g = f + 1; g < c.number_of_faces(); ++g)
          if (dangerous.count({f, g}) == 0) {
            ++skipped;
            ASSERT_TRUE(meet_properly<Kernel>(c, mixed, f, g)) << seed << ' ' << state << ' ' << f << ' ' << g;
          }
    }
  }
  EXPECT_GT(kept, 1000u);
  EXPECT_GT(skipped, 1000u);
}

TEST(Clearance, SeparationNeedsAGap)
{
  const Point_3 a[3] = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)};
  const double slack = projection_slack(4);
  const auto lifted = [&](double z) {
    const Point_3 b[3] = {Point_3(0, 0, z), Point_3(1, 1, 1 + z), Point_3(-1, 1, 1 + z)};
    return are_separated(a, 3, b, 3, slack);
  };
  EXPECT_TRUE(lifted(1e-3));
  EXPECT_TRUE(lifted(1e-12));
  EXPECT_FALSE(lifted(0));
  EXPECT_FALSE(lifted(-1e-3));
  EXPECT_FALSE(lifted(1e-16)); // a true gap, but too small for floating point to prove
}

TEST(Clearance, SeparatesTrianglesInOnePlane)
{
  const Point_3 a[3] = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)};
  const Point_3 b[3] = {Point_3(1, 1, 0), Point_3(2, 0, 0), Point_3(0, 2, 0)};
  EXPECT_TRUE(are_separated(a, 3, b, 3, projection_slack(2)));
  const Point_3 overlapping[3] = {Point_3(.4, .4, 0), Point_3(2, 0, 0), Point_3(0, 2, 0)};
  EXPECT_FALSE(are_separated(a, 3, overlapping, 3, projection_slack(2)));
}

TEST(Clearance, HugeCoordinatesAreNeverCertified)
{
  const Point_3 a[1] = {Point_3(-1e200, 0, 0)}, b[1] = {Point_3(1e200, 0, 0)};
  EXPECT_FALSE(are_separated(a, 1, b, 1, projection_slack(1e200)));
  EXPECT_FALSE(are_unfolded(make_normal_cone(Point_3(0, 0, 0), Point_3(1e200, 0, 0), Point_3(0, 1e200, 0), 0, 0, 0),
                            make_normal_cone(Point_3(0, 0, 0), Point_3(0, 1, 0), Point_3(1, 0, 0), 0, 0, 0)));
}

TEST(Clearance, NormalConesWidenWithTheMotion)
{
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, -1, 0);
  const auto unfolded = [&](double way) {
    return are_unfolded(make_normal_cone(a, b, c, way, way, way), make_normal_cone(b, a, d, way, way, way));
  };
  EXPECT_TRUE(unfolded(0));
  EXPECT_TRUE(unfolded(0.1));
  EXPECT_FALSE(unfolded(0.4));
  const Point_3 folded(0.1, 1, 0); // back onto (a, b, c)
  EXPECT_FALSE(are_unfolded(make_normal_cone(a, b, c, 0, 0, 0), make_normal_cone(b, a, folded, 0, 0, 0)));
  EXPECT_FALSE(are_unfolded(make_normal_cone(a, b, b, 0, 0, 0), make_normal_cone(a, b, c, 0, 0, 0)));
}

TEST(Clearance, VertexNeedsAGapOnBothSides)
{
  const Point_3 o(0, 0, 0), b(1, 0, 0), c(0.5, 1, 0), v(-0.5, 1, 0), w(-1, 0, 0);
  const auto rest = [](const Point_3& p) { return Moving_point{p, p}; };
  EXPECT_TRUE(are_separated_at_vertex(rest(o), rest(b), rest(c), rest(v), rest(w), projection_slack(1)));
  const Point_3 across(0.6, 1, 0);
  EXPECT_FALSE(are_separated_at_vertex(rest(o), rest(b), rest(c), {v, across}, rest(w), projection_slack(1)));
  EXPECT_FALSE(are_separated_at_vertex(rest(o), rest(b), rest(c), rest(c), rest(w), projection_slack(1)));
}

} // namespace
