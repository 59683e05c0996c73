// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which holes of a panel's part are slots that something must hold.

#include "checks.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace CGAL::Multiplanar::verification;

namespace {

Loop rectangle(double x0, double y0, double x1, double y1)
{
  return {Point_2(x0, y0), Point_2(x1, y0), Point_2(x1, y1), Point_2(x0, y1)};
}

Written_part part(const std::string& id, const Point_3& origin, const Vector_3& u, const Vector_3& v,
                  const Loop& outline)
{
  Written_part result;
  result.id = id;
  result.frame = {origin, u, v, CGAL::cross_product(u, v)};
  result.outline = outline;
  return result;
}

/// A flat part with a hole of 6 x 3 mm in its sheet of 3 mm, from x = 20 to 26 and y = 10 to 13; beside it an upright
/// one, 6 mm wide, whose sheet is where y = `y` to y + 3.
Written_model holed_sheet(double y)
{
  Written_model model;
  model.thickness = 3;
  model.parts.push_back(part("P01", Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), rectangle(0, 0, 40, 40)));
  model.parts[0].holes.push_back(rectangle(20, 10, 26, 13));
  model.parts.push_back(part("P02", Point_3(20, y, -20), Vector_3(1, 0, 0), Vector_3(0, 0, 1), rectangle(0, 0, 6, 20)));
  Written_edge edge;
  edge.id = "E001";
  edge.panels = {{"P01", "P02"}};
  edge.joint = "none";
  edge.reason = "glue";
  model.edges.push_back(edge);
  return model;
}

std::string said_of(const Written_model& model)
{
  std::ostringstream out;
  Report report(out);
  check_joints(model, report);
  return out.str();
}

TEST(Verify_joints, a_slot_without_a_tab_is_a_fault)
{
  for (double y : {0., 6., 14., 30.})
    EXPECT_NE(said_of(holed_sheet(y)).find("P01 has a slot at"), std::string::npos) << y;
}

TEST(Verify_joints, a_hole_that_another_panel_reaches_through_is_no_slot) { EXPECT_EQ(said_of(holed_sheet(10)), ""); }

TEST(Verify_joints, a_hole_of_another_shape_is_no_slot)
{
  Written_model model = holed_sheet(30);
  for (const Loop& hole : {rectangle(20, 10, 26, 13.01), Loop{Point_2(20, 10), Point_2(26, 10), Point_2(20, 13)}}) {
    model.parts[0].holes = {hole};
    EXPECT_EQ(said_of(model), "");
  }
}

} // namespace
