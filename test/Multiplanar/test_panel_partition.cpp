// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/panel_partition_problems.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;
using internal::Connectivity;
using Multiplanar_test::Mesh;
using Labels = std::vector<int>;

/// A mesh with what the partition needs.
struct Model
{
  Model(std::string name, Mesh m)
      : name(std::move(name)), mesh(Multiplanar_test::normalised(std::move(m))),
        c(internal::make_connectivity(mesh.triangles, int(mesh.points.size()))), costs(c, mesh.points)
  {
  }
  Model(const Model&) = delete; // the costs refer to the connectivity

  Point_3 centroid(int f) const { return costs.centroid(f); }
  int faces() const { return c.number_of_faces(); }
  int fewest_panels() const { return 4 + 3 * c.genus(); }

  std::string name;
  Mesh mesh;
  Connectivity c;
  Label_costs costs;
};

Labels labels_by_point(const Model& m, const std::function<int(const Point_3&)>& label)
{
  Labels result;
  for (int f = 0; f < m.faces(); ++f) result.push_back(label(m.centroid(f)));
  return result;
}

/// Cells around random vertices, by distance in space.
Labels random_cells(const Model& m, int cells, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point_3> sites;
  for (int i = 0; i < cells; ++i) sites.push_back(m.mesh.points[random() % m.mesh.points.size()]);
  return labels_by_point(m, [&](const Point_3& p) {
    int best = 0;
    for (int i = 1; i < cells; ++i)
      if (CGAL::squared_distance(p, sites[i]) < CGAL::squared_distance(p, sites[best])) best = i;
    return best;
  });
}

/// Labels of the nearest of `k` planes, some rounds of refitting: ragged, in many pieces.
Labels plane_cells(const Model& m, int k, std::uint64_t seed)
{
  std::vector<Plane> planes = seed_planes(m.costs, k, seed);
  Labels labels(m.faces());
  for (int round = 0; round < 3; ++round) {
    for (int f = 0; f < m.faces(); ++f) {
      labels[f] = 0;
      for (int p = 1; p < k; ++p)
        if (m.costs.data_cost(f, planes[p]) < m.costs.data_cost(f, planes[labels[f]])) labels[f] = p;
    }
    estimate_planes(m.costs, labels, planes);
  }
  return labels;
}

/// The surface of a flat bar of unit cubes with holes through it, each cube's side an n x n grid: genus = holes.
Mesh plate_with_holes(int holes, int n)
{
  const int width = 2 * holes + 1;
  const auto solid = [&](int x, int y, int z) {
    return 0 <= x && x < width && 0 <= y && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
  };
  Mesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = index.emplace(p, int(mesh.points.size()));
    if (found.second) mesh.points.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
    return found.first->second;
  };
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < 3; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          std::array<int, 3> next{x, y, 0};
          next[axis] += side == 1 ? 1 : -1;
          if (!solid(x, y, 0) || solid(next[0], next[1], next[2])) continue;
          int u = (axis + 1) % 3, v = (axis + 2) % 3;
          if (side == 0) std::swap(u, v);
          for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
              const auto corner = [&](int di, int dj) {
                std::array<int, 3> p{n * x, n * y, 0};
                p[axis] += side * n;
                p[u] += i + di;
                p[v] += j + dj;
                return vertex(p);
              };
              const int a = corner(0, 0), b = corner(1, 0), d = corner(1, 1), e = corner(0, 1);
              mesh.triangles.push_back({a, b, d});
              mesh.triangles.push_back({a, d, e});
            }
        }
  return mesh;
}

Panel_partition_options options_for(int k, bool realisable = true)
{
  Panel_partition_options options;
  options.max_panels = k;
  options.realisable = realisable;
  return options;
}

std::string text_of(const std::vector<Partition_problem>& problems)
{
  std::string text;
  for (const auto& p : problems) text += "panel " + std::to_string(p.panel) + ": " + p.text + "; ";
  return text;
}

