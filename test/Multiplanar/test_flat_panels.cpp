// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include "boxes.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <random>

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;

namespace {

double unit(std::mt19937_64& random) { return double(random() >> 11) / 9007199254740992.0; }
Vec3 noise(std::mt19937_64& random, double size)
{
  const double x = unit(random), y = unit(random), z = unit(random);
  return size * Vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
}

/// Everything that every result promises, checked from scratch.
void expect_promises(const Connectivity& c, const Points& source, const Flat_panels_result& r, int max_panels)
{
  ASSERT_TRUE(r.ok);
  const double diagonal = bounding_box_diagonal(as_vecs(source));
  EXPECT_LE(r.complex.number_of_panels(), max_panels);
  EXPECT_LT(r.complex.planarity_deviation(), 1e-12 * diagonal);
  for (const auto& panel : r.complex.panels) EXPECT_NEAR(panel.plane.normal.squared_length(), 1, 1e-12);
  EXPECT_TRUE(panel_complex_problems(r.complex).empty());
  Points corners;
  for (const auto& corner : r.complex.corners) corners.push_back(corner.point);
  const auto triangles = triangulate_panels(r.complex).triangles;
  const auto closed = make_connectivity(triangles, r.complex.number_of_corners());
  EXPECT_EQ(closed.genus(), c.genus());
  EXPECT_TRUE(is_embedded(closed, corners));
  const auto d = symmetric_hausdorff(source, c.triangles, corners, triangles, 1e-6 * diagonal);
  EXPECT_LE(d.lower(), r.hausdorff * (1 + 1e-12));
  EXPECT_GE(d.upper(), r.hausdorff - r.hausdorff_error);
  // The complex belongs to the labels.
  const auto again = make_panel_complex(c, source, r.panel_of_face, r.complex.number_of_panels());
  ASSERT_EQ(again.number_of_corners(), r.complex.number_of_corners());
  for (int i = 0; i < again.number_of_corners(); ++i) {
    EXPECT_EQ(again.corners[i].vertex, r.complex.corners[i].vertex);
    EXPECT_EQ(again.corners[i].panels, r.complex.corners[i].panels);
  }
}

/// A polyhedron with its true panels as labels comes back exactly, corner by corner.
void expect_exact(const Mesh& mesh, const std::vector<int>& labels, int panels, int corners, int edges, int holes)
{
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  Flat_panels_options options;
  options.max_panels = panels;
  options.effort = Effort::fast;
  const auto r = flat_panels(c, mesh.points, {labels}, options);
  expect_promises(c, mesh.points, r, panels);
  if (!r.ok) return;
  const double diagonal = bounding_box_diagonal(as_vecs(mesh.points));
  EXPECT_EQ(r.complex.number_of_panels(), panels);
  EXPECT_EQ(r.complex.number_of_corners(), corners);
  EXPECT_EQ(r.complex.number_of_edges(), edges);
  int loops = 0;
  for (const auto& p : r.complex.panels) loops += int(p.loops.size());
  EXPECT_EQ(loops, panels + holes);
  for (const auto& corner : r.complex.corners)
    EXPECT_LT(std::sqrt(CGAL::squared_distance(corner.point, mesh.points[corner.vertex])), 1e-9 * diagonal);
  EXPECT_LT(r.hausdorff, 2e-5 * diagonal);
  EXPECT_LT(r.mean, 1e-9 * diagonal);
}

std::vector<int> blocks(int faces, int size)
{
  std::vector<int> labels(faces);
  for (int f = 0; f < faces; ++f) labels[f] = f / size;
  return labels;
}

Mesh dodecahedron()
{
  // The dual of the icosahedron: a corner for each face, and a fan around the middle of each pentagon.
  const Mesh ico = icosahedron();
  const auto c = make_connectivity(ico.triangles, 12);
  Mesh mesh;
  for (const auto& t : ico.triangles)
    mesh.points.push_back(CGAL::centroid(ico.points[t[0]], ico.points[t[1]], ico.points[t[2]]));
  for (int v = 0; v < 12; ++v) {
    const auto star = c.star(v);
    Vector_3 sum(0, 0, 0);
    for (int f : star) sum = sum + (mesh.points[f] - CGAL::ORIGIN) / 5;
    const int middle = int(mesh.points.size());
    mesh.points.push_back(CGAL::ORIGIN + sum);
    for (int i = 0; i < 5; ++i) mesh.triangles.push_back({middle, star[i], star[(i + 1) % 5]});
  }
  return mesh;
}

/// The topology and the true state of a polyhedron whose labels are known, in its own frame.
struct Exact_model
{
  Complex_topology topology;
  std::vector<int> corner_vertex;
  Flat_state state;
  std::vector<Moments> moments;
};

Exact_model exact_model(const Mesh& mesh, const std::vector<int>& labels, int panels)
{
  Exact_model m;
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  EXPECT_TRUE(Topology_tracer(c, labels, panels).trace(m.topology, m.corner_vertex));
  const auto faces = face_moments(c, as_vecs(mesh.points));
  m.moments.resize(panels);
  for (std::size_t f = 0; f < labels.size(); ++f) m.moments[labels[f]] += faces[f];
  m.state.normal.resize(panels), m.state.offset.resize(panels);
  for (int p = 0; p < panels; ++p) fit_plane(m.moments[p], m.state.normal[p], m.state.offset[p]);
  for (int v : m.corner_vertex) m.state.corner.push_back(as_vec(mesh.points[v]));
  return m;
}

/// An octahedron with random affine image: flat faces, all corners with four of them.
Mesh random_octahedron(std::mt19937_64& random)
{
  const Vec3 a = Vec3(1, 0, 0) + noise(random, 0.3), b = Vec3(0, 1, 0) + noise(random, 0.3),
             d = Vec3(0, 0, 1) + noise(random, 0.3);
  return normalised(mapped(subdivided(octahedron(), 3),
                           [&](const Point_3& p) { return as_point(p.x() * a + p.y() * b + p.z() * d); }));
}

} // namespace

