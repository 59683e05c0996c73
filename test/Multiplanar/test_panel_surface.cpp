// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_panel_fixtures.h"

using namespace Multiplanar_test;

TEST(Simple_polygons, FindPlantedFaults)
{
  using P = Kernel::Point_2;
  const Polygon_loop square{P(0, 0), P(4, 0), P(4, 4), P(0, 4)};
  const Polygon_loop hole{P(1, 1), P(1, 2), P(2, 2), P(2, 1)};
  EXPECT_TRUE(is_polygon_with_holes({square}));
  EXPECT_TRUE(is_polygon_with_holes({square, hole}));
  EXPECT_FALSE(is_polygon_with_holes({}));
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 0), P(4, 4), P(4, 0), P(0, 4)}}));          // bow-tie
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 4), P(4, 4), P(4, 0), P(0, 0)}}));          // clockwise
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 0), P(4, 0), P(4, 4), P(4, 0), P(0, 4)}})); // a spike
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 0), P(2, 0), P(1, 0), P(4, 0), P(0, 4)}})); // back and forth on a line
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 0), P(4, 0), P(4, 4), P(2, 0), P(0, 4)}})); // a corner on a side
  EXPECT_FALSE(is_polygon_with_holes({{P(0, 0), P(0, 0), P(4, 0), P(0, 4)}}));          // a side of length zero
  EXPECT_FALSE(is_polygon_with_holes({square, {P(1, 1), P(2, 1), P(2, 2), P(1, 2)}}));  // a hole counter-clockwise
  EXPECT_FALSE(is_polygon_with_holes({square, {P(5, 1), P(5, 2), P(6, 2), P(6, 1)}}));  // outside
  EXPECT_FALSE(is_polygon_with_holes({square, {P(0, 1), P(1, 2), P(1, 1)}}));           // touching the outline
  EXPECT_FALSE(is_polygon_with_holes({square, {P(3, 1), P(3, 2), P(5, 2), P(5, 1)}}));  // crossing it
  EXPECT_FALSE(is_polygon_with_holes({square, hole, {P(1.2, 1.2), P(1.2, 1.5), P(1.5, 1.2)}})); // a hole in a hole
  EXPECT_TRUE(is_polygon_with_holes({{P(0, 0), P(2, 0), P(4, 0), P(4, 4), P(0, 4)}})); // a straight corner is allowed
  // One digit decides: the last corner lies on the side, then one unit in the last place beside it.
  const double x = 0.1 + 0.2;
  EXPECT_FALSE(is_simple_polygon_loop({P(0, 0), P(3, 3), P(0, 3), P(x, x)}));
  EXPECT_TRUE(is_simple_polygon_loop({P(0, 0), P(3, 3), P(0, 3), P(x, std::nextafter(x, 1))}));
}

TEST(Simple_polygons, EarsAndDelaunayCoverThePolygon)
{
  const std::uint64_t seed = 31;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + int(random() % 14);
    Polygon_loop loop; // star-shaped: simple
    for (int i = 0; i < n; ++i) {
      const double a = 6.283185307179586 * (i + 0.8 * unit(random)) / n, r = 0.1 + unit(random);
      loop.push_back(Kernel::Point_2(r * std::cos(a), r * std::sin(a)));
    }
    if (!is_polygon_with_holes({loop})) continue;
    double area = 0;
    for (int i = 0; i < n; ++i) area += CGAL::area(Kernel::Point_2(0, 0), loop[i], loop[(i + 1) % n]);
    std::vector<std::array<int, 3>> ears;
    ASSERT_TRUE(cut_ears(loop, ears));
    for (const auto& triangles : {ears, triangulate_polygon({loop})}) {
      EXPECT_EQ(int(triangles.size()), n - 2);
      double sum = 0;
      for (const auto& t : triangles) {
        EXPECT_EQ(CGAL::orientation(loop[t[0]], loop[t[1]], loop[t[2]]), CGAL::LEFT_TURN);
        sum += CGAL::area(loop[t[0]], loop[t[1]], loop[t[2]]);
      }
      EXPECT_NEAR(sum, area, 1e-12);
    }
  }
}

TEST(Panel_surface, FindsIntersectingPanels)
{
  // Two tetrahedra, apart and then one poked into the other.
  for (bool poked : {false, true}) {
    Exact_model m = exact_model(subdivided(tetrahedron(), 2), blocks(16, 4), 4);
    Complex_topology t = m.topology;
    Flat_state s = m.state;
    const Vec3 shift = poked ? Vec3(0.7, 0.1, 0.2) : Vec3(5, 0, 0);
    for (int c = 0; c < m.topology.number_of_corners(); ++c) {
      t.corner_panels.push_back(m.topology.corner_panels[c]);
      for (int& p : t.corner_panels.back()) p += 4;
      s.corner.push_back(m.state.corner[c] + shift);
    }
    for (int p = 0; p < 4; ++p) {
      t.loops.push_back(m.topology.loops[p]);
      for (int& c : t.loops.back()[0]) c += 4;
      s.normal.push_back(s.normal[p]);
      s.offset.push_back(s.offset[p] + s.normal[p].dot(shift));
    }
    Panel_surface surface(t);
    surface.update(s, {0, 1, 2, 3, 4, 5, 6, 7});
    surface.build_tree(s);
    EXPECT_TRUE(surface.all_simple());
    const auto all = surface.conflicts(s, std::vector<char>(8, 1), 1000);
    EXPECT_EQ(!all.empty(), poked);
    for (const auto& pair : all) EXPECT_NE(pair[0] < 4, pair[1] < 4);
    std::vector<char> one(8, 0); // looked at from the one side only, the same pairs
    for (int p = 4; p < 8; ++p) one[p] = 1;
    std::set<std::set<int>> a, b;
    for (const auto& pair : all) a.insert({pair[0], pair[1]});
    for (const auto& pair : surface.conflicts(s, one, 1000)) b.insert({pair[0], pair[1]});
    EXPECT_EQ(a, b);
  }
  // A panel with two corners exchanged.
  Exact_model m = exact_model(cube(2), blocks(48, 8), 6);
  std::swap(m.topology.loops[0][0][1], m.topology.loops[0][0][2]);
  Panel_surface surface(m.topology);
  surface.update(m.state, {0, 1, 2, 3, 4, 5});
  EXPECT_FALSE(surface.is_simple(0));
  for (int p = 1; p < 6; ++p) EXPECT_TRUE(surface.is_simple(p));
}

