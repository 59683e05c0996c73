// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_panel_fixtures.h"

using namespace Multiplanar_test;

namespace {

/// An octahedron with random affine image: flat faces, all corners with four of them.
Mesh random_octahedron(std::mt19937_64& random)
{
  const Vec3 a = Vec3(1, 0, 0) + noise(random, 0.3), b = Vec3(0, 1, 0) + noise(random, 0.3),
             d = Vec3(0, 0, 1) + noise(random, 0.3);
  return normalised(mapped(subdivided(octahedron(), 3),
                           [&](const Point_3& p) { return as_point(p.x() * a + p.y() * b + p.z() * d); }));
}

} // namespace

TEST(Plane_corner_system, PerturbedCornersConvergeBack)
{
  std::mt19937_64 random(1);
  const auto pit = boxes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
  const Mesh notch = normalised(pit.mesh);
  const Mesh ico = normalised(subdivided(icosahedron(), 2));
  for (int which = 0; which < 2; ++which) {
    Exact_model m = which == 0 ? exact_model(notch, pit.panels, 8) : exact_model(ico, blocks(80, 4), 20);
    const Flat_state exact = m.state;
    for (auto& x : m.state.corner) x += noise(random, 0.02);
    for (auto& n : m.state.normal) n = (n + noise(random, 0.02)).normalized();
    const std::vector<char> all(m.state.normal.size(), 1);
    Plane_corner_system system(m.topology, all);
    ASSERT_TRUE(first_fit(m.moments, system, all, m.state, 1e-6, 30));
    EXPECT_LT(flatness(m.topology, m.state), 1e-14);
    for (std::size_t i = 0; i < exact.corner.size(); ++i)
      EXPECT_LT((m.state.corner[i] - exact.corner[i]).norm(), 1e-3) << i; // the pull is not zero
  }
}

TEST(Plane_corner_system, CornersOfFourPanelsBecomeFlat)
{
  const std::uint64_t seed = 23;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 20; ++round) {
    Exact_model m = exact_model(random_octahedron(random), blocks(72, 9), 8);
    for (auto& x : m.state.corner) x += noise(random, 0.03);
    for (auto& n : m.state.normal) n = (n + noise(random, 0.05)).normalized();
    EXPECT_GT(flatness(m.topology, m.state), 1e-3);
    Plane_corner_system system(m.topology, std::vector<char>(8, 1));
    system.linearise(m.state);
    ASSERT_TRUE(system.settle(m.state));
    EXPECT_LT(flatness(m.topology, m.state), 1e-14);
    for (const auto& n : m.state.normal) EXPECT_NEAR(n.norm(), 1, 1e-14);
  }
}

TEST(Plane_corner_system, NearlyParallelPlanesDoNotMakeCornersFly)
{
  // A cube with one side divided into two that are almost coplanar: the corners on the fold are ill-conditioned.
  for (double angle : {1e-2, 1e-4, 1e-6, 0.0}) {
    Mesh mesh = cube(4);
    std::vector<int> labels = blocks(192, 32);
    for (int f = 0; f < 192; ++f) {
      const auto& t = mesh.triangles[f];
      const auto m = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
      if (labels[f] == 4 && m.x() > 0) labels[f] = 6;
    }
    for (auto& p : mesh.points)
      if (p.x() == 0 && p.z() == 1) p = Point_3(0, p.y(), 1 + angle);
    mesh = normalised(mesh);
    Exact_model m = exact_model(mesh, labels, 7);
    const std::vector<Vec3> before = m.state.corner;
    const std::vector<char> all(7, 1);
    Plane_corner_system system(m.topology, all);
    ASSERT_TRUE(first_fit(m.moments, system, all, m.state, 0.03)) << angle;
    EXPECT_LT(flatness(m.topology, m.state), 1e-12);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((m.state.corner[i] - before[i]).norm(), 0.02) << angle;
  }
}

