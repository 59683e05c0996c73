// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace CGAL::Multiplanar;
using internal::Connectivity;

namespace {

Connectivity connectivity(const Multiplanar_test::Mesh& mesh)
{
  return internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
}

/// One label for every distinct direction of face normals.
std::vector<int> labels_by_normal(const Connectivity& c, const Points& points, int& labels)
{
  std::map<std::array<long, 3>, int> seen;
  std::vector<int> result;
  for (int f = 0; f < c.number_of_faces(); ++f) {
    const Vector_3 a = internal::area_vector(c, points, f);
    const double l = std::sqrt(a.squared_length());
    const std::array<long, 3> key{std::lround(a.x() / l * 1e6), std::lround(a.y() / l * 1e6),
                                  std::lround(a.z() / l * 1e6)};
    result.push_back(seen.insert({key, int(seen.size())}).first->second);
  }
  labels = int(seen.size());
  return result;
}

/// What must hold in every complex, whatever its shape.
void expect_consistent(const Panel_complex& complex)
{
  for (int p = 0; p < complex.number_of_panels(); ++p)
    for (const auto& loop : complex.panels[p].loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EXPECT_EQ(complex.panel(loop[i]), p);
        EXPECT_EQ(complex.target(loop[i]), complex.source(loop[(i + 1) % loop.size()]));
      }
  for (int v = 0; v < complex.number_of_corners(); ++v) {
    const auto& corner = complex.corners[v];
    ASSERT_GE(corner.panels.size(), 3u);
    ASSERT_EQ(corner.panels.size(), corner.edges.size());
    for (std::size_t i = 0; i < corner.panels.size(); ++i) {
      const auto& e = complex.edges[corner.edges[i]];
      const std::set<int> sides(e.panels.begin(), e.panels.end());
      EXPECT_EQ(sides, (std::set<int>{corner.panels[i], corner.panels[(i + 1) % corner.panels.size()]}));
      EXPECT_TRUE(e.corners[0] == v || e.corners[1] == v);
    }
  }
}

/// A closed polyhedron of axis-parallel boxes: unit cells of a grid that `solid` says are filled.
/// Coplanar neighbouring squares stay separate triangles; labels by connected coplanar region.
struct Voxels
{
  Multiplanar_test::Mesh mesh;
  explicit Voxels(int nx, int ny, int nz, const std::function<bool(int, int, int)>& solid)
  {
    std::map<std::array<int, 3>, int> index;
    const auto vertex = [&](int x, int y, int z) {
      const auto it = index.insert({{x, y, z}, int(mesh.points.size())});
      if (it.second) mesh.points.emplace_back(x, y, z);
      return it.first->second;
    };
    const auto filled = [&](int x, int y, int z) {
      return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && solid(x, y, z);
    };
    const auto quad = [&](int a, int b, int c, int d) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    };
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z) {
          if (!filled(x, y, z)) continue;
          const auto v = [&](int i) { return vertex(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)); };
          if (!filled(x - 1, y, z)) quad(v(0), v(4), v(6), v(2));
          if (!filled(x + 1, y, z)) quad(v(1), v(3), v(7), v(5));
          if (!filled(x, y - 1, z)) quad(v(0), v(1), v(5), v(4));
          if (!filled(x, y + 1, z)) quad(v(2), v(6), v(7), v(3));
          if (!filled(x, y, z - 1)) quad(v(0), v(2), v(3), v(1));
          if (!filled(x, y, z + 1)) quad(v(4), v(5), v(7), v(6));
        }
  }
};

/// Labels by connected regions of equal normals.
std::vector<int> labels_by_region(const Connectivity& c, const Points& points, int& regions)
{
  int n = 0;
  const auto by_normal = labels_by_normal(c, points, n);
  std::vector<int> result(by_normal.size(), -1);
  regions = 0;
  for (int f = 0; f < c.number_of_faces(); ++f) {
    if (result[f] >= 0) continue;
    std::vector<int> stack{f};
    result[f] = regions;
    while (!stack.empty()) {
      const int g = stack.back();
      stack.pop_back();
      for (int h : c.neighbours[g])
        if (result[h] < 0 && by_normal[h] == by_normal[f]) result[h] = regions, stack.push_back(h);
    }
    ++regions;
  }
  return result;
}

