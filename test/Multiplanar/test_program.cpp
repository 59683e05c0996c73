// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

// The program from the outside: what it writes and what it refuses.

using namespace Multiplanar_test;
using nlohmann::json;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;

namespace {

Mesh sphere() { return bumpy_sphere(6); } // 720 faces

Surface_mesh read_shell(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  Surface_mesh mesh;
  std::string comments;
  EXPECT_TRUE(CGAL::IO::read_PLY(in, mesh, comments));
  return mesh;
}

std::vector<int> panels_of(const Surface_mesh& mesh)
{
  const auto found = mesh.property_map<Surface_mesh::Face_index, std::int32_t>("f:panel");
  EXPECT_TRUE(found.second);
  std::vector<int> result;
  for (auto f : mesh.faces()) result.push_back(found.first[f]);
  return result;
}

std::vector<std::array<int, 3>> triangles_of(const Surface_mesh& mesh)
{
  std::vector<std::array<int, 3>> result;
  for (auto f : mesh.faces()) {
    std::array<int, 3> t{};
    int i = 0;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) t[i++ % 3] = int(v);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  return result;
}

std::vector<std::array<int, 3>> from_smallest(std::vector<std::array<int, 3>> triangles)
{
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return triangles;
}

/// \pre no panel fell apart
std::size_t number_of_panel_parts(const json& model)
{
  std::size_t count = 0;
  for (const json& part : model["parts"]) count += part["kind"] == "panel";
  return count;
}

std::set<std::string> kinds_of_joints(const json& model)
{
  std::set<std::string> kinds;
  for (const json& edge : model["edges"]) kinds.insert(edge["joint"].get<std::string>());
  return kinds;
}

} // namespace

TEST_F(Program_test, help_and_version_succeed)
{
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* command : {"make", "approximate", "fabricate", "verify", "compare", "preview"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
  EXPECT_EQ(help.err, "");
  const Outcome make_help = run({"make", "--help"});
  EXPECT_EQ(make_help.code, 0);
  EXPECT_NE(make_help.out.find("--panels"), std::string::npos);
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("multiplanar ", 0), 0u);
}

TEST_F(Program_test, wrong_usage_is_refused_with_one_line)
{
  const std::string mesh = write("m.off", off_text(sphere()));
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"frobnicate"},
      {"make"},
      {"make", mesh},
      {"make", mesh, "-o"},
      {"make", mesh, "-o", path("out"), "--no-such-option"},
      {"make", mesh, "-o", path("out"), "-k", "many"},
      {"make", mesh, "-o", path("out"), "-k", "10", "-k", "12"},
      {"make", mesh, "-o", path("out"), "--seed", "-1"},
      {"make", mesh, "-o", path("out"), "--effort", "heroic"},
      {"make", mesh, "-o", path("out"), "--solver", "guess"},
      {"make", mesh, "-o", path("out"), "--iterations", "0"},
      {"make", mesh, "-o", path("out"), "--threads", "-2"},
      {"make", mesh, "-o", path("out"), "--smoothness", "nan"},
      {"make", mesh, "-o", path("out"), "--sheet", "600"},
      {"make", mesh, "-o", path("out"), "--joints", "nails"},
      {"make", mesh, "-o", ""},
      {"make", mesh, "-o", mesh},
      {"approximate", mesh, "-o", path("out.ply"), "--kerf", "0.1"},
  };
  for (const auto& arguments : wrong) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << ::testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(names(), std::vector<std::string>{"m.off"});
  }
}

TEST_F(Program_test, absurd_measures_are_refused)
{
  const std::string mesh = write("m.off", off_text(sphere()));
  const std::vector<std::vector<std::string>> absurd = {
      {"--size", "-5"},       {"--size", "nan"},  {"--size", "1e12"},      {"--thickness", "0"},
      {"--thickness", "400"}, {"--kerf", "-0.1"}, {"--sheet", "-600x400"}, {"--sheet", "600x0"},
      {"--kerf", "inf"},      {"--fit", "-0.1"},  {"--fit", "nan"}};
  for (const auto& option : absurd) {
    const Outcome outcome = run({"make", mesh, "-o", path("out"), option[0], option[1]});
    EXPECT_EQ(outcome.code, 3) << ::testing::PrintToString(option) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1);
    EXPECT_NE(outcome.err.find(option[0]), std::string::npos) << outcome.err;
  }
}

