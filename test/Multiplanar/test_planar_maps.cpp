// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/internal/injective_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace CGAL::Multiplanar::internal;

namespace {

/// The unit squares of an n x n grid, each as two triangles, without the upper right quarter: an L.
struct L_shape
{
  explicit L_shape(int n) : n(n)
  {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        Planar_node node;
        node.base = {double(i), double(j)};
        const bool inside = i > 0 && j > 0 && i < n && j < n && (i < n / 2 || j < n / 2);
        if (inside) {
          node.kind = Planar_node::Kind::free;
          node.unknown = complex.unknowns;
          complex.unknowns += 2;
          x.push_back(i), x.push_back(j);
        }
        complex.nodes.push_back(node);
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        if (i >= n / 2 && j >= n / 2) continue;
        const int a = i + (n + 1) * j, b = a + 1, c = a + n + 1, d = c + 1;
        complex.triangles.push_back({{a, b, d}});
        complex.triangles.push_back({{a, d, c}});
      }
    complex.tolerance.assign(complex.triangles.size(), 1e-9);
  }

  double least_area(const std::vector<double>& at) const
  {
    double least = 1e300;
    for (const auto& t : complex.triangles)
      least = (std::min)(least, doubled_area(complex.nodes[t[0]].at(at.data()), complex.nodes[t[1]].at(at.data()),
                                             complex.nodes[t[2]].at(at.data())));
    return least;
  }

  int n;
  Planar_complex complex;
  std::vector<double> x;
};

/// An n x n grid of squares, as triangles, whose boundary lies on a horseshoe: the lower side along the outer arc, the
/// upper side along the inner one.
struct Horseshoe
{
  explicit Horseshoe(int n)
  {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double angle = 5.5 * i / n, radius = 1 - 0.6 * j / n;
        shape.emplace_back(i, j, 0);
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        fixed.push_back(i == 0 || j == 0 || i == n || j == n);
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = i + (n + 1) * j, b = a + 1, c = a + n + 1, d = c + 1;
        triangles.push_back({{a, b, d}});
        triangles.push_back({{a, d, c}});
      }
    area = 0.5 * 5.5 * (1 - 0.4 * 0.4);
  }

  int inverted(const std::vector<Point_2d>& at) const
  {
    return int(std::count_if(triangles.begin(), triangles.end(), [&](const std::array<int, 3>& t) {
      return !(doubled_area(at[t[0]], at[t[1]], at[t[2]]) > tolerance);
    }));
  }

  std::vector<Eigen::Vector3d> shape;
  std::vector<Point_2d> points;
  std::vector<char> fixed;
  Triangles triangles;
  double area, tolerance = 1e-9;
};

double unit(std::mt19937_64& random) { return double(random() >> 11) / 9007199254740992.0; }

} // namespace

TEST(Local_untangling, frees_a_grid_with_a_few_vertices_out_of_place)
{
  const std::uint64_t seed = 20;
  std::mt19937_64 random(seed);
  for (int run = 0; run < 40; ++run) {
    L_shape shape(8);
    std::vector<double> x = shape.x;
    for (int i = 0; i < 6; ++i) x[random() % x.size()] += 5 * (unit(random) - 0.5);
    const int before = shape.complex.count_inverted(x.data());
    EXPECT_TRUE(Local_untangling(shape.complex, x).run(60)) << "seed " << seed << " run " << run << ", " << before;
    EXPECT_EQ(shape.complex.count_inverted(x.data()), 0);
  }
}

