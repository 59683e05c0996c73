// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "partition_fixtures.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace Multiplanar_test;

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
  const Model m("bumpy", bumpy_sphere(6));
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
  const Model m("bumpy", bumpy_sphere(6));
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
    const Model m("torus", torus(30, 15));
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
  const Model m("cube", cube(3));
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
  const Model m("cube", cube(4));
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
  const Model m("bumpy", bumpy_sphere(6));
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

} // namespace
