// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Multiplanar/internal/map_to_panels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;

/// The boundary of the cubes of side 1/n in [0, 2] x [0, 2] x [0, 1] that are not in [1, 2] x [1, 2] x [0, 1].
Multiplanar_test::Mesh l_mesh(int n)
{
  Multiplanar_test::Mesh mesh;
  std::map<std::array<int, 3>, int> number;
  const auto full = [n](const std::array<int, 3>& x) {
    return x[0] >= 0 && x[1] >= 0 && x[2] >= 0 && x[0] < 2 * n && x[1] < 2 * n && x[2] < n && (x[0] < n || x[1] < n);
  };
  const auto vertex = [&](const std::array<int, 3>& x) {
    const auto found = number.emplace(x, int(number.size()));
    if (found.second) mesh.points.emplace_back(double(x[0]) / n, double(x[1]) / n, double(x[2]) / n);
    return found.first->second;
  };
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < 2 * n; ++j)
      for (int k = 0; k < n; ++k)
        for (int axis = 0; axis < 3; ++axis)
          for (int side = 0; side < 2; ++side) {
            const std::array<int, 3> cell{i, j, k};
            std::array<int, 3> beside = cell, a = cell;
            beside[axis] += 2 * side - 1;
            if (!full(cell) || full(beside)) continue;
            a[axis] += side;
            std::array<int, 3> b = a, d = a;
            ++b[(axis + 1) % 3];
            ++d[(axis + 2) % 3];
            std::array<int, 3> e = b;
            ++e[(axis + 2) % 3];
            if (!side) std::swap(b, d);
            mesh.triangles.push_back({vertex(a), vertex(b), vertex(e)});
            mesh.triangles.push_back({vertex(a), vertex(e), vertex(d)});
          }
  return mesh;
}

/// The solid over an L in the plane, each unit divided in n: its bottom and top have a reflex corner.
struct L_solid
{
  explicit L_solid(int n) : mesh(l_mesh(n)), c(make_connectivity(mesh.triangles, int(mesh.points.size())))
  {
    labels.assign(c.number_of_faces(), -1);
    for (int f = 0; f < c.number_of_faces(); ++f) {
      const auto& t = mesh.triangles[f];
      const auto all = [&](int axis, double x) {
        return std::all_of(t.begin(), t.end(), [&](int v) { return mesh.points[v][axis] == x; });
      };
      labels[f] = all(0, 0) ? 0 : all(1, 0) ? 1 : all(2, 0) ? 2 : all(2, 1) ? 3 : all(0, 2) ? 4 : all(1, 2) ? 5
                  : all(0, 1) ? 6 : 7;
    }
    complex = complex_of(labels);
  }

  Panel_complex complex_of(const std::vector<int>& of) const
  {
    static const Vector_3 normals[8] = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                        {0, 1, 0}};
    static const double offsets[8] = {0, 0, 0, 1, 2, 2, 1, 1};
    Panel_complex result = make_panel_complex(c, mesh.points, of, 8);
    for (int p = 0; p < 8; ++p) result.panels[p].plane = {normals[p], offsets[p]};
    return result;
  }

  int vertex_at(const Point_3& p) const
  {
    return int(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin());
  }

  Multiplanar_test::Mesh mesh;
  Connectivity c;
  std::vector<int> labels;
  Panel_complex complex;
};

int not_positive(const L_solid& solid, const Panel_mapping& mapping)
{
  int n = 0;
  for (int f = 0; f < solid.c.number_of_faces(); ++f)
    n += !(area_vector(solid.c, mapping.targets(), f) * mapping.complex().panels[mapping.labels()[f]].plane.normal > 0);
  return n;
}

} // namespace

TEST(Flat_ears, there_are_none_where_corners_have_company)
{
  const L_solid solid(4);
  EXPECT_TRUE(flat_ears(solid.c, solid.labels, solid.complex).empty());
  EXPECT_EQ(solid.complex.number_of_corners(), 12);
}

TEST(Flat_ears, a_lonely_face_at_a_reflex_corner_gets_company)
{
  L_solid solid(4);
  // Of the faces of the top around its reflex corner all but the middle one go to the walls beside them.
  const int corner = solid.vertex_at({1, 1, 1});
  ASSERT_LT(corner, solid.c.number_of_vertices());
  std::vector<int> labels = solid.labels;
  std::vector<int> fan; // the faces of the top, from one wall to the other
  const auto star = solid.c.star(corner);
  const int n = int(star.size());
  int begin = 0;
  while (!(solid.labels[star[begin]] == 3 && solid.labels[star[(begin + n - 1) % n]] != 3)) ++begin;
  for (int i = begin; solid.labels[star[i % n]] == 3; ++i) fan.push_back(star[i % n]);
  ASSERT_GE(fan.size(), 3u);
  const int before = solid.labels[star[(begin + n - 1) % n]], after = solid.labels[star[(begin + int(fan.size())) % n]];
  const std::size_t lonely = fan.size() / 2;
  for (std::size_t i = 0; i < fan.size(); ++i)
    if (i != lonely) labels[fan[i]] = i < lonely ? before : after;
  Panel_complex complex = solid.complex_of(labels);
  ASSERT_TRUE(transfer_geometry(solid.complex, complex));
  const auto ears = flat_ears(solid.c, labels, complex);
  ASSERT_FALSE(ears.empty());
  EXPECT_TRUE(std::any_of(ears.begin(), ears.end(), [&](const Flat_ear& e) { return e.face == fan[lonely]; }));

  std::vector<int> mended = labels;
  Panel_complex mended_complex = complex;
  EXPECT_GT(mend_flat_ears(solid.c, solid.mesh.points, mended, mended_complex), 0);
  EXPECT_TRUE(flat_ears(solid.c, mended, mended_complex).empty());
  EXPECT_EQ(mended_complex.number_of_corners(), 12);

  Panel_mapping mapping(solid.c, solid.mesh.points, labels, complex);
  mapping.repair();
  EXPECT_TRUE(mapping.failed().empty());
  EXPECT_EQ(not_positive(solid, mapping), 0);
}
