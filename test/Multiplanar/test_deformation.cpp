// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The mathematics of the deformation: its terms against their definitions, each solver against the full dense system.

#include "deformation_fixtures.h"

#include <CGAL/Multiplanar/Ceres_deformation_solver.h>
#include <CGAL/Multiplanar/Cholmod_deformation_solver.h>

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using internal::Transformation_rows;

template <class Solver>
class Deformation : public testing::Test
{
public:
  static Points solved(const Deformation_problem& p, int threads = 1)
  {
    Solver solver(p.connectivity, p.rest, p.weights, threads);
    Points target;
    EXPECT_TRUE(solver.solve(p.current, p.labels, p.normals, p.w_p, p.similarity_scale, target)) << p.name;
    return target;
  }
};

using Solvers = testing::Types<Ceres_deformation_solver, Cholmod_deformation_solver>;
TYPED_TEST_SUITE(Deformation, Solvers);

std::vector<Deformation_problem> small_problems()
{
  const std::uint64_t seed = 20260101;
  std::mt19937_64 random(seed);
  std::vector<Deformation_problem> problems;
  for (const auto& mesh : {std::make_pair("icosphere", icosphere(1)), std::make_pair("torus", torus(7, 5)),
                           std::make_pair("tetrahedron", tetrahedron()), std::make_pair("cube", cube(2))})
    for (double w_p : {1., 30., 2000.})
      for (double smoothness : {0., 0.01}) {
        Deformation_problem p = shaken(problem_at_rest(mesh.first, mesh.second, 7), 0.01, random);
        p.name += ", w_p " + std::to_string(w_p) + ", smoothness " + std::to_string(smoothness) + ", seed " +
                  std::to_string(seed);
        p.w_p = w_p;
        p.weights.smoothness = smoothness;
        if (smoothness > 0)
          for (std::size_t v = 0; v < p.rest.size(); ++v) p.similarity_scale.push_back(2 + random_unit(random));
        problems.push_back(p);
      }
  return problems;
}

} // namespace

// The elimination of v4, all four objectives, all weights: the same vertices as the paper's system with v4 unknown.
TYPED_TEST(Deformation, EqualsTheFullSystemWithFourthVertices)
{
  for (const Deformation_problem& p : small_problems())
    EXPECT_LT(largest_distance(this->solved(p), Full_deformation_system(p).minimiser()), 1e-9) << p.name;
}

TYPED_TEST(Deformation, StaysAtRestWhenThereIsNothingToFlatten)
{
  for (const Mesh& mesh : {bumpy_sphere(6), torus(20, 12), cube(4)}) {
    Deformation_problem p = problem_at_rest("rest", mesh, 10);
    p.normals.assign(p.normals.size(), CGAL::NULL_VECTOR);
    p.w_p = 100;
    EXPECT_LT(largest_distance(this->solved(p), p.rest), 1e-14);
  }
}

// A cube labelled by its sides is flat already: it is the minimum of every objective but smoothness.
TYPED_TEST(Deformation, KeepsACube)
{
  const int n = 4;
  Deformation_problem p = problem_at_rest("cube", cube(n), 6);
  for (int f = 0; f < p.connectivity.number_of_faces(); ++f) p.labels[f] = f / (2 * n * n);
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, 6);
  for (double w_p : {1., 100., 2000.}) {
    p.w_p = w_p;
    EXPECT_LT(largest_distance(this->solved(p), p.rest), 1e-14) << w_p;
  }
}

// Transformation and flattening do not see translations, so the similarity objective alone decides: a mesh carried
// away comes back to rest at once.
TYPED_TEST(Deformation, BringsATranslatedCubeBack)
{
  Deformation_problem p = problem_at_rest("cube", cube(3), 6);
  for (Point_3& q : p.current) q = q + Vector_3(0.2, -0.1, 0.05);
  p.w_p = 50;
  for (int f = 0; f < p.connectivity.number_of_faces(); ++f) p.labels[f] = f / 18;
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, 6);
  EXPECT_LT(largest_distance(this->solved(p), p.rest), 1e-12);
}

