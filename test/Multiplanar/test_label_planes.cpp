// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>

#include "label_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace {

using namespace Multiplanar_test;

// --- Planes ---------------------------------------------------------------------------------------------------------

TEST(Estimate_planes, takes_the_area_weighted_means)
{
  const Model m(normalised(bumpy_sphere(6)));
  std::vector<int> labelling;
  for (int f = 0; f < m.costs.faces(); ++f)
    labelling.push_back(m.costs.normal(f).z() > 0.3 ? 1 : m.costs.normal(f).x() > 0 ? 0 : 2);
  std::vector<Plane> planes(3);
  const Plane_estimation estimation = estimate_planes(m.costs, labelling, planes);
  EXPECT_TRUE(estimation.emptied.empty());
  EXPECT_TRUE(estimation.cancelled.empty());
  for (int label = 0; label < 3; ++label) {
    Vector_3 normal(0, 0, 0), centroid(0, 0, 0);
    double area = 0;
    for (int f = 0; f < m.costs.faces(); ++f)
      if (labelling[f] == label) {
        normal += m.costs.area(f) * m.costs.normal(f);
        centroid += m.costs.area(f) * (m.costs.centroid(f) - CGAL::ORIGIN);
        area += m.costs.area(f);
      }
    normal /= std::sqrt(normal.squared_length());
    EXPECT_NEAR((planes[label].normal - normal).squared_length(), 0, 1e-28);
    EXPECT_NEAR(planes[label].offset, centroid * normal / area, 1e-14);
    EXPECT_NEAR(planes[label].normal.squared_length(), 1, 1e-14);
  }
}

TEST(Estimate_planes, finds_the_sides_of_a_cube)
{
  const Model m(cube(4));
  std::vector<int> labelling;
  for (int f = 0; f < m.costs.faces(); ++f) labelling.push_back(f / 32);
  std::vector<Plane> planes(6);
  estimate_planes(m.costs, labelling, planes);
  for (int side = 0; side < 6; ++side) {
    EXPECT_NEAR(planes[side].normal[side / 2], side % 2 == 0 ? 1 : -1, 1e-15);
    EXPECT_NEAR(planes[side].offset, 1, 1e-15);
  }
}

TEST(Estimate_planes, emptied_labels_keep_their_plane)
{
  const Model m(cube(1));
  const std::vector<Plane> before = random_planes(3, 2);
  std::vector<Plane> planes = before;
  std::vector<int> labelling(12, 1);
  labelling[0] = labelling[1] = 1;
  for (int f = 2; f < 12; ++f) labelling[f] = 2;
  const Plane_estimation estimation = estimate_planes(m.costs, labelling, planes);
  EXPECT_EQ(estimation.emptied, (std::vector<int>{0}));
  EXPECT_EQ(planes[0].normal, before[0].normal);
  EXPECT_EQ(planes[0].offset, before[0].offset);
  EXPECT_EQ(planes[1].normal, Vector_3(1, 0, 0));
}

TEST(Estimate_planes, a_label_of_faces_without_area_counts_as_emptied)
{
  Mesh mesh = tetrahedron();
  mesh.points[3] = CGAL::midpoint(mesh.points[0], mesh.points[1]);
  const Model m(mesh);
  std::vector<Plane> planes(2, Plane{Vector_3(0, 1, 0), 7});
  const Plane_estimation estimation = estimate_planes(m.costs, {0, 1, 0, 0}, planes);
  EXPECT_EQ(estimation.emptied, (std::vector<int>{1}));
  EXPECT_EQ(planes[1].offset, 7);
}

TEST(Estimate_planes, normals_that_cancel_leave_the_largest_face)
{
  // All of a box: the normals cancel exactly. The largest faces are the first two, on +z, of the longest sides.
  const Model m(mapped(cube(1), [](const Point_3& p) { return Point_3(2 * p.x(), 3 * p.y(), p.z() + 5); }));
  std::vector<Plane> planes(1);
  const Plane_estimation estimation = estimate_planes(m.costs, std::vector<int>(12, 0), planes);
  EXPECT_EQ(estimation.cancelled, (std::vector<int>{0}));
  EXPECT_EQ(planes[0].normal, Vector_3(0, 0, 1)); // faces 8, 9 (+z) come before 10, 11 (-z)
  EXPECT_NEAR(planes[0].offset, 5, 1e-14);        // through the mean centroid
}

TEST(Estimate_planes, all_of_a_sphere_cancels_up_to_rounding)
{
  const Model m(normalised(bumpy_sphere(5)));
  std::vector<Plane> planes(1);
  EXPECT_EQ(estimate_planes(m.costs, std::vector<int>(m.costs.faces(), 0), planes).cancelled.size(), 1u);
  EXPECT_NEAR(planes[0].normal.squared_length(), 1, 1e-14);
}

TEST(First_coinciding, names_the_least_label_on_the_same_plane)
{
  const Plane a{Vector_3(0, 0, 1), 1}, b{Vector_3(0, 0, 1), 2}, c{Vector_3(0, 0, -1), -1}, d{Vector_3(1e-12, 0, 1), 1};
  EXPECT_EQ(first_coinciding({a, b, c, a, d, b}), (std::vector<int>{0, 1, 2, 0, 0, 1})); // c faces the other way
  EXPECT_EQ(first_coinciding({a, d}, 1e-13), (std::vector<int>{0, 1}));
  EXPECT_TRUE(first_coinciding({}).empty());
}

