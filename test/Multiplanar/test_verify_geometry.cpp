// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the verifier's verdicts rest on, against slow twins: erosion against distances of sampled points, the separation
// of prisms against an exact linear program, containment against the solid angle.

#include "erosion.h"
#include "loops.h"
#include "polytope.h"
#include "solids.h"

#include <CGAL/Gmpz.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace CGAL::Multiplanar::verification;

constexpr unsigned seed = 20260131;

class Random
{
public:
  explicit Random(unsigned s) : engine(s) {}
  double real(double low, double high) { return low + (high - low) * (double(engine() >> 11) / 9007199254740992.0); }
  int integer(int low, int high) { return low + int(engine() % std::uint64_t(high - low + 1)); }

private:
  std::mt19937_64 engine;
};

/// A simple polygon around `centre` with spikes and dents, radii between `low` and `high`.
Loop star(Random& random, const Point_2& centre, int n, double low, double high)
{
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back((i + random.real(0.05, 0.95)) * 6.283185307179586 / n);
  Loop loop;
  for (double a : angles) {
    const double r = random.real(low, high);
    loop.emplace_back(centre.x() + r * std::cos(a), centre.y() + r * std::sin(a));
  }
  return loop;
}

double distance_from_material(const Loop& outline, const std::vector<Loop>& holes, const Point_2& p)
{
  double d = distance_to_boundary(p, outline);
  bool inside = side_of(outline, p) > 0;
  for (const Loop& hole : holes) {
    d = (std::min)(d, distance_to_boundary(p, hole));
    inside = inside && side_of(hole, p) < 0;
  }
  return inside ? d : -d; // depth
}

bool covered(const std::vector<Eroded_triangle>& triangles, const Point_2& p)
{
  return std::any_of(triangles.begin(), triangles.end(), [&](const Eroded_triangle& t) {
    return side_of({t.vertices[0], t.vertices[1], t.vertices[2]}, p) >= 0;
  });
}

/// What erosion.h promises, at random points and at points of the triangles.
void expect_eroded(const Loop& outline, const std::vector<Loop>& holes, double depth, Random& random)
{
  ASSERT_EQ(problem_of_region(outline, holes), "");
  const auto triangles = erode(outline, holes, depth);
  for (const auto& t : triangles)
    for (int k = 0; k < 20; ++k) {
      double w[3] = {random.real(0, 1), random.real(0, 1), random.real(0, 1)};
      const double sum = w[0] + w[1] + w[2];
      double x = 0, y = 0;
      for (int i = 0; i < 3; ++i) x += w[i] / sum * t.vertices[i].x(), y += w[i] / sum * t.vertices[i].y();
      EXPECT_GE(distance_from_material(outline, holes, Point_2(x, y)), depth);
    }
  const CGAL::Bbox_2 box = box_of(outline);
  int deep = 0;
  for (int k = 0; k < 2000; ++k) {
    // Half of the points close to the boundary, where it matters.
    Point_2 p(random.real(box.xmin(), box.xmax()), random.real(box.ymin(), box.ymax()));
    if (k % 2) {
      const Point_2& v = outline[std::size_t(random.integer(0, int(outline.size()) - 1))];
      p = Point_2(v.x() + random.real(-4, 4) * depth, v.y() + random.real(-4, 4) * depth);
    }
    if (distance_from_material(outline, holes, p) <= 1.0826 * depth) continue;
    ++deep;
    EXPECT_TRUE(covered(triangles, p)) << p;
  }
  EXPECT_GT(deep + int(triangles.empty()), 0);
}

TEST(Verify_geometry, erosion_keeps_what_is_deep_and_nothing_else)
{
  Random random(seed);
  SCOPED_TRACE(seed);
  for (int round = 0; round < 40; ++round) {
    const Loop outline = star(random, Point_2(0, 0), random.integer(3, 30), 4, 20);
    std::vector<Loop> holes;
    if (round % 2) holes.push_back(star(random, Point_2(0, 0), random.integer(3, 8), 0.2, 1.9));
    if (!problem_of_region(outline, holes).empty()) continue;
    expect_eroded(outline, holes, round % 3 ? 0.3 : 1e-3, random);
  }
}

