// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The verifier on boxes made by hand: faults planted into the assembly, the sheets and the files.

#include "verify_test.h"

#include <random>

namespace {

using namespace verify_test;

class Verify_files : public Verify
{
};

// The assembly.

void swap_steps(Json& m, int i, int j)
{
  std::swap(m["assembly"][i], m["assembly"][j]);
  m["assembly"][i]["step"] = i + 1;
  m["assembly"][j]["step"] = j + 1;
}

TEST_F(Verify_files, swapped_steps)
{
  expect_fault([](Json& m) { swap_steps(m, 1, 3); }, "step . \\(P0.*\\): over the last 4 mm of its way, .* runs into");
}

TEST_F(Verify_files, swapped_steps_without_new_numbers)
{
  expect_fault([](Json& m) { std::swap(m["assembly"][0], m["assembly"][1]); }, "assembly: step 1 is numbered 2");
}

TEST_F(Verify_files, part_never_placed)
{
  expect_fault([](Json& m) { m["assembly"].erase(5); }, "assembly never places part P02");
}

TEST_F(Verify_files, step_from_the_wrong_side)
{
  expect_fault(
      [](Json& m) {
        m["assembly"][5]["direction"] = {0, 0, 1};
      },
      "step 6 \\(P02\\): panel P02 does not move against its outward normal");
}

TEST_F(Verify_files, travel_that_is_not_free)
{
  // Panel +x, coming from outside, is free for ever; a part in its way is not.
  expect_fault(
      [](Json& m) {
        m["assembly"][5]["travel"] = 40;
        Json lump = make_box(Joints::none)["parts"][1];
        lump["id"] = "C099";
        lump["kind"] = "connector";
        lump["frame"]["origin"][2] = 90;
        m["parts"].push_back(lump);
        m["assembly"][0]["parts"].push_back("C099");
      },
      "step 6 \\(P02\\): over the 40 mm claimed to be free, P02 runs into C099");
}

TEST_F(Verify_files, travel_that_is_too_short)
{
  expect_fault([](Json& m) { m["assembly"][2]["travel"] = 3; },
               "step 3 .*: only 3 mm of its way are claimed to be free");
}

// Sheets and drawings.

TEST_F(Verify_files, parts_that_overlap_on_a_sheet)
{
  expect_fault(
      [](Json& m) {
        Json& p = m["sheets"][0]["placements"];
        p[7]["x"] = p[8]["x"], p[7]["y"] = p[8]["y"];
      },
      "sheets/sheet-1.svg: parts C00. and C00. overlap");
}

TEST_F(Verify_files, part_outside_its_sheet)
{
  expect_fault([](Json& m) { m["sheets"][1]["placements"][0]["x"] = -10; },
               "sheets/sheet-2.svg: part P06 lies .* mm beyond the edge");
}

TEST_F(Verify_files, part_on_no_sheet)
{
  expect_fault([](Json& m) { m["sheets"][1]["placements"].erase(0); }, "part P06 lies on no sheet");
}

TEST_F(Verify_files, moved_placement_is_not_what_the_drawing_shows)
{
  Json model = complete(Joints::connectors);
  write_all(dir, model);
  Json& p = model["sheets"][1]["placements"][0];
  p["y"] = p["y"].get<double>() + 0.02;
  write_model(dir, model);
  expect_line(1, "violation: sheets/sheet-2.svg: part P06: its outer cut is 0.0");
  expect_line(1, "violation: sheets/sheet-2.dxf: part P06: its outer cut is 0.0");
}

TEST_F(Verify_files, altered_svg_path)
{
  expect_fault_in_file(
      "sheets/sheet-1.svg",
      [](std::string& s) {
        // The x of the first point of the last outer cut, moved by a twentieth of a millimetre.
        const auto at = s.rfind("<path d=\"M ") + 11;
        const double x = std::stod(s.substr(at));
        s.replace(at, s.find(',', at) - at, std::to_string(x + 0.05));
      },
      1, "violation: sheets/sheet-1.svg: part C012: its outer cut is 0.0");
}

TEST_F(Verify_files, kerf_left_out)
{
  Json model = complete(Joints::connectors), drawn = model;
  write_all(dir, model);
  drawn["settings"]["kerf"] = 1e-6;
  for (const Json& sheet : drawn["sheets"])
    write_text(dir / sheet["file"].get<std::string>(), svg_of_sheet(drawn, sheet));
  expect_line(1, "violation: sheets/sheet-1.svg: part P01: its outer cut is 0.075 mm too near");
}

TEST_F(Verify_files, fit_left_out)
{
  Json model = complete(Joints::connectors), drawn = model;
  write_all(dir, model);
  drawn["settings"]["fit"] = 0;
  for (const Json& sheet : drawn["sheets"])
    write_text(dir / sheet["file"].get<std::string>(), svg_of_sheet(drawn, sheet));
  expect_line(1, "violation: sheets/sheet-1.svg: part C001: its tab 1 is not drawn wider by the fit of 0.05 mm");
}

TEST_F(Verify_files, slot_that_is_not_cut)
{
  expect_fault_in_file(
      "sheets/sheet-1.svg",
      [](std::string& s) {
        const auto at = s.find("<path", s.find("P01-inner"));
        s.erase(at, s.find('\n', at) - at);
      },
      1, "violation: sheets/sheet-1.svg: part P01: hole . at .* is not cut");
}

TEST_F(Verify_files, outer_cut_missing_in_the_dxf)
{
  expect_fault_in_file(
      "sheets/sheet-2.dxf", [](std::string& s) { replace(s, "CUT_OUTER", "ENGRAVE"); }, 1,
      "violation: sheets/sheet-2.dxf: part P06: it has 0 outer cuts instead of one");
}

TEST_F(Verify_files, path_that_is_open)
{
  expect_fault_in_file(
      "sheets/sheet-2.svg", [](std::string& s) { s.erase(s.rfind(" Z"), 2); }, 1,
      "violation: sheets/sheet-2.svg: a path among the outer cuts at .* is not closed");
}

TEST_F(Verify_files, engraving_across_a_cut_or_beside_all_parts)
{
  expect_fault_in_file(
      "sheets/sheet-2.svg", [](std::string& s) { replace(s, "h 0.1", "h 500"); }, 1,
      "violation: sheets/sheet-2.svg: engraving at .* crosses a cut");
  expect_fault_in_file(
      "sheets/sheet-2.svg", [](std::string& s) { replace(s, "l 0.1", "m 400 300 l 0.1"); }, 1,
      "violation: sheets/sheet-2.svg: engraving at .* is on no part");
}

TEST_F(Verify_files, page_that_is_not_the_sheet)
{
  const std::string begin = "%PDF-1.5\n1 0 obj\n<< /Type /Page\n /MediaBox [ 0 0 ", end = " ]\n>>\nendobj\n%%EOF\n";
  const std::string right = "1700.787402 1133.858268";
  write_all(dir, complete(Joints::connectors));
  write_text(dir / "sheets/sheet-1.pdf", begin + right + end);
  expect_line(1, "violation: some sheets have a PDF file");
  write_text(dir / "sheets/sheet-2.pdf", begin + right + end);
  expect_good();
  write_text(dir / "sheets/sheet-2.pdf", begin + "1700 1133.858268" + end);
  expect_line(1, "violation: sheets/sheet-2.pdf: its page is 599.7");
}

TEST_F(Verify_files, unit_missing_in_svg_and_dxf)
{
  expect_fault_in_file(
      "sheets/sheet-1.svg", [](std::string& s) { replace(s, "mm\"", "\""); }, 1,
      "violation: sheet-1.svg: its width is not given in mm");
  expect_fault_in_file(
      "sheets/sheet-1.dxf", [](std::string& s) { replace(s, "$INSUNITS\n70\n4", "$INSUNITS\n70\n1"); }, 1,
      "violation: sheet-1.dxf: \\$INSUNITS is not 4");
}

// Files.

TEST_F(Verify_files, missing_files)
{
  write_all(dir, complete(Joints::connectors));
  fs::remove(dir / "sheets/sheet-2.svg");
  expect_line(1, "violation: sheets/sheet-2.svg is named in model.json but does not exist");
  fs::remove(dir / "sheets/sheet-1.dxf");
  expect_line(1, "violation: sheets/sheet-1.svg has no DXF file beside it");
}

TEST_F(Verify_files, missing_texture)
{
  expect_fault(
      [](Json& m) {
        m["parts"][0]["texture"] = {{"file", "textures/P01.png"}};
      },
      "textures/P01.png, the texture of part P01, does not exist");
}

TEST_F(Verify_files, no_directory) { expect_line(3, "unreadable: model.json: cannot be opened"); }

TEST_F(Verify_files, truncated_files)
{
  for (const char* file :
       {"model.json", "sheets/sheet-1.svg", "sheets/sheet-2.dxf", "shell.ply", "report.json", "panels.obj"}) {
    SCOPED_TRACE(file);
    for (double part : {0.0, 0.3, 0.9}) {
      write_all(dir, complete(Joints::connectors));
      const std::string text = read_text(dir / file);
      write_text(dir / file, text.substr(0, std::size_t(part * double(text.size()))));
      const Outcome outcome = run();
      if (std::string(file) == "panels.obj") // lines may be missing at its end without any being damaged
        EXPECT_NE(outcome.code, 0) << outcome.text;
      else EXPECT_EQ(outcome.code, 3) << outcome.text;
      EXPECT_TRUE(outcome.has_line(fs::path(file).filename().string())) << outcome.text;
    }
  }
}

TEST_F(Verify_files, references_that_lead_nowhere)
{
  Json model = make_box(Joints::none);
  model["panels"][2]["loops"][0][1] = 8;
  write_model(dir, model);
  expect_line(3, "unreadable: model.json: panels\\[2\\].loops\\[0\\]\\[1\\] is no corner");
}

TEST_F(Verify_files, shell_that_is_not_the_model)
{
  expect_fault_in_file(
      "shell.ply", [](std::string& s) { replace(s, "\n50 0 0\n", "\n50.001 0 0\n"); }, 1,
      "violation: shell.ply: panel P06 has faces .* mm off its plane");
}

TEST_F(Verify_files, polygon_that_is_not_the_panel)
{
  expect_fault_in_file(
      "panels.obj", [](std::string& s) { replace(s, "\nf 1 3", "\nf 3 1"); }, 1,
      "violation: panels.obj: the polygon of P01 is not that of model.json");
}

// Hostile input: whatever stands in the files, the verifier comes back with a verdict.

constexpr unsigned seed = 20260207;

TEST_F(Verify_files, any_change_of_the_model_gets_a_verdict)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const Json model = complete(Joints::connectors);
  write_all(dir, model);
  std::vector<std::string> places;
  const auto flat = model.flatten();
  for (const auto& entry : flat.items()) places.push_back(entry.key());
  const Json values = {0, -1, 1e9, 1e-300, 3.5, 1e300, "P01", "", nullptr, true, Json::array(), Json::object(), {1, 2}};
  for (int round = 0; round < 150; ++round) {
    Json changed = model;
    for (int k = 0; k < 3; ++k) {
      Json::json_pointer place(places[random() % places.size()]);
      for (auto up = random() % 4; up > 0 && !place.empty(); --up) place.pop_back();
      if (!changed.contains(place)) continue;
      changed[place] = values[random() % values.size()];
    }
    write_model(dir, changed);
    const Outcome outcome = run();
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 1 || outcome.code == 3) << outcome.text;
    EXPECT_EQ(outcome.code == 0, outcome.lines("violation:") + outcome.lines("unreadable:") == 0) << outcome.text;
  }
}

TEST_F(Verify_files, any_change_of_the_bytes_gets_a_verdict)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  write_all(dir, complete(Joints::connectors));
  for (const char* name :
       {"model.json", "sheets/sheet-1.svg", "sheets/sheet-1.dxf", "shell.ply", "panels.obj", "report.json"}) {
    const std::string text = read_text(dir / name);
    for (int round = 0; round < 20; ++round) {
      std::string changed = text;
      for (auto k = 1 + random() % 4; k > 0; --k) changed[random() % changed.size()] = char(random() % 256);
      write_text(dir / name, changed);
      const Outcome outcome = run();
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 1 || outcome.code == 3) << outcome.text;
    }
    write_text(dir / name, text);
  }
  expect_good();
}

} // namespace
