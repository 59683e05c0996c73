// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Orders of assembly: what is promised of every step, on solids made without the code that found the order; and whether
// an order is found exactly where one exists, by trying all.

#include <CGAL/Multiplanar/assembled_parts.h>

#include "digital_assembly.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace Multiplanar_test;
using namespace CGAL::Multiplanar;

constexpr double t = 3, last = t + 1; // mm

Joint_options options_for(Joint_mode mode)
{
  Joint_options options;
  options.thickness = t;
  options.mode = mode;
  return options;
}

struct Named_model
{
  std::string name;
  Panel_complex complex;
};

std::vector<Named_model> small_models()
{
  return {{"cube", turned(box(60, 60, 60))},
          {"octahedron", turned(triangle_panels(octahedron(), 60))},
          {"L", l_prism(50, 40)},
          {"dodecahedron", dodecahedron(45)},
          {"ring", ring(120, 50, 30)},
          {"star", stellated(octahedron(), 40, 70)}};
}

/// The parts moved by `offset`.
std::vector<Convex_solid> solids_at(const Part& part, const Vector_3& offset)
{
  Part moved = part;
  moved.frame.origin = part.frame.origin + offset;
  return solids(moved, t);
}

bool any_meet(const std::vector<Convex_solid>& a, const std::vector<Convex_solid>& b)
{
  for (const auto& s : a)
    for (const auto& q : b)
      if (Multiplanar_test::interiors_meet(s, q)) return true;
  return false;
}

/// Sampled positions of a motion that ends in place: does anything that moves meet anything that stands?
bool meets_on_its_way(const std::vector<Part>& parts, const std::vector<int>& moving, const Vector_3& direction,
                      double way, const std::vector<int>& standing, int samples)
{
  for (const int p : moving)
    for (int s = 0; s <= samples; ++s) {
      const auto there = solids_at(parts[p], -(way * s / samples) * direction);
      for (const int q : standing)
        if (any_meet(there, solids(parts[q], t))) return true;
    }
  return false;
}