TEST(Verify_geometry, erosion_of_features_thinner_than_its_depth)
{
  Random random(seed);
  const double e = 0.1;
  // A fin, a crack, a step and a chamfer smaller than the depth, and a hole nearer to the outline than that.
  expect_eroded({{0, 0}, {10, 0}, {10, 4}, {13, 4}, {13, 4.05}, {10, 4.05}, {10, 10}, {0, 10}}, {}, e, random);
  expect_eroded({{0, 0}, {10, 0}, {10, 4}, {5, 4}, {5, 4.05}, {10, 4.05}, {10, 10}, {0, 10}}, {}, e, random);
  expect_eroded({{0, 0}, {5, 0}, {5, 0.03}, {10, 0.03}, {10, 9.98}, {9.98, 10}, {0, 10}}, {}, e, random);
  expect_eroded({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 0.1}, {4, 2}, {6, 2}, {6, 0.1}}}, e, random);
  expect_eroded({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4.001, 4}, {4.001, 4.001}}}, e, random);
  // Two squares with a neck between them that vanishes: two pieces.
  const Loop neck = {{0, 0},  {4, 0}, {4, 2},   {6, 2},   {6, 0}, {10, 0},
                     {10, 4}, {6, 4}, {6, 2.1}, {4, 2.1}, {4, 4}, {0, 4}};
  expect_eroded(neck, {}, e, random);
  int pieces = 0;
  for (const auto& t : erode(neck, {}, e)) pieces = (std::max)(pieces, t.piece + 1);
  EXPECT_EQ(pieces, 2);
  EXPECT_TRUE(erode({{0, 0}, {10, 0}, {10, 0.15}, {0, 0.15}}, {}, e).empty());
}

TEST(Verify_geometry, erosion_of_sides_parallel_to_the_octagon)
{
  Random random(seed);
  Loop octagon;
  for (int i = 0; i < 8; ++i)
    octagon.emplace_back(10 * std::cos(0.1 + i * 0.7853981633974483), 10 * std::sin(0.1 + i * 0.7853981633974483));
  expect_eroded(octagon, {}, 0.5, random);
  Loop hole;
  for (int i = 7; i >= 0; --i) hole.emplace_back(octagon[i].x() / 3, octagon[i].y() / 3);
  expect_eroded(octagon, {hole}, 0.5, random);
}

/// Do the interiors of two convex hulls meet (if `b` is flat: its relative interior)? Whether positive combinations of
/// the vertices can agree: a linear program over integers, solved exactly.
bool hulls_meet(const std::vector<std::array<int, 3>>& a, const std::vector<std::array<int, 3>>& b)
{
  // Variables: weights of a, of b, and d. Maximise d; every weight is at least d; the weights of each sum to 1.
  CGAL::Quadratic_program<CGAL::Gmpz> lp(CGAL::EQUAL, true, 0, false, 0);
  const int n = int(a.size()), m = int(b.size()), d = n + m;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) lp.set_a(i, k, a[i][k]);
  for (int j = 0; j < m; ++j)
    for (int k = 0; k < 3; ++k) lp.set_a(n + j, k, -b[j][k]);
  for (int i = 0; i < n; ++i) lp.set_a(i, 3, 1);
  for (int j = 0; j < m; ++j) lp.set_a(n + j, 4, 1);
  lp.set_b(3, 1);
  lp.set_b(4, 1);
  for (int i = 0; i < n + m; ++i) {
    lp.set_a(i, 5 + i, 1);
    lp.set_a(d, 5 + i, -1);
    lp.set_r(5 + i, CGAL::LARGER);
  }
  lp.set_c(d, -1);
  const auto s = CGAL::solve_linear_program(lp, CGAL::Gmpz());
  return !s.is_infeasible() && s.objective_value() < 0;
}

struct Integer_prism
{
  Body body;
  std::vector<std::array<int, 3>> vertices;
};

/// A prism with small integer coordinates, so that contact without overlap is frequent. The frame need not be
/// orthonormal.
Integer_prism random_prism(Random& random, bool swept)
{
  const auto vector = [&](int r) {
    return Vector_3(random.integer(-r, r), random.integer(-r, r), random.integer(-r, r));
  };
  for (;;) {
    const Written_frame f = {CGAL::ORIGIN + vector(3), vector(1), vector(1), vector(1)};
    std::array<Point_2, 3> t;
    for (Point_2& p : t) p = Point_2(random.integer(-2, 2), random.integer(-2, 2));
    const Vector_3 w = swept ? vector(2) : Vector_3(0, 0, 0);
    if (CGAL::determinant(f.u, f.v, f.normal) == 0 || CGAL::collinear(t[0], t[1], t[2])) continue;
    Integer_prism result{prism(f, t, 0, 1, w), {}};
    for (const auto& v : result.body.exact().vertices)
      result.vertices.push_back({int(CGAL::to_double(v.x)), int(CGAL::to_double(v.y)), int(CGAL::to_double(v.z))});
    return result;
  }
}

