// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_checks.h"

using namespace Multiplanar_test;

namespace {

TEST(Connector_profile, shape)
{
  for (double degrees : {15., 30., 45., 60., 89., 90., 91., 120., 150., 179., 180., 181., 225., 270., 285.}) {
    SCOPED_TRACE(degrees);
    const double theta = radians(degrees);
    ASSERT_STREQ(connector_obstacle(theta, t, t + 1), "");
    for (const Connector_size& size : Joint_options().sizes) {
      const auto profile = connector_profile(theta, t, t + 1, size);
      EXPECT_TRUE(internal::is_simple_loop(profile.outline, CGAL::COUNTERCLOCKWISE));
      EXPECT_NEAR(profile.slot_end - profile.slot_start, size.tab_width * t, 1e-12);
      double area = 2 * size.tab_width * t * t;
      const Vector_3 far_face(std::sin(theta), -std::cos(theta), 0); // inner normal of the second panel
      for (const Outline& piece : profile.body) {
        EXPECT_TRUE(internal::is_convex(piece));
        area += twice_signed_area(piece) / 2;
        // Beyond the inner faces: below 180 degrees of both panels, above of either (the other one's sheet and all that
        // is outside then lie beyond the line of that face).
        double below[2] = {1e300, 1e300};
        for (const Point_2& p : piece) {
          below[0] = (std::min)(below[0], p.y());
          below[1] = (std::min)(below[1], far_face * Vector_3(p.x(), p.y(), 0));
        }
        EXPECT_GE(degrees <= 180 ? (std::min)(below[0], below[1]) : (std::max)(below[0], below[1]), t - 1e-9);
      }
      EXPECT_NEAR(area, twice_signed_area(profile.outline) / 2, 1e-9) << "body and tabs make up the outline";
      Outline mirror;
      for (const Point_2& p : profile.outline) mirror.push_back(internal::mirrored(p, theta));
      EXPECT_LT(distance(mirror, profile.outline), 1e-9);
      for (const auto& tab : profile.tabs) EXPECT_EQ(tab[1] - tab[0], 3);
    }
  }
}

TEST(Connector_profile, limit_above_270_degrees)
{
  // (t + 1) tan(theta - 270) <= t / 2: up to 20.556 degrees at 3 mm
  EXPECT_STREQ(connector_obstacle(radians(290.5), 3, 4), "");
  EXPECT_STRNE(connector_obstacle(radians(290.6), 3, 4), "");
  EXPECT_STRNE(connector_obstacle(radians(5), 3, 4), "");
}

TEST(Slot_room, distance_agrees_with_sampling)
{
  std::mt19937_64 random(11);
  const internal::Edge_in_panel edge{0, Point_2(0, 0), internal::Vector_2(1, 0), internal::Vector_2(0, 1)};
  for (int n = 0; n < 500; ++n) {
    const internal::Slot slot{0, 1 + uniform(random), 0, 1 + 2 * uniform(random)};
    const Point_2 a(8 * uniform(random) - 3, 8 * uniform(random) - 3),
        b(8 * uniform(random) - 3, 8 * uniform(random) - 3);
    double least = 1e300;
    for (int i = 0; i <= 2000; ++i) {
      const Point_2 p = a + (i / 2000.) * (b - a);
      least = (std::min)(least, internal::distance_to_slot(slot, p.x(), p.y()));
    }
    EXPECT_NEAR(internal::distance_to_slot(slot, edge, a, b), least, 1e-2);
  }
}

/// Random flat blocks: the projection test must agree with a search for separating planes.
TEST(Block, apart_or_not)
{
  std::mt19937_64 random(5);
  int apart = 0, sure = 0;
  const int trials = 400;
  const auto block = [&] {
    const Vector_3 n(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
    Frame frame;
    frame.normal = n / std::sqrt(n.squared_length());
    frame.u = CGAL::cross_product(frame.normal, Vector_3(0.3, 0.5, 0.8));
    frame.u = frame.u / std::sqrt(frame.u.squared_length());
    frame.v = CGAL::cross_product(frame.normal, frame.u);
    frame.origin = Point_3(12 * uniform(random), 12 * uniform(random), 12 * uniform(random));
    Outline triangle{Point_2(0, 0), Point_2(4 + 4 * uniform(random), 0),
                     Point_2(3 * uniform(random), 4 + 4 * uniform(random))};
    return internal::Block(frame, {triangle}, 0, 2);
  };
  for (int n = 0; n < trials; ++n) {
    const internal::Block a = block(), b = block();
    const auto solid = [](const internal::Block& x) {
      Points base;
      for (const Point_2& p : x.pieces[0]) base.push_back(x.frame(p));
      return Convex_solid(base, -2 * x.frame.normal);
    };
    const bool meet = interiors_meet(solid(a), solid(b));
    EXPECT_EQ(internal::exactly_apart(a, b), !meet) << n;
    EXPECT_EQ(internal::exactly_apart(b, a), !meet) << n;
    if (internal::surely_apart(a, b, 0.1)) {
      EXPECT_FALSE(meet);
      ++sure;
    }
    apart += !meet;
  }
  EXPECT_GT(sure, 0.8 * apart);
  EXPECT_GT(apart, trials / 10);
  EXPECT_LT(apart, trials * 9 / 10);
}

TEST(Connectors, acute_right_obtuse_and_reflex_connectors)
{
  for (double degrees : {30., 60., 89., 90., 91., 135., 165., 178., 200., 240., 270., 285.}) {
    SCOPED_TRACE(degrees);
    const auto complex = wedge(degrees, 120, 100);
    Joint_options options = options_for(Joint_mode::connectors);
    const auto joined = make_joined_parts(complex, options);
    expect_sound(complex, joined);
    for (int e = 0; e < complex.number_of_edges(); ++e)
      if (std::abs(complex.dihedral(e) - degrees) < 1e-6 && std::abs(complex.edge_vector(e).z()) > 50 &&
          complex.corners[complex.edges[e].corners[0]].point.x() == 0) {
        EXPECT_EQ(joined.joints[e].kind, Edge_joint::Kind::connector) << joined.joints[e].reason;
        EXPECT_EQ(joined.joints[e].parts.size(), 2u) << "one for every 45 mm of 100";
      }
  }
}

TEST(Connectors, overhang_above_the_limit_has_no_connector)
{
  const auto complex = wedge(320, 120, 100);
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::automatic));
  expect_sound(complex, joined);
  int unjoined = 0;
  for (const Edge_joint& joint : joined.joints)
    if (joint.kind == Edge_joint::Kind::none) {
      ++unjoined;
      EXPECT_NE(joint.reason.find("overhang"), std::string::npos) << joint.reason;
    }
  EXPECT_EQ(unjoined, 1);
}

/// One for every 15 thicknesses of the edge, from one to four.
TEST(Connectors, more_on_longer_edges)
{
  const auto complex = box(60, 110, 300);
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::connectors));
  expect_sound(complex, joined);
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const double length = complex.edge_length(e);
    EXPECT_EQ(joined.joints[e].parts.size(), length < 70 ? 1u : length < 120 ? 2u : 4u) << length;
  }
}

/// The sheets of a flat box leave 10 mm between them: the connectors along its top and its bottom edges, 6 mm deep and
/// more, must get out of each other's way.
TEST(Connectors, run_into_nothing_in_a_flat_box)
{
  for (double height : {12., 16., 22., 30.}) {
    SCOPED_TRACE(height);
    const auto complex = box(120, 80, height);
    expect_sound(complex, make_joined_parts(complex, options_for(Joint_mode::automatic)));
  }
}

} // namespace
