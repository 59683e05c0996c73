// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles merged to panels, step by step: what is decided from the surroundings beside the whole traced anew, and
// models that stay flat and embedded.

#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/internal/Mapping_check.h>
#include <CGAL/Multiplanar/internal/map_to_panels.h>
#include <CGAL/Multiplanar/internal/merge_triangles.h>

#include "flat_panel_fixtures.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace Multiplanar_test;

struct Merging
{
  explicit Merging(const Mesh& mesh)
      : c(make_connectivity(mesh.triangles, int(mesh.points.size()))), in(make_input_surface(c, mesh.points, 500)),
        modeller(in, 0.05)
  {
  }
  Connectivity c;
  Input_surface in;
  Panel_modeller modeller;
};

std::vector<int> merged_labels(const Panel_model& m, int p, int q)
{
  Label_edit edit = no_edit(m.labels, m.panels());
  merge_labels(edit, p, q);
  return edit.labels;
}

/// Faults of the model found from scratch.
int faults_anew(const Panel_model& m)
{
  Panel_surface surface(*m.topology);
  std::vector<int> all(m.panels());
  for (int p = 0; p < m.panels(); ++p) all[p] = p;
  surface.update(m.state, all);
  surface.build_tree(m.state);
  int faults = int(surface.conflicts(m.state, std::vector<char>(m.panels(), 1), 1 << 20).size());
  for (int p = 0; p < m.panels(); ++p) faults += !surface.is_simple(p);
  return faults;
}

TEST(Merge_triangles, pairs_that_can_be_merged_are_those_that_can_be_traced)
{
  int yes = 0, no = 0;
  for (const Mesh& mesh : {bumpy_sphere(6), torus(12, 8)}) {
    Merging t(mesh);
    Panel_model m;
    ASSERT_TRUE(t.modeller.of_triangles(m));
    Merge_rounds rounds(t.modeller);
    for (int panels : {400, 100, 40, 24}) {
      if (panels > m.panels()) continue;
      rounds.run(panels, m);
      const Mergeable_panels mergeable(*m.topology);
      for (const auto& e : m.topology->edges) {
        const int p = e.panels[0], q = e.panels[1];
        int common = 0;
        for (const auto& f : m.topology->edges)
          common += (f.panels[0] == p && f.panels[1] == q) || (f.panels[0] == q && f.panels[1] == p);
        Complex_topology traced;
        std::vector<int> vertices;
        const std::vector<int> labels = merged_labels(m, p, q);
        const bool can = Topology_tracer(t.c, labels, m.panels() - 1).trace(traced, vertices);
        if (mergeable(p, q)) {
          ++yes;
          EXPECT_TRUE(can) << p << " and " << q << " of " << m.panels();
        } else if (common == 1) {
          ++no;
          EXPECT_FALSE(can) << p << " and " << q << " of " << m.panels();
        }
      }
    }
  }
  EXPECT_GT(yes, 100);
  EXPECT_GT(no, 0);
}

TEST(Merge_triangles, every_round_leaves_flat_panels_without_faults)
{
  for (const Mesh& mesh : {bumpy_sphere(8), torus(24, 12)}) {
    Merging t(mesh);
    Panel_model m;
    ASSERT_TRUE(t.modeller.of_triangles(m));
    EXPECT_EQ(m.panels(), t.c.number_of_faces());
    EXPECT_EQ(faults_anew(m), 0);
    Merge_rounds rounds(t.modeller);
    for (int panels = m.panels() / 2; panels >= 60; panels /= 2) {
      rounds.run(panels, m);
      EXPECT_EQ(m.faults, 0);
      EXPECT_EQ(faults_anew(m), 0) << m.panels();
      EXPECT_LT(flatness(*m.topology, m.state), 1e-12);
      EXPECT_LT(t.modeller.largest_displacement(m), 0.02 + 1e-12);
    }
    EXPECT_LE(m.panels(), 130);
  }
}