TEST(Coinciding_planes, one_label_takes_adjacent_faces_of_the_other)
{
  const Model m(normalised(cube(4)));
  std::vector<int> labelling;
  for (int f = 0; f < m.costs.faces(); ++f) labelling.push_back(f / 32);
  std::vector<Plane> planes(6);
  estimate_planes(m.costs, labelling, planes);
  // A seventh label on side 0, which holds the second half of it.
  planes.push_back(planes[0]);
  for (int f = 16; f < 32; ++f) labelling[f] = 6;
  const auto result = alpha_expansion(m.costs.potts_graph(), 7, m.costs.data_cost(planes), labelling);
  EXPECT_TRUE(result.converged);
  for (int f = 0; f < m.costs.faces(); ++f) EXPECT_EQ(labelling[f], f / 32); // label 0 is the first to expand
  EXPECT_EQ(estimate_planes(m.costs, labelling, planes).emptied, (std::vector<int>{6}));
  EXPECT_EQ(first_coinciding(planes), (std::vector<int>{0, 1, 2, 3, 4, 5, 0}));
}

// --- Seeds ----------------------------------------------------------------------------------------------------------

TEST(Seeding, draws_in_proportion_and_never_what_weighs_nothing)
{
  std::mt19937_64 rng(3);
  std::vector<int> count(5, 0);
  for (int i = 0; i < 30000; ++i) ++count[internal::draw_index({0, 1, 3, 0, 2}, rng)];
  EXPECT_EQ(count[0] + count[3], 0);
  EXPECT_NEAR(count[1], 5000, 400);
  EXPECT_NEAR(count[2], 15000, 400);
  EXPECT_NEAR(count[4], 10000, 400);
  EXPECT_EQ(internal::draw_index({0, 0}, rng), -1);
  EXPECT_EQ(internal::draw_index({}, rng), -1);
  EXPECT_EQ(internal::draw_index({0, 1e-300, 0}, rng), 1);
}

TEST(Seeding, uses_numbers_that_are_the_same_everywhere)
{
  std::mt19937_64 rng(5489); // the standard fixes the first output of the default seed
  EXPECT_EQ(internal::uniform_real(rng), double(14514284786278117030u >> 11) / 9007199254740992.);
}

TEST(Seeding, is_k_means_plus_plus_on_the_data_cost)
{
  const Mesh mesh = normalised(bumpy_sphere(6));
  std::vector<double> w_t;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) w_t.push_back(double(f % 5));
  const Model m(mesh, {}, w_t);
  for (int f = 0; f < 10; ++f) EXPECT_EQ(m.costs.seed_density(f), 4 / (4 + w_t[f]));
  for (int seed = 0; seed < 3; ++seed) {
    const std::vector<int> drawn = seed_faces(m.costs, 12, seed);
    std::mt19937_64 rng(seed);
    for (int i = 0; i < 12; ++i) { // weights computed anew from all faces drawn so far
      std::vector<double> weights;
      for (int f = 0; f < m.costs.faces(); ++f) {
        double least = i == 0 ? m.costs.area(f) : std::numeric_limits<double>::max();
        for (int j = 0; j < i; ++j)
          least = (std::min)(least, f == drawn[j] ? 0 : m.costs.data_cost(f, m.costs.plane_of(drawn[j])));
        weights.push_back(least * std::pow(m.costs.seed_density(f), 1.5));
      }
      EXPECT_EQ(drawn[i], internal::draw_index(weights, rng)) << "seed " << seed << ", draw " << i;
    }
  }
}

TEST(Seeding, depends_on_the_seed_alone)
{
  const Model m(normalised(bumpy_sphere(6)));
  EXPECT_EQ(seed_faces(m.costs, 20, 7), seed_faces(m.costs, 20, 7));
  EXPECT_NE(seed_faces(m.costs, 20, 7), seed_faces(m.costs, 20, 8));
  const std::vector<int> few = seed_faces(m.costs, 5, 7), many = seed_faces(m.costs, 20, 7);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  const std::vector<Plane> planes = seed_planes(m.costs, 5, 7);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(planes[i].normal, m.costs.normal(few[i]));
}

TEST(Seeding, every_face_comes_before_any_comes_twice)
{
  const Model m(normalised(bumpy_sphere(2))); // 80 faces
  const std::vector<int> drawn = seed_faces(m.costs, 100, 1);
  EXPECT_EQ(drawn.size(), 100u);
  EXPECT_EQ(std::set<int>(drawn.begin(), drawn.begin() + 80).size(), 80u);
}

TEST(Seeding, a_mesh_with_six_planes_has_each_of_them_first)
{
  const Model m(cube(4));
  for (int seed = 0; seed < 10; ++seed) {
    const std::vector<int> drawn = seed_faces(m.costs, 20, seed);
    std::set<int> sides;
    for (int i = 0; i < 6; ++i) sides.insert(drawn[i] / 32);
    EXPECT_EQ(sides.size(), 6u) << "seed " << seed;
  }
}

TEST(Seeding, works_without_any_area)
{
  Mesh mesh = tetrahedron();
  for (Point_3& p : mesh.points) p = Point_3(1, 2, 3);
  const Model m(mesh);
  EXPECT_EQ(seed_faces(m.costs, 3, 1), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(seed_planes(m.costs, 0, 1).empty());
}

} // namespace