TEST(Exact_shapes, Tetrahedron) { expect_exact(subdivided(tetrahedron(), 4), blocks(64, 16), 4, 4, 6, 0); }
TEST(Exact_shapes, Cube) { expect_exact(cube(4), blocks(192, 32), 6, 8, 12, 0); }
TEST(Exact_shapes, CubeOfTwelveTriangles) { expect_exact(cube(1), blocks(12, 2), 6, 8, 12, 0); }
TEST(Exact_shapes, Octahedron) { expect_exact(subdivided(octahedron(), 3), blocks(72, 9), 8, 6, 12, 0); }
TEST(Exact_shapes, OctahedronOfEightTriangles) { expect_exact(octahedron(), blocks(8, 1), 8, 6, 12, 0); }
TEST(Exact_shapes, Icosahedron) { expect_exact(subdivided(icosahedron(), 2), blocks(80, 4), 20, 12, 30, 0); }
TEST(Exact_shapes, Dodecahedron)
{
  expect_exact(dodecahedron(), blocks(60, 5), 12, 20, 30, 0);
  const auto fine = subdivided(dodecahedron(), 3);
  expect_exact(fine, blocks(540, 45), 12, 20, 30, 0);
}
TEST(Exact_shapes, PrismWithNotch)
{
  const auto m = boxes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3);
  expect_exact(m.mesh, m.panels, 8, 12, 18, 0);
}
TEST(Exact_shapes, TorusOfBoxes)
{
  const auto m = boxes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}}, 2);
  expect_exact(m.mesh, m.panels, 10, 16, 24, 2);
}
TEST(Exact_shapes, PanelWithAHole)
{
  std::vector<std::array<int, 3>> cells;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 2; ++z)
        if (x != 1 || y != 1 || z != 1) cells.push_back({{x, y, z}});
  const auto m = boxes(cells, 2);
  expect_exact(m.mesh, m.panels, 11, 16, 24, 1);
}

