// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The verifier on what the program itself writes: it passes, and every fault planted into the files is found.

#include "polyhedra.h"
#include "program_runner.h"

#include <CGAL/Multiplanar/io/write_shell_ply.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <sstream>

using namespace Multiplanar_test;
using Json = nlohmann::ordered_json;

namespace {

/// A house: a prism over a pentagon, whose roof has obtuse and whose gables have right angles.
std::string house_shell()
{
  const std::vector<std::array<double, 2>> gable = {{0, 0}, {100, 0}, {100, 60}, {50, 100}, {0, 60}};
  Points points;
  for (const double z : {0.0, 120.0})
    for (const auto& p : gable) points.emplace_back(p[0], p[1], z);
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> panel;
  const auto add = [&](int a, int b, int c, int p) {
    triangles.push_back({a, b, c});
    panel.push_back(p);
  };
  for (int i = 1; i < 4; ++i) {
    add(0, i + 1, i, 0);
    add(5, 5 + i, 6 + i, 1);
  }
  for (int a = 0; a < 5; ++a) {
    const int b = (a + 1) % 5;
    add(a, b, 5 + b, 2 + a);
    add(a, 5 + b, 5 + a, 2 + a);
  }
  std::ostringstream out;
  CGAL::Multiplanar::write_shell_ply(out, points, triangles, panel);
  return out.str();
}

class Planted_faults : public Program_test
{
protected:
  void SetUp() override
  {
    Program_test::SetUp();
    const Outcome made =
        run({"fabricate", write("house.ply", house_shell()), "-o", path("house"), "--size", "200", "--no-preview"});
    ASSERT_EQ(made.code, 0) << made.err;
    const Outcome proof = run({"verify", path("house")});
    ASSERT_EQ(proof.code, 0) << proof.out;
  }

  void change_model(const std::function<void(Json&)>& change)
  {
    Json model = Json::parse(content(path("house/model.json")));
    const Json before = model;
    change(model);
    ASSERT_NE(model, before);
    write("house/model.json", model.dump());
  }

  static Json& part(Json& model, const std::string& id)
  {
    for (Json& p : model["parts"])
      if (p["id"] == id) return p;
    throw std::logic_error(id);
  }

  void expect_fault(int code, const std::string& text)
  {
    const Outcome proof = run({"verify", path("house")});
    EXPECT_EQ(proof.code, code) << proof.out;
    EXPECT_NE(proof.out.find(text), std::string::npos) << "expected: " << text << "\n" << proof.out;
    EXPECT_EQ(proof.out.find("Everything that is claimed holds"), std::string::npos);
    EXPECT_EQ(proof.error_lines(), 1) << proof.err;
  }
};

TEST_F(Planted_faults, panel_grown_by_five_percent)
{
  change_model([](Json& m) {
    for (Json& q : part(m, "P03")["outline"]) q = {q[0].get<double>() * 1.05, q[1].get<double>() * 1.05};
  });
  expect_fault(1, "violation: part P03 leaves the model");
}

TEST_F(Planted_faults, removed_connector)
{
  change_model([](Json& m) {
    for (auto p = m["parts"].begin(); p != m["parts"].end(); ++p)
      if ((*p)["id"] == "C002") {
        m["parts"].erase(p);
        return;
      }
  });
  expect_fault(1, "names the connector C002, which is no part");
}

TEST_F(Planted_faults, slot_moved_by_a_millimetre)
{
  change_model([](Json& m) {
    for (Json& p : m["parts"])
      if (p["kind"] == "panel" && !p["holes"].empty()) {
        for (Json& q : p["holes"][0]) q[0] = q[0].get<double>() + 1;
        return;
      }
  });
  expect_fault(1, "does not lie in a slot of");
}

TEST_F(Planted_faults, moved_placement)
{
  change_model([](Json& m) {
    Json& x = m["sheets"][0]["placements"][0]["x"];
    x = x.get<double>() + 0.5;
  });
  expect_fault(1, "violation: sheets/sheet-1.svg");
}

TEST_F(Planted_faults, swapped_step)
{
  // The last panel's step first: its connectors come with panels that are not there.
  change_model([](Json& m) {
    Json& steps = m["assembly"];
    std::swap(steps.front()["parts"], steps.back()["parts"]);
    std::swap(steps.front()["direction"], steps.back()["direction"]);
  });
  expect_fault(1, "mm of its way");
}

TEST_F(Planted_faults, altered_path)
{
  std::string svg = content(path("house/sheets/sheet-1.svg"));
  const auto at = svg.rfind(" Z");
  ASSERT_NE(at, std::string::npos);
  svg.replace(at, 2, " L 1 1 Z");
  write("house/sheets/sheet-1.svg", svg);
  expect_fault(1, "violation: sheets/sheet-1.svg");
}

TEST_F(Planted_faults, truncated_files)
{
  for (const std::string name :
       {"model.json", "sheets/sheet-1.svg", "sheets/sheet-1.dxf", "sheets/sheet-1.pdf", "shell.ply", "panels.obj",
        "report.json", "assembly.html", "assembly.pdf", "assembly.glb"}) {
    const std::string whole = content(path("house/" + name));
    write("house/" + name, whole.substr(0, whole.size() / 2));
    const Outcome proof = run({"verify", path("house")});
    EXPECT_NE(proof.code, 0) << name << "\n" << proof.out;
    EXPECT_NE(proof.out.find(name.substr(name.find('/') + 1)), std::string::npos) << proof.out;
    write("house/" + name, whole);
  }
  EXPECT_EQ(run({"verify", path("house")}).code, 0);
}

TEST_F(Planted_faults, summary_names_what_was_checked)
{
  const Outcome good = run({"verify", path("house")});
  EXPECT_NE(good.out.find("Digital assembly of house.ply in " + path("house") + "\n"), std::string::npos) << good.out;
  EXPECT_NE(good.out.find("7 panels"), std::string::npos) << good.out;
  const std::string end = "Everything that is claimed holds.\n";
  EXPECT_EQ(good.out.rfind(end), good.out.size() - end.size()) << good.out;
  change_model([](Json& m) { m["assembly"].erase(m["assembly"].size() - 1); });
  const Outcome bad = run({"verify", path("house")});
  EXPECT_NE(bad.out.find("  assembly   BROKEN"), std::string::npos) << bad.out;
  EXPECT_NE(bad.out.rfind("Do not cut this: "), std::string::npos) << bad.out;
}

TEST_F(Program_test, make_verifies_what_it_hands_over)
{
  const std::string shell = write("house.ply", house_shell());
  const Outcome made = run({"fabricate", shell, "-o", path("out"), "--size", "200", "--no-preview"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("verify: done"), std::string::npos) << made.out;
  const Json model = Json::parse(content(path("out/model.json")));
  EXPECT_GE(model["assembly"].size(), 7u);
}

} // namespace
