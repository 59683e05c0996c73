// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/parts_from_joints.h>

#include "digital_assembly.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <random>

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

namespace {

const double t = 3;

Joint_options options_for(Joint_mode mode)
{
  Joint_options options;
  options.thickness = t;
  options.mode = mode;
  return options;
}

double distance(const Point_2& p, const Point_2& a, const Point_2& b)
{
  return std::sqrt(CGAL::squared_distance(p, CGAL::Multiplanar::Kernel::Segment_2(a, b)));
}

/// The least distance between the boundaries of two polygons.
double distance(const Outline& first, const Outline& second)
{
  double least = 1e300;
  const auto to_sides = [&least](const Outline& points, const Outline& loop) {
    for (const Point_2& p : points)
      for (std::size_t i = 0; i < loop.size(); ++i)
        least = (std::min)(least, distance(p, loop[i], loop[(i + 1) % loop.size()]));
  };
  to_sides(first, second);
  to_sides(second, first);
  return least;
}

bool is_inside(const Outline& outline, const Point_2& p)
{
  return CGAL::bounded_side_2(outline.begin(), outline.end(), p) == CGAL::ON_BOUNDED_SIDE;
}

/// The outline of a tab or tooth as points of the model, at both faces of the sheet.
Points tab_corners(const Part& part, std::size_t tab)
{
  Points result;
  const int n = int(part.outline.size());
  for (int i = part.tabs[tab][0];; i = (i + 1) % n) {
    result.push_back(part.frame(part.outline[i]));
    result.push_back(part.frame(part.outline[i]) - t * part.frame.normal);
    if (i == part.tabs[tab][1]) return result;
  }
}

/// Does every tab of a connector fill a slot of a part of one of the panels of its edge, through the whole sheet?
void expect_tabs_in_slots(const Panel_complex& complex, const Joined_parts& joined, std::size_t index,
                          std::map<std::pair<int, int>, int>& slot_uses)
{
  const Part& connector = joined.parts[index];
  const auto& edge = complex.edges[joined.edge_of_part[index]];
  ASSERT_EQ(connector.tabs.size(), 2u);
  for (std::size_t tab = 0; tab < 2; ++tab) {
    const Points corners = tab_corners(connector, tab);
    ASSERT_EQ(corners.size(), 8u);
    int found = 0;
    for (std::size_t p = 0; p < joined.parts.size(); ++p) {
      if (joined.panel_of_part[p] != edge.panels[tab]) continue;
      const Part& part = joined.parts[p];
      for (std::size_t h = 0; h < part.holes.size(); ++h) {
        double off = 0; // every corner of the tab is at a corner of the slot, on the inner or the outer face
        for (const Point_3& c : corners) {
          const double depth = (part.frame.origin - c) * part.frame.normal;
          off = (std::max)(off, (std::min)(std::abs(depth), std::abs(depth - t)));
          double nearest = 1e300;
          for (const Point_2& q : part.holes[h])
            nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(q, part.frame.project(c))));
          off = (std::max)(off, nearest);
        }
        if (off > 1e-6) continue;
        ++found;
        ++slot_uses[{int(p), int(h)}];
      }
    }
    EXPECT_EQ(found, 1) << connector.id << " tab " << tab;
  }
}

/// Slots are exact rectangles, one thickness wide, inside their part with 1.5 thicknesses of material around.
void expect_good_slot(const Part& part, std::size_t h)
{
  const Outline& slot = part.holes[h];
  ASSERT_EQ(slot.size(), 4u);
  EXPECT_LT(twice_signed_area(slot), 0);
  double sides[4];
  for (int i = 0; i < 4; ++i) {
    const auto a = slot[(i + 1) % 4] - slot[i], b = slot[(i + 2) % 4] - slot[(i + 1) % 4];
    sides[i] = std::sqrt(a.squared_length());
    EXPECT_NEAR(a * b, 0, 1e-10);
  }
  EXPECT_NEAR((std::min)(sides[0], sides[1]), t, 1e-10);
  EXPECT_NEAR(sides[0], sides[2], 1e-10);
  EXPECT_TRUE(is_inside(part.outline, slot[0]));
  EXPECT_GE(distance(slot, part.outline), 1.5 * t) << part.id;
  for (std::size_t other = 0; other < part.holes.size(); ++other)
    if (other != h) EXPECT_GE(distance(slot, part.holes[other]), 1.5 * t) << part.id;
}

/// Who has material along the line half a thickness below both panels of an edge: 1, 2, both (3) or none (0), at
/// intervals of a tenth of a millimetre.
std::vector<int> owners(const Panel_complex& complex, const Joined_parts& joined, int e)
{
  const auto& edge = complex.edges[e];
  const double theta = radians(complex.dihedral(e)), below = t / 2 / std::sin(theta / 2);
  const Vector_3 n = complex.panels[edge.panels[0]].plane.normal + complex.panels[edge.panels[1]].plane.normal;
  const Vector_3 down = -below / std::sqrt(n.squared_length()) * n;
  const Point_3 start = complex.corners[edge.corners[0]].point + down;
  const int steps = int(complex.edge_length(e) / 0.1);
  std::vector<int> result;
  for (int i = 0; i <= steps; ++i) {
    const Point_3 x = start + (double(i) / steps) * complex.edge_vector(e);
    int owner = 0;
    for (std::size_t p = 0; p < joined.parts.size(); ++p)
      for (int side = 0; side < 2; ++side) {
        if (joined.panel_of_part[p] != edge.panels[side]) continue;
        const Part& part = joined.parts[p];
        const Point_2 q = part.frame.project(x);
        bool material = is_inside(part.outline, q);
        for (const Outline& hole : part.holes) material = material && !is_inside(hole, q);
        if (material) owner |= 1 << side;
      }
    result.push_back(owner);
  }
  return result;
}

