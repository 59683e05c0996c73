// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "partition_fixtures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace Multiplanar_test;

TEST(Make_panels, Good_labels_stay_as_they_are)
{
  const Model m("cube", cube(6));
  for (int k : {6, 12, 50}) {
    Labels labels = cube_sides(6);
    const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k));
    EXPECT_EQ(labels, cube_sides(6)) << "k = " << k; // no panel can be split into two that are not in one plane
    EXPECT_EQ(report.relabelled_faces + report.merges + report.splits, 0);
    EXPECT_EQ(report.panels, 6);
    EXPECT_EQ(report.corner_valences[3], 8);
    EXPECT_NEAR(report.cost_after, 0, 1e-12);
  }
}

TEST(Make_panels, Flush_pieces_become_one_panel)
{
  const Model m("cube", cube(2));
  Labels labels(m.faces());
  for (int f = 0; f < m.faces(); ++f) labels[f] = f;
  const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(m.faces()));
  EXPECT_TRUE(report.ok);
  EXPECT_EQ(report.panels, 6);
}

TEST(Make_panels, Adversarial_labels_on_a_sphere)
{
  const Model m("sphere", icosphere(3));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 5, 6, 12, 30}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_bumpy_sphere)
{
  const Model m("bumpy sphere", bumpy_sphere(12, 0.25));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 7, 20, 50}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_cube)
{
  const Model m("cube", cube(8));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 6, 9, 30}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_torus)
{
  const Model m("torus", torus(36, 18));
  ASSERT_EQ(m.c.genus(), 1);
  for (const auto& labels : adversarial_labels(m))
    for (int k : {7, 8, 9, 10, 11, 12, 30}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Higher_genus)
{
  for (int holes : {2, 3}) {
    const Model m("plate with " + std::to_string(holes) + " holes", plate_with_holes(holes, 4));
    ASSERT_EQ(m.c.genus(), holes);
    for (int k : {m.fewest_panels(), m.fewest_panels() + 2, 30}) {
      expect_good_panels(m, Labels(m.faces(), 0), k, "one label");
      expect_good_panels(m, random_cells(m, 25, 2), k, "random cells");
    }
  }
}

TEST(Make_panels, Random_cells)
{
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::string what = "random cells, seed " + std::to_string(seed);
    const Model sphere("bumpy sphere", bumpy_sphere(10, 0.05 * double(seed))),
        torus("torus", Multiplanar_test::torus(30 + int(seed), 12 + int(seed), 1, 0.2 + 0.05 * double(seed)));
    for (int cells : {3, 10, 40})
      for (const Model* m : {&sphere, &torus})
        for (int k : {m->fewest_panels(), 16, 40})
          expect_good_panels(*m, random_cells(*m, cells, seed), k, what + ", " + std::to_string(cells) + " cells");
  }
}

TEST(Make_panels, Uses_nearly_all_panels_where_the_surface_is_curved)
{
  const Model m("bumpy sphere", bumpy_sphere(22, 0.25));
  for (int k : {30, 50, 90})
    for (int cells : {5, k, 3 * k}) {
      Labels labels = random_cells(m, cells, std::uint64_t(k));
      const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k));
      EXPECT_GE(report.panels, (9 * k + 9) / 10);
      labels = random_cells(m, cells, std::uint64_t(k));
      EXPECT_GE(make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k, false)).panels, (9 * k + 9) / 10);
    }
}

TEST(Make_panels, Labels_of_planes_keep_their_cost)
{
  // What is repaired costs little more than connected pieces without any repair.
  const Model m("bumpy sphere", bumpy_sphere(22, 0.25));
  for (int k : {12, 30, 60}) {
    const Labels start = plane_cells(m, k, 1);
    Labels light = start, full = start;
    const auto light_report = make_panels(m.c, m.mesh.points, m.costs, light, options_for(k, false));
    const auto full_report = make_panels(m.c, m.mesh.points, m.costs, full, options_for(k));
    expect_good_panels(m, start, k, "plane cells");
    EXPECT_LT(full_report.cost_after, 1.15 * light_report.cost_after) << "k = " << k;
    EXPECT_EQ(full_report.attempt, 0);
    EXPECT_NEAR(full_report.cost_after, internal::refitted_cost(m.costs, full), 1e-12);
  }
}

TEST(Make_panels, Corners_have_three_panels)
{
  const Model m("bumpy sphere", bumpy_sphere(22, 0.25));
  for (int k : {12, 40}) {
    Labels labels = plane_cells(m, k, 4);
    const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k));
    const auto complex = make_panel_complex(m.c, m.mesh.points, labels, report.panels);
    std::array<int, 8> valences{};
    for (const auto& corner : complex.corners) ++valences[std::min<std::size_t>(7, corner.panels.size())];
    EXPECT_EQ(valences, report.corner_valences);
    EXPECT_EQ(valences[3], complex.number_of_corners());
  }
}

TEST(Make_panels, Simplifies_a_corner_of_four_panels)
{
  // The lunes between four meridians meet at a pole.
  const Model m("sphere", icosphere(4));
  internal::Panel_work work(m.costs,
                            internal::Panel_labelling(m.c, labels_by_point(m,
                                                                           [](const Point_3& p) {
                                                                             if (p.z() < -0.05)
                                                                               return 4 + (p.x() > 0.02);
                                                                             return 2 * (p.x() > 0.003) +
                                                                                    (p.y() > 0.002);
                                                                           })),
                            true);
  int large = 0, still_large = 0;
  for (int v = 0; v < m.c.number_of_vertices(); ++v) large += work.panels.labels_at(v).size() > 3;
  ASSERT_GT(large, 0);
  const int problems = work.panels.number_of_local_problems();
  internal::simplify_corners(work);
  for (int v = 0; v < m.c.number_of_vertices(); ++v) still_large += work.panels.labels_at(v).size() > 3;
  EXPECT_EQ(still_large, 0);
  EXPECT_LE(work.panels.number_of_local_problems(), problems);
}

