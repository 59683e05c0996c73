// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_checks.h"
#include "program_runner.h"

#include <CGAL/Multiplanar/Palette.h>
#include <CGAL/Multiplanar/io/write_shell_ply.h>

#include <nlohmann/json.hpp>

#include <array>
#include <sstream>

// The options of sheets, from the command line to the files.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

/// A shell.ply of a box.
std::string box_shell(double a, double b, double c)
{
  const std::vector<std::array<int, 4>> quads = {{{0, 2, 3, 1}}, {{4, 5, 7, 6}}, {{0, 1, 5, 4}},
                                                 {{2, 6, 7, 3}}, {{0, 4, 6, 2}}, {{1, 3, 7, 5}}};
  Points points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? a : 0, i & 2 ? b : 0, i & 4 ? c : 0);
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> panels;
  for (int q = 0; q < 6; ++q)
    for (int k = 1; k < 3; ++k) {
      triangles.push_back({{quads[q][0], quads[q][k], quads[q][k + 1]}});
      panels.push_back(q);
    }
  std::ostringstream out;
  write_shell_ply(out, points, triangles, panels);
  return out.str();
}

json read(const std::string& file) { return json::parse(content(file)); }

} // namespace

TEST_F(Program_test, palettes_colour_the_lines)
{
  const std::string shell = write("box.ply", box_shell(3, 2, 1));
  for (const Palette& palette : palettes()) {
    ASSERT_EQ(run({"fabricate", shell, "-o", path("out"), "--quiet", "--palette", palette.name}).code, 0);
    for (const char* file : {"out/sheets/sheet-1.svg", "out/fit-test.svg"}) {
      const std::string svg = content(path(file));
      for (const std::string& colour : {palette.engrave, palette.inner, palette.outer})
        EXPECT_NE(svg.find("stroke=\"" + colour + "\""), std::string::npos) << palette.name;
    }
  }
  const Outcome refused = run({"fabricate", shell, "-o", path("out"), "--palette", "pink"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("lightburn"), std::string::npos);
}

TEST_F(Program_test, gap_margin_and_rotations_are_heeded)
{
  const std::string shell = write("box.ply", box_shell(3, 2, 1));
  const auto used = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"fabricate", shell, "-o", path("out"), "--quiet", "--nest-seconds", "0"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(run({"verify", path("out")}).code, 0);
    return read(path("out/report.json"))["last_sheet_length"].get<double>();
  };
  const double plain = used({"--rotations", "4"});
  EXPECT_GT(used({"--rotations", "4", "--gap", "10"}), plain + 5);
  EXPECT_GT(used({"--rotations", "4", "--margin", "20"}), plain + 20);
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
           {"--rotations", "0"}, {"--nest-seconds", "-2"}, {"--nest-seconds", "nan"}}) {
    std::vector<std::string> arguments{"fabricate", shell, "-o", path("out"), wrong[0], wrong[1]};
    EXPECT_EQ(run(arguments).code, 2) << wrong[0] << " " << wrong[1];
  }
  EXPECT_EQ(run({"fabricate", shell, "-o", path("out"), "--margin", "200"}).code, 3);
}

TEST_F(Program_test, the_same_sheets_whatever_the_threads)
{
  const std::string shell = write("box.ply", box_shell(3, 2, 1));
  for (const char* threads : {"1", "3"})
    EXPECT_EQ(run({"fabricate", shell, "-o", path(threads), "--quiet", "--threads", threads}).code, 0);
  for (const char* file :
       {"sheets/sheet-1.svg", "sheets/sheet-1.dxf", "sheets/sheet-1.pdf", "parts.csv", "fit-test.svg"}) {
    EXPECT_FALSE(content(path(std::string("1/") + file)).empty()) << file;
    EXPECT_EQ(content(path(std::string("1/") + file)), content(path(std::string("3/") + file))) << file;
  }
}

TEST_F(Program_test, the_report_counts_material_and_lines)
{
  const std::string shell = write("box.ply", box_shell(3, 2, 1));
  ASSERT_EQ(run({"fabricate", shell, "-o", path("out"), "--quiet"}).code, 0);
  const json report = read(path("out/report.json")), model = read(path("out/model.json"));
  double parts = 0;
  for (const json& part : model["parts"]) parts += part["area"].get<double>();
  const double sheets = model["sheets"].size() * 600. * 400;
  const double used = sheets - (600 - report["last_sheet_length"].get<double>()) * 400;
  EXPECT_NEAR(report["utilisation_of_whole_sheets"].get<double>(), parts / sheets, 1e-9);
  EXPECT_NEAR(report["utilisation"].get<double>(), parts / used, 1e-9);
  EXPECT_GT(report["cut_length"].get<double>(), 2 * 6 * 100);
  EXPECT_GT(report["engraved_length"].get<double>(), 100);
}
