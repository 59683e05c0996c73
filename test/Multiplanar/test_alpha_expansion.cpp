// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/alpha_expansion.h>

#include "potts_problems.h"

#include <gtest/gtest.h>

#include <limits>
#include <new>

namespace {

using namespace Multiplanar_test;
namespace internal = CGAL::Multiplanar::internal;

// --- Graphs ---------------------------------------------------------------------------------------------------------

TEST(Potts_graph, has_each_edge_twice_and_no_loops)
{
  const Potts_graph g = make_potts_graph(4, {{0, 1}, {2, 2}, {2, 1}, {0, 1}}, {1, 5, 2, 3});
  EXPECT_EQ(g.nodes(), 4);
  EXPECT_EQ(g.begin, (std::vector<int>{0, 2, 5, 6, 6}));
  EXPECT_EQ(g.adjacent, (std::vector<int>{1, 1, 0, 2, 0, 1}));
  EXPECT_EQ(g.weight, (std::vector<double>{1, 3, 1, 2, 3, 2}));
  EXPECT_EQ(cut_weight(g, {0, 0, 0, 1}), 0);
  EXPECT_EQ(cut_weight(g, {0, 1, 1, 1}), 4); // parallel edges add up
  EXPECT_EQ(cut_weight(g, {0, 1, 0, 1}), 6);
}

TEST(Potts_graph, energy_is_the_sum_over_nodes_and_edges)
{
  std::mt19937_64 rng(11);
  for (int i = 0; i < 50; ++i) {
    const Problem p = random_problem(rng, 1 + draw(rng, 20), draw(rng, 40), 1 + draw(rng, 5), true, 6);
    EXPECT_EQ(potts_energy(p.graph, p.cost, p.start), slow_energy(p, p.start));
  }
}

TEST(Potts_graph, refuses_negative_weights_and_unknown_nodes)
{
  CGAL::Failure_behaviour old = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  EXPECT_THROW(make_potts_graph(2, {{0, 1}}, {-1}), CGAL::Precondition_exception);
  EXPECT_THROW(make_potts_graph(2, {{0, 2}}, {1}), CGAL::Precondition_exception);
  EXPECT_THROW(make_potts_graph(2, {{0, 1}}, {}), CGAL::Precondition_exception);
  CGAL::set_error_behaviour(old);
}

TEST(Reverse_arcs, pair_up_the_two_arcs_of_each_edge)
{
  std::mt19937_64 rng(12);
  for (int i = 0; i < 100; ++i) {
    const Potts_graph g = random_problem(rng, 1 + draw(rng, 8), draw(rng, 30), 1, true, 50).graph;
    const std::vector<int> reverse = internal::reverse_arcs(g);
    for (int p = 0; p < g.nodes(); ++p)
      for (int a = g.begin[p]; a < g.begin[p + 1]; ++a) {
        EXPECT_EQ(reverse[reverse[a]], a);
        EXPECT_NE(reverse[a], a);
        EXPECT_EQ(g.adjacent[reverse[a]], p);
        EXPECT_EQ(g.weight[reverse[a]], g.weight[a]);
      }
  }
}

// --- Flow -----------------------------------------------------------------------------------------------------------

TEST(Demand_flow, finds_the_smallest_minimiser)
{
  const int seed = 21;
  std::mt19937_64 rng(seed);
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 1 + draw(rng, 10);
    const Potts_graph g = random_problem(rng, n, draw(rng, 25), 1, true, 6).graph;
    std::vector<double> a(n);
    for (double& x : a) x = draw(rng, 21) - 12;
    const auto energy = [&](unsigned set) {
      double sum = 0;
      for (int p = 0; p < n; ++p)
        for (int e = g.begin[p]; e < g.begin[p + 1]; ++e)
          if ((set >> p & 1) > (set >> g.adjacent[e] & 1)) sum += g.weight[e];
      for (int p = 0; p < n; ++p) sum += (set >> p & 1) * a[p];
      return sum;
    };
    unsigned smallest = 0;
    double best = 0;
    for (unsigned set = 0; set < 1u << n; ++set) {
      if (energy(set) == best) smallest &= set;
      if (energy(set) < best) {
        best = energy(set);
        smallest = set;
      }
    }
    internal::Demand_flow flow(g);
    flow.start();
    const auto reach = [&](int p) {
      for (int e = g.begin[p]; e < g.begin[p + 1]; ++e) flow.set_capacity(e, g.weight[e]);
      flow.add(p, a[p]);
      flow.send(p);
    };
    for (int p = 0; p < n; ++p)
      if (a[p] < 0 && !flow.knows(p)) reach(p);
    flow.run(reach);
    unsigned found = 0;
    for (int p = 0; p < n; ++p) found |= unsigned(flow.is_one(p)) << p;
    ASSERT_EQ(found, smallest) << "seed " << seed << ", trial " << trial;
  }
}

