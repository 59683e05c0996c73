// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_panel_fixtures.h"

using namespace Multiplanar_test;

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

// As with a mesh that cannot be mapped into panels: here panels of many faces are what the caller cannot use. A search
// for close panels makes some that are larger; only merging from small ones with this in view keeps all below.
TEST(Flat_panels, AreMergedFromSmallOnesWhereACallerCannotUseOthers)
{
  const Mesh mesh = bumpy_sphere(12, 0.2);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  Flat_panels_options options;
  options.max_panels = 30;
  options.effort = Effort::fast;
  const int most = 3 * c.number_of_faces() / (2 * options.max_panels);
  const auto large_panels = [&](const Flat_panels_result& r) {
    std::vector<int> large;
    for (int p = 0; p < r.complex.number_of_panels(); ++p)
      if (int(r.complex.panels[p].faces.size()) > most) large.push_back(p);
    return large;
  };
  EXPECT_FALSE(large_panels(flat_panels(c, mesh.points, {}, options)).empty());
  const auto r = flat_panels(c, mesh.points, {}, options, {}, large_panels);
  expect_promises(c, mesh.points, r, 30);
  EXPECT_TRUE(large_panels(r).empty());
  ASSERT_FALSE(r.notes.empty());
  EXPECT_NE(r.notes.back().find("merged from smaller ones"), std::string::npos) << r.notes.back();
}
