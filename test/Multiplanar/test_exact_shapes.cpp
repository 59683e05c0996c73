// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_panel_fixtures.h"

using namespace Multiplanar_test;

namespace {

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

TEST(GrowPartition, pieces_without_faces_are_no_seeds)
{
  // As many pieces as faces: random seeds coincide, and a piece whose seed another one has got is empty.
  const Mesh mesh = cube(1);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  const Input_surface in = make_input_surface(c, mesh.points);
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    for (int k : {11, 12, 14}) {
      const auto labels = grow_partition(in, face_moments(c, in.points), Face_cost(in, 0.05), k, seed, 1.3);
      for (int label : labels) ASSERT_TRUE(label >= 0 && label < k) << seed;
    }
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
