// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define CGAL_MULTIPLANAR_CHECK_EXPENSIVE // the whole mesh before every pass too

#include "guard_fixtures.h"

#include <CGAL/Multiplanar/guarded_motion.h>
#include <CGAL/Multiplanar/named_parameters.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;

// ---- one pass

TEST(Guarded_motion, StepsStayBetweenTheEnds)
{
  Random_numbers random(3);
  for (int n = 0; n < 100000; ++n) {
    const auto number = [&] { return std::ldexp(random.signed_unit(), random.between(-40, 40)); };
    const Point_3 p(number(), number(), number()), q(number(), number(), number());
    const Point_3 step = step_towards(p, q, std::ldexp(1, -random.between(1, 8)));
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE((std::min)(p[i], q[i]), step[i]);
      EXPECT_GE((std::max)(p[i], q[i]), step[i]);
    }
  }
}

TEST(Guarded_motion, SmallMovesAllArriveBitwiseWithoutExactTests)
{
  const Mesh mesh = bumpy_sphere(8);
  const Connectivity c = connect(mesh);
  const Points targets = displaced(mesh.points, 1e-4, 1);
  Points points = mesh.points;
  const Guard_statistics s = Guarded_motion(c).move(points, targets);
  EXPECT_EQ(s.moved, points.size());
  EXPECT_EQ(s.partial + s.refused, 0u);
  EXPECT_EQ(s.exact_tests, 0u);
  EXPECT_EQ(s.skipped_by_clearance, s.candidate_pairs);
  EXPECT_EQ(s.rounds, 1);
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_TRUE(are_same_bits(points[v], targets[v]));
}

TEST(Guarded_motion, NothingToDoCostsNothing)
{
  const Mesh mesh = bumpy_sphere(4);
  const Connectivity c = connect(mesh);
  Points points = mesh.points;
  const Guard_statistics s = Guarded_motion(c).move(points, mesh.points);
  EXPECT_EQ(s.moved + s.partial + s.refused, 0u);
  EXPECT_EQ(s.candidate_pairs, 0u);
  EXPECT_EQ(s.rounds, 0);
}

TEST(Guarded_motion, EveryVertexArrivesOrStaysBitwiseOrIsOnItsWay)
{
  const Mesh mesh = bumpy_sphere(6);
  const Connectivity c = connect(mesh);
  bool some_moved = false, some_partial = false, some_refused = false;
  for (double size : {0.05, 0.2, 0.6}) {
    const Points targets = displaced(mesh.points, size, 17);
    Points points = mesh.points;
    const Guard_statistics s = Guarded_motion(c).move(points, targets);
    std::size_t moved = 0, partial = 0, refused = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (are_same_bits(points[v], targets[v])) ++moved;
      else if (are_same_bits(points[v], mesh.points[v])) ++refused;
      else {
        ++partial;
        const Vector_3 way = targets[v] - mesh.points[v], gone = points[v] - mesh.points[v];
        EXPECT_LT(std::sqrt(CGAL::cross_product(way, gone).squared_length() / way.squared_length()), 1e-15);
        for (int i = 0; i < 3; ++i) EXPECT_LE(gone[i] * gone[i], gone[i] * way[i] * (1 + 1e-9));
      }
    }
    EXPECT_EQ(s.moved, moved);
    EXPECT_EQ(s.partial, partial);
    EXPECT_EQ(s.refused, refused);
    EXPECT_TRUE(is_embedded(c, points));
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(surface_mesh(c, points)));
    some_moved |= moved > 0;
    some_partial |= partial > 0;
    some_refused |= refused > 0;
  }
  EXPECT_TRUE(some_moved && some_partial && some_refused);
}

TEST(Guarded_motion, SameEveryTimeAndWithAUsedObject)
{
  const Mesh mesh = bumpy_sphere(6);
  const Connectivity c = connect(mesh);
  const Points targets = displaced(mesh.points, 0.4, 23);
  Points first = mesh.points, second = mesh.points;
  Guarded_motion guard(c);
  guard.move(first, targets);
  guard.move(second, targets);
  for (std::size_t v = 0; v < first.size(); ++v) EXPECT_TRUE(are_same_bits(first[v], second[v]));
}

TEST(Guarded_motion, TargetsThatAreNotFiniteAreRefused)
{
  const Mesh mesh = bumpy_sphere(4);
  const Connectivity c = connect(mesh);
  Points points = mesh.points, targets = displaced(mesh.points, 1e-3, 2);
  targets[0] = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  targets[1] = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  const Guard_statistics s = Guarded_motion(c).move(points, targets);
  EXPECT_EQ(s.refused, 2u);
  EXPECT_EQ(s.moved, points.size() - 2);
  EXPECT_TRUE(are_same_bits(points[0], mesh.points[0]));
  EXPECT_TRUE(are_same_bits(points[1], mesh.points[1]));
}

