// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>

#include "label_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace Multiplanar_test;

// --- Eqs. 2 - 4 -----------------------------------------------------------------------------------------------------

TEST(Label_costs, data_cost_by_hand)
{
  // The octahedron's face (1,1,1)/sqrt(3) has area sqrt(3)/2 and centroid (1,1,1)/3.
  const Model m(octahedron());
  const double s = 1 / std::sqrt(3.);
  EXPECT_NEAR(m.costs.area(0), std::sqrt(3.) / 2, 1e-15);
  EXPECT_NEAR((m.costs.normal(0) - Vector_3(s, s, s)).squared_length(), 0, 1e-30);
  EXPECT_NEAR((m.costs.centroid(0) - Point_3(1. / 3, 1. / 3, 1. / 3)).squared_length(), 0, 1e-30);
  // Against the plane z = 2: |n_f - n_p|_1 = s + s + (1 - s), distance 2 - 1/3.
  EXPECT_NEAR(m.costs.data_cost(0, Plane{Vector_3(0, 0, 1), 2}), std::sqrt(3.) / 2 * (1 + s + 10 * (2 - 1. / 3)),
              1e-13);
  EXPECT_NEAR(m.costs.data_cost(0, m.costs.plane_of(0)), 0, 1e-15);
}

TEST(Label_costs, data_costs_agree_with_the_formula_written_out)
{
  Labelling_weights weights;
  weights.normal_distance = 3.5;
  const Model m(normalised(bumpy_sphere(6)), weights);
  const std::vector<Plane> planes = random_planes(5, 1);
  const Plane_costs label_costs = m.costs.data_cost(planes);
  EXPECT_EQ(label_costs.labels(), 5);
  for (int label = 0; label < 5; ++label) {
    const Plane& plane = planes[label];
    std::vector<double> block(m.costs.faces());
    label_costs.block(label, 0, m.costs.faces(), block.data());
    for (int f = 0; f < m.costs.faces(); ++f) {
      const auto& t = m.mesh.triangles[f];
      const Point_3 &a = m.mesh.points[t[0]], &b = m.mesh.points[t[1]], &c = m.mesh.points[t[2]];
      const Vector_3 normal = CGAL::unit_normal(a, b, c), step = plane.normal - normal;
      const double cost =
          std::sqrt(CGAL::squared_area(a, b, c)) * (std::abs(step.x()) + std::abs(step.y()) + std::abs(step.z()) +
                                                    3.5 * std::abs(signed_distance(plane, CGAL::centroid(a, b, c))));
      EXPECT_NEAR(m.costs.data_cost(f, plane), cost, 1e-13 * cost);
      EXPECT_NEAR(label_costs(f, label), cost, 1e-13 * cost);
      EXPECT_NEAR(block[f], cost, 1e-13 * cost);
    }
  }
}

TEST(Label_costs, potts_graph_has_the_edges_and_weights_of_equation_4)
{
  Labelling_weights weights;
  weights.smoothness = 0.3;
  const Mesh mesh = normalised(bumpy_sphere(5));
  std::vector<double> w_t;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) w_t.push_back(0.1 * double(f % 13));
  const Model m(mesh, weights, w_t);
  const Potts_graph g = m.costs.potts_graph();
  ASSERT_EQ(g.nodes(), m.costs.faces());
  ASSERT_EQ(g.adjacent.size(), 3 * mesh.triangles.size());
  const double scale = 0.3 * std::sqrt(500 / 1e4);
  for (int p = 0; p < g.nodes(); ++p)
    for (int i = 0; i < 3; ++i) {
      const int a = g.begin[p] + i, q = g.adjacent[a];
      EXPECT_EQ(q, m.connectivity.neighbours[p][i]);
      const Vector_3 step = m.costs.normal(p) - m.costs.normal(q);
      const double v = (m.costs.area(p) + m.costs.area(q)) / 2 *
                       (4 - std::abs(step.x()) - std::abs(step.y()) - std::abs(step.z()) + (w_t[p] + w_t[q]) / 2);
      EXPECT_NEAR(g.weight[a], scale * v, 1e-14 * v);
      EXPECT_GT(g.weight[a], 0);
    }
}

TEST(Label_costs, a_boundary_costs_the_same_on_meshes_of_any_fineness)
{
  const auto equator = [](int n) {
    const Model m(normalised(geodesic_sphere(n)));
    std::vector<int> labelling;
    for (int f = 0; f < m.costs.faces(); ++f) labelling.push_back(m.costs.centroid(f).z() > 0.03);
    return cut_weight(m.costs.potts_graph(), labelling);
  };
  const double coarse = equator(10), fine = equator(40); // 2,000 and 32,000 faces: without the factor, 1/4 as much
  EXPECT_NEAR(fine / coarse, 1, 0.1);
}

TEST(Label_costs, a_face_without_area_costs_nothing)
{
  Mesh mesh = tetrahedron();
  mesh.points[3] = CGAL::midpoint(mesh.points[0], mesh.points[1]); // {0, 3, 1} loses its area
  const Model m(mesh);
  EXPECT_EQ(m.costs.area(1), 0);
  EXPECT_EQ(m.costs.normal(1), Vector_3(0, 0, 0));
  EXPECT_EQ(m.costs.data_cost(1, Plane{Vector_3(1, 0, 0), 5}), 0);
  for (double w : m.costs.potts_graph().weight) EXPECT_TRUE(w >= 0 && std::isfinite(w));
}