TEST(Demand_flow, does_not_look_beyond_where_demand_is_met)
{
  // A path of 1000 nodes; node 500 demands 3, every node has room 1, capacities are ample.
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i + 1 < 1000; ++i) edges.emplace_back(i, i + 1);
  const Potts_graph g = make_potts_graph(1000, edges, std::vector<double>(edges.size(), 10));
  internal::Demand_flow flow(g);
  flow.start();
  const auto reach = [&](int p) {
    for (int e = g.begin[p]; e < g.begin[p + 1]; ++e) flow.set_capacity(e, g.weight[e]);
    flow.add(p, p == 500 ? -3 : 1);
    flow.send(p);
  };
  reach(500);
  flow.run(reach);
  EXPECT_LE(flow.known().size(), 6u);
  for (int p = 0; p < 1000; ++p) EXPECT_FALSE(flow.is_one(p));
}

// --- Expansions -----------------------------------------------------------------------------------------------------

TEST(Alpha_expansion, each_expansion_is_the_smallest_best_of_all)
{
  for (int seed = 0; seed < 600; ++seed) {
    std::mt19937_64 rng(seed);
    const int nodes = 1 + draw(rng, 10), labels = 2 + draw(rng, 4);
    const Problem p = random_problem(rng, nodes, draw(rng, 3 * nodes), labels, true, 2 + draw(rng, 8));
    Labels labelling = p.start;
    internal::Alpha_expander<Dense_data_cost> expander(p.graph, labels, p.cost, labelling, 0, 1);
    for (int step = 0; step < 4 * labels; ++step) { // any order of labels, several times over
      const int alpha = draw(rng, labels);
      const Labels expected = brute_force_expansion(p, labelling, alpha);
      const bool gain = expected != labelling;
      ASSERT_EQ(expander.expand(alpha), gain) << "seed " << seed << ", step " << step;
      ASSERT_EQ(labelling, expected) << "seed " << seed << ", step " << step;
      ASSERT_EQ(expander.energy(), slow_energy(p, labelling)) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(Alpha_expansion, ends_where_no_expansion_lowers_the_energy)
{
  for (int seed = 1000; seed < 1300; ++seed) {
    std::mt19937_64 rng(seed);
    const int nodes = 1 + draw(rng, 12), labels = 1 + draw(rng, 5);
    const Problem p = random_problem(rng, nodes, draw(rng, 3 * nodes), labels, seed % 2 == 0, 8);
    Labels labelling = p.start;
    const auto result = alpha_expansion(p.graph, labels, p.cost, labelling);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(result.energy, slow_energy(p, labelling), 1e-12);
    for (int alpha = 0; alpha < labels; ++alpha)
      EXPECT_GE(slow_energy(p, brute_force_expansion(p, labelling, alpha)), result.energy * (1 - 2e-10) - 1e-12)
          << "seed " << seed;
  }
}

TEST(Alpha_expansion, goes_the_way_of_the_textbook_construction)
{
  for (int seed = 2000; seed < 2020; ++seed) {
    std::mt19937_64 rng(seed);
    const int nodes = 300, labels = 6;
    const Problem p = random_problem(rng, nodes, 500, labels, seed % 2 == 0, 4 + seed % 5);
    Labels labelling = p.start;
    internal::Alpha_expander<Dense_data_cost> expander(p.graph, labels, p.cost, labelling, 0, 1);
    for (int step = 0; step < 4 * labels; ++step) {
      const int alpha = draw(rng, labels);
      const Labels twin = textbook_expansion(p, labelling, alpha);
      expander.expand(alpha);
      ASSERT_NEAR(slow_energy(p, labelling), slow_energy(p, twin), 1e-9) << "seed " << seed << ", step " << step;
      // Boost's flow decides exact ties either way, so labels can be compared only where there are none.
      if (seed % 2 == 1) {
        ASSERT_EQ(labelling, twin) << "seed " << seed << ", step " << step;
      }
    }
  }
}

TEST(Alpha_expansion, never_raises_the_energy)
{
  std::mt19937_64 rng(31);
  const Problem p = random_problem(rng, 2000, 4000, 12, false, 6);
  Labels labelling = p.start;
  internal::Alpha_expander<Dense_data_cost> expander(p.graph, 12, p.cost, labelling, 0, 1);
  double energy = slow_energy(p, labelling);
  for (int step = 0; step < 60; ++step) {
    const Labels before = labelling;
    const bool accepted = expander.expand(step % 12);
    EXPECT_EQ(accepted, labelling != before);
    const double now = slow_energy(p, labelling);
    EXPECT_TRUE(accepted ? now < energy : now == energy);
    energy = now;
  }
}

TEST(Alpha_expansion, handles_what_is_hardly_a_problem)
{
  Labels labelling;
  EXPECT_EQ(alpha_expansion(Potts_graph(), 3, Dense_data_cost{{}, 3}, labelling).energy, 0); // no nodes
  labelling = {0, 0};
  EXPECT_EQ(alpha_expansion(make_potts_graph(2, {{0, 1}}, {7}), 1, Dense_data_cost{{2, 3}, 1}, labelling).energy, 5);
  labelling = {1, 2, 0}; // no edges: everyone takes the cheapest
  const auto result =
      alpha_expansion(make_potts_graph(3, {}, {}), 3, Dense_data_cost{{3, 1, 2, 1, 2, 3, 4, 5, 6}, 3}, labelling);
  EXPECT_EQ(labelling, (Labels{1, 0, 0}));
  EXPECT_EQ(result.energy, 6);
  labelling = {0, 1, 2, 3}; // no data: one label for all, and a negative offset changes nothing
  const std::vector<std::pair<int, int>> cycle = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_EQ(alpha_expansion(make_potts_graph(4, cycle, {1, 1, 1, 1}), 4,
                            Dense_data_cost{std::vector<double>(16, -1), 4}, labelling)
                .energy,
            -4);
  EXPECT_EQ(labelling, (Labels{0, 0, 0, 0}));
}

TEST(Alpha_expansion, infinite_costs_forbid_a_label)
{
  const double never = std::numeric_limits<double>::infinity();
  for (int seed = 3000; seed < 3100; ++seed) {
    std::mt19937_64 rng(seed);
    Problem p = random_problem(rng, 9, 20, 3, true, 8);
    Problem high = p; // the same with a cost so high that nobody pays it
    for (int i = 0; i < 9; ++i) {
      const int forbidden = i * 3 + draw(rng, 3);
      p.cost.values[forbidden] = never;
      high.cost.values[forbidden] = 1e6;
      p.start[i] = (forbidden + 1) % 3;
    }
    Labels labelling = p.start, expected = p.start;
    alpha_expansion(p.graph, 3, p.cost, labelling);
    alpha_expansion(high.graph, 3, high.cost, expected);
    EXPECT_EQ(labelling, expected) << "seed " << seed;
  }
}

TEST(Alpha_expansion, stops_after_the_sweeps_allowed_and_goes_on_from_there)
{
  std::mt19937_64 rng(32);
  const Problem p = random_problem(rng, 500, 1000, 8, false, 6);
  Labels once = p.start, steps = p.start;
  const auto result = alpha_expansion(p.graph, 8, p.cost, once);
  EXPECT_TRUE(result.converged);
  ASSERT_GT(result.sweeps, 2);
  Alpha_expansion_options one_sweep;
  one_sweep.maximal_sweeps = 1;
  for (int sweep = 1; sweep <= result.sweeps; ++sweep) {
    const auto part = alpha_expansion(p.graph, 8, p.cost, steps, one_sweep);
    EXPECT_EQ(part.sweeps, 1);
    EXPECT_EQ(part.converged, sweep == result.sweeps);
    EXPECT_EQ(part.expansions == 0, part.converged);
  }
  EXPECT_EQ(steps, once);
}

// The same costs, block by block.
struct Blockwise_cost : Dense_data_cost
{
  void block(int label, int first, int last, double* out) const
  {
    for (int p = first; p < last; ++p) *out++ = (*this)(p, label);
  }
};

TEST(Alpha_expansion, does_not_depend_on_threads_or_blocks)
{
  std::mt19937_64 rng(33);
  const int labels = 60;
  const Problem p = random_problem(rng, 12000, 18000, labels, false, 6);
  ASSERT_GE(internal::useful_threads(7, 12000, labels), 3); // or this tests nothing
  const Labels start = cheapest_labels(12000, labels, p.cost);
  Labels expected = start;
  const auto result = alpha_expansion(p.graph, labels, p.cost, expected);
  for (int i = 0; i < 12000; ++i)
    for (int f = 0; f < labels; ++f) {
      ASSERT_LE(p.cost(i, start[i]), p.cost(i, f));
      if (f < start[i]) {
        ASSERT_LT(p.cost(i, start[i]), p.cost(i, f));
      }
    }
  for (int threads : {0, 2, 3, 7}) {
    Alpha_expansion_options options;
    options.threads = threads;
    Labels labelling = cheapest_labels(12000, labels, p.cost, threads);
    EXPECT_EQ(labelling, start);
    const auto other = alpha_expansion(p.graph, labels, Blockwise_cost{p.cost}, labelling, options);
    EXPECT_EQ(labelling, expected);
    EXPECT_EQ(other.energy, result.energy);
    EXPECT_EQ(other.survivors, result.survivors);
  }
}

TEST(Parallel_ranges, cover_everything_once_and_pass_exceptions_on)
{
  for (int n : {0, 1, 5, 1000})
    for (int parts : {1, 2, 3, 8}) {
      std::vector<int> count(n, 0);
      internal::parallel_ranges(n, parts, [&](int, int first, int last) {
        for (int i = first; i < last; ++i) ++count[i];
      });
      EXPECT_EQ(count, std::vector<int>(n, 1));
    }
  for (int bad : {0, 1, 2})
    EXPECT_THROW(internal::parallel_ranges(9, 3,
                                           [&](int part, int, int) {
                                             if (part == bad) throw std::bad_alloc();
                                           }),
                 std::bad_alloc);
}

} // namespace