// Without transformation, tetrahedron: one face asked to be perpendicular to n. The three vertices of that face take
// part in two equations of one unknown each (height along n); solved by hand below.
TYPED_TEST(Deformation, SolvesOneFaceInClosedForm)
{
  Deformation_problem p = problem_at_rest("tetrahedron", tetrahedron(), 2);
  p.labels = {0, 1, 1, 1};
  p.normals = {Vector_3(0, 0, 1), CGAL::NULL_VECTOR};
  p.weights.transformation = 0;
  p.w_p = 3;
  // Each vertex has weight s = similarity / 4. Heights h = z + d minimise s |d|^2 + w^2 ((h2 - h1)^2 + (h3 - h1)^2):
  // d2 = -q (h2 - h1), d3 = -q (h3 - h1), d1 = -(d2 + d3) with q = w^2 / s; so, with a = h2 - h1, b = h3 - h1,
  // a (1 + q) = (z2 - z1) - q (a + b), and the same for b.
  const double s = p.weights.similarity / 4, q = p.w_p * p.w_p / s;
  const auto& t = p.connectivity.triangles[0];
  const double a0 = p.rest[t[1]].z() - p.rest[t[0]].z(), b0 = p.rest[t[2]].z() - p.rest[t[0]].z();
  const double sum = (a0 + b0) / (1 + 3 * q);
  const double a = (a0 - q * sum) / (1 + q), b = (b0 - q * sum) / (1 + q);
  Points expected = p.rest;
  expected[t[0]] = expected[t[0]] + Vector_3(0, 0, q * (a + b));
  expected[t[1]] = expected[t[1]] + Vector_3(0, 0, -q * a);
  expected[t[2]] = expected[t[2]] + Vector_3(0, 0, -q * b);
  ASSERT_GT(std::abs(a0) + std::abs(b0), 0.1);
  EXPECT_LT(largest_distance(this->solved(p), expected), 1e-13);
}

// A label without a normal is not flattened: the same as no flattening weight at all.
TYPED_TEST(Deformation, IgnoresLabelsWithoutNormal)
{
  std::mt19937_64 random(5);
  Deformation_problem p = shaken(problem_at_rest("sphere", icosphere(2), 9), 0.01, random);
  Deformation_problem none = p;
  p.normals.assign(9, CGAL::NULL_VECTOR);
  p.w_p = 500;
  none.w_p = 0;
  EXPECT_LT(largest_distance(this->solved(p), this->solved(none)), 1e-14);
  EXPECT_GT(largest_distance(this->solved(p), p.current), 1e-3); // it does pull back to rest
}

// Every face its own label: each keeps its own plane, so nothing has to move.
TYPED_TEST(Deformation, KeepsEveryFaceThatIsItsOwnLabel)
{
  Deformation_problem p = problem_at_rest("bumpy sphere", bumpy_sphere(8), 1);
  for (int f = 0; f < p.connectivity.number_of_faces(); ++f) p.labels[f] = f;
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, p.connectivity.number_of_faces());
  p.w_p = 2000;
  EXPECT_LT(largest_distance(this->solved(p), p.rest), 1e-9);
  // One label fewer. Two faces have to turn while the others must not, which leaves them only their sizes: the whole
  // mesh shrinks a little to shrink the misfit, but nothing worse.
  p.labels[p.connectivity.neighbours[0][0]] = 0;
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, p.connectivity.number_of_faces());
  const Points target = this->solved(p);
  EXPECT_LT(largest_unevenness(p, target), 0.5 * largest_unevenness(p, p.rest));
  EXPECT_LT(largest_distance(target, p.rest), 0.1);
}

TYPED_TEST(Deformation, FlattensMoreWithMoreWeight)
{
  Deformation_problem p = problem_at_rest("bumpy sphere", bumpy_sphere(10), 20);
  double before = largest_unevenness(p, p.rest);
  for (double w_p : {1., 10., 100., 1000.}) {
    p.w_p = w_p;
    const double now = largest_unevenness(p, this->solved(p));
    EXPECT_LT(now, before) << w_p;
    before = now;
  }
  EXPECT_LT(before, 1e-4);
}

TYPED_TEST(Deformation, SmoothnessRoundsACube)
{
  Deformation_problem p = problem_at_rest("cube", cube(4), 6);
  p.normals.assign(6, CGAL::NULL_VECTOR);
  const auto corner_radius = [&](double smoothness) {
    p.weights.smoothness = smoothness;
    double largest = 0;
    for (const Point_3& q : this->solved(p)) largest = (std::max)(largest, (q - CGAL::ORIGIN).squared_length());
    return std::sqrt(largest);
  };
  EXPECT_NEAR(corner_radius(0), 0.5, 1e-13);
  EXPECT_LT(corner_radius(0.01), corner_radius(0.001));
  EXPECT_LT(corner_radius(0.001), 0.499);
}

