// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multiplanar/truncation.h>

#include "digital_assembly.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

namespace {

std::vector<Part> parts_of(const Panel_complex& complex, const Truncation& truncation)
{
  std::vector<Part> parts;
  for (int p = 0; p < complex.number_of_panels(); ++p)
    for (const Flat_polygon& piece : truncation.panels[p].pieces) {
      Part part;
      part.id = panel_id(complex, p);
      part.frame = truncation.panels[p].frame;
      part.outline = piece.outline;
      part.holes = piece.holes;
      parts.push_back(part);
    }
  return parts;
}

void expect_fitting(const Panel_complex& complex, double thickness, const Truncation& truncation)
{
  for (const std::string& violation : violations(complex, parts_of(complex, truncation), thickness))
    ADD_FAILURE() << violation;
}

/// The distance along panel `p`, from the edge over the origin of a wedge, where its material begins at half height.
double strip_removed(const Truncation& truncation, int p, const Vector_3& away, double half_height)
{
  const Frame& frame = truncation.panels[p].frame;
  const Flat_polygon& piece = truncation.panels[p].pieces.at(0);
  double least = 1e300;
  internal::for_each_side(piece, [&](const Point_2& a, const Point_2& b) {
    const Point_3 p = frame(a), q = frame(b);
    if ((p.z() - half_height) * (q.z() - half_height) > 0 || p.z() == q.z()) return;
    const Point_3 x = p + (half_height - p.z()) / (q.z() - p.z()) * (q - p);
    least = (std::min)(least, (x - CGAL::ORIGIN) * away);
  });
  return least;
}

class Formulas : public testing::TestWithParam<double>
{
};

TEST_P(Formulas, strips_at_an_edge)
{
  const double degrees = GetParam(), theta = radians(degrees), t = 3, h = 150;
  const auto complex = wedge(degrees, 200, h);
  const auto truncation = truncate_panels(complex, t);
  const int last = complex.number_of_panels() - 1;
  double a = strip_removed(truncation, 2, Vector_3(1, 0, 0), h / 2);
  double b = strip_removed(truncation, last, Vector_3(std::cos(theta), std::sin(theta), 0), h / 2);
  if (a > b) std::swap(a, b);
  double expected_a = 0, expected_b = 0;
  if (degrees < 90) expected_a = t / std::tan(theta), expected_b = t / std::tan(theta / 2);
  else if (degrees < 180) expected_b = t * std::sin(theta);
  else if (degrees > 270) expected_b = (t + 1) * std::tan(theta - radians(270));
  EXPECT_NEAR(a, expected_a, 1e-7);
  EXPECT_NEAR(b, expected_b, 1e-7);
  EXPECT_EQ(truncation.warnings, std::vector<std::string>());
  EXPECT_EQ(truncation.overhangs.size(), degrees > 270 ? 1u : 0u);
  expect_fitting(complex, t, truncation);
}

INSTANTIATE_TEST_SUITE_P(Angles, Formulas,
                         testing::Values(30., 45., 60., 89., 90., 91., 120., 150., 179., 200., 225., 250., 270.,
                                         270.0001, 271., 285., 300., 315., 330.));

TEST(Truncation, narrower_panel_stays_whole)
{
  const auto complex = box(100, 60, 20); // panels: bottom and top 100 x 60, then 100 x 20, 60 x 20, 100 x 20, 60 x 20
  const auto truncation = truncate_panels(complex, 3);
  const double expected[] = {94 * 54, 94 * 54, 94 * 20, 60 * 20, 94 * 20, 60 * 20};
  for (int p = 0; p < 6; ++p) EXPECT_NEAR(truncation.panels[p].pieces.at(0).area(), expected[p], 1e-5) << p;
}

TEST(Truncation, fits_on_hand_made_solids)
{
  for (const auto& complex :
       {box(40, 50, 60), l_prism(40, 50), ring(90, 40, 30), dodecahedron(40), triangle_panels(octahedron(), 60),
        triangle_panels(tetrahedron(), 50), triangle_panels(icosahedron(), 60), stellated(octahedron(), 0.9, 50),
        stellated(tetrahedron(), 1.5, 30)}) {
    SCOPED_TRACE(complex.number_of_panels());
    for (const auto& model : {complex, turned(complex)}) {
      const auto truncation = truncate_panels(model, 3);
      EXPECT_EQ(truncation.warnings, std::vector<std::string>());
      expect_fitting(model, 3, truncation);
    }
  }
}

TEST(Truncation, fits_on_random_polyhedra)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto complex = random_convex(30 + 10 * int(seed), 100, seed);
    expect_fitting(complex, 3, truncate_panels(complex, 3));
  }
}

/// Corners with five and six panels, convex and reflex edges side by side.
TEST(Truncation, fits_on_bumpy_triangles)
{
  for (double height : {0.15, 0.28}) {
    const auto complex = triangle_panels(bumpy_sphere(2, height), 120);
    const auto truncation = truncate_panels(complex, 3);
    expect_fitting(complex, 3, truncation);
    for (const auto& panel : truncation.panels) EXPECT_EQ(panel.pieces.size(), 1u);
  }
}

