// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/internal/Joint_room.h>
#include <CGAL/Multiplanar/joints.h>

#include "polyhedra.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using internal::Joint_room;

namespace {

Joint_room::Lack lack_of(const Panel_complex& complex, double thickness)
{
  return Joint_room(thickness).lack(internal::complex_topology(complex), internal::flat_state(complex));
}

/// The share of the length of the edges longer than five thicknesses that has no joint: the slow twin.
double true_lack(const Panel_complex& complex, double thickness)
{
  Joint_options options;
  options.thickness = thickness;
  const Joints joints = make_joints(complex, options);
  double all = 0, none = 0;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const double length = std::sqrt(complex.edge_vector(e).squared_length());
    if (length <= 5 * thickness) continue;
    all += length;
    if (joints.joints[e].kind == Edge_joint::Kind::none) none += length;
  }
  return all > 0 ? none / all : 0;
}

} // namespace

TEST(Joint_room, WideBoxesHaveRoomAtEveryEdge)
{
  EXPECT_EQ(lack_of(box(100, 80, 60), 3).share, 0);
  EXPECT_TRUE(lack_of(box(100, 80, 60), 3).edges.empty());
  EXPECT_EQ(true_lack(box(100, 80, 60), 3), 0);
}

TEST(Joint_room, NothingIsAskedWithoutAThickness) { EXPECT_EQ(lack_of(wedge(3, 100, 40), 0).share, 0); }

TEST(Joint_room, FindsTheEdgesOfPanelsThatAreTooNarrow)
{
  const Panel_complex thin = box(100, 5, 60); // the long sides of the narrow panels are truncated away
  const auto lack = lack_of(thin, 3);
  EXPECT_GT(lack.share, 0.5);
  EXPECT_GE(true_lack(thin, 3), 0.5);
  for (std::size_t i = 1; i < lack.edges.size(); ++i)
    EXPECT_GE(thin.edge_vector(lack.edges[i - 1]).squared_length(), thin.edge_vector(lack.edges[i]).squared_length());
}

TEST(Joint_room, FindsEdgesThatOverhangTooMuch)
{
  for (double degrees : {230., 280., 300., 330.}) {
    const Panel_complex notch = wedge(degrees, 100, 60);
    EXPECT_EQ(lack_of(notch, 3).share > 0, degrees > 290.6) << degrees;
    EXPECT_EQ(true_lack(notch, 3) > 0, degrees > 290.6) << degrees;
  }
}

TEST(Joint_room, DoesNotDependOnUnits)
{
  for (double scale : {1e-3, 1., 1e3}) {
    const auto lack = lack_of(scaled(wedge(17, 100, 20), scale), 3 * scale);
    EXPECT_NEAR(lack.share, lack_of(wedge(17, 100, 20), 3).share, 1e-9);
  }
}

/// It is a guess, but it must be a good one where panels are as they usually are.
TEST(Joint_room, AgreesWithTheJointsThatAreMade)
{
  const double sizes[] = {10, 15, 25, 60};
  for (double a : sizes)
    for (double b : sizes) {
      const Panel_complex complex = box(90, a, b);
      EXPECT_NEAR(lack_of(complex, 3).share, true_lack(complex, 3), 0.35) << a << " x " << b;
    }
  for (double degrees : {23., 40., 60., 75.}) {
    const Panel_complex complex = wedge(degrees, 90, 50);
    EXPECT_NEAR(lack_of(complex, 3).share, true_lack(complex, 3), 0.35) << degrees;
  }
}
