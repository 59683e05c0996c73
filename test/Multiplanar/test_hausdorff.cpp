// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/hausdorff.h>

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <random>

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using internal::Triangle_tree;
using internal::Vec3;

namespace {

double unit(std::mt19937_64& random) { return double(random() >> 11) / 9007199254740992.0; }
Point_3 random_point(std::mt19937_64& random, double size = 1)
{
  const double x = unit(random), y = unit(random), z = unit(random);
  return Point_3(size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1));
}

/// The slow twin: CGAL's exact-case distance to every triangle.
double distance_by_hand(const Point_3& q, const Mesh& mesh)
{
  double best = 1e300;
  for (const auto& t : mesh.triangles)
    best = (std::min)(
        best, CGAL::squared_distance(q, Kernel::Triangle_3(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])));
  return std::sqrt(best);
}

Mesh moved(const Mesh& mesh, const Vector_3& v)
{
  return mapped(mesh, [&](const Point_3& p) { return p + v; });
}

Mesh random_triangles(std::mt19937_64& random, int n)
{
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    const Point_3 o = random_point(random);
    for (int j = 0; j < 3; ++j) mesh.points.push_back(o + (random_point(random, 0.3) - CGAL::ORIGIN));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

CGAL::Surface_mesh<Point_3> surface(const Mesh& mesh)
{
  CGAL::Surface_mesh<Point_3> result;
  for (const Point_3& p : mesh.points) result.add_vertex(p);
  using V = CGAL::Surface_mesh<Point_3>::Vertex_index;
  for (const auto& t : mesh.triangles) result.add_face(V(t[0]), V(t[1]), V(t[2]));
  return result;
}

Symmetric_hausdorff distance(const Mesh& a, const Mesh& b, double error)
{
  return symmetric_hausdorff(a.points, a.triangles, b.points, b.triangles, error);
}

} // namespace

TEST(Triangle_tree, ClosestPointsEqualThoseOfEveryTriangle)
{
  const std::uint64_t seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int n : {1, 2, 5, 200}) {
    const Mesh mesh = random_triangles(random, n);
    const Triangle_tree tree(internal::as_vecs(mesh.points), mesh.triangles);
    for (int i = 0; i < 300; ++i) {
      const Point_3 q = random_point(random, 1.5);
      const auto c = tree.closest(internal::as_vec(q), i % 3 == 0 ? int(random() % n) : -1);
      EXPECT_NEAR(std::sqrt(c.squared_distance), distance_by_hand(q, mesh), 1e-12);
      const auto& t = mesh.triangles[c.triangle];
      Vec3 x = Vec3::Zero();
      for (int j = 0; j < 3; ++j) {
        EXPECT_GE(c.weights.w[j], -1e-12);
        x += c.weights.w[j] * internal::as_vec(mesh.points[t[j]]);
      }
      EXPECT_LT((x - c.point).norm(), 1e-12);
    }
  }
}

TEST(Triangle_tree, DegenerateTrianglesStillAnswer)
{
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}};
  const Triangle_tree tree(points, {{0, 1, 2}, {0, 3, 0}});
  for (const Vec3& q : {Vec3(0.5, 1, 0), Vec3(1.5, -1, 0), Vec3(1, 0, 1), Vec3(0, 1, 0)})
    EXPECT_NEAR(std::sqrt(tree.closest(q).squared_distance), 1, 1e-12) << q.transpose();
}