TEST_F(Program_test, make_writes_all_that_it_promises)
{
  const Mesh mesh = sphere();
  const std::string input = write("m.off", off_text(mesh));
  const Outcome outcome = run({"make", input, "-o", path("out"), "-k", "14", "--effort", "fast", "--size", "200"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("sheets/sheet-1.svg"), std::string::npos);
  EXPECT_EQ(names(), (std::vector<std::string>{"m.off", "out"}));

  const Surface_mesh shell = read_shell(path("out/shell.ply"));
  EXPECT_EQ(triangles_of(shell), from_smallest(mesh.triangles));
  std::vector<Point_3> points;
  for (auto v : shell.vertices()) points.push_back(shell.point(v));
  const auto connectivity = CGAL::Multiplanar::internal::make_connectivity(mesh.triangles, int(points.size()));
  EXPECT_TRUE(CGAL::Multiplanar::internal::is_embedded(connectivity, points));

  const json model = json::parse(content(path("out/model.json")));
  EXPECT_EQ(model["format"], "multiplanar-model");
  EXPECT_EQ(model["settings"]["panels"], 14);
  const auto panels = panels_of(shell);
  EXPECT_LE(model["panels"].size(), 14u);
  EXPECT_EQ(std::set<int>(panels.begin(), panels.end()).size(), model["panels"].size());
  EXPECT_EQ(model["settings"]["fit"], 0.05);
  EXPECT_EQ(number_of_panel_parts(model), model["panels"].size());

  // Every vertex of the mesh, scaled, lies in the plane of its panel.
  const double scale = model["input"]["scale"];
  const auto triangles = triangles_of(shell);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const json& panel = model["panels"][panels[f]];
    for (int v : triangles[f]) {
      double distance = -double(panel["offset"]);
      for (int i = 0; i < 3; ++i) distance += double(panel["normal"][i]) * points[v][i] * scale;
      EXPECT_NEAR(distance, 0, 1e-6 * 200);
    }
  }
  const json report = json::parse(content(path("out/report.json")));
  EXPECT_EQ(report["input"]["faces"], mesh.triangles.size());
  EXPECT_GT(double(report["accuracy"]["hausdorff_percent"]), 0);
  EXPECT_EQ(report["sheets"], model["sheets"].size());
}

TEST_F(Program_test, the_longest_side_of_the_model_is_the_size)
{
  const std::string input = write("m.off", off_text(sphere()));
  ASSERT_EQ(run({"make", input, "-o", path("out"), "-k", "14", "--effort", "fast", "--size", "123"}).code, 0);
  std::array<double, 3> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  const json model = json::parse(content(path("out/model.json")));
  for (const json& corner : model["corners"])
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], double(corner[i]));
      high[i] = std::max(high[i], double(corner[i]));
    }
  EXPECT_NEAR(std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}), 123, 1e-9 * 123);
}

TEST_F(Program_test, fabricate_repeats_what_make_did)
{
  const std::string input = write("m.off", off_text(sphere()));
  ASSERT_EQ(run({"make", input, "-o", path("a"), "-k", "14", "--effort", "fast"}).code, 0);
  ASSERT_EQ(run({"approximate", input, "-o", path("shell.ply"), "-k", "14", "--effort", "fast"}).code, 0);
  EXPECT_EQ(content(path("shell.ply")), content(path("a/shell.ply")));
  ASSERT_EQ(run({"fabricate", path("shell.ply"), "-o", path("b")}).code, 0);
  EXPECT_EQ(content(path("b/shell.ply")), content(path("a/shell.ply")));
  const json a = json::parse(content(path("a/model.json"))), b = json::parse(content(path("b/model.json")));
  EXPECT_EQ(a["panels"].size(), b["panels"].size());
  for (std::size_t p = 0; p < a["panels"].size(); ++p) EXPECT_EQ(a["panels"][p]["loops"], b["panels"][p]["loops"]);
  EXPECT_EQ(a["sheets"].size(), b["sheets"].size());
}

TEST_F(Program_test, every_kind_of_joint_passes_the_digital_assembly)
{
  const std::string input = write("m.off", off_text(cube(2)));
  ASSERT_EQ(run({"approximate", input, "-o", path("shell.ply"), "-k", "6", "--effort", "fast"}).code, 0);
  const std::vector<std::pair<std::string, std::set<std::string>>> kinds = {
      {"auto", {"connector"}}, {"connectors", {"connector"}}, {"teeth", {"teeth"}}, {"none", {"none"}}};
  for (const auto& kind : kinds) {
    ASSERT_EQ(run({"fabricate", path("shell.ply"), "-o", path("out"), "--joints", kind.first, "--size", "150", "--fit",
                   "0.1"})
                  .code,
              0);
    const json model = json::parse(content(path("out/model.json"))),
               report = json::parse(content(path("out/report.json")));
    EXPECT_EQ(kinds_of_joints(model), kind.second) << kind.first;
    EXPECT_EQ(report["joints"]["joined_share"], kind.first == "none" ? 0. : 1.);
    const Outcome outcome = run({"verify", path("out")});
    EXPECT_EQ(outcome.code, 0) << kind.first << "\n" << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err, "");
    if (kind.first == "none") {
      EXPECT_EQ(model["edges"][0]["reason"], "no joints were asked for");
    }
  }
}