/// Runs `make_panels()` in both modes and checks all that it promises. \return the report of the full mode
Panel_partition_report expect_good_panels(const Model& m, const Labels& start, int k, const std::string& what)
{
  const std::string where = m.name + ", " + what + ", k = " + std::to_string(k);
  Labels labels = start;
  const auto light = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k, false));
  EXPECT_TRUE(light.ok) << where;
  EXPECT_LE(light.panels, k) << where;
  for (const auto& p : partition_problems(m.c, m.mesh.points, labels, light.panels))
    EXPECT_GT(p.kind, Partition_problem::self_touch) << where << ": " << p.text;

  labels = start;
  const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k));
  EXPECT_TRUE(report.ok) << where;
  EXPECT_LE(report.panels, k) << where;
  const auto problems = partition_problems(m.c, m.mesh.points, labels, report.panels);
  EXPECT_TRUE(problems.empty()) << where << ": " << text_of(problems);
  return report;
}

/// Labellings that a segmentation would hardly make.
std::vector<std::pair<std::string, Labels>> adversarial_labels(const Model& m)
{
  const double turn = 2 * std::acos(-1.);
  const auto angle = [](const Point_3& p) { return std::atan2(p.y(), p.x()); };
  const auto floor = [](double x) { return int(std::floor(x)) + 1000; };
  std::vector<std::pair<std::string, Labels>> result;
  result.emplace_back("one label", Labels(m.faces(), 0));
  Labels labels(m.faces());
  for (int f = 0; f < m.faces(); ++f) labels[f] = f;
  result.emplace_back("a label a face", labels);
  for (int f = 0; f < m.faces(); ++f) labels[f] = f % 2;
  result.emplace_back("checkerboard", labels);
  result.emplace_back("stripes across z", labels_by_point(m, [&](const Point_3& p) { return floor(12 * p.z()); }));
  result.emplace_back("stripes across x", labels_by_point(m, [&](const Point_3& p) { return floor(9 * p.x()); }));
  result.emplace_back("sectors", labels_by_point(m, [&](const Point_3& p) { return floor(3 * angle(p)); }));
  result.emplace_back("two spirals",
                      labels_by_point(m, [&](const Point_3& p) { return floor(angle(p) / turn + 8 * p.z()) % 2; }));
  result.emplace_back("one inside another", labels_by_point(m, [](const Point_3& p) {
                        const double d = CGAL::squared_distance(p, Point_3(0.3, 0, 0));
                        return d < 0.01 ? 0 : d < 0.03 ? 1 : 2;
                      }));
  result.emplace_back("A, B, A, B", labels_by_point(m, [](const Point_3& p) {
                        return std::abs(p.z()) < 0.08 ? 2 : int(p.x() * p.y() > 0);
                      }));
  result.emplace_back("a label in 40 pieces", random_cells(m, 80, 5));
  for (int& p : result.back().second) p = p % 2 == 0 ? 0 : p;
  result.emplace_back("noise", labels);
  std::mt19937_64 random(7);
  for (int& p : result.back().second) p = int(random() % 5);
  result.emplace_back("salt and pepper", random_cells(m, 12, 9));
  for (int& p : result.back().second)
    if (random() % 10 == 0) p = int(random() % 12);
  return result;
}

// --- the checker itself ------------------------------------------------------------------------------------------

std::set<int> kinds(const std::vector<Partition_problem>& problems)
{
  std::set<int> result;
  for (const auto& p : problems) result.insert(p.kind);
  return result;
}

Labels cube_sides(int n)
{
  Labels labels(12 * n * n);
  for (int f = 0; f < int(labels.size()); ++f) labels[f] = f / (2 * n * n);
  return labels;
}

TEST(Partition_problems, Sides_of_a_cube_have_none)
{
  const Model m("cube", Multiplanar_test::cube(4));
  EXPECT_TRUE(partition_problems(m.c, m.mesh.points, cube_sides(4), 6).empty());
}

