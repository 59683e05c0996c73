// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles merged to panels, step by step: what is decided from the surroundings beside the whole traced anew, and
// models that stay flat and embedded.

#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/internal/Mapping_check.h>
#include <CGAL/Multiplanar/internal/map_to_panels.h>
#include <CGAL/Multiplanar/internal/mend_ears.h>
#include <CGAL/Multiplanar/internal/merge_triangles.h>

#include "flat_panel_fixtures.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
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

Accuracy_options few_steps()
{
  Accuracy_options few;
  few.powers = {4}, few.steps = 3;
  return few;
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
  const auto all_of_use = [](Panel_model&) { return std::vector<int>(); };
  ASSERT_TRUE(merge_triangles(t.modeller, few_steps(), 6, all_of_use, m));
  EXPECT_EQ(m.panels(), 6);
  EXPECT_EQ(faults_anew(m), 0);
}

/// What keeps the mesh from being mapped into the panels of a model, as they are.
std::vector<int> unmapped(const Merging& t, const Points& source, Mapping_check& check, const Panel_model& m)
{
  const Flat_panels_result r = result_of(t.c, source, t.in, m);
  EXPECT_TRUE(r.ok);
  return check.unmapped(r.panel_of_face, r.complex);
}

TEST(Merge_triangles, what_the_check_takes_is_mapped)
{
  const Mesh mesh = bumpy_sphere(8);
  Merging t(mesh);
  Mapping_check check(t.c, mesh.points);
  int taken = 0, refused = 0;
  const auto unusable = [&](Panel_model& m) {
    Mapping_check fresh(t.c, mesh.points); // remembers nothing
    const std::vector<int> bad = unmapped(t, mesh.points, check, m);
    EXPECT_EQ(bad, unmapped(t, mesh.points, fresh, m));
    if (bad.empty()) {
      const Flat_panels_result r = result_of(t.c, mesh.points, t.in, m);
      EXPECT_TRUE(Panel_mapping(t.c, mesh.points, r.panel_of_face, r.complex).failed().empty());
    }
    ++(bad.empty() ? taken : refused);
    return bad;
  };
  Panel_model m;
  EXPECT_TRUE(merge_triangles(t.modeller, few_steps(), 30, unusable, m));
  EXPECT_LE(m.panels(), 30);
  EXPECT_TRUE(unmapped(t, mesh.points, check, m).empty());
  EXPECT_GT(taken, 0);
  EXPECT_GT(refused, 0);
}

TEST(Merge_triangles, mended_ears_leave_the_polygons_where_they_are)
{
  int mended = 0;
  for (const Mesh& mesh : {bumpy_sphere(10), torus(30, 16)}) {
    Merging t(mesh);
    Panel_model m;
    ASSERT_TRUE(t.modeller.of_triangles(m));
    Merge_rounds rounds(t.modeller);
    for (int panels : {200, 120, 80, 60, 40}) {
      rounds.run(panels, m);
      const Flat_panels_result before = result_of(t.c, mesh.points, t.in, m);
      const auto ears = flat_ears(t.c, before.panel_of_face, before.complex);
      std::vector<int> bad;
      for (const Flat_ear& ear : ears) bad.push_back(before.panel_of_face[ear.face]);
      Ear_mender mender(t.c, m);
      if (!mender.run(bad)) continue;
      Panel_model next = m;
      ASSERT_TRUE(t.modeller.relabel(mender.labels, next)) << m.panels() << ": the complex is another";
      const Flat_panels_result after = result_of(t.c, mesh.points, t.in, next);
      Panel_complex expected = before.complex;
      EXPECT_TRUE(transfer_geometry(after.complex, expected));
      for (int p = 0; p < m.panels(); ++p) EXPECT_NEAR(after.complex.area(p), before.complex.area(p), 1e-9) << p;
      EXPECT_LT(flat_ears(t.c, after.panel_of_face, after.complex).size(), ears.size());
      EXPECT_EQ(faults_anew(next), 0);
      EXPECT_EQ(next.faults, 0);
      Moments anew;
      for (int f = 0; f < t.c.number_of_faces(); ++f)
        if (next.labels[f] == 0) anew += t.modeller.moments_of_faces()[f];
      EXPECT_NEAR(next.moments[0].area, anew.area, 1e-12);
      ++mended;
      m = next; // and on from there
    }
  }
  EXPECT_GT(mended, 2);
}

TEST(Merge_triangles, labels_of_another_complex_are_refused)
{
  const Mesh mesh = bumpy_sphere(6);
  Merging t(mesh);
  Panel_model m;
  ASSERT_TRUE(t.modeller.of_triangles(m));
  Merge_rounds(t.modeller).run(40, m);
  const std::vector<int> labels = m.labels;
  EXPECT_TRUE(t.modeller.relabel(labels, m));
  int refused = 0;
  for (int f = 0; f < t.c.number_of_faces(); f += 7) {
    std::vector<int> changed = labels;
    changed[f] = (labels[f] + m.panels() / 2) % m.panels(); // in most cases an island
    refused += !t.modeller.relabel(changed, m);
    EXPECT_TRUE(m.labels == changed || m.labels == labels);
    m.labels == labels || t.modeller.relabel(labels, m);
  }
  EXPECT_GT(refused, 10);
}

TEST(Merge_triangles, pinned_corners_change_nothing_but_the_work)
{
  Merging t(bumpy_sphere(6));
  Panel_model m;
  ASSERT_TRUE(t.modeller.of_triangles(m));
  std::mt19937 random(7); // its seed
  for (int i = 0; i < 40; ++i) {
    const auto& e = m.topology->edges[random() % m.topology->edges.size()];
    std::vector<char> free(m.panels(), 0), refit(m.panels(), 0);
    for (int corner : e.corners)
      for (int p : m.topology->corner_panels[corner]) free[p] = 1;
    std::vector<Moments> moments = m.moments;
    moments[e.panels[0]] += moments[e.panels[1]];
    refit[e.panels[0]] = 1;
    Flat_state pinned = m.state, all = m.state;
    Plane_corner_system a(*m.topology, free, true), b(*m.topology, free);
    ASSERT_TRUE(first_fit(moments, a, refit, pinned, 0.1));
    ASSERT_TRUE(first_fit(moments, b, refit, all, 0.1));
    EXPECT_LT(a.unknowns(), b.unknowns());
    EXPECT_LT(flatness(*m.topology, pinned), 1e-12);
    for (int x = 0; x < m.topology->number_of_corners(); ++x)
      EXPECT_LT((pinned.corner[x] - all.corner[x]).norm(), 1e-6) << "round " << i << ", corner " << x;
  }
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
