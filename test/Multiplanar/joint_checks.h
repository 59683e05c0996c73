// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_JOINT_CHECKS_H
#define MULTIPLANAR_TEST_JOINT_CHECKS_H

#include <CGAL/Multiplanar/parts_from_joints.h>

#include "digital_assembly.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// What holds for every result of `make_joined_parts()`, measured on the parts alone.
namespace Multiplanar_test {

using namespace CGAL::Multiplanar;

constexpr double t = 3; // mm, of every sheet here

inline Joint_options options_for(Joint_mode mode)
{
  Joint_options options;
  options.thickness = t;
  options.mode = mode;
  return options;
}

inline double distance(const Point_2& p, const Point_2& a, const Point_2& b)
{
  return std::sqrt(CGAL::squared_distance(p, CGAL::Multiplanar::Kernel::Segment_2(a, b)));
}

/// The least distance between the boundaries of two polygons.
inline double distance(const Outline& first, const Outline& second)
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

inline bool is_inside(const Outline& outline, const Point_2& p)
{
  return CGAL::bounded_side_2(outline.begin(), outline.end(), p) == CGAL::ON_BOUNDED_SIDE;
}

/// The outline of a tab or tooth as points of the model, at both faces of the sheet.
inline Points tab_corners(const Part& part, std::size_t tab)
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
inline void expect_tabs_in_slots(const Panel_complex& complex, const Joined_parts& joined, std::size_t index,
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
inline void expect_good_slot(const Part& part, std::size_t h)
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
  EXPECT_NEAR((std::min)(std::abs(sides[0] - t), std::abs(sides[1] - t)), 0, 1e-10);
  EXPECT_NEAR(sides[0], sides[2], 1e-10);
  EXPECT_TRUE(is_inside(part.outline, slot[0]));
  EXPECT_GE(distance(slot, part.outline), 1.5 * t) << part.id;
  for (std::size_t other = 0; other < part.holes.size(); ++other)
    if (other != h) EXPECT_GE(distance(slot, part.holes[other]), 1.5 * t) << part.id;
}

/// Who has material along the line half a thickness below both panels of an edge: 1, 2, both (3) or none (0), at
/// intervals of a tenth of a millimetre.
inline std::vector<int> owners(const Panel_complex& complex, const Joined_parts& joined, int e)
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
inline double widest_held_tooth(const std::vector<int>& owners)
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
inline std::array<int, 3> expect_sound(const Panel_complex& complex, const Joined_parts& joined)
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

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_JOINT_CHECKS_H