TEST(Topology_tracer, SaysWhatTheComplexSays)
{
  const std::uint64_t seed = 17;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const Mesh sphere = bumpy_sphere(6), ring = torus(14, 9);
  int realisable = 0, refused = 0;
  for (int round = 0; round < 60; ++round) {
    const Mesh& mesh = round % 2 ? sphere : ring;
    const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
    const Input_surface in = make_input_surface(c, mesh.points);
    const int k = 4 + int(random() % 25);
    auto labels = grow_partition(in, face_moments(c, in.points), Face_cost(in, 0.05), k, random(), 1.3);
    if (round % 3 == 0) labels[random() % labels.size()] = int(random() % k); // often leaves a panel in pieces
    const auto complex = make_panel_complex(c, mesh.points, labels, k);
    Complex_topology t;
    std::vector<int> vertices;
    const bool traced = Topology_tracer(c, labels, k).trace(t, vertices);
    std::set<std::vector<int>> triples;
    bool repeated = false;
    for (const auto& corner : complex.corners) {
      auto around = corner.panels;
      std::sort(around.begin(), around.end());
      if (around.size() == 3) repeated = repeated || !triples.insert(around).second;
    }
    const bool has_problems = !panel_complex_problems(complex).empty();
    if (traced) {
      ++realisable;
      EXPECT_FALSE(has_problems || repeated);
      ASSERT_EQ(t.number_of_corners(), complex.number_of_corners());
      ASSERT_EQ(t.edges.size(), complex.edges.size());
      const auto cyclic = [](std::vector<int> a) {
        std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
        return a;
      };
      for (int i = 0; i < t.number_of_corners(); ++i) {
        EXPECT_EQ(vertices[i], complex.corners[i].vertex);
        EXPECT_EQ(cyclic(t.corner_panels[i]), cyclic(complex.corners[i].panels));
      }
      const auto key = [](std::array<int, 2> corners, std::array<int, 2> panels) {
        if (panels[0] > panels[1]) std::swap(panels[0], panels[1]), std::swap(corners[0], corners[1]);
        return std::array<int, 4>{{corners[0], corners[1], panels[0], panels[1]}};
      };
      std::set<std::array<int, 4>> ours, theirs;
      for (const auto& e : t.edges) ours.insert(key(e.corners, e.panels));
      for (const auto& e : complex.edges) theirs.insert(key(e.corners, e.panels));
      EXPECT_EQ(ours, theirs);
      for (int p = 0; p < k; ++p) {
        std::set<std::vector<int>> a, b;
        for (const auto& loop : t.loops[p]) a.insert(cyclic(loop));
        for (const auto& loop : complex.panels[p].loops) b.insert(cyclic(complex.loop_corners(loop)));
        EXPECT_EQ(a, b);
      }
    } else if (!repeated) {
      bool larger = false; // a corner with four panels can repeat a triple as well
      for (const auto& corner : complex.corners) larger = larger || corner.panels.size() > 3;
      EXPECT_TRUE(has_problems || larger);
      ++refused;
    }
  }
  EXPECT_GT(realisable, 5);
  EXPECT_GT(refused, 5);
}

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

TEST(Flat_panels, CurvedShapesKeepAllPromises)
{
  for (const Mesh& mesh : {bumpy_sphere(12), torus(36, 18), mapped(bumpy_sphere(10), [](const Point_3& p) {
                             return Point_3(3 * p.x() + 5, p.y(), 0.7 * p.z());
                           })}) {
    const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
    for (int k : {14, 24}) {
      Flat_panels_options options;
      options.max_panels = k;
      options.effort = Effort::fast;
      const auto r = flat_panels(c, mesh.points, {}, options);
      expect_promises(c, mesh.points, r, k);
      EXPECT_LT(r.hausdorff, 0.1 * bounding_box_diagonal(as_vecs(mesh.points)));
    }
  }
}

TEST(Flat_panels, SearchingLowersTheDistance)
{
  const Mesh mesh = bumpy_sphere(16, 0.2);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  Flat_panels_options options;
  options.max_panels = 20;
  options.effort = Effort::fast;
  const auto fast = flat_panels(c, mesh.points, {}, options);
  options.effort = Effort::normal;
  options.work = 0.05;
  const auto normal = flat_panels(c, mesh.points, {}, options);
  expect_promises(c, mesh.points, normal, 20);
  EXPECT_LT(normal.hausdorff, fast.hausdorff);
}

TEST(Flat_panels, WhatIsTooSmallToCutIsRemovedOrReported)
{
  const Mesh mesh = bumpy_sphere(12, 0.2);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  const double diagonal = bounding_box_diagonal(as_vecs(mesh.points));
  Flat_panels_options options;
  options.max_panels = 30;
  options.effort = Effort::fast;
  int before = 0;
  for (const double least : {0.0, 0.05}) {
    options.min_edge = options.min_width = least;
    const auto r = flat_panels(c, mesh.points, {}, options);
    expect_promises(c, mesh.points, r, 30);
    int shorter = 0;
    for (int e = 0; e < r.complex.number_of_edges(); ++e)
      shorter += std::sqrt(r.complex.edge_vector(e).squared_length()) < 0.05 * diagonal;
    if (least == 0) before = shorter;
    else EXPECT_TRUE(shorter == 0 || !r.notes.empty()) << shorter;
    if (least > 0) EXPECT_LT(shorter, before);
  }
  EXPECT_GT(before, 0);
}

TEST(Flat_panels, IsTheSameWithAnyNumberOfThreads)
{
  const Mesh mesh = bumpy_sphere(5, 0.2);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  Flat_panels_options options;
  options.max_panels = 10;
  options.work = 0.02;
  std::vector<Points> corners;
  for (int threads : {1, 2, 3}) {
    options.threads = threads;
    const auto r = flat_panels(c, mesh.points, {}, options);
    ASSERT_TRUE(r.ok);
    corners.emplace_back();
    for (const auto& corner : r.complex.corners) corners.back().push_back(corner.point);
  }
  EXPECT_EQ(corners[0], corners[1]);
  EXPECT_EQ(corners[0], corners[2]);
}