TEST(Saliency_weights, are_low_where_saliency_is_high)
{
  EXPECT_EQ(saliency_weights({0, 0.25, 1}, 8), (std::vector<double>{8, 6, 0}));
  EXPECT_EQ(saliency_weights({0, 1}, 0), (std::vector<double>{0, 0}));
  EXPECT_TRUE(saliency_weights({}, 3).empty());
  for (double bad : {-0.1, 1.1, std::nan(""), HUGE_VAL})
    EXPECT_THROW(saliency_weights({0, bad}, 1), std::invalid_argument);
  for (double bad : {-1., std::nan(""), HUGE_VAL}) EXPECT_THROW(saliency_weights({0.5}, bad), std::invalid_argument);
}

// Passes of labelling and plane estimation at fixed vertices, from k-means++ seeds.
std::vector<int> labelled(const Model& m, int k, int seed)
{
  std::vector<Plane> planes = seed_planes(m.costs, k, seed);
  const Potts_graph graph = m.costs.potts_graph();
  std::vector<int> labelling = cheapest_labels(m.costs.faces(), k, m.costs.data_cost(planes));
  for (int pass = 0; pass < 8; ++pass) {
    alpha_expansion(graph, k, m.costs.data_cost(planes), labelling);
    estimate_planes(m.costs, labelling, planes);
  }
  return labelling;
}

// Numbers of labels and lengths of label boundaries where z > 0, divided by those where z < 0; over a few seeds.
struct Upper_to_lower
{
  double labels, boundaries;
};

Upper_to_lower upper_to_lower(const Model& m, int k)
{
  double upper_labels = 0, lower_labels = 0, upper = 0, lower = 0;
  for (int seed = 0; seed < 8; ++seed) {
    const std::vector<int> labelling = labelled(m, k, seed);
    std::vector<double> height(k, 0);
    for (int f = 0; f < m.costs.faces(); ++f) {
      height[labelling[f]] += m.costs.area(f) * m.costs.centroid(f).z();
      for (int i = 0; i < 3; ++i)
        if (labelling[f] != labelling[m.connectivity.neighbours[f][i]]) {
          const auto& t = m.mesh.triangles[f];
          const Point_3 &a = m.mesh.points[t[i]], &b = m.mesh.points[t[(i + 1) % 3]];
          (a.z() + b.z() > 0 ? upper : lower) += std::sqrt(CGAL::squared_distance(a, b));
        }
    }
    for (double h : height) (h > 0 ? upper_labels : lower_labels) += h != 0;
  }
  return {upper_labels / lower_labels, upper / lower};
}

TEST(Saliency, moves_labels_to_where_it_is_painted)
{
  const Mesh sphere = normalised(geodesic_sphere(14)); // 3,920 faces
  std::vector<double> upper_half;
  for (const auto& t : sphere.triangles)
    upper_half.push_back(sphere.points[t[0]].z() + sphere.points[t[1]].z() + sphere.points[t[2]].z() > 0);
  const auto painted = [&](double scale) {
    return upper_to_lower(Model(sphere, {}, saliency_weights(upper_half, scale)), 60);
  };

  const Upper_to_lower plain = upper_to_lower(Model(sphere), 60), none = painted(0);
  EXPECT_NEAR(plain.labels, 1, 0.1);
  EXPECT_NEAR(plain.boundaries, 1, 0.1);
  EXPECT_EQ(none.labels, plain.labels); // W = 0 has no effect
  EXPECT_EQ(none.boundaries, plain.boundaries);
  Upper_to_lower last = plain;
  for (double scale : {4., 16., 32.}) {
    const Upper_to_lower now = painted(scale);
    EXPECT_GT(now.labels, 1.1 * last.labels) << "W = " << scale;
    EXPECT_GT(now.boundaries, 1.1 * last.boundaries) << "W = " << scale;
    last = now;
  }
  EXPECT_GT(last.labels, 2);
  EXPECT_GT(last.boundaries, 1.6);
}

TEST(Saliency, makes_seeds_as_dense_as_it_says)
{
  const Mesh mesh = normalised(geodesic_sphere(14));
  std::vector<double> upper_half;
  for (const auto& t : mesh.triangles)
    upper_half.push_back(mesh.points[t[0]].x() + mesh.points[t[1]].x() + mesh.points[t[2]].x() > 0);
  for (double scale : {0., 4., 28.}) {
    const Model m(mesh, {}, saliency_weights(upper_half, scale));
    double upper = 0, lower = 0;
    for (int seed = 0; seed < 40; ++seed)
      for (int f : seed_faces(m.costs, 60, seed)) (upper_half[f] == 1 ? upper : lower) += 1;
    EXPECT_NEAR(upper / lower / (1 + scale / 4), 1, 0.2) << "W = " << scale;
  }
}

} // namespace
