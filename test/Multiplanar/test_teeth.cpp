// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_checks.h"

#include <sstream>

using namespace Multiplanar_test;

namespace {

/// A tab begins and ends with a flank, and all flanks of one tooth are parallel, in opposite directions.
void expect_flanks(const Part& part)
{
  const int n = int(part.outline.size());
  for (const auto& tab : part.tabs) {
    const auto first = part.outline[(tab[0] + 1) % n] - part.outline[tab[0]];
    const auto last = part.outline[tab[1]] - part.outline[(tab[1] + n - 1) % n];
    const double lengths = std::sqrt(first.squared_length() * last.squared_length());
    EXPECT_NEAR((first.x() * last.y() - first.y() * last.x()) / lengths, 0, 1e-3) << part.id;
    EXPECT_LT(first * last, 0) << part.id;
    EXPECT_GE((tab[1] - tab[0] + n) % n, 3) << part.id;
  }
}

/// A line for each edge without a joint.
std::string reasons(const Panel_complex& complex, const Joined_parts& joined)
{
  std::ostringstream lines;
  for (int e = 0; e < complex.number_of_edges(); ++e)
    if (joined.joints[e].kind == Edge_joint::Kind::none)
      lines << complex.edge_length(e) << " mm, " << complex.dihedral(e) << " degrees: " << joined.joints[e].reason
            << '\n';
  return lines.str();
}

TEST(Teeth, on_every_edge_that_is_long_and_sharp_enough)
{
  for (const auto& complex : {box(40, 50, 60), dodecahedron(40), triangle_panels(octahedron(), 60),
                              triangle_panels(tetrahedron(), 50), random_convex(30, 100, 3)}) {
    SCOPED_TRACE(complex.number_of_panels());
    const auto joined = make_joined_parts(turned(complex), options_for(Joint_mode::teeth));
    const auto count = expect_sound(turned(complex), joined);
    EXPECT_EQ(count[0], 0);
    for (int e = 0; e < complex.number_of_edges(); ++e) // too short and too flat ones may do without
      if (complex.edge_length(e) >= 3 * t && tooth_strip(radians(complex.dihedral(e)), t).depth() >= 0.8)
        EXPECT_EQ(joined.joints[e].kind, Edge_joint::Kind::teeth) << reasons(complex, joined);
    for (const Part& part : joined.parts) expect_flanks(part);
  }
}

TEST(Teeth, where_connectors_have_no_room)
{
  const auto complex = box(16, 16, 16); // a slot of 3 x 3 mm needs 4.5 mm around it, and 3 mm for the neighbour's sheet
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::automatic));
  const auto count = expect_sound(complex, joined);
  EXPECT_EQ(count[1], 12);
}

/// Teeth are t sin(theta) deep: 0.8 mm up to 164.53 degrees at 3 mm.
TEST(Teeth, only_where_they_are_deep_enough)
{
  for (double degrees : {30., 60., 90., 120., 150., 164., 165.}) {
    SCOPED_TRACE(degrees);
    const auto complex = wedge(degrees, 120, 100);
    const auto joined = make_joined_parts(complex, options_for(Joint_mode::teeth));
    expect_sound(complex, joined);
    for (int e = 0; e < complex.number_of_edges(); ++e)
      if (std::abs(complex.dihedral(e) - degrees) < 1e-6 && std::abs(complex.edge_vector(e).z()) > 50 &&
          complex.corners[complex.edges[e].corners[0]].point.x() == 0) {
        EXPECT_EQ(joined.joints[e].kind, degrees < 164.5 ? Edge_joint::Kind::teeth : Edge_joint::Kind::none);
        EXPECT_EQ(joined.joints[e].reason.empty(), degrees < 164.5) << joined.joints[e].reason;
      }
  }
}

/// A box with a notch out of one of its long edges: its top and front share two edges on one line, one of 4 mm, which
/// is too short for teeth, and one of 60 mm.
Panel_complex notched_box()
{
  const double x[] = {0, 4, 40, 100}, y[] = {0, 12, 60}, z[] = {0, 28, 40};
  const Points points = {
      {x[0], y[0], z[0]}, {x[3], y[0], z[0]}, {x[3], y[2], z[0]}, {x[0], y[2], z[0]}, // 0-3 bottom
      {x[0], y[2], z[2]}, {x[3], y[2], z[2]}, {x[3], y[0], z[2]}, {x[0], y[0], z[2]}, // 4-7 top
      {x[1], y[0], z[2]}, {x[2], y[0], z[2]},                                         // 8, 9 where the edge ends
      {x[1], y[1], z[2]}, {x[2], y[1], z[2]}, {x[1], y[1], z[1]}, {x[2], y[1], z[1]}, // 10-13 the back of the notch
      {x[1], y[0], z[1]}, {x[2], y[0], z[1]}};                                        // 14, 15
  return make_panel_complex_from_polygons(points, {{{0, 3, 2, 1}},
                                                   {{7, 8, 10, 11, 9, 6, 5, 4}},
                                                   {{0, 1, 6, 9, 15, 14, 8, 7}},
                                                   {{1, 2, 5, 6}},
                                                   {{2, 3, 4, 5}},
                                                   {{3, 0, 7, 4}},
                                                   {{10, 12, 13, 11}},
                                                   {{14, 15, 13, 12}},
                                                   {{8, 14, 12, 10}},
                                                   {{9, 11, 13, 15}}});
}

/// Teeth beside the long edge were claimed by the short one.
TEST(Teeth, two_edges_of_one_pair_on_one_line_do_not_share_teeth)
{
  const auto complex = notched_box();
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::teeth));
  expect_sound(complex, joined);
  int edges = 0;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    if (complex.edges[e].panels != std::array<int, 2>{{1, 2}} && complex.edges[e].panels != std::array<int, 2>{{2, 1}})
      continue;
    ++edges;
    EXPECT_EQ(joined.joints[e].kind, complex.edge_length(e) > 50 ? Edge_joint::Kind::teeth : Edge_joint::Kind::none);
  }
  EXPECT_EQ(edges, 2);
  for (const Part& part : joined.parts) { // no tooth twice
    auto tabs = part.tabs;
    std::sort(tabs.begin(), tabs.end());
    EXPECT_EQ(std::adjacent_find(tabs.begin(), tabs.end()), tabs.end()) << part.id;
  }
}

TEST(Teeth, neither_teeth_nor_connectors)
{
  const auto flat = wedge(170, 60, 60); // teeth would be 0.52 mm deep
  for (const auto& joint : make_joined_parts(flat, options_for(Joint_mode::teeth)).joints)
    if (joint.kind == Edge_joint::Kind::none) EXPECT_NE(joint.reason.find("flat"), std::string::npos) << joint.reason;
  const auto reflex = make_joined_parts(wedge(225, 60, 60), options_for(Joint_mode::teeth));
  EXPECT_EQ(std::count_if(reflex.joints.begin(), reflex.joints.end(),
                          [](const Edge_joint& j) { return j.reason.find("reflex") != std::string::npos; }),
            1);
  for (const auto& joint : make_joined_parts(box(60, 60, 60), options_for(Joint_mode::none)).joints)
    EXPECT_EQ(joint.kind, Edge_joint::Kind::none);
}

} // namespace