TEST(Partition_problems, Find_labels_out_of_range_and_empty_and_disconnected_panels)
{
  const Model m("cube", Multiplanar_test::cube(4));
  Labels labels = cube_sides(4);
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 5)), std::set<int>{Partition_problem::bad_label});
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 7)), std::set<int>{Partition_problem::empty_panel});
  for (int& p : labels) p = p == 1 ? 0 : p == 5 ? 1 : p; // opposite sides
  EXPECT_EQ(kinds(partition_problems(m.c, m.mesh.points, labels, 5)), std::set<int>{Partition_problem::disconnected});
}

TEST(Partition_problems, Find_a_panel_that_touches_itself)
{
  const Model m("cube", Multiplanar_test::cube(4));
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
  const Model m("sphere", Multiplanar_test::icosphere(3));
  const Labels labels = labels_by_point(m, [](const Point_3& p) { return p.z() > 0.1; });
  EXPECT_TRUE(kinds(partition_problems(m.c, m.mesh.points, labels, 2)).count(Partition_problem::complex_problem));
}

TEST(Partition_problems, Find_chords_and_collinear_faces)
{
  const Model m("cube", Multiplanar_test::cube(4));
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
  const Model m("sphere", Multiplanar_test::icosphere(4));
  const Labels labels = labels_by_point(m, [](const Point_3& p) {
    return p.z() > 0.15 ? 0 : p.z() < -0.15 ? 1 : p.x() > 0.013 ? 2 : 3;
  });
  const auto complex = make_panel_complex(m.c, m.mesh.points, labels, 4);
  bool repeated = false;
  for (const auto& p : panel_complex_problems(complex))
    repeated = repeated || p.problem == Panel_problem::repeated_corner;
  EXPECT_TRUE(repeated);
}

// --- the parts ---------------------------------------------------------------------------------------------------

/// What `Panel_labelling` keeps count of, counted from scratch.
struct Counts
{
  int touches = 0, chords = 0, repeated = 0;

  Counts(const Connectivity& c, const Labels& labels)
  {
    std::vector<std::set<int>> at(c.number_of_vertices());
    std::map<std::array<int, 3>, int> corners;
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      const Labels star(c.star(v).begin(), c.star(v).end());
      int runs = 0;
      for (std::size_t i = 0; i < star.size(); ++i) {
        at[v].insert(labels[star[i]]);
        runs += labels[star[i]] != labels[star[(i + 1) % star.size()]];
      }
      touches += runs == 0 ? 0 : runs - int(at[v].size());
      for (int p : at[v])
        for (int q : at[v])
          for (int r : at[v])
            if (p < q && q < r) ++corners[{p, q, r}];
    }
    for (const auto& corner : corners) repeated += corner.second - 1;
    for (int f = 0; f < c.number_of_faces(); ++f)
      for (int i = 0; i < 3; ++i) {
        const int v = c.triangles[f][i], w = c.triangles[f][(i + 1) % 3];
        if (v > w || labels[f] != labels[c.neighbours[f][i]]) continue;
        int common = 0;
        for (int p : at[v]) common += int(at[w].count(p));
        chords += common >= 2;
      }
  }
};

TEST(Panel_labelling, Keeps_its_counts_through_changes_and_their_reversal)
{
  const std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  const Model m("bumpy", Multiplanar_test::bumpy_sphere(6));
  internal::Panel_labelling panels(m.c, random_cells(m, 15, seed));
  panels.start_watching();
  for (int round = 0; round < 200; ++round) {
    const Labels before = panels.labels();
    const std::size_t mark = panels.mark();
    for (int change = 0; change < 3; ++change) {
      std::set<int> faces;
      for (int i = 0; i < 1 + int(random() % 6); ++i) faces.insert(int(random() % m.faces()));
      panels.relabel({faces.begin(), faces.end()}, int(random() % 15));
    }
    if (random() % 2 == 0) {
      panels.roll_back(mark);
      ASSERT_EQ(panels.labels(), before);
    }
    const Counts counts(m.c, panels.labels());
    ASSERT_EQ(panels.number_of_touches(), counts.touches);
    ASSERT_EQ(panels.number_of_chords(), counts.chords);
    ASSERT_EQ(panels.number_of_repeated_corners(), counts.repeated);
    std::size_t faces = 0;
    for (int p = 0; p < panels.number_of_labels(); ++p) {
      for (int f : panels.faces(p)) ASSERT_EQ(panels.label(f), p);
      faces += panels.faces(p).size();
    }
    ASSERT_EQ(faces, std::size_t(m.faces()));
  }
}