TEST(Guarded_motion, HugeTargetsDoNotBreakTheMesh)
{
  const Mesh mesh = octahedron();
  const Connectivity c = connect(mesh);
  Points points = mesh.points, targets = points;
  targets[0] = Point_3(1e300, 1e300, -1e300);
  targets[1] = Point_3(1.7e308, 0, 0);
  Guarded_motion(c).move(points, targets);
  EXPECT_TRUE(is_embedded(c, points));
}

/// An octahedron whose vertices 0 and 1 (at x = 1 and -1) stand in each other's way: 1 wants to go to x = 2, past 0,
/// which is tried first and wants to go to x = 10.
TEST(Guarded_motion, WaitingVerticesAreTriedAgainWhenTheirObstacleHasMoved)
{
  const Mesh mesh = octahedron();
  const Connectivity c = connect(mesh);
  Points targets = mesh.points;
  targets[0] = Point_3(3, 0, 0); // tried first: would pass through 1's place to be
  targets[1] = Point_3(4, 0, 0); // beyond 0's target
  Points points = mesh.points;
  Guard_statistics s = Guarded_motion(c, 0, 4).move(points, targets);
  EXPECT_EQ(s.moved, 1u);
  EXPECT_EQ(s.refused, 1u);

  // Now 0 waits for 1: 0 wants to x = -2, 1 to x = -5.
  targets = mesh.points;
  targets[0] = Point_3(-2, 0, 0);
  targets[1] = Point_3(-5, 0, 0);
  points = mesh.points;
  s = Guarded_motion(c, 0, 1).move(points, targets);
  EXPECT_EQ(s.moved, 1u);
  EXPECT_EQ(s.refused, 1u);
  EXPECT_TRUE(are_same_bits(points[0], mesh.points[0]));
  points = mesh.points;
  s = Guarded_motion(c, 0, 2).move(points, targets);
  EXPECT_EQ(s.moved, 2u);
  EXPECT_EQ(s.rounds, 2);
  EXPECT_TRUE(is_embedded(c, points));
}

TEST(Guarded_motion, PartialStepsHalve)
{
  const Mesh mesh = octahedron();
  const Connectivity c = connect(mesh);
  Points targets = mesh.points;
  targets[0] = Point_3(-5, 0, 0); // 0 and 1 would meet after a third of the way
  for (int halvings = 0; halvings < 5; ++halvings) {
    Points points = mesh.points;
    const Guard_statistics s = Guarded_motion(c, halvings, 1).move(points, targets);
    EXPECT_EQ(s.partial, halvings >= 2 ? 1u : 0u);
    EXPECT_EQ(s.refused, halvings >= 2 ? 0u : 1u);
    EXPECT_EQ(points[0], halvings >= 2 ? Point_3(-0.5, 0, 0) : Point_3(1, 0, 0));
  }
}

TEST(Guarded_motion, ThinSheetsStopBeforeEachOther)
{
  // A cube pressed flat: its top wants to pass below its bottom, and only end states would let it.
  const Mesh mesh = mapped(cube(4), [](const Point_3& p) { return Point_3(p.x(), p.y(), p.z() / 64); });
  const Connectivity c = connect(mesh);
  Points targets, points = mesh.points;
  for (const Point_3& p : points) targets.emplace_back(p.x(), p.y(), -p.z());
  const Guard_statistics s = Guarded_motion(c).move(points, targets);
  EXPECT_LT(s.moved, points.size());
  EXPECT_TRUE(is_embedded(c, points));
  EXPECT_GT(volume({points, mesh.triangles}), 0);
}

/// Without the guard the end state would be embedded: the mesh turned inside out.
TEST(Guarded_motion, NeverTurnsInsideOut)
{
  const Mesh mesh = bumpy_sphere(5);
  const Connectivity c = connect(mesh);
  Points targets, points = mesh.points;
  for (const Point_3& p : points) targets.push_back(CGAL::ORIGIN - (p - CGAL::ORIGIN));
  EXPECT_TRUE(is_embedded(c, targets));
  Guarded_motion guard(c);
  for (int pass = 0; pass < 5; ++pass) {
    guard.move(points, targets);
    ASSERT_TRUE(is_embedded(c, points));
    ASSERT_GT(volume({points, mesh.triangles}), 0);
  }
}

TEST(Guarded_motion, FarFromTheOriginStillExact)
{
  const Mesh mesh = mapped(bumpy_sphere(5), [](const Point_3& p) { return p + Vector_3(1e9, -3e8, 2e9); });
  const Connectivity c = connect(mesh);
  ASSERT_TRUE(is_embedded(c, mesh.points));
  const Points targets = displaced(mesh.points, 0.5, 3);
  Points points = mesh.points;
  const Guard_statistics s = Guarded_motion(c).move(points, targets);
  EXPECT_GT(s.moved, 0u);
  EXPECT_TRUE(is_embedded(c, points));
}

