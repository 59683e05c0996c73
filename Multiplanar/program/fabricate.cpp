// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fabricate.h"
#include "failure.h"
#include "previews.h"
#include "write_sheets.h"

#include <CGAL/Multiplanar/assembled_parts.h>
#include <CGAL/Multiplanar/engrave_parts.h>
#include <CGAL/Multiplanar/io/write_model_json.h>
#include <CGAL/Multiplanar/io/write_panels_obj.h>
#include <CGAL/Multiplanar/nesting.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

using namespace CGAL::Multiplanar;

namespace {

std::vector<Sheet> nest(const std::vector<Part>& parts, const Settings& s)
{
  try {
    return nest_parts(parts, s.sheet);
  } catch (const Part_too_large& error) {
    char text[256];
    std::snprintf(text, sizeof text,
                  "%s: part %s is %.1f x %.1f mm and does not fit a sheet of %g x %g mm: take larger sheets, or "
                  "--size %g",
                  s.input.c_str(), error.id.c_str(), error.width, error.height, s.sheet.width, s.sheet.height,
                  std::floor(error.factor * s.model.size * 10 * (1 - 1e-9)) / 10);
    throw input_error(text);
  }
}

/// Parts without their ids are told one by one; shorter texts are for the part list.
void warn_of_blank_parts(const std::vector<Part>& parts, std::vector<std::string>& warnings)
{
  std::string list;
  int others = 0;
  for (const Part& part : parts)
    if (std::count(part.not_engraved.begin(), part.not_engraved.end(), part.id) > 0) list += " " + part.id;
    else others += !part.not_engraved.empty();
  if (!list.empty()) warnings.push_back("too small for an engraved id:" + list);
  if (others > 0)
    warnings.push_back("not everything fits on " + std::to_string(others) + " parts: the rest is in parts.csv");
}

/// Makes the parts, joins them, and finds an order to put them together.
void join_parts(Model& model, const Settings& s, std::vector<std::string>& warnings)
{
  Joint_options options;
  options.thickness = s.model.thickness;
  options.mode = s.joints;
  Assembled_parts assembled = make_assembled_parts(model.complex, options);
  Joined_parts& joined = assembled.joined;
  if (joined.parts.empty())
    throw input_error(s.input + ": nothing is left of its panels at this --size and --thickness: make the model larger "
                                "or the material thinner");
  model.parts = std::move(joined.parts);
  model.joints = std::move(joined.joints);
  model.assembly = std::move(assembled.steps);
  if (s.joints == Joint_mode::none)
    for (Edge_joint& joint : model.joints) joint.reason = "no joints were asked for";
  warnings.insert(warnings.end(), assembled.warnings.begin(), assembled.warnings.end());
}

} // namespace

Model make_model(const Panel_complex& complex, const Settings& s, std::vector<std::string>& warnings)
{
  Model model;
  model.input_file = std::filesystem::path(s.input).filename().string();
  model.settings = s.model;
  model.scale = s.model.size / longest_side(complex);
  model.complex = scaled(complex, model.scale);
  join_parts(model, s, warnings);
  model.sheets = nest(model.parts, s);
  Engraving_options engraving;
  engraving.up = up_of(model.complex);
  engraving.clearance = 0.4 + s.model.kerf / 2;
  engrave_parts(model, engraving);
  warn_of_blank_parts(model.parts, warnings);
  return model;
}

void write_model(Output& output, const Model& model, const Palette& palette, Report& report)
{
  write_sheets(output, model, palette, report);
  output.write("panels.obj", [&](std::ostream& out) { write_panels_obj(out, model.complex); });
  output.write("model.json", [&](std::ostream& out) { write_model_json(out, model); });
  output.write("report.json", [&](std::ostream& out) { write_report_json(out, report, model); });
}