/// Pieces, Euler characteristic, loops and touches of every panel, from scratch.
std::vector<std::array<int, 4>> shapes(const Model& m, const Labels& labels, int panels)
{
  const auto euler = internal::panel_euler_characteristics(m.c, labels, panels);
  const auto complex = make_panel_complex(m.c, m.mesh.points, labels, panels);
  std::vector<Partition_problem> touches;
  internal::find_self_touches(m.c, labels, touches);
  std::vector<std::array<int, 4>> result;
  for (int p = 0; p < panels; ++p) {
    int own = 0;
    for (const auto& t : touches) own += t.panel == p;
    result.push_back({internal::count_pieces(m.c, labels, p), euler[p], int(complex.panels[p].loops.size()), own});
  }
  return result;
}

TEST(Panel_flips, A_flip_is_simple_exactly_if_it_keeps_the_shape_of_both_panels)
{
  const Model m("bumpy", Multiplanar_test::bumpy_sphere(6));
  Labels labels = random_cells(m, 40, 3); // narrow panels: many flips are not simple
  make_panels(m.c, m.mesh.points, m.costs, labels, options_for(40, false));
  const int count = 1 + *std::max_element(labels.begin(), labels.end());
  internal::Panel_labelling panels(m.c, labels);
  panels.start_watching();
  const auto before = shapes(m, labels, count);
  int simple = 0, others = 0;
  for (int f = 0; f < m.faces(); ++f)
    for (int g : m.c.neighbours[f]) {
      const int b = labels[g];
      if (b == labels[f] || panels.faces(labels[f]).size() == 1) continue;
      Labels flipped = labels;
      flipped[f] = b;
      const bool expected = shapes(m, flipped, count) == before;
      EXPECT_EQ(internal::is_simple_flip(panels, f, b), expected) << "face " << f << " to " << b;
      ++(expected ? simple : others);
    }
  EXPECT_GT(simple, 20);
  EXPECT_GT(others, 20);
}

TEST(Panel_topology, Agrees_with_the_panel_complex)
{
  for (int cells : {3, 6, 20}) {
    const Model m("torus", Multiplanar_test::torus(30, 15));
    Labels labels = random_cells(m, cells, 40 + cells);
    const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(cells, false));
    internal::Panel_labelling panels(m.c, labels);
    panels.start_watching();
    const auto complex = make_panel_complex(m.c, m.mesh.points, labels, report.panels);
    for (int p = 0; p < report.panels; ++p) {
      const auto topology = internal::panel_topology(panels, p);
      int closed = 0;
      for (const auto& loop : complex.panels[p].loops) closed += complex.edges[loop[0].edge].is_closed();
      EXPECT_EQ(topology.loops, int(complex.panels[p].loops.size()));
      EXPECT_EQ(2 * topology.handles, 2 - topology.loops - complex.panels[p].euler);
      EXPECT_EQ(int(topology.closed.size()), closed);
    }
  }
}

TEST(Panel_pieces, Connected_pieces_are_numbered_by_their_first_faces)
{
  const Model m("cube", Multiplanar_test::cube(3));
  Labels labels = cube_sides(3);
  for (int& p : labels) p = p < 2 ? 5 : 7; // two opposite sides; a belt of four
  EXPECT_EQ(internal::label_connected_pieces(m.c, labels), 3);
  EXPECT_EQ(labels.front(), 0);
  EXPECT_EQ(labels[2 * 9], 1);
  EXPECT_EQ(labels.back(), 2);
}