TEST(Guarded_motion, AcceptedMovesAreReportedInOrder)
{
  const Mesh mesh = bumpy_sphere(5);
  const Connectivity c = connect(mesh);
  const Points targets = displaced(mesh.points, 0.4, 31);
  Points points = mesh.points, replayed = mesh.points;
  int moves = 0;
  Guarded_motion(c).move(points, targets, [&](int v, const Point_3& from, const Point_3& to) {
    EXPECT_TRUE(are_same_bits(replayed[v], from));
    replayed[v] = to;
    ++moves;
  });
  EXPECT_GT(moves, 50);
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_TRUE(are_same_bits(points[v], replayed[v]));
}

// ---- the public function

TEST(Guarded_move, MovesASurfaceMesh)
{
  const Mesh mesh = bumpy_sphere(6);
  Surface surface = surface_mesh(connect(mesh), mesh.points);
  auto target = surface.add_property_map<Surface::Vertex_index, Point_3>("v:target").first;
  const Points targets = displaced(mesh.points, 0.3, 41);
  for (auto v : surface.vertices()) target[v] = targets[v];
  const Guard_statistics s = guarded_move(surface, target);
  EXPECT_EQ(s.moved + s.partial + s.refused, mesh.points.size());
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(surface));
  Points points = mesh.points;
  Guarded_motion(connect(mesh)).move(points, targets);
  for (auto v : surface.vertices()) EXPECT_TRUE(are_same_bits(surface.point(v), points[v]));
}

TEST(Guarded_move, TakesNamedParameters)
{
  const Mesh mesh = octahedron();
  Surface surface = surface_mesh(connect(mesh), mesh.points);
  auto position = surface.add_property_map<Surface::Vertex_index, Point_3>("v:position").first;
  auto target = surface.add_property_map<Surface::Vertex_index, Point_3>("v:target").first;
  for (auto v : surface.vertices()) position[v] = target[v] = surface.point(v);
  target[Surface::Vertex_index(0)] = Point_3(-2, 0, 0);
  target[Surface::Vertex_index(1)] = Point_3(-5, 0, 0);
  const auto once = CGAL::parameters::vertex_point_map(position).number_of_iterations(1).geom_traits(Kernel());
  const Guard_statistics s = guarded_move(surface, target, once);
  EXPECT_EQ(s.rounds, 1);
  EXPECT_EQ(position[Surface::Vertex_index(1)], Point_3(-5, 0, 0));
  for (auto v : surface.vertices()) EXPECT_EQ(surface.point(v), mesh.points[v]); // the other map is left alone
  EXPECT_THROW(guarded_move(surface, target, CGAL::parameters::number_of_iterations(0)), std::invalid_argument);
}

TEST(Guarded_move, WorksWithAnotherKernelOfDoubles)
{
  using Simple = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Simple::Point_3> surface;
  const Mesh mesh = octahedron();
  for (const Point_3& p : mesh.points) surface.add_vertex(Simple::Point_3(p.x(), p.y(), p.z()));
  using Vertex = CGAL::Surface_mesh<Simple::Point_3>::Vertex_index;
  for (const auto& t : mesh.triangles) surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  auto target = surface.add_property_map<Vertex, Simple::Point_3>("v:target").first;
  for (auto v : surface.vertices()) target[v] = surface.point(v) + Simple::Vector_3(0.125, 0, 0);
  EXPECT_EQ(guarded_move(surface, target).moved, 6u);
  for (auto v : surface.vertices()) EXPECT_EQ(surface.point(v), target[v]);
}

TEST(Guarded_move, RefusesWhatIsNotClosedOrNotEmbedded)
{
  const Mesh mesh = octahedron();
  const Connectivity c = connect(mesh);
  Surface open = surface_mesh(c, mesh.points);
  auto here = open.points();
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  EXPECT_THROW(guarded_move(open, here), std::invalid_argument);

  const Mesh sphere = geodesic_sphere(3);
  Points points = sphere.points;
  points[0] = points[0] + 3. * (CGAL::ORIGIN - points[0]); // through the other side
  Surface crossing = surface_mesh(connect(sphere), points);
  EXPECT_THROW(guarded_move(crossing, crossing.points()), std::invalid_argument);
  for (auto v : crossing.vertices()) EXPECT_TRUE(are_same_bits(crossing.point(v), points[v]));

  points = mesh.points;
  points[0] = points[2];
  Surface degenerate = surface_mesh(c, points);
  EXPECT_THROW(guarded_move(degenerate, degenerate.points()), std::invalid_argument);
}

} // namespace