/// Every promise about the steps, but that the way between samples is free.
void expect_good_steps(const Joined_parts& joined, const std::vector<Assembly_step>& steps, int samples)
{
  std::vector<int> placed;
  for (const Assembly_step& step : steps) {
    ASSERT_FALSE(step.parts.empty());
    EXPECT_NEAR(step.direction.squared_length(), 1, 1e-12);
    EXPECT_GE(step.travel, last);
    const Part& first = joined.parts[step.parts[0]];
    if (first.kind == Part::Kind::panel) EXPECT_EQ(step.direction, -first.frame.normal);
    for (std::size_t i = 1; i < step.parts.size(); ++i) {
      const auto& hosts = joined.hosts[step.parts[i]];
      EXPECT_TRUE(hosts[0] == step.parts[0] || hosts[1] == step.parts[0]);
    }
    if (first.kind == Part::Kind::connector) {
      const auto& hosts = joined.hosts[step.parts[0]];
      const auto is_placed = [&](int p) { return std::find(placed.begin(), placed.end(), p) != placed.end(); };
      EXPECT_NE(is_placed(hosts[0]), is_placed(hosts[1])) << first.id;
    }
    EXPECT_FALSE(meets_on_its_way(joined.parts, step.parts, step.direction, step.travel, placed, samples)) << first.id;
    if (step.approach) {
      // From outside to where the travel begins.
      const Vector_3 out = -step.travel * step.direction;
      for (const int p : step.parts)
        for (int s = 0; s <= samples; ++s) {
          const auto there = solids_at(joined.parts[p], out - (300. * s / samples) * *step.approach);
          for (const int q : placed) EXPECT_FALSE(any_meet(there, solids(joined.parts[q], t))) << first.id;
        }
    }
    placed.insert(placed.end(), step.parts.begin(), step.parts.end());
  }
  std::sort(placed.begin(), placed.end());
  std::vector<int> all(joined.parts.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(placed, all) << "every part once";
}

TEST(Assembly, steps_of_small_models_are_free_at_sampled_positions)
{
  for (const auto& model : small_models()) {
    SCOPED_TRACE(model.name);
    const Assembled_parts assembled = make_assembled_parts(model.complex, options_for(Joint_mode::automatic));
    ASSERT_FALSE(assembled.steps.empty());
    expect_good_steps(assembled.joined, assembled.steps, 8);
  }
}

/// How many groups the connectors hold together, single panels without any aside.
int joined_groups(const Joined_parts& joined)
{
  std::vector<int> group(joined.parts.size());
  std::iota(group.begin(), group.end(), 0);
  std::set<int> with_joints;
  for (const auto& hosts : joined.hosts) {
    if (hosts[0] < 0) continue;
    with_joints.insert(hosts.begin(), hosts.end());
    const int from = group[hosts[0]], to = group[hosts[1]];
    std::replace(group.begin(), group.end(), from, to);
  }
  std::set<int> groups;
  for (const int p : with_joints) groups.insert(group[p]);
  return int(groups.size());
}

/// Panels that have connectors, none of which leads to a panel placed before.
int unheld_panels(const Assembled_parts& assembled)
{
  std::set<int> placed;
  int unheld = 0;
  for (const Assembly_step& step : assembled.steps) {
    const int unit = step.parts[0];
    bool has_joints = false, is_held = false;
    for (const auto& hosts : assembled.joined.hosts)
      for (int side = 0; side < 2; ++side)
        if (hosts[side] == unit) {
          has_joints = true;
          is_held = is_held || placed.count(hosts[1 - side]) > 0;
        }
    unheld += has_joints && !is_held;
    placed.insert(unit);
  }
  return unheld;
}

TEST(Assembly, a_large_panel_is_the_base_and_every_other_is_held_by_one_that_is_placed)
{
  for (const auto& model : small_models()) {
    SCOPED_TRACE(model.name);
    const Assembled_parts assembled = make_assembled_parts(model.complex, options_for(Joint_mode::connectors));
    ASSERT_FALSE(assembled.steps.empty());
    const auto& parts = assembled.joined.parts;
    const double base = parts[assembled.steps[0].parts[0]].area();
    for (const Part& part : parts) EXPECT_GE(base, part.area() - 1e-9);
    if (assembled.joined.overhangs.empty()) // these may force another order
      EXPECT_EQ(unheld_panels(assembled), joined_groups(assembled.joined)) << "one to begin every group with";
  }
}

TEST(Assembly, whole_columns_of_a_convex_model_are_free)
{
  const Assembled_parts assembled = make_assembled_parts(dodecahedron(60), options_for(Joint_mode::teeth));
  for (const Assembly_step& step : assembled.steps) {
    EXPECT_GT(step.travel, 100);
    ASSERT_TRUE(step.approach);
    EXPECT_EQ(*step.approach, step.direction);
  }
}

// All orders, one by one.

/// By the rules of an order alone: units one after another, connectors with the host that comes first, or put in from
/// inside right after it. Motions are judged on sampled positions.
class Brute_force
{
public:
  explicit Brute_force(const Joined_parts& joined) : joined(joined)
  {
    for (int p = 0; p < int(joined.parts.size()); ++p) all_solids.push_back(solids(joined.parts[p], t));
  }

  bool exists()
  {
    std::vector<int> units;
    for (int p = 0; p < int(joined.parts.size()); ++p)
      if (joined.hosts[p][0] < 0) units.push_back(p);
    do
      if (is_order(units)) return true;
    while (std::next_permutation(units.begin(), units.end()));
    return false;
  }

  bool is_order(const std::vector<int>& units)
  {
    std::vector<int> placed;
    for (const int unit : units)
      if (!place(unit, placed)) return false;
    return true;
  }

private:
  bool place(int unit, std::vector<int>& placed)
  {
    if (!is_free(unit, unit, placed, 1)) return false;
    std::vector<int> with_it{unit};
    std::vector<int> own;
    for (int c = 0; c < int(joined.parts.size()); ++c) {
      const auto& hosts = joined.hosts[c];
      if (hosts[0] != unit && hosts[1] != unit) continue;
      const int other = hosts[0] == unit ? hosts[1] : hosts[0];
      if (std::find(placed.begin(), placed.end(), other) == placed.end()) own.push_back(c);
    }
    for (const int c : own) {
      if (!is_free(c, unit, placed, 1)) {
        std::vector<int> there = placed;
        there.push_back(unit);
        for (const int d : own)
          if (d != c) there.push_back(d);
        if (!is_free(c, unit, there, -1)) return false;
      }
      with_it.push_back(c);
    }
    placed.insert(placed.end(), with_it.begin(), with_it.end());
    return true;
  }

  bool is_free(int part, int host, const std::vector<int>& there, double sign)
  {
    return std::none_of(there.begin(), there.end(), [&](int p) { return hits(part, host, p, sign); });
  }

  /// Does `part` hit `obstacle` when it comes along the normal of `host`? Remembered.
  bool hits(int part, int host, int obstacle, double sign)
  {
    const auto key = std::make_tuple(part, host, obstacle, sign > 0);
    const auto known = answers.find(key);
    if (known != answers.end()) return known->second;
    bool hit = false;
    for (int s = 0; s <= 8 && !hit; ++s)
      hit = any_meet(solids_at(joined.parts[part], sign * last * s / 8 * joined.parts[host].frame.normal),
                     all_solids[obstacle]);
    return answers[key] = hit;
  }

  const Joined_parts& joined;
  std::vector<std::vector<Convex_solid>> all_solids;
  std::map<std::tuple<int, int, int, bool>, bool> answers;
};

/// A box with a groove whose sides hang over each other: `lean` degrees, `mouth` mm wide above.
Panel_complex groove(double lean, double mouth, double depth)
{
  const double d = depth * std::tan(radians(lean));
  return prism({{{0, 0},
                 {160, 0},
                 {160, 60},
                 {80 + mouth / 2, 60},
                 {80 + mouth / 2 + d, 60 - depth},
                 {80 - mouth / 2 - d, 60 - depth},
                 {80 - mouth / 2, 60},
                 {0, 60}}},
               50);
}

TEST(Assembly, an_order_is_found_exactly_where_one_exists)
{
  std::vector<Named_model> models = small_models();
  models.erase(std::remove_if(models.begin(), models.end(),
                              [](const Named_model& m) { return m.complex.number_of_panels() > 8; }),
               models.end());
  int without = 0;
  for (const Joint_mode mode : {Joint_mode::none, Joint_mode::connectors, Joint_mode::automatic})
    for (const auto& model : models) {
      SCOPED_TRACE(model.name);
      const Joined_parts joined = make_joined_parts(model.complex, options_for(mode));
      const Assembly_order order = assembly_order(model.complex, joined, t);
      Brute_force all(joined);
      EXPECT_EQ(!order.steps.empty(), all.exists());
      without += order.steps.empty();
      std::vector<int> units;
      for (const auto& step : order.steps)
        if (joined.hosts[step.parts[0]][0] < 0) units.push_back(step.parts[0]);
      if (!order.steps.empty()) EXPECT_TRUE(all.is_order(units));
    }
  EXPECT_EQ(without, 0);
}

/// Parts that cannot be put together, made by hand: two plates in the way of each other, held in a common step by none.
Joined_parts interlocked(bool by_connector)
{
  const auto plate = [](const std::string& id, const Frame& frame, const Outline& outline) {
    Part part;
    part.id = id;
    part.frame = frame;
    part.outline = outline;
    return part;
  };
  const Frame up{Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)};
  const Frame down{Point_3(0, 0, -10), Vector_3(0, 1, 0), Vector_3(1, 0, 0), Vector_3(0, 0, -1)};
  const Outline square{Point_2(0, 0), Point_2(50, 0), Point_2(50, 50), Point_2(0, 50)};
  Joined_parts joined;
  // `a` comes from above to z = 0, `b` from below to z = -10; the connector reaches below b and above a.
  joined.parts = {plate("P01", up, square), plate("P02", down, square)};
  joined.edge_of_part = {-1, -1};
  joined.panel_of_part = {0, 1};
  joined.hosts = {{{-1, -1}}, {{-1, -1}}};
  joined.joints.resize(1);
  if (by_connector) {
    // Upright at x = 20: a body between the plates and bars outside of both, beyond their sides.
    Part c = plate("C001", {Point_3(20, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1), Vector_3(1, 0, 0)},
                   {Point_2(-3, -14), Point_2(5, -14), Point_2(5, -11), Point_2(-1, -11), Point_2(-1, 1), Point_2(5, 1),
                    Point_2(5, 4), Point_2(-3, 4)});
    c.kind = Part::Kind::connector;
    joined.parts.push_back(c);
    joined.edge_of_part.push_back(0);
    joined.panel_of_part.push_back(-1);
    joined.hosts.push_back({{0, 1}});
    joined.joints[0].kind = Edge_joint::Kind::connector;
    joined.joints[0].parts = {"C001"};
  }
  return joined;
}

