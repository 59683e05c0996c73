// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_FLAT_PANEL_FIXTURES_H
#define MULTIPLANAR_TEST_FLAT_PANEL_FIXTURES_H

#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include "boxes.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

/// What the tests of flat panels share: promises checked from scratch, and polyhedra whose panels are known.
namespace Multiplanar_test {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;

inline double unit(std::mt19937_64& random) { return double(random() >> 11) / 9007199254740992.0; }
inline Vec3 noise(std::mt19937_64& random, double size)
{
  const double x = unit(random), y = unit(random), z = unit(random);
  return size * Vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
}

/// Everything that every result promises, checked from scratch.
inline void expect_promises(const Connectivity& c, const Points& source, const Flat_panels_result& r, int max_panels)
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

inline std::vector<int> blocks(int faces, int size)
{
  std::vector<int> labels(faces);
  for (int f = 0; f < faces; ++f) labels[f] = f / size;
  return labels;
}

/// The topology and the true state of a polyhedron whose labels are known, in its own frame.
struct Exact_model
{
  Complex_topology topology;
  std::vector<int> corner_vertex;
  Flat_state state;
  std::vector<Moments> moments;
};

inline Exact_model exact_model(const Mesh& mesh, const std::vector<int>& labels, int panels)
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

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_FLAT_PANEL_FIXTURES_H
