// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The verifier on boxes made by hand: the good ones pass, and every fault planted into the model, its parts and its
// joints is named by a line of its own.

#include "verify_test.h"

namespace {

using namespace verify_test;

// Good models.

TEST_F(Verify, box_with_connectors_holds)
{
  write_all(dir, complete(Joints::connectors));
  expect_good();
}

TEST_F(Verify, box_with_teeth_holds)
{
  write_all(dir, complete(Joints::teeth));
  expect_good();
}

TEST_F(Verify, what_is_not_claimed_is_said_and_is_no_fault)
{
  write_model(dir, make_box(Joints::none));
  expect_good();
  const Outcome outcome = run();
  for (const char* subject : {"joints", "assembly", "sheets", "svg", "dxf", "panels.obj", "shell.ply"})
    EXPECT_TRUE(outcome.has_line("^  " + std::string(subject) + " +not claimed")) << outcome.text;
}

TEST_F(Verify, overlap_of_rounding_errors_is_none)
{
  // Half a micrometre on all sides of a panel that touches all others.
  Json model = make_box(Joints::none);
  Json& part = thing(model, "parts", "P05");
  Ring outline = part["outline"].get<Ring>();
  const double d = 0.5e-3;
  outline = {{outline[0][0] - d, outline[0][1] - d},
             {outline[1][0] + d, outline[1][1] - d},
             {outline[2][0] + d, outline[2][1] + d},
             {outline[3][0] - d, outline[3][1] + d}};
  set_outline(part, outline);
  write_model(dir, model);
  expect_good();
}

// The surface.

TEST_F(Verify, panel_that_is_not_flat)
{
  expect_fault([](Json& m) { m["corners"][7][2] = 60.001; }, "panel P0[246] is not flat: corner 7");
}

TEST_F(Verify, open_surface)
{
  expect_fault([](Json& m) { m["panels"].erase(5); }, "the surface is open: panel P0[1-5]");
}

TEST_F(Verify, surface_that_intersects_itself)
{
  // The lid pushed below the base: every panel is flat still, walls run backward.
  expect_fault(
      [](Json& m) {
        // A dent: corner 7 joins three panels; moving it along an edge through the far corner folds two of them over.
        m["corners"][7] = {-20, 80, 60};
      },
      "panel P0[246]: the outline is not a simple polygon|violation: panels P0. and P0. of the surface intersect");
}

TEST_F(Verify, loop_that_runs_the_wrong_way)
{
  expect_fault(
      [](Json& m) {
        auto& loop = m["panels"][0]["loops"][0];
        std::reverse(loop.begin(), loop.end());
      },
      "panel P01: its outline runs clockwise");
}

TEST_F(Verify, wrong_dihedral)
{
  expect_fault([](Json& m) { m["edges"][3]["dihedral"] = 91; }, "edge E004 says that its dihedral is 91");
}

TEST_F(Verify, edge_that_is_missing)
{
  expect_fault([](Json& m) { m["edges"].erase(3); }, "the side between corners . and . is in no edge");
}

// Parts.

TEST_F(Verify, panel_grown_by_five_percent)
{
  expect_fault(
      [](Json& m) {
        Json& part = thing(m, "parts", "P05");
        set_outline(part, scaled(part["outline"].get<Ring>(), 1.05));
      },
      "parts P03 and P05 overlap near");
}

TEST_F(Verify, whole_panel_grown_by_five_percent_leaves_the_model)
{
  expect_fault(
      [](Json& m) {
        Json& part = thing(m, "parts", "P02");
        set_outline(part, scaled(part["outline"].get<Ring>(), 1.05));
      },
      "part P02 leaves the model through panel P0[3-6]");
}

TEST_F(Verify, overlap_of_three_micrometres)
{
  Json model = make_box(Joints::none);
  Json& part = thing(model, "parts", "P05");
  Ring outline = part["outline"].get<Ring>();
  for (Flat& p : outline) p[0] += p[0] < 10 ? -3e-3 : 0;
  set_outline(part, outline);
  write_model(dir, model);
  expect_line(1, "violation: parts P0[1-4] and P05 overlap");
}

TEST_F(Verify, part_outside_the_model)
{
  expect_fault(
      [](Json& m) {
        auto& origin = thing(m, "parts", "C001")["frame"]["origin"];
        for (int i = 0; i < 3; ++i) origin[i] = origin[i].get<double>() + 300;
      },
      "part C001 lies outside the model");
}

TEST_F(Verify, panel_off_its_plane)
{
  expect_fault([](Json& m) { thing(m, "parts", "P02")["frame"]["origin"][2] = 59.5; },
               "part P02: its outer face lies 0.5 mm off the plane of panel P02");
}

TEST_F(Verify, frame_that_is_skew)
{
  expect_fault([](Json& m) { thing(m, "parts", "P02")["frame"]["u"][0] = 1.01; },
               "part P02: its frame is not orthonormal");
}

TEST_F(Verify, outline_that_crosses_itself)
{
  expect_fault(
      [](Json& m) { std::swap(thing(m, "parts", "C002")["outline"][0], thing(m, "parts", "C002")["outline"][5]); },
      "part C002: the outline is not a simple polygon");
}

TEST_F(Verify, part_of_a_panel_missing)
{
  expect_fault([](Json& m) { m["parts"].erase(3); }, "panel P04 has no part");
}

TEST_F(Verify, panel_that_vanished_may_be_reported)
{
  Json model = make_box(Joints::none);
  model["parts"].erase(3);
  write_model(dir, model);
  write_text(dir / "report.json", "{\"warnings\": [\"panel P04 vanishes at this thickness\"]}");
  expect_good();
}

TEST_F(Verify, wrong_area)
{
  expect_fault([](Json& m) { m["parts"][1]["area"] = 7999; }, "part P02 says that its area is 7999 mm2");
}

// Joints.

TEST_F(Verify, connector_removed_from_the_parts)
{
  expect_fault([](Json& m) { m["parts"].erase(6); }, "edge E001 names the connector C001, which is no part");
}

TEST_F(Verify, connector_removed_everywhere)
{
  Json model = make_box(Joints::connectors);
  model["parts"].erase(6);
  Json& edge = thing(model, "edges", "E001");
  edge["joint"] = "none";
  edge["reason"] = "glue";
  edge["parts"] = Json::array();
  write_model(dir, model);
  expect_line(1, "violation: part P01 has a slot at .* that holds no tab");
  expect_line(1, "violation: part P03 has a slot at .* that holds no tab");
}

TEST_F(Verify, slot_moved_by_a_millimetre)
{
  const auto plant = [](Json& m) {
    for (Json& p : thing(m, "parts", "P01")["holes"][0]) p[0] = p[0].get<double>() + 1;
  };
  expect_fault(plant, "parts P01 and C001 overlap");
  expect_line(1, "violation: edge E001, connector C001: tab 1 does not lie in a slot of P01");
}

TEST_F(Verify, slot_that_is_too_wide)
{
  expect_fault(
      [](Json& m) {
        Json& part = thing(m, "parts", "P01");
        Ring slot = scaled(part["holes"][0].get<Ring>(), 1.2);
        part["holes"][0] = slot;
        set_outline(part, part["outline"].get<Ring>());
      },
      "edge E001, connector C001: tab 1 has .* mm of play in its slot in P01");
}

TEST_F(Verify, tab_that_is_too_short)
{
  expect_fault(
      [](Json& m) {
        Json& part = thing(m, "parts", "C003");
        Ring outline = part["outline"].get<Ring>();
        for (int i : {2, 3}) outline[i][1] = 1.5;
        set_outline(part, outline);
      },
      "edge E003, connector C003: tab 1 does not go through P01");
}

TEST_F(Verify, connector_at_the_wrong_edge)
{
  expect_fault([](Json& m) { std::swap(thing(m, "edges", "E001")["parts"], thing(m, "edges", "E002")["parts"]); },
               "edge E001, connector C002: no tab of it lies in a slot of P03");
}

TEST_F(Verify, connector_that_nobody_claims)
{
  expect_fault([](Json& m) { thing(m, "edges", "E001")["parts"] = Json::array(); },
               "connector C001 belongs to no edge");
  expect_line(1, "violation: edge E001 has the joint \"connector\" but names no connector");
}

TEST_F(Verify, edge_without_joint_or_reason)
{
  expect_fault([](Json& m) { m["edges"][0].erase("reason"); }, "edge E001 has no joint and gives no reason",
               Joints::teeth);
}

TEST_F(Verify, teeth_that_do_not_interlock)
{
  const auto straight = [](Json& m) {
    for (int p : {2, 4}) set_outline(m["parts"][p], rectangular_panel(p).outline);
    m["parts"][4]["tabs"] = Json::array();
  };
  expect_fault(straight, "edge E0..: no tooth of P03 or P05 lies between two of the other", Joints::teeth);
}

TEST_F(Verify, teeth_of_both_panels_in_one_place)
{
  expect_fault([](Json& m) { set_outline(m["parts"][2], rectangular_panel(2).outline); }, "parts P03 and P05 overlap",
               Joints::teeth);
}

} // namespace