TEST(Make_panels, Merges_small_and_narrow_panels)
{
  const Model m("bumpy sphere", bumpy_sphere(16, 0.25));
  double whole = 0;
  for (int f = 0; f < m.faces(); ++f) whole += m.costs.area(f);
  const Labels start = random_cells(m, 60, 8);
  const auto smallest = [&](const Labels& labels, int panels) {
    std::vector<double> areas(panels, 0);
    for (int f = 0; f < m.faces(); ++f) areas[labels[f]] += m.costs.area(f);
    return *std::min_element(areas.begin(), areas.end());
  };
  auto options = options_for(60);
  Labels labels = start;
  auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options);
  ASSERT_LT(smallest(labels, report.panels), whole / 100);
  options.min_area = whole / 100;
  labels = start;
  report = make_panels(m.c, m.mesh.points, m.costs, labels, options);
  EXPECT_TRUE(partition_problems(m.c, m.mesh.points, labels, report.panels).empty());
  EXPECT_GE(smallest(labels, report.panels), 0.9 * whole / 100); // boundaries are drawn tight afterwards
  options.min_area = 0;
  options.min_width = 0.12;
  labels = start;
  report = make_panels(m.c, m.mesh.points, m.costs, labels, options);
  EXPECT_TRUE(partition_problems(m.c, m.mesh.points, labels, report.panels).empty());
  EXPECT_LT(report.panels, 60);
}

TEST(Make_panels, Teleports_lower_the_cost)
{
  const Model m("bumpy sphere", bumpy_sphere(16, 0.25));
  // Far too many panels on one half.
  const Labels start = labels_by_point(m, [&](const Point_3& p) { return p.z() > 0 ? 0 : 1; });
  Labels fine = random_cells(m, 60, 3);
  for (int f = 0; f < m.faces(); ++f) fine[f] = start[f] == 0 ? 1000 : fine[f];
  const int k = 25;
  auto options = options_for(k);
  Labels labels = fine;
  const auto without = make_panels(m.c, m.mesh.points, m.costs, labels, options);
  options.max_teleports = k;
  labels = fine;
  const auto with = make_panels(m.c, m.mesh.points, m.costs, labels, options);
  EXPECT_GT(with.teleports, 0);
  EXPECT_LE(with.teleports, k);
  EXPECT_LT(with.cost_after, without.cost_after);
  EXPECT_TRUE(partition_problems(m.c, m.mesh.points, labels, with.panels).empty());
}

TEST(Make_panels, Is_deterministic_and_nearly_a_projection)
{
  const Model m("bumpy sphere", bumpy_sphere(16, 0.25));
  const Labels start = plane_cells(m, 30, 2);
  Labels first = start, second = start;
  make_panels(m.c, m.mesh.points, m.costs, first, options_for(30));
  make_panels(m.c, m.mesh.points, m.costs, second, options_for(30));
  EXPECT_EQ(first, second);
  Labels again = first;
  const auto report = make_panels(m.c, m.mesh.points, m.costs, again, options_for(30));
  EXPECT_EQ(report.merges + report.splits, 0); // panels that are good already are kept, boundaries may be drawn tighter
}

TEST(Make_panels, Says_so_when_it_cannot)
{
  const Model sphere("sphere", icosphere(2)), torus("torus", Multiplanar_test::torus(20, 10));
  for (const auto& model_and_k : {std::make_pair(&sphere, 3), std::make_pair(&sphere, 1), std::make_pair(&torus, 3)}) {
    const Model& m = *model_and_k.first;
    Labels labels = random_cells(m, 10, 1);
    const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(model_and_k.second));
    EXPECT_FALSE(report.ok) << m.name << " " << model_and_k.second << " " << report.panels
                            << text_of(partition_problems(m.c, m.mesh.points, labels, report.panels));
    EXPECT_LE(report.panels, model_and_k.second);
    for (const auto& p : partition_problems(m.c, m.mesh.points, labels, report.panels))
      EXPECT_GT(p.kind, Partition_problem::self_touch) << p.text;
  }
}

TEST(Make_panels, Smallest_meshes)
{
  const Model tetrahedron("tetrahedron", Multiplanar_test::tetrahedron()),
      octahedron("octahedron", Multiplanar_test::octahedron());
  for (const Model* m : {&tetrahedron, &octahedron}) {
    Labels labels(m->faces());
    for (int f = 0; f < m->faces(); ++f) labels[f] = f;
    expect_good_panels(*m, labels, m->faces(), "a label a face");
    expect_good_panels(*m, Labels(m->faces(), 0), m->faces(), "one label");
  }
}

TEST(Make_panels, Real_meshes)
{
  const char* folder = std::getenv("MULTIPLANAR_TEST_MESHES");
  if (!folder) GTEST_SKIP() << "MULTIPLANAR_TEST_MESHES is not set";
  int meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".off" || entry.file_size() > 1000000) continue;
    const Model m(entry.path().filename().string(), read_off(entry.path().string()));
    for (int k : {6, 12, 30, 50, 70, 90}) {
      if (k < m.fewest_panels()) continue;
      const auto report = expect_good_panels(m, plane_cells(m, k, 0), k, "plane cells");
      const bool organic = m.name.find("anchor") != 0 && m.name.find("fandisk") != 0;
      EXPECT_GE(report.panels, k >= 30 && organic ? (9 * k + 9) / 10 : 1) << m.name;
    }
    ++meshes;
  }
  EXPECT_GT(meshes, 0);
}

} // namespace
