// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyhedra.h"
#include "program_runner.h"

#include <CGAL/Multiplanar/Material.h>
#include <CGAL/Multiplanar/io/write_shell_ply.h>

#include <nlohmann/json.hpp>

#include <array>
#include <set>
#include <sstream>

// From a shell to parts with the program: materials, fit, warnings about panels that do not stay whole.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

/// A shell.ply of a prism over a simple polygon: every panel a fan of triangles around a corner that sees all others.
/// \param fan the position of that corner in the polygon
std::string prism_shell(const std::vector<std::array<double, 2>>& polygon, double h, int fan = 0)
{
  const int n = int(polygon.size());
  Points points;
  for (double z : {0.0, h})
    for (const auto& p : polygon) points.emplace_back(p[0], p[1], z);
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> panel;
  const auto add = [&](int a, int b, int c, int p) {
    triangles.push_back({a, b, c});
    panel.push_back(p);
  };
  for (int i = 1; i + 1 < n; ++i) {
    const int b = (fan + i) % n, c = (fan + i + 1) % n;
    add(fan, c, b, 0);
    add(n + fan, n + b, n + c, 1);
  }
  for (int a = 0; a < n; ++a) {
    const int b = (a + 1) % n;
    add(a, b, n + b, 2 + a);
    add(a, n + b, n + a, 2 + a);
  }
  std::ostringstream out;
  CGAL::Multiplanar::write_shell_ply(out, points, triangles, panel);
  return out.str();
}

std::string box_shell(double a, double b, double c) { return prism_shell({{0, 0}, {a, 0}, {a, b}, {0, b}}, c); }

json read(const std::string& file) { return json::parse(content(file)); }

bool has_warning(const json& report, const std::string& text)
{
  for (const auto& warning : report["warnings"])
    if (warning.get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

TEST_F(Program_test, list_of_materials)
{
  const Outcome outcome = run({"--list-materials"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const auto& m : CGAL::Multiplanar::materials()) EXPECT_NE(outcome.out.find(m.name), std::string::npos) << m.name;
}

TEST_F(Program_test, materials_set_the_measures_and_options_override_them)
{
  const std::string shell = write("box.ply", box_shell(2, 1, 1));
  const auto settings = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"fabricate", shell, "-o", path("out"), "--quiet", "--no-preview"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(run({"verify", path("out")}).code, 0);
    return read(path("out/model.json"))["settings"];
  };
  for (const auto& m : CGAL::Multiplanar::materials()) {
    const json s = settings({"--material", m.name});
    EXPECT_EQ(s["thickness"], m.thickness);
    EXPECT_EQ(s["kerf"], m.kerf);
    EXPECT_EQ(s["fit"], m.fit);
  }
  const json wood = settings({"--material", "Plywood"}), glass = settings({"--material", "acrylic"});
  EXPECT_GT(wood["fit"], 0);
  EXPECT_EQ(glass["fit"], 0) << "acrylic breaks where it is pressed";
  const json own = settings({"--fit", "0.02", "--material", "mdf-6", "--thickness", "5.8"});
  EXPECT_EQ(own["thickness"], 5.8);
  EXPECT_EQ(own["fit"], 0.02);
  EXPECT_EQ(own["kerf"], CGAL::Multiplanar::find_material("mdf-6")->kerf);
  const Outcome unknown = run({"fabricate", shell, "-o", path("other"), "--material", "steel"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("--list-materials"), std::string::npos) << unknown.err;
}

TEST_F(Program_test, fit_changes_what_is_cut_but_no_part)
{
  const std::string shell = write("box.ply", box_shell(2, 1, 1));
  for (const char* fit : {"0", "0.2"})
    for (const char* joints : {"connectors", "teeth"})
      ASSERT_EQ(run({"fabricate", shell, "-o", path(std::string(joints) + fit), "--joints", joints, "--fit", fit,
                     "--no-preview"})
                    .code,
                0);
  for (const std::string joints : {"connectors", "teeth"}) {
    json loose = read(path(joints + "0/model.json")), tight = read(path(joints + "0.2/model.json"));
    for (json* model : {&loose, &tight}) // how text stands depends on how a part lies on its sheet
      for (json& part : (*model)["parts"]) part.erase("engraving");
    EXPECT_TRUE(loose["parts"] == tight["parts"]);
    EXPECT_NE(content(path(joints + "0/sheets/sheet-1.svg")), content(path(joints + "0.2/sheets/sheet-1.svg")));
  }
}

/// An hourglass falls apart at its neck: a part for either half, a warning with both ids, and exit 0.
TEST_F(Program_test, a_panel_that_falls_apart_is_cut_in_pieces)
{
  const std::string shell =
      write("hourglass.ply", prism_shell({{0, 0}, {100, 0}, {52, 50}, {100, 100}, {0, 100}, {48, 50}}, 20, 2));
  const Outcome outcome = run({"fabricate", shell, "-o", path("out"), "--size", "100", "--no-preview"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::set<std::string> ids;
  const json model = read(path("out/model.json"));
  for (const auto& part : model["parts"]) ids.insert(part["id"].get<std::string>());
  for (const char* id : {"P01a", "P01b", "P02a", "P02b", "P03"}) EXPECT_EQ(ids.count(id), 1u) << id;
  EXPECT_TRUE(has_warning(read(path("out/report.json")), "P01 falls apart into 2 pieces (P01a, P01b)"));
  EXPECT_NE(outcome.out.find("use a larger size, a thinner sheet or fewer panels"), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"verify", path("out")}).code, 0);
}

/// A plate of 5 mm has room for one sheet of 3 mm, not for two.
TEST_F(Program_test, a_panel_that_vanishes_is_named)
{
  const std::string shell = write("plate.ply", box_shell(100, 80, 5));
  const Outcome outcome = run({"fabricate", shell, "-o", path("out"), "--size", "100", "--no-preview"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(has_warning(read(path("out/report.json")), "P02 (8000 mm2) vanishes"));
  EXPECT_NE(outcome.out.find("P02 (8000 mm2) vanishes"), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"verify", path("out")}).code, 0);
}

} // namespace