/// The slow twin: planes and all corners as unknowns of one dense KKT system.
TEST(Plane_corner_system, EliminationSolvesTheFullSystem)
{
  std::mt19937_64 random(5);
  for (int which = 0; which < 3; ++which) {
    const auto ring = boxes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
    Exact_model m = which == 0   ? exact_model(normalised(ring.mesh), ring.panels, 8)
                    : which == 1 ? exact_model(random_octahedron(random), blocks(72, 9), 8)
                                 : exact_model(normalised(subdivided(icosahedron(), 2)), blocks(80, 4), 20);
    for (auto& x : m.state.corner) x += noise(random, 0.01); // not flat: the constraints have right sides
    const int panels = int(m.state.normal.size()), corners = int(m.state.corner.size());
    std::vector<char> free(panels, 1);
    free[2] = 0;
    Plane_corner_system system(m.topology, free);
    system.linearise(m.state);
    // The objective: |y|^2 / 2 + sum over corners of weights (u . dx + r)^2 / 2.
    struct Term
    {
      int corner;
      Vec3 u;
      double w, r;
    };
    std::vector<Term> terms;
    for (int c = 0; c < corners; ++c)
      for (int i = 0; i < 4; ++i) terms.push_back({c, noise(random, 1), 0.1 + unit(random), unit(random) - 0.5});
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(system.unknowns(), system.unknowns());
    Eigen::VectorXd f = Eigen::VectorXd::Zero(system.unknowns());
    for (int p : system.free_panels()) H.diagonal().segment<3>(3 * system.block_of(p)).array() += 1;
    H.diagonal().array() += 1e-9; // special corners have only their terms
    Linear_form form;
    for (const Term& t : terms) {
      form.clear();
      system.add_corner_motion(t.corner, t.u, form);
      add_square(form, t.w, t.r, H, f);
    }
    Flat_state moved = m.state;
    system.move_linearly(system.solve(H, f), moved);

    // Unknowns: (dn, dh) of every panel as a change of (n, d) along tangents, dx of every corner, multipliers.
    int rows = 0;
    for (const auto& around : m.topology.corner_panels) rows += int(around.size());
    const int np = 3 * panels, nc = 3 * corners, n = np + nc + rows;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (int p = 0; p < panels; ++p) K.block<3, 3>(3 * p, 3 * p) = (free[p] ? 1 : 1e12) * Eigen::Matrix3d::Identity();
    for (const Term& t : terms) {
      K.block<3, 3>(np + 3 * t.corner, np + 3 * t.corner) += t.w * t.u * t.u.transpose();
      b.segment<3>(np + 3 * t.corner) -= t.w * t.r * t.u;
    }
    int row = np + nc;
    for (int c = 0; c < corners; ++c)
      for (int p : m.topology.corner_panels[c]) {
        Vec3 middle = Vec3::Zero();
        for (int q : m.topology.loops[p][0]) middle += m.state.corner[q] / double(m.topology.loops[p][0].size());
        double radius = 0;
        for (int q : m.topology.loops[p][0]) radius = (std::max)(radius, (m.state.corner[q] - middle).norm());
        const auto tangent = tangents(m.state.normal[p]);
        const Vec3 x = m.state.corner[c] - middle;
        Eigen::RowVectorXd r = Eigen::RowVectorXd::Zero(n);
        r.segment<3>(np + 3 * c) = m.state.normal[p].transpose();
        r[3 * p] = x.dot(tangent[0]) / radius, r[3 * p + 1] = x.dot(tangent[1]) / radius, r[3 * p + 2] = -1;
        K.row(row) += r;
        K.col(row) += r.transpose();
        b[row++] = m.state.offset[p] - m.state.normal[p].dot(m.state.corner[c]);
      }
    const Eigen::VectorXd z = K.completeOrthogonalDecomposition().solve(b);
    for (int c = 0; c < corners; ++c) {
      // A corner that no free panel touches stays where it is in the system, but not in the twin.
      if (!system.moves(c)) continue;
      EXPECT_LT((moved.corner[c] - m.state.corner[c] - z.segment<3>(np + 3 * c)).norm(), 1e-5) << which << ' ' << c;
    }
  }
}