TEST(Local_untangling, one_vertex_goes_where_a_search_over_all_places_finds_the_largest_least_area)
{
  const std::uint64_t seed = 7;
  std::mt19937_64 random(seed);
  for (int run = 0; run < 20; ++run) {
    // A star-shaped ring around one free vertex.
    Planar_complex c;
    const int n = 4 + int(random() % 6);
    for (int i = 0; i < n; ++i) {
      Planar_node node;
      const double a = 6.283185307179586 * i / n, r = 0.5 + unit(random);
      node.base = {r * std::cos(a), r * std::sin(a)};
      c.nodes.push_back(node);
      c.triangles.push_back({{i, (i + 1) % n, n}});
    }
    Planar_node middle;
    middle.kind = Planar_node::Kind::free;
    middle.unknown = 0;
    c.nodes.push_back(middle);
    c.unknowns = 2;
    c.tolerance.assign(n, 1e-9);
    const auto least = [&](const std::vector<double>& at) {
      double worst = 1e300;
      for (const auto& t : c.triangles)
        worst = (std::min)(
            worst, doubled_area(c.nodes[t[0]].at(at.data()), c.nodes[t[1]].at(at.data()), c.nodes[t[2]].at(at.data())));
      return worst;
    };
    std::vector<double> x{3 + unit(random), -2 * unit(random)}; // outside: something is inverted
    ASSERT_LT(least(x), 0);
    Local_untangling(c, x).run(1);
    double best = -1e300;
    for (double u = -1.5; u <= 1.5; u += 0.01)
      for (double v = -1.5; v <= 1.5; v += 0.01) best = (std::max)(best, least({u, v}));
    EXPECT_GE(least(x), best - 1e-12) << "seed " << seed << " run " << run;
    EXPECT_LE(least(x), best + 0.05);
  }
}

TEST(Local_untangling, a_vertex_on_a_line_slides_to_where_both_sides_have_room)
{
  // Two triangles fans over the segment (0,0)-(4,0), which the vertex 4 divides; it starts beyond the end.
  Planar_complex c;
  for (const Point_2d& p : {Point_2d(0, 0), Point_2d(4, 0), Point_2d(2, 3), Point_2d(2, -1)}) {
    Planar_node node;
    node.base = p;
    c.nodes.push_back(node);
  }
  Planar_node slider;
  slider.kind = Planar_node::Kind::sliding;
  slider.along = {4, 0};
  slider.unknown = 0;
  c.nodes.push_back(slider);
  c.triangles = {{{0, 4, 2}}, {{4, 1, 2}}, {{4, 0, 3}}, {{1, 4, 3}}};
  c.tolerance.assign(4, 1e-9);
  c.unknowns = 1;
  std::vector<double> x{1.7};
  EXPECT_TRUE(Local_untangling(c, x).run(1));
  EXPECT_NEAR(x[0], 0.5, 1e-12);
}

TEST(Untangle, frees_a_grid_in_disorder_and_never_moves_the_boundary)
{
  const std::uint64_t seed = 3;
  std::mt19937_64 random(seed);
  int freed = 0;
  for (int run = 0; run < 10; ++run) {
    L_shape shape(8);
    std::vector<double> x = shape.x;
    for (double& u : x) u = 8 * unit(random);
    freed += untangle(shape.complex, 0.5, x);
  }
  EXPECT_GE(freed, 9) << "seed " << seed;
}

TEST(Untangle, says_so_where_a_triangle_has_no_room)
{
  // All corners of a triangle are fixed, clockwise; the free vertex beside it cannot help.
  L_shape shape(4);
  std::swap(shape.complex.triangles[0][0], shape.complex.triangles[0][1]);
  std::vector<double> x = shape.x;
  ASSERT_GE(shape.complex.count_inverted(x.data()), 1);
  Planar_complex& c = shape.complex;
  for (int v : c.triangles[0]) c.nodes[v].kind = Planar_node::Kind::fixed;
  const int before = c.count_inverted(x.data());
  EXPECT_FALSE(untangle(c, 0.5, x));
  EXPECT_LE(c.count_inverted(x.data()), before);
}

TEST(Injective_map, of_many_vertices_into_a_horseshoe)
{
  const Horseshoe h(60);
  std::vector<Point_2d> points = h.points;
  ASSERT_TRUE(mean_value_map(h.triangles, h.shape, h.fixed, points));
  ASSERT_GT(h.inverted(points), 100);
  ASSERT_GT(untangle(h.triangles, h.fixed, h.area, h.tolerance, points), 0) << "an easy one, and no test";
  points = h.points;
  EXPECT_TRUE(injective_map(h.triangles, h.shape, h.fixed, h.area, h.tolerance, points));
  EXPECT_EQ(h.inverted(points), 0);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (h.fixed[v]) EXPECT_EQ(points[v], h.points[v]);
}