TYPED_TEST(Deformation, FailsWithoutMovingOnNumbersThatAreNone)
{
  Deformation_problem p = problem_at_rest("sphere", icosphere(1), 5);
  TypeParam solver(p.connectivity, p.rest, p.weights, 1);
  p.normals[2] = Vector_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  Points target;
  EXPECT_FALSE(solver.solve(p.current, p.labels, p.normals, p.w_p, {}, target));
  EXPECT_EQ(target, p.current);
  // The solver is not spoilt by it.
  p.normals[2] = Vector_3(0, 0, 1);
  EXPECT_TRUE(solver.solve(p.current, p.labels, p.normals, p.w_p, {}, target));
  EXPECT_EQ(target, this->solved(p));
}

TYPED_TEST(Deformation, MovesButDoesNotCopy)
{
  static_assert(!std::is_copy_constructible<TypeParam>::value, "one factorisation, one owner");
  Deformation_problem p = problem_at_rest("sphere", icosphere(2), 12);
  TypeParam first(p.connectivity, p.rest, p.weights, 1);
  Points target;
  ASSERT_TRUE(first.solve(p.current, p.labels, p.normals, 10, {}, target));
  TypeParam second(std::move(first));
  Points again;
  ASSERT_TRUE(second.solve(p.current, p.labels, p.normals, 10, {}, again));
  EXPECT_EQ(target, again);
}

// The six residuals are |T - I|^2 times the area for any triangle, whichever vertex comes first.
TEST(TransformationRows, AreTheEliminatedObjective)
{
  std::mt19937_64 random(17);
  for (int run = 0; run < 200; ++run) {
    const auto point = [&] { return Point_3(random_unit(random), random_unit(random), random_unit(random)); };
    const Point_3 before[3] = {point(), point(), point()}, after[3] = {point(), point(), point()};
    Eigen::Matrix<double, 3, 2> e0, e;
    for (int i = 0; i < 2; ++i)
      for (int d = 0; d < 3; ++d) {
        e0(d, i) = before[i + 1][d] - before[0][d];
        e(d, i) = after[i + 1][d] - after[0][d];
      }
    const Eigen::Matrix<double, 2, 3> pseudo_inverse = (e0.transpose() * e0).inverse() * e0.transpose();
    const double area = std::sqrt(CGAL::squared_area(before[0], before[1], before[2]));
    if (area < 0.05) continue;
    const double expected = 3 * area * ((e - e0) * pseudo_inverse).squaredNorm();
    for (int first = 0; first < 3; ++first) {
      const int index[3] = {first, (first + 1) % 3, (first + 2) % 3};
      const Transformation_rows rows =
          internal::transformation_rows(before[index[0]], before[index[1]], before[index[2]], 3);
      double sum = 0;
      for (const auto& row : rows) {
        Vector_3 residual = CGAL::NULL_VECTOR;
        for (int j = 0; j < 3; ++j) residual = residual + row[j] * (after[index[j]] - before[index[j]]);
        sum += residual.squared_length();
        EXPECT_NEAR(row[0] + row[1] + row[2], 0, 1e-12);
      }
      EXPECT_NEAR(sum, expected, 1e-9 * expected);
    }
  }
}

TEST(TransformationRows, StayBoundedOnSlivers)
{
  for (double height : {1e-3, 1e-6, 1e-12, 1e-200, 0.})
    for (double foot : {0., 0.3, 0.5, 1.}) {
      const Transformation_rows rows =
          internal::transformation_rows(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(foot, height, 0), 1);
      for (const auto& row : rows)
        for (double a : row) EXPECT_LE(std::abs(a), 23) << height; // NaN fails too
    }
  for (const auto& row : internal::transformation_rows(Point_3(1, 2, 3), Point_3(1, 2, 3), Point_3(1, 2, 3), 1))
    for (double a : row) EXPECT_EQ(a, 0);
}

TEST(DeformationWeights, GrowGeometrically)
{
  const Deformation_weights w;
  ASSERT_TRUE(w.is_valid());
  EXPECT_EQ(w.flattening(0, 50), 1);
  EXPECT_EQ(w.flattening(49, 50), 2000);
  EXPECT_EQ(w.flattening(0, 1), 2000);
  for (int i = 1; i < 50; ++i)
    EXPECT_NEAR(w.flattening(i, 50) / w.flattening(i - 1, 50), std::pow(2000, 1. / 49), 1e-12);
  Deformation_weights bad;
  bad.similarity = 0;
  EXPECT_FALSE(bad.is_valid());
  bad = {};
  bad.smoothness = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(bad.is_valid());
}