TEST(Triangle_tree, OverlapsEqualThoseFoundByHand)
{
  std::mt19937_64 random(5);
  const Mesh mesh = random_triangles(random, 150);
  const Triangle_tree tree(internal::as_vecs(mesh.points), mesh.triangles);
  for (int i = 0; i < 50; ++i) {
    const Vec3 low = internal::as_vec(random_point(random)), high = low + Vec3::Constant(0.4 * unit(random));
    std::vector<int> found, expected;
    tree.for_each_overlap(low, high, [&](int t) { found.push_back(t); });
    for (int t = 0; t < int(mesh.triangles.size()); ++t) {
      bool overlap = true;
      for (int axis = 0; axis < 3; ++axis) {
        double a = 1e300, b = -1e300;
        for (int v : mesh.triangles[t])
          a = (std::min)(a, mesh.points[v][axis]), b = (std::max)(b, mesh.points[v][axis]);
        overlap = overlap && a <= high[axis] && b >= low[axis];
      }
      if (overlap) expected.push_back(t);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(Hausdorff, OfASurfaceFromItselfIsZero)
{
  const Mesh mesh = bumpy_sphere(5);
  const auto d = distance(mesh, mesh, 1e-6);
  EXPECT_LT(d.lower(), 1e-15);
  EXPECT_LE(d.upper(), 1e-6);
}

TEST(Hausdorff, CoincidingSurfacesWithDifferentTrianglesAreOverlaid)
{
  // Without cuts along sides this would need pieces as small as the error along every side.
  const Mesh coarse = octahedron(), fine = subdivided(octahedron(), 7);
  const auto d = distance(coarse, fine, 1e-8);
  EXPECT_LE(d.upper(), 1e-8);
  const Mesh other = subdivided(octahedron(), 5);
  EXPECT_LE(distance(other, fine, 1e-8).upper(), 1e-8);
  // And one corner pulled out is found.
  Mesh pulled = fine;
  pulled.points[40] = pulled.points[40] + 1e-3 * (pulled.points[40] - CGAL::ORIGIN);
  const auto e = distance(pulled, coarse, 1e-8);
  EXPECT_NEAR(e.to_second.lower, distance_by_hand(pulled.points[40], coarse), 1e-8);
  EXPECT_GT(e.to_second.lower, 1e-4);
}

TEST(Hausdorff, KnownValues)
{
  // A cube shifted along an axis: the corners that move out are 0.25 away, and so is the side that moves in.
  const auto shifted = distance(cube(), moved(cube(), Vector_3(0.25, 0, 0)), 1e-9);
  EXPECT_NEAR(shifted.to_second.lower, 0.25, 1e-8);
  EXPECT_NEAR(shifted.to_first.upper, 0.25, 1e-8);

  // The cube [-1,1]^3 inside that of twice the size: from inside 1, from outside the corner's sqrt(3).
  const Mesh large = mapped(cube(), [](const Point_3& p) { return Point_3(2 * p.x(), 2 * p.y(), 2 * p.z()); });
  const auto nested = distance(cube(), large, 1e-9);
  EXPECT_NEAR(nested.to_second.lower, 1, 1e-8);
  EXPECT_NEAR(nested.to_first.lower, std::sqrt(3.0), 1e-8);
  EXPECT_NEAR(nested.upper(), std::sqrt(3.0), 1e-8);
  EXPECT_NEAR(std::abs(nested.to_first.witness.x()), 2, 1e-8);

  // The largest distance may lie inside a large triangle, far from its corners: a plate over a plate with a peak.
  Mesh plate{{Point_3(-3, -3, 0), Point_3(3, -3, 0), Point_3(0, 4, 0)}, {{0, 1, 2}}};
  Mesh pit = plate;
  pit.points.push_back(Point_3(0.3, 0.2, -2));
  pit.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const auto peak = distance(plate, pit, 1e-7);
  EXPECT_NEAR(peak.to_first.lower, 2, 1e-6);
  double by_grid = 0;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; i + j <= 200; ++j) {
      const Point_3 q = plate.points[0] + (plate.points[1] - plate.points[0]) * (i / 200.0) +
                        (plate.points[2] - plate.points[0]) * (j / 200.0);
      by_grid = (std::max)(by_grid, distance_by_hand(q, pit));
    }
  EXPECT_GE(peak.to_second.upper, by_grid);
  EXPECT_LT(peak.to_second.upper, by_grid + 0.03); // the grid's resolution
}

TEST(Hausdorff, BoundsHoldAgainstSamplingAndAgainstCGAL)
{
  const std::uint64_t seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const Mesh fine = bumpy_sphere(9, 0.2), coarse = bumpy_sphere(2, 0.1);
  for (double error : {1e-2, 1e-4, 1e-6}) {
    const auto d = distance(fine, coarse, error);
    EXPECT_LE(d.to_second.upper - d.to_second.lower, error);
    EXPECT_LE(d.to_first.upper - d.to_first.lower, error);
    EXPECT_NEAR(distance_by_hand(d.to_second.witness, coarse), d.to_second.lower, 1e-12);
    EXPECT_NEAR(distance_by_hand(d.to_first.witness, fine), d.to_first.lower, 1e-12);
    double sampled = 0;
    for (int i = 0; i < 3000; ++i) {
      const auto& t = coarse.triangles[random() % coarse.triangles.size()];
      const double u = unit(random), v = unit(random) * (1 - u);
      const Point_3 q = coarse.points[t[0]] + (coarse.points[t[1]] - coarse.points[t[0]]) * u +
                        (coarse.points[t[2]] - coarse.points[t[0]]) * v;
      sampled = (std::max)(sampled, distance_by_hand(q, fine));
    }
    EXPECT_LE(sampled, d.to_first.upper + 1e-12);
    EXPECT_GE(sampled, 0.9 * d.to_first.lower);
  }
  const auto a = surface(fine), b = surface(coarse);
  const double error = 1e-3;
  const auto ours = distance(fine, coarse, error);
  const double theirs =
      CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(a, b, error);
  EXPECT_NEAR(ours.to_second.lower, theirs, 2 * error);
  const double back =
      CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(b, a, error);
  EXPECT_NEAR(ours.to_first.lower, back, 2 * error);
}

TEST(Hausdorff, RefusesNonsense)
{
  const Mesh mesh = cube();
  EXPECT_THROW(directed_hausdorff(mesh.points, {}, mesh.points, mesh.triangles, 1e-3), std::invalid_argument);
  EXPECT_THROW(directed_hausdorff(mesh.points, mesh.triangles, mesh.points, {}, 1e-3), std::invalid_argument);
  EXPECT_THROW(directed_hausdorff(mesh.points, mesh.triangles, mesh.points, mesh.triangles, 0), std::invalid_argument);
}

TEST(MeanDistance, KnownValues)
{
  const Mesh mesh = cube();
  EXPECT_LT(mean_distance(mesh.points, mesh.triangles, mesh.points, mesh.triangles), 1e-15);
  // A cube in that of twice the size: every point is 1 away.
  const Mesh large = mapped(mesh, [](const Point_3& p) { return Point_3(2 * p.x(), 2 * p.y(), 2 * p.z()); });
  EXPECT_NEAR(mean_distance(mesh.points, mesh.triangles, large.points, large.triangles), 1, 1e-12);
  // A square of side 4 and its middle square: the mean of (|x| - 1)+ ... is not constant; compared with a fine grid.
  const Mesh plate{{Point_3(-2, -2, 0), Point_3(2, -2, 0), Point_3(2, 2, 0), Point_3(-2, 2, 0)},
                   {{0, 1, 2}, {0, 2, 3}}};
  const Mesh dot{{Point_3(0, 0, 0), Point_3(1e-6, 0, 0), Point_3(0, 1e-6, 0)}, {{0, 1, 2}}};
  // The mean distance of a square of side s from its centre is s (sqrt(2) + asinh(1)) / 6.
  const double exact = 4 * (std::sqrt(2.0) + std::asinh(1.0)) / 6;
  EXPECT_NEAR(mean_distance(plate.points, plate.triangles, dot.points, dot.triangles), exact, 1e-3);
}