Panel_complex two_panels_with_an_edge()
{
  Panel_complex complex;
  complex.panels.resize(2);
  complex.edges.resize(1);
  complex.edges[0].panels = {{0, 1}};
  return complex;
}

TEST(Assembly, an_edge_whose_connector_is_in_the_way_is_named)
{
  const Panel_complex complex = two_panels_with_an_edge();
  EXPECT_EQ(assembly_order(complex, interlocked(false), t).steps.size(), 2u);
  const Joined_parts joined = interlocked(true);
  EXPECT_FALSE(Brute_force(joined).exists());
  const Assembly_order order = assembly_order(complex, joined, t);
  EXPECT_TRUE(order.steps.empty());
  EXPECT_EQ(order.blocking_edges, std::vector<int>{0});
  EXPECT_TRUE(order.stuck_parts.empty());
}

TEST(Assembly, panels_that_are_in_each_others_way_are_named)
{
  Joined_parts joined = interlocked(false);
  joined.parts[1].frame.origin = Point_3(0, 0, 3.5); // each in the column before the other
  joined.parts[1].frame.normal = Vector_3(0, 0, -1);
  const Assembly_order order = assembly_order(two_panels_with_an_edge(), joined, t);
  EXPECT_TRUE(order.steps.empty());
  EXPECT_EQ(order.stuck_parts, (std::vector<int>{0, 1}));
}

TEST(Assembly, panels_that_overhang_each_other_are_cut_free_in_the_end)
{
  for (const double lean : {30., 55., 70.}) {
    SCOPED_TRACE(lean);
    const Panel_complex complex = groove(lean, 8, 12);
    const Assembled_parts assembled = make_assembled_parts(complex, options_for(Joint_mode::automatic));
    ASSERT_FALSE(assembled.steps.empty());
    expect_good_steps(assembled.joined, assembled.steps, 4);
  }
}

TEST(Assembly, all_is_the_same_in_a_second_run)
{
  const auto steps = [] {
    return make_assembled_parts(stellated(octahedron(), 40, 70), options_for(Joint_mode::automatic));
  };
  const Assembled_parts a = steps(), b = steps();
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    EXPECT_EQ(a.steps[i].parts, b.steps[i].parts);
    EXPECT_EQ(a.steps[i].travel, b.steps[i].travel);
  }
}

} // namespace