TEST(Panel_surface, FoldedTrianglesConflict)
{
  const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.4, 0}, {0.3, 0.4, 1e-300}};
  EXPECT_FALSE(triangles_conflict(x, {{0, 1, 2}}, {{1, 3, 2}})); // side by side in one plane
  EXPECT_TRUE(triangles_conflict(x, {{0, 1, 2}}, {{1, 0, 4}}));  // one upon the other
  EXPECT_FALSE(triangles_conflict(x, {{0, 1, 2}}, {{1, 0, 5}})); // almost, but not quite
  EXPECT_TRUE(triangles_conflict(x, {{0, 1, 2}}, {{0, 3, 4}}));  // around a shared corner
}

TEST(Two_sided_distance, LazyDistancesGiveTheSameEnergy)
{
  const Mesh mesh = bumpy_sphere(12);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  const Input_surface in = make_input_surface(c, mesh.points, 500);
  const Panel_modeller modeller(in, 0.05);
  const int k = 14;
  auto labels = grow_partition(in, modeller.moments_of_faces(), Face_cost(in, 0.05), k, 1, 1.3);
  Panel_model m;
  std::vector<char> touched;
  ASSERT_TRUE(modeller.rebuild(nullptr, no_edit(labels, k), m, touched));
  std::vector<int> active(in.samples.size());
  for (std::size_t i = 0; i < active.size(); ++i) active[i] = int(i);
  const std::vector<char> all(k, 1);
  Plane_corner_system system(*m.topology, all);
  Two_sided_distance distance(in, *m.topology, system, active, std::vector<int>(active.size(), 0), 0.05);
  Evaluation base, lazy, full;
  Panel_surface surface = *m.surface;
  distance.measure_active(m.state, surface, base);
  distance.resample(m.state, surface, base);
  const double unit_length = base.largest();
  Flat_state moved = m.state;
  for (auto& x : moved.corner) x += Vec3(0.001, 0, 0);
  for (int p = 0; p < k; ++p) moved.offset[p] += 0.001 * moved.normal[p].x();
  surface.update(moved, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13});
  surface.build_tree(moved);
  distance.update(moved, surface, base, 0.001, 0.75 * unit_length, lazy);
  distance.update(moved, surface, base, 0.001, 0, full);
  int skipped = 0;
  for (const auto& d : lazy.to_panels) skipped += d.slack > 0;
  for (const auto& d : full.to_panels) EXPECT_EQ(d.slack, 0);
  EXPECT_GT(skipped, 50);
  EXPECT_NEAR(distance.energy(lazy, 32, unit_length) / distance.energy(full, 32, unit_length), 1, 1e-3);
  // Each distance against all triangles of the panels.
  for (std::size_t i = 0; i < active.size(); i += 17) {
    double best = 1e300;
    for (const auto& t : surface.triangles())
      best = (std::min)(best, squared_distance_to_triangle(in.samples[active[i]].point, moved.corner[t[0]],
                                                           moved.corner[t[1]], moved.corner[t[2]]));
    EXPECT_NEAR(full.to_panels[i].r, std::sqrt(best), 1e-12);
  }
  // The linear form predicts the change of a distance.
  Linear_form form;
  std::mt19937_64 random(3);
  system.linearise(m.state);
  Eigen::VectorXd pull(system.unknowns());
  for (int i = 0; i < pull.size(); ++i) pull[i] = 1e-6 * (2 * unit(random) - 1);
  const Eigen::VectorXd y = system.solve(Eigen::MatrixXd::Identity(pull.size(), pull.size()), pull); // stays flat
  Flat_state stepped = m.state;
  ASSERT_TRUE(system.move(y, stepped));
  surface.update(stepped, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13});
  surface.build_tree(stepped);
  distance.update(stepped, surface, base, 0.001, 0, full);
  int close = 0, seen = 0;
  const auto compare = [&](const Distance& before, const Distance& after) {
    if (before.r < 1e-3) return;
    distance.linear_form(before, m.state, form);
    ++seen;
    close += std::abs(form(y) - (after.r - before.r)) < 0.05 * std::abs(after.r - before.r) + 1e-8;
  };
  for (std::size_t i = 0; i < base.to_panels.size(); ++i) compare(base.to_panels[i], full.to_panels[i]);
  for (std::size_t i = 0; i < base.to_input.size(); ++i) compare(base.to_input[i], full.to_input[i]);
  EXPECT_GT(close, 9 * seen / 10) << seen; // kinks, where the closest point jumps, are few
}