TEST(Merge_triangles, pits_vanish_whole)
{
  // A cube with a dent in the middle of a face: its walls can only go together.
  Mesh mesh = cube(4);
  int dented = 0;
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points.begin(), mesh.points.end());
  const double size = box.xmax() - box.xmin();
  for (Point_3& p : mesh.points) {
    const bool in_the_middle = std::abs(p.x() - (box.xmin() + box.xmax()) / 2) < 1e-3 * size &&
                               std::abs(p.y() - (box.ymin() + box.ymax()) / 2) < 1e-3 * size;
    if (p.z() == box.zmax() && in_the_middle) p = Point_3(p.x(), p.y(), p.z() - 0.05 * size), ++dented;
  }
  ASSERT_EQ(dented, 1);
  Merging t(mesh);
  Panel_model m;
  ASSERT_TRUE(t.modeller.of_triangles(m));
  Accuracy_options few;
  few.powers = {4}, few.steps = 3;
  ASSERT_TRUE(merge_triangles(t.modeller, few, 6, [](Panel_model& x) { return x.faults == 0; }, m));
  EXPECT_EQ(m.panels(), 6);
  EXPECT_EQ(faults_anew(m), 0);
}

TEST(Merge_triangles, what_the_check_takes_is_mapped)
{
  const Mesh mesh = bumpy_sphere(8);
  Merging t(mesh);
  Mapping_check check(t.c, mesh.points);
  int taken = 0, refused = 0;
  const auto usable = [&](Panel_model& m) {
    if (m.faults > 0) return false;
    const Flat_panels_result r = result_of(t.c, mesh.points, t.in, m);
    if (!r.ok) return false;
    Mapping_check fresh(t.c, mesh.points); // remembers nothing
    const bool fits = check(r.panel_of_face, r.complex);
    EXPECT_EQ(fits, fresh(r.panel_of_face, r.complex));
    if (fits) {
      EXPECT_TRUE(Panel_mapping(t.c, mesh.points, r.panel_of_face, r.complex).failed().empty());
    }
    ++(fits ? taken : refused);
    return fits;
  };
  Accuracy_options few;
  few.powers = {4}, few.steps = 3;
  Panel_model m;
  EXPECT_TRUE(merge_triangles(t.modeller, few, 30, usable, m));
  EXPECT_LE(m.panels(), 30);
  EXPECT_GT(taken, 0);
}

TEST(Merge_triangles, flat_panels_made_so_keep_all_promises)
{
  const Mesh mesh = torus(20, 12);
  const auto c = make_connectivity(mesh.triangles, int(mesh.points.size()));
  Flat_panels_options options;
  options.max_panels = 40;
  options.merge_triangles = true;
  const Flat_panels_result r = flat_panels(c, mesh.points, {}, options);
  expect_promises(c, mesh.points, r, 40);
  EXPECT_GT(r.fewest, 0);
}

TEST(Merge_triangles, free_panels_fall_into_pieces_without_common_corners)
{
  Merging t(bumpy_sphere(5));
  Panel_model m;
  ASSERT_TRUE(t.modeller.of_triangles(m));
  std::vector<char> free(m.panels(), 0);
  for (int p = 0; p < m.panels(); p += 17) free[p] = 1;
  free[1] = 1;
  const auto pieces = free_pieces(*m.topology, free);
  std::vector<int> piece_of(m.panels(), -1);
  for (int i = 0; i < int(pieces.size()); ++i)
    for (int p : pieces[i]) {
      EXPECT_EQ(piece_of[p], -1);
      piece_of[p] = i;
    }
  for (int p = 0; p < m.panels(); ++p) EXPECT_EQ(piece_of[p] >= 0, bool(free[p]));
  for (const auto& around : m.topology->corner_panels)
    for (int p : around)
      for (int q : around)
        if (free[p] && free[q]) {
          EXPECT_EQ(piece_of[p], piece_of[q]);
        }
  EXPECT_GT(pieces.size(), 2u);
}

} // namespace