TEST(Panel_complex, subdivided_cube_has_six_square_panels)
{
  const auto mesh = Multiplanar_test::cube(4);
  const auto c = connectivity(mesh);
  int n = 0;
  const auto labels = labels_by_normal(c, mesh.points, n);
  ASSERT_EQ(n, 6);
  const auto complex = make_panel_complex(c, mesh.points, labels, n);
  expect_consistent(complex);
  EXPECT_EQ(complex.number_of_corners(), 8);
  EXPECT_EQ(complex.number_of_edges(), 12);
  EXPECT_TRUE(panel_complex_problems(complex).empty());
  const double side = complex.edge_length(0);
  for (int e = 0; e < 12; ++e) {
    EXPECT_NEAR(complex.dihedral(e), 90, 1e-12);
    EXPECT_NEAR(complex.edge_length(e), side, 1e-12);
    EXPECT_EQ(complex.edges[e].chain.size(), 5u);
  }
  for (int p = 0; p < 6; ++p) EXPECT_NEAR(complex.area(p), side * side, 1e-12);
  EXPECT_LT(complex.planarity_deviation(), 1e-14);
}

TEST(Panel_complex, octahedron_has_corners_of_valence_four)
{
  const auto mesh = Multiplanar_test::subdivided(Multiplanar_test::octahedron(), 3);
  const auto c = connectivity(mesh);
  int n = 0;
  const auto labels = labels_by_normal(c, mesh.points, n);
  ASSERT_EQ(n, 8);
  const auto complex = make_panel_complex(c, mesh.points, labels, n);
  expect_consistent(complex);
  EXPECT_EQ(complex.number_of_corners(), 6);
  EXPECT_EQ(complex.number_of_edges(), 12);
  for (const auto& corner : complex.corners) EXPECT_EQ(corner.panels.size(), 4u);
  for (int e = 0; e < 12; ++e) EXPECT_NEAR(complex.dihedral(e), std::acos(-1.0 / 3) * 180 / M_PI, 1e-9);
}

TEST(Panel_complex, dodecahedron_from_polygons)
{
  // The dual of the icosahedron: corners at the centroids of its faces, one pentagon around each of its vertices.
  const auto ico = Multiplanar_test::icosahedron();
  const auto c = connectivity(ico);
  Points corners;
  for (const auto& t : ico.triangles)
    corners.push_back(CGAL::centroid(ico.points[t[0]], ico.points[t[1]], ico.points[t[2]]));
  std::vector<std::vector<std::vector<int>>> polygons;
  for (int v = 0; v < 12; ++v) polygons.push_back({std::vector<int>(c.star(v).begin(), c.star(v).end())});
  const auto complex = make_panel_complex_from_polygons(corners, polygons);
  expect_consistent(complex);
  EXPECT_EQ(complex.number_of_edges(), 30);
  EXPECT_TRUE(panel_complex_problems(complex).empty());
  for (int e = 0; e < 30; ++e) EXPECT_NEAR(complex.dihedral(e), std::acos(-1 / std::sqrt(5.0)) * 180 / M_PI, 1e-9);
  for (int p = 0; p < 12; ++p) EXPECT_GT(complex.area(p), 0);
}

TEST(Panel_complex, prism_with_a_notch_has_one_kind_of_reflex_edge)
{
  const Voxels l_shape(2, 2, 1, [](int x, int y, int) { return !(x == 1 && y == 1); });
  const auto c = connectivity(l_shape.mesh);
  int n = 0;
  const auto labels = labels_by_region(c, l_shape.mesh.points, n);
  const auto complex = make_panel_complex(c, l_shape.mesh.points, labels, n);
  expect_consistent(complex);
  EXPECT_EQ(n, 8);
  EXPECT_EQ(complex.number_of_corners(), 12);
  int reflex = 0;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const double angle = complex.dihedral(e);
    EXPECT_TRUE(std::abs(angle - 90) < 1e-9 || std::abs(angle - 270) < 1e-9);
    reflex += angle > 180;
  }
  EXPECT_EQ(reflex, 1);
}

