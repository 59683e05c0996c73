// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "partition_fixtures.h"

#include <set>

namespace {

using namespace Multiplanar_test;

std::set<int> kinds(const std::vector<Partition_problem>& problems)
{
  std::set<int> result;
  for (const auto& p : problems) result.insert(p.kind);
  return result;
}

TEST(Partition_problems, Sides_of_a_cube_have_none)
{
  const Model m("cube", cube(4));
  EXPECT_TRUE(partition_problems(m.c, m.mesh.points, cube_sides(4), 6).empty());
}

TEST(Partition_problems, Find_labels_out_of_range_and_empty_and_disconnected_panels)
{
  const Model m("cube", cube(4));
  Labels labels = cube_sides(4);
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 5)), std::set<int>{Partition_problem::bad_label});
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 7)), std::set<int>{Partition_problem::empty_panel});
  for (int& p : labels) p = p == 1 ? 0 : p == 5 ? 1 : p; // opposite sides
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 5)), std::set<int>{Partition_problem::disconnected});
}

TEST(Partition_problems, Find_a_panel_that_touches_itself)
{
  const Model m("cube", cube(4));
  // Around a vertex within side 0, give two opposite faces to another panel, connected to it elsewhere or not.
  Labels labels = cube_sides(4);
  for (int v = 0; v < m.c.number_of_vertices(); ++v) {
    const auto star = m.c.star(v);
    bool within = star.size() == 6;
    for (int f : star) within = within && labels[f] == 0;
    if (!within) continue;
    labels[star[0]] = labels[star[3]] = 6;
    break;
  }
  const auto found = kinds(partition_problems(m.c, m.mesh.points, labels, 7));
  EXPECT_TRUE(found.count(Partition_problem::self_touch));
}

TEST(Partition_problems, Find_one_panel_inside_another)
{
  const Model m("sphere", icosphere(3));
  const Labels labels = labels_by_point(m, [](const Point_3& p) { return p.z() > 0.1; });
  EXPECT_TRUE(kinds(partition_problems(m.c, m.mesh.points, labels, 2)).count(Partition_problem::complex_problem));
}

TEST(Partition_problems, Find_chords_and_collinear_faces)
{
  const Model m("cube", cube(4));
  // A face of side 0 with one edge on the border to side 2 goes there: its tip is an inner vertex of side 0 and its
  // own neighbours keep an edge. Two neighbours of such a face in side 0 then have an edge along the new chain.
  const Labels sides = cube_sides(4);
  bool chord = false, collinear = false;
  for (int f = 0; f < m.faces(); ++f)
    for (int g : m.c.neighbours[f]) {
      if (sides[g] == sides[f]) continue;
      Labels labels = sides;
      labels[f] = sides[g];
      const auto found = kinds(partition_problems(m.c, m.mesh.points, labels, 6));
      chord = chord || found.count(Partition_problem::chord);
      collinear = collinear || found.count(Partition_problem::collinear_face);
      // A face between three vertices on one line has an edge inside the panel between two of them.
      EXPECT_GE(found.count(Partition_problem::chord), found.count(Partition_problem::collinear_face));
    }
  EXPECT_TRUE(chord);
  EXPECT_TRUE(collinear);
}

TEST(Partition_problems, Find_three_panels_that_meet_at_two_corners)
{
  // Two panels along the equator between a northern and a southern one: the loop of each polar panel has two
  // neighbours.
  const Model m("sphere", icosphere(4));
  const Labels labels = labels_by_point(m, [](const Point_3& p) {
    return p.z() > 0.15 ? 0 : p.z() < -0.15 ? 1 : p.x() > 0.013 ? 2 : 3;
  });
  const auto complex = make_panel_complex(m.c, m.mesh.points, labels, 4);
  bool repeated = false;
  for (const auto& p : panel_complex_problems(complex))
    repeated = repeated || p.problem == Panel_problem::repeated_corner;
  EXPECT_TRUE(repeated);
}

} // namespace