/// At a corner of the octahedron, opposite panels share nothing else and overlap nonetheless.
TEST(Truncation, panels_that_share_only_a_corner)
{
  const auto complex = triangle_panels(octahedron(), 60);
  const auto truncation = truncate_panels(complex, 3);
  auto parts = parts_of(complex, truncation);
  int pairs = 0;
  for (int p = 0; p < 8; ++p)
    for (int q = 0; q < p; ++q) {
      const auto around = complex.neighbours(p);
      if (std::find(around.begin(), around.end(), q) != around.end()) continue;
      Panel_complex two = complex; // whole panels p and q do overlap
      std::vector<Part> whole(2);
      int i = 0;
      for (int r : {p, q}) {
        whole[i].id = std::to_string(r);
        whole[i].frame = truncation.panels[r].frame;
        whole[i].outline = internal::part_from_panel(complex, r).outline;
        ++i;
      }
      for (const auto& v : violations(two, whole, 3)) pairs += v.find("overlap") != std::string::npos;
    }
  EXPECT_EQ(pairs, 12) << "each corner joins two pairs of opposite panels";
  expect_fitting(complex, 3, truncation);
}

TEST(Truncation, thin_plate)
{
  // 5 mm: two sheets of 3 mm overlap without touching at an edge. 2.5 mm: no sheet has room.
  auto truncation = truncate_panels(box(100, 80, 5), 3);
  EXPECT_EQ(truncation.panels[0].pieces.size() + truncation.panels[1].pieces.size(), 1u);
  ASSERT_EQ(truncation.warnings.size(), 1u);
  EXPECT_NE(truncation.warnings[0].find("P02 (8000 mm2) vanishes"), std::string::npos) << truncation.warnings[0];
  EXPECT_NE(truncation.warnings[0].find("thinner sheet"), std::string::npos);
  expect_fitting(box(100, 80, 5), 3, truncation);

  truncation = truncate_panels(box(100, 80, 2.5), 3);
  EXPECT_TRUE(truncation.panels[0].pieces.empty() && truncation.panels[1].pieces.empty());
  EXPECT_EQ(truncation.warnings.size(), 2u);
}

/// An hourglass: top and bottom are wider than the sides and give way to them, which takes the neck away.
TEST(Truncation, panel_falls_apart)
{
  const auto complex = prism({{{0, 0}, {100, 0}, {52, 50}, {100, 100}, {0, 100}, {48, 50}}}, 20);
  const auto truncation = truncate_panels(complex, 3);
  for (int p = 0; p < 8; ++p) EXPECT_EQ(truncation.panels[p].pieces.size(), p < 2 ? 2u : 1u);
  ASSERT_EQ(truncation.warnings.size(), 2u);
  EXPECT_NE(truncation.warnings[0].find("P01 falls apart into 2 pieces (P01a, P01b)"), std::string::npos)
      << truncation.warnings[0];
  expect_fitting(complex, 3, truncation);
}

/// Placed in the order of the truncation, every panel comes along its normal past all that stand, but for the pairs
/// listed as blocked.
TEST(Truncation, later_panels_come_past_earlier_ones)
{
  int overhangs = 0;
  for (const auto& complex : {wedge(300, 120, 60), wedge(275, 120, 60), stellated(octahedron(), 0.9, 80),
                              triangle_panels(bumpy_sphere(2, 0.28), 120)}) {
    const double t = 3, way = 4;
    const auto truncation = truncate_panels(complex, t);
    overhangs += int(truncation.overhangs.size());
    EXPECT_TRUE(truncation.blocked.empty());
    std::vector<std::vector<Convex_solid>> placed;
    for (int p : truncation.order)
      for (const Flat_polygon& piece : truncation.panels[p].pieces) {
        Part part;
        part.frame = truncation.panels[p].frame;
        part.outline = piece.outline;
        part.holes = piece.holes;
        Part coming = part;
        coming.frame.origin = part.frame.origin + way * part.frame.normal;
        for (const auto& moving : solids(coming, t + way))
          for (const auto& solid : placed)
            for (const auto& s : solid) EXPECT_FALSE(interiors_meet(moving, s)) << "panel " << p;
        placed.push_back(solids(part, t));
      }
  }
  EXPECT_GE(overhangs, 2);
}

TEST(Truncation, refuses_what_is_not_flat)
{
  auto complex = box(100, 80, 50);
  EXPECT_THROW(truncate_panels(complex, 0), std::invalid_argument);
  complex.corners[0].point = complex.corners[0].point + Vector_3(0, 0, 1);
  try {
    truncate_panels(complex, 3);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("panel P01"), std::string::npos) << e.what();
  }
}

TEST(Truncation, is_deterministic)
{
  const auto complex = random_convex(40, 100, 7);
  const auto a = truncate_panels(complex, 3), b = truncate_panels(complex, 3);
  for (int p = 0; p < 40; ++p) {
    ASSERT_EQ(a.panels[p].pieces.size(), b.panels[p].pieces.size());
    for (std::size_t i = 0; i < a.panels[p].pieces.size(); ++i)
      EXPECT_EQ(a.panels[p].pieces[i].outline, b.panels[p].pieces[i].outline);
  }
}

} // namespace