TEST_F(Program_test, what_make_wrote_passes_the_digital_assembly_until_it_is_changed)
{
  const std::string input = write("m.off", off_text(sphere()));
  ASSERT_EQ(run({"make", input, "-o", path("out"), "-k", "12", "--effort", "fast", "--size", "200"}).code, 0);
  const Outcome good = run({"verify", path("out")});
  EXPECT_EQ(good.code, 0) << good.out << good.err;

  const std::string text = content(path("out/model.json"));
  json model = json::parse(text);
  model["settings"]["kerf"] = 0.3;
  write("out/model.json", model.dump());
  const Outcome broken = run({"verify", path("out")});
  EXPECT_EQ(broken.code, 1);
  EXPECT_NE(broken.out.find("violation: "), std::string::npos);
  EXPECT_EQ(broken.error_lines(), 1);

  write("out/model.json", text.substr(0, text.size() / 2));
  EXPECT_EQ(run({"verify", path("out")}).code, 3);
  EXPECT_EQ(run({"verify", path("nowhere")}).code, 3);
  EXPECT_EQ(run({"verify"}).code, 2);
}

TEST_F(Program_test, two_runs_write_the_same_bytes)
{
  const std::string input = write("m.off", off_text(sphere()));
  ASSERT_EQ(run({"make", input, "-o", path("a"), "-k", "14", "--effort", "fast", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"make", input, "-o", path("b"), "-k", "14", "--effort", "fast", "--threads", "3"}).code, 0);
  for (const char* name : {"shell.ply", "panels.obj", "model.json", "sheets/sheet-1.svg"})
    EXPECT_EQ(content(folder / "a" / name), content(folder / "b" / name)) << name;
}

TEST_F(Program_test, a_part_too_large_names_the_size_that_fits)
{
  const std::string input = write("m.off", off_text(sphere()));
  const std::vector<std::string> base = {"make",     input,  "-o",      path("out"), "-k",    "14",
                                         "--effort", "fast", "--sheet", "90x60",     "--size"};
  auto arguments = base;
  arguments.push_back("300");
  const Outcome refused = run(arguments);
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.error_lines(), 1);
  EXPECT_NE(refused.err.find("part P"), std::string::npos) << refused.err;
  const std::size_t at = refused.err.find("or --size ");
  ASSERT_NE(at, std::string::npos) << refused.err;
  const double size = std::stod(refused.err.substr(at + 10));
  EXPECT_LT(size, 300);
  arguments.back() = std::to_string(size);
  EXPECT_EQ(run(arguments).code, 0);
  arguments.back() = std::to_string(size * 1.3);
  EXPECT_EQ(run(arguments).code, 3);
}

TEST_F(Program_test, progress_comes_as_asked_for)
{
  const std::string input = write("m.off", off_text(sphere()));
  const std::vector<std::string> base = {"approximate", input, "-o", path("s.ply"), "-k", "14", "--effort", "fast"};
  auto with = [&](const std::string& option) {
    auto arguments = base;
    arguments.push_back(option);
    return run(arguments);
  };
  EXPECT_EQ(with("--quiet").out, "");
  const Outcome plain = run(base);
  EXPECT_EQ(plain.out.find('\r'), std::string::npos);
  EXPECT_NE(plain.out.find("panels"), std::string::npos);
  std::stringstream lines(with("--json-progress").out);
  std::string last;
  for (std::string line; std::getline(lines, line); last = line) EXPECT_TRUE(json::accept(line)) << line;
  EXPECT_EQ(json::parse(last)["event"], "done");
}

TEST_F(Program_test, saliency_is_read_and_checked)
{
  const Mesh mesh = sphere();
  const std::string input = write("m.off", off_text(mesh));
  std::string values;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) values += f % 2 ? "0.25\n" : "1\n";
  const auto with = [&](const std::string& file) {
    return run({"approximate", input, "-o", path("s.ply"), "-k", "14", "--effort", "fast", "--saliency", file});
  };
  EXPECT_EQ(with(write("good.txt", values)).code, 0);
  for (const auto& wrong :
       {write("few.txt", "0.5\n"), write("range.txt", values + "0"), write("high.txt", "1.5\n" + values.substr(2)),
        write("words.txt", "much\n"), path("missing.txt")}) {
    const Outcome outcome = with(wrong);
    EXPECT_EQ(outcome.code, 3) << wrong;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  }
}