TEST(Panel_complex, torus_of_boxes_has_genus_one_and_panels_with_holes)
{
  const Voxels ring(3, 3, 1, [](int x, int y, int) { return !(x == 1 && y == 1); });
  const auto c = connectivity(ring.mesh);
  EXPECT_EQ(c.genus(), 1);
  int n = 0;
  const auto labels = labels_by_region(c, ring.mesh.points, n);
  const auto complex = make_panel_complex(c, ring.mesh.points, labels, n);
  expect_consistent(complex);
  EXPECT_EQ(n, 10);
  int with_hole = 0;
  for (int p = 0; p < n; ++p) {
    const auto& panel = complex.panels[p];
    EXPECT_EQ(panel.euler, 2 - int(panel.loops.size()));
    if (panel.loops.size() != 2) continue;
    ++with_hole;
    EXPECT_NEAR(complex.area(p), 8, 1e-12);
    EXPECT_NEAR(complex.loop_area_vector(panel.loops[0]) * panel.plane.normal, 2 * 9, 1e-12);
    EXPECT_NEAR(complex.loop_area_vector(panel.loops[1]) * panel.plane.normal, -2 * 1, 1e-12);
  }
  EXPECT_EQ(with_hole, 2);
  EXPECT_TRUE(panel_complex_problems(complex).empty());
}

TEST(Panel_complex, names_what_cannot_be_flat)
{
  const auto mesh = Multiplanar_test::icosphere(3);
  const auto c = connectivity(mesh);
  const auto problems_of = [&](const std::function<int(const Point_3&)>& label, int n) {
    std::vector<int> labels;
    for (const auto& t : c.triangles)
      labels.push_back(label(CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])));
    std::set<Panel_problem> kinds;
    for (const auto& p : panel_complex_problems(make_panel_complex(c, mesh.points, labels, n))) kinds.insert(p.problem);
    return kinds;
  };
  const auto hemispheres = problems_of([](const Point_3& p) { return p.z() > 0; }, 2);
  EXPECT_TRUE(hemispheres.count(Panel_problem::closed_edge));
  const auto slices = problems_of([](const Point_3& p) { return p.z() > 0 ? p.x() > 0 : 2; }, 3);
  EXPECT_TRUE(slices.count(Panel_problem::few_neighbours));
  EXPECT_TRUE(slices.count(Panel_problem::shared_ends));
  const auto two_caps = problems_of([](const Point_3& p) { return std::abs(p.z()) > 0.6 ? 0 : p.z() > 0 ? 1 : 2; }, 3);
  EXPECT_TRUE(two_caps.count(Panel_problem::not_a_planar_domain));
}

TEST(Panel_complex, handle_inside_a_panel_is_not_a_planar_domain)
{
  const auto mesh = Multiplanar_test::torus(24, 16);
  const auto c = connectivity(mesh);
  // Four small panels on one side; the rest, with the handle, is the fifth.
  std::vector<int> labels;
  for (const auto& t : c.triangles) {
    const Point_3 p = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    labels.push_back(p.x() > 0.8 && std::abs(p.y()) < 0.4 ? (p.y() > 0) + 2 * (p.z() > 0) : 4);
  }
  const auto problems = panel_complex_problems(make_panel_complex(c, mesh.points, labels, 5));
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const Panel_complex_problem& p) {
    return p.problem == Panel_problem::not_a_planar_domain && p.panel == 4;
  }));
}

TEST(Panel_complex, polygons_that_do_not_close_are_refused)
{
  const Points points{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)};
  EXPECT_THROW(make_panel_complex_from_polygons(points, {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}}), std::invalid_argument);
  EXPECT_NO_THROW(make_panel_complex_from_polygons(points, {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}}));
}

TEST(Connectivity, refuses_what_is_not_a_closed_manifold)
{
  EXPECT_THROW(internal::make_connectivity({{0, 1, 2}}, 3), std::invalid_argument);
  EXPECT_THROW(internal::make_connectivity({{0, 1, 2}, {0, 1, 2}}, 3), std::invalid_argument);
  EXPECT_THROW(internal::make_connectivity({{0, 1, 1}}, 3), std::invalid_argument);
  EXPECT_THROW(internal::make_connectivity({{0, 1, 7}}, 3), std::invalid_argument);
  // Two tetrahedra that share a vertex.
  EXPECT_THROW(internal::make_connectivity({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3},
                                            {0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}}, 7),
               std::invalid_argument);
}

} // namespace