/// The longest run of one owner between two of the other, in mm.
double widest_held_tooth(const std::vector<int>& owners)
{
  std::vector<std::pair<int, int>> runs; // owner, length
  for (int o : owners) {
    if (runs.empty() || runs.back().first != o) runs.push_back({o, 0});
    ++runs.back().second;
  }
  runs.erase(std::remove_if(runs.begin(), runs.end(), [](const auto& r) { return r.first == 0 && r.second <= 1; }),
             runs.end());
  int widest = 0;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    if (runs[i].first + runs[i - 1].first == 3 && runs[i].first + runs[i + 1].first == 3 && runs[i].first != 0)
      widest = (std::max)(widest, runs[i].second);
  return widest * 0.1;
}

/// All that holds for every result. \return how many edges have connectors, teeth, nothing
std::array<int, 3> expect_sound(const Panel_complex& complex, const Joined_parts& joined)
{
  for (const std::string& violation : violations(complex, joined.parts, t)) ADD_FAILURE() << violation;
  EXPECT_EQ(joined.joints.size(), complex.edges.size());
  std::array<int, 3> count{{0, 0, 0}};
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const Edge_joint& joint = joined.joints[e];
    ++count[int(joint.kind)];
    EXPECT_EQ(joint.kind == Edge_joint::Kind::none, !joint.reason.empty());
    EXPECT_EQ(joint.kind == Edge_joint::Kind::connector, !joint.parts.empty());
    if (joint.kind != Edge_joint::Kind::teeth) continue;
    EXPECT_GE(tooth_strip(radians(complex.dihedral(e)), t).depth(), 0.8);
    EXPECT_GE(widest_held_tooth(owners(complex, joined, e)), t - 0.11) << "edge " << e;
  }
  std::map<std::pair<int, int>, int> slot_uses;
  std::set<std::string> ids, claimed;
  for (const Edge_joint& joint : joined.joints) claimed.insert(joint.parts.begin(), joint.parts.end());
  for (std::size_t i = 0; i < joined.parts.size(); ++i) {
    const Part& part = joined.parts[i];
    EXPECT_TRUE(ids.insert(part.id).second) << part.id << " occurs twice";
    if (part.kind == Part::Kind::connector) {
      EXPECT_EQ(claimed.count(part.id), 1u);
      expect_tabs_in_slots(complex, joined, i, slot_uses);
    }
  }
  for (std::size_t i = 0; i < joined.parts.size(); ++i) {
    if (joined.parts[i].kind == Part::Kind::connector) continue;
    const std::size_t own_holes = complex.panels[joined.panel_of_part[i]].loops.size() - 1;
    for (std::size_t h = own_holes; h < joined.parts[i].holes.size(); ++h) {
      EXPECT_EQ((slot_uses[{int(i), int(h)}]), 1) << joined.parts[i].id;
      expect_good_slot(joined.parts[i], h);
    }
  }
  return count;
}

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
        for (const Point_2& p : piece) { // beyond the inner faces, wherever these are in front of the point
          if (degrees <= 180 || p.x() > 0) EXPECT_GE(p.y(), t - 1e-9);
          if (degrees <= 180) EXPECT_GE(far_face * Vector_3(p.x(), p.y(), 0), t - 1e-9);
        }
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

TEST(Joints, acute_right_obtuse_and_reflex_connectors)
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

TEST(Joints, overhang_above_the_limit_has_no_connector)
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

TEST(Joints, teeth_everywhere)
{
  for (const auto& complex : {box(40, 50, 60), dodecahedron(40), triangle_panels(octahedron(), 60),
                              triangle_panels(tetrahedron(), 50), random_convex(30, 100, 3)}) {
    SCOPED_TRACE(complex.number_of_panels());
    const auto joined = make_joined_parts(turned(complex), options_for(Joint_mode::teeth));
    const auto count = expect_sound(turned(complex), joined);
    EXPECT_EQ(count[0], 0);
    EXPECT_GE(count[1], complex.number_of_edges() * 9 / 10);
    for (const Part& part : joined.parts)
      for (const auto& tab : part.tabs)
        EXPECT_EQ((tab[1] - tab[0] + int(part.outline.size())) % int(part.outline.size()), 3);
  }
}

TEST(Joints, teeth_where_connectors_have_no_room)
{
  const auto complex = box(16, 16, 16); // a slot of 3 x 3 mm needs 4.5 mm around it, and 3 mm for the neighbour's sheet
  const auto joined = make_joined_parts(complex, options_for(Joint_mode::automatic));
  const auto count = expect_sound(complex, joined);
  EXPECT_EQ(count[1], 12);
}

TEST(Joints, neither_teeth_nor_connectors)
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