TEST(Verify_geometry, prisms_meet_where_the_linear_program_says_so)
{
  Random random(seed);
  SCOPED_TRACE(seed);
  int meeting = 0, apart = 0;
  for (int round = 0; round < 3000; ++round) {
    const Integer_prism a = random_prism(random, round % 3 == 1), b = random_prism(random, round % 3 == 2);
    const bool meet = hulls_meet(a.vertices, b.vertices);
    EXPECT_EQ(interiors_meet(a.body, b.body), meet);
    EXPECT_EQ(interiors_meet(b.body, a.body), meet);
    ++(meet ? meeting : apart);
  }
  EXPECT_GT(meeting, 300);
  EXPECT_GT(apart, 300);
}

TEST(Verify_geometry, prism_meets_triangle_where_the_linear_program_says_so)
{
  Random random(seed + 1);
  SCOPED_TRACE(seed + 1);
  int meeting = 0, apart = 0;
  while (meeting + apart < 2000) {
    const Integer_prism a = random_prism(random, false);
    std::vector<std::array<int, 3>> t(3);
    for (auto& p : t)
      for (int& x : p) x = random.integer(-4, 4);
    const auto point = [&](int i) { return Point_3(t[i][0], t[i][1], t[i][2]); };
    if (CGAL::collinear(point(0), point(1), point(2))) continue;
    const bool meet = hulls_meet(a.vertices, t);
    EXPECT_EQ(interiors_meet(a.body, triangle(point(0), point(1), point(2))), meet);
    ++(meet ? meeting : apart);
  }
  EXPECT_GT(meeting, 100);
  EXPECT_GT(apart, 100);
}

TEST(Verify_geometry, rounding_does_not_decide)
{
  // Two unit cubes that touch, or overlap by the last bit of a coordinate.
  const Written_frame f = {Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)};
  const std::array<Point_2, 3> t = {Point_2(0, 0), Point_2(1, 0), Point_2(0, 1)};
  const Body a = prism(f, t, 0, 1);
  EXPECT_FALSE(interiors_meet(a, prism(f, t, 1, 2)));
  EXPECT_TRUE(interiors_meet(a, prism(f, t, std::nextafter(1.0, 0.0), 2)));
  EXPECT_FALSE(interiors_meet(a, prism(f, t, std::nextafter(1.0, 2.0), 2)));
}

/// The solid angle of a triangle seen from p, in units of the whole sphere; not a number if p lies on it.
double solid_angle(const Point_3& p, const Point_3& a, const Point_3& b, const Point_3& c)
{
  const Vector_3 u = a - p, v = b - p, w = c - p;
  const double l = std::sqrt(u * u), m = std::sqrt(v * v), n = std::sqrt(w * w);
  const double sine = CGAL::determinant(u, v, w), cosine = l * m * n + (u * v) * n + (v * w) * l + (w * u) * m;
  return sine == 0 && cosine <= 1e-9 ? std::nan("") : std::atan2(sine, cosine) / 6.283185307179586;
}

TEST(Verify_geometry, inside_is_where_the_solid_angle_is_whole)
{
  // An L-shaped block of integer corners: rays through edges and corners are frequent at integer points.
  Written_model model;
  const std::vector<Point_2> base = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const int n = int(base.size());
  for (int z : {0, 3})
    for (const Point_2& p : base) model.corners.emplace_back(p.x(), p.y(), z);
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) bottom.push_back(n - 1 - i), top.push_back(n + i);
  model.panels.push_back({"bottom", Vector_3(0, 0, -1), 0, {bottom}});
  model.panels.push_back({"top", Vector_3(0, 0, 1), 3, {top}});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const Vector_3 d(base[j].y() - base[i].y(), base[i].x() - base[j].x(), 0);
    model.panels.push_back({"side", d, 0, {{i, j, n + j, n + i}}});
  }
  const Boundary boundary = make_boundary(model);
  int inside = 0;
  for (double x = -0.5; x < 5; x += 0.5)
    for (double y = -0.5; y < 5; y += 0.5)
      for (double z = -0.5; z < 4; z += 1) {
        const Point_3 p(x, y, z);
        double angle = 0;
        for (const auto& t : boundary.triangles)
          angle += solid_angle(p, boundary.point(t, 0), boundary.point(t, 1), boundary.point(t, 2));
        if (!(std::abs(angle - std::round(angle)) < 1e-6)) continue; // on the boundary
        EXPECT_EQ(boundary.contains(p), angle > 0.5) << p;
        inside += angle > 0.5;
      }
  EXPECT_GT(inside, 50);
}

} // namespace
