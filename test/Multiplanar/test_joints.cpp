// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_checks.h"

using namespace Multiplanar_test;

namespace {

TEST(Joints, connectors_on_hand_made_solids)
{
  for (const auto& complex :
       {box(60, 70, 80), l_prism(40, 50), ring(120, 60, 60), dodecahedron(50), triangle_panels(tetrahedron(), 60),
        triangle_panels(octahedron(), 80), triangle_panels(icosahedron(), 80), stellated(octahedron(), 0.9, 80)}) {
    SCOPED_TRACE(complex.number_of_panels());
    const auto joined = make_joined_parts(turned(complex), options_for(Joint_mode::automatic));
    const auto count = expect_sound(turned(complex), joined);
    EXPECT_EQ(count[0], complex.number_of_edges()) << "all edges are long enough for connectors";
  }
}

TEST(Joints, mode_edge_by_edge)
{
  const auto complex = box(60, 60, 60);
  Joint_options options = options_for(Joint_mode::automatic);
  for (int e = 0; e < 12; ++e)
    options.mode_of_edge.push_back(e % 3 == 0   ? Joint_mode::teeth
                                   : e % 3 == 1 ? Joint_mode::connectors
                                                : Joint_mode::none);
  const auto joined = make_joined_parts(complex, options);
  expect_sound(complex, joined);
  for (int e = 0; e < 12; ++e)
    EXPECT_EQ(joined.joints[e].kind, e % 3 == 0   ? Edge_joint::Kind::teeth
                                     : e % 3 == 1 ? Edge_joint::Kind::connector
                                                  : Edge_joint::Kind::none)
        << joined.joints[e].reason;
  options.mode_of_edge.pop_back();
  EXPECT_THROW(make_joined_parts(complex, options), std::invalid_argument);
}

TEST(Joints, sound_on_random_polyhedra)
{
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    const auto complex = random_convex(25 + 20 * int(seed), 100, seed);
    const auto count = expect_sound(complex, make_joined_parts(complex, options_for(Joint_mode::automatic)));
    EXPECT_LT(count[2], complex.number_of_edges() / 5);
  }
  const auto bumpy = triangle_panels(bumpy_sphere(2, 0.28), 120);
  const auto count = expect_sound(bumpy, make_joined_parts(bumpy, options_for(Joint_mode::automatic)));
  EXPECT_EQ(count[2], 0);
}

/// Panels hardly larger than a few slots: connectors are in each other's way, move aside, or leave an edge to teeth.
TEST(Joints, sound_where_there_is_hardly_room)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto complex = random_convex(30, 45, seed);
    const auto count = expect_sound(complex, make_joined_parts(complex, options_for(Joint_mode::automatic)));
    EXPECT_GT(count[0], 0);
    EXPECT_GT(count[1], 0);
  }
}

/// An hourglass: its top and bottom fall apart at the neck.
TEST(Joints, ids_of_pieces)
{
  const auto complex = prism({{{0, 0}, {100, 0}, {52, 50}, {100, 100}, {0, 100}, {48, 50}}}, 20);
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::automatic));
  expect_sound(complex, joined);
  std::vector<std::string> ids;
  for (const Part& part : joined.parts)
    if (part.kind == Part::Kind::panel) ids.push_back(part.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"P01a", "P01b", "P02a", "P02b", "P03", "P04", "P05", "P06", "P07", "P08"}));
  EXPECT_EQ(joined.warnings.size(), 2u);
  for (const auto& w : joined.warnings) EXPECT_NE(w.find("falls apart into 2 pieces (P0"), std::string::npos) << w;
  const auto connector =
      std::find_if(joined.parts.begin(), joined.parts.end(), [](const Part& p) { return p.id == "C001"; });
  EXPECT_NE(connector, joined.parts.end());
}

TEST(Joints, is_deterministic)
{
  const auto complex = random_convex(40, 100, 9);
  const auto a = make_joined_parts(complex, options_for(Joint_mode::automatic));
  const auto b = make_joined_parts(complex, options_for(Joint_mode::automatic));
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    EXPECT_EQ(a.parts[i].id, b.parts[i].id);
    EXPECT_EQ(a.parts[i].outline, b.parts[i].outline);
    EXPECT_EQ(a.parts[i].holes, b.parts[i].holes);
  }
}

} // namespace