TEST(Panel_pieces, Merging_takes_the_cheapest_pair_first)
{
  // A cube whose side +x is cut in two: any other merger costs more.
  const Model m("cube", Multiplanar_test::cube(4));
  Labels labels = cube_sides(4);
  for (int f = 0; f < 16; ++f) labels[f] = 6;
  internal::Panel_labelling panels(m.c, labels);
  internal::Panel_fits fits(m.costs, panels);
  EXPECT_EQ(internal::merge_cheapest(panels, fits, 6), 1);
  EXPECT_EQ(panels.label(0), panels.label(31));
  EXPECT_NEAR(fits.total(), 0, 1e-12);
}

TEST(Panel_pieces, A_merger_costs_what_refitting_says)
{
  const Model m("bumpy", Multiplanar_test::bumpy_sphere(6));
  Labels labels = random_cells(m, 8, 21);
  const int count = internal::label_connected_pieces(m.c, labels);
  internal::Panel_labelling panels(m.c, labels);
  internal::Panel_fits fits(m.costs, panels);
  const auto cost = [&](const Labels& l) {
    std::vector<Plane> planes(count);
    estimate_planes(m.costs, l, planes);
    double sum = 0;
    for (int f = 0; f < m.faces(); ++f) sum += m.costs.data_cost(f, planes[l[f]]);
    return sum;
  };
  for (int q : internal::neighbouring_panels(panels, 0)) {
    Labels merged = labels;
    for (int& p : merged) p = p == q ? 0 : p;
    EXPECT_NEAR(fits.merge_cost(0, q), cost(merged) - cost(labels), 1e-12);
  }
}

// --- the whole ---------------------------------------------------------------------------------------------------

TEST(Make_panels, Good_labels_stay_as_they_are)
{
  const Model m("cube", Multiplanar_test::cube(6));
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
  const Model m("cube", Multiplanar_test::cube(2));
  Labels labels(m.faces());
  for (int f = 0; f < m.faces(); ++f) labels[f] = f;
  const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(m.faces()));
  EXPECT_TRUE(report.ok);
  EXPECT_EQ(report.panels, 6);
}

TEST(Make_panels, Adversarial_labels_on_a_sphere)
{
  const Model m("sphere", Multiplanar_test::icosphere(3));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 5, 6, 12, 30}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_bumpy_sphere)
{
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(12, 0.25));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 7, 20, 50}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_cube)
{
  const Model m("cube", Multiplanar_test::cube(8));
  for (const auto& labels : adversarial_labels(m))
    for (int k : {4, 6, 9, 30}) expect_good_panels(m, labels.second, k, labels.first);
}

TEST(Make_panels, Adversarial_labels_on_a_torus)
{
  const Model m("torus", Multiplanar_test::torus(36, 18));
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
    const Model sphere("bumpy sphere", Multiplanar_test::bumpy_sphere(10, 0.05 * double(seed))),
        torus("torus", Multiplanar_test::torus(30 + int(seed), 12 + int(seed), 1, 0.2 + 0.05 * double(seed)));
    for (int cells : {3, 10, 40})
      for (const Model* m : {&sphere, &torus})
        for (int k : {m->fewest_panels(), 16, 40})
          expect_good_panels(*m, random_cells(*m, cells, seed), k, what + ", " + std::to_string(cells) + " cells");
  }
}

TEST(Make_panels, Uses_nearly_all_panels_where_the_surface_is_curved)
{
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(22, 0.25));
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
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(22, 0.25));
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
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(22, 0.25));
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
  const Model m("sphere", Multiplanar_test::icosphere(4));
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
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(16, 0.25));
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
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(16, 0.25));
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
  const Model m("bumpy sphere", Multiplanar_test::bumpy_sphere(16, 0.25));
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
  const Model sphere("sphere", Multiplanar_test::icosphere(2)), torus("torus", Multiplanar_test::torus(20, 10));
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
    const Model m(entry.path().filename().string(), Multiplanar_test::read_off(entry.path().string()));
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
