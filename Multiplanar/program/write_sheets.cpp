// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_sheets.h"
#include "write_sheet_pdf.h"

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/fit_test.h>
#include <CGAL/Multiplanar/io/write_dxf.h>
#include <CGAL/Multiplanar/io/write_parts_csv.h>
#include <CGAL/Multiplanar/io/write_svg.h>

#include <string>
#include <vector>

using namespace CGAL::Multiplanar;

namespace {

void write_sheet(Output& output, int i, const Sheet_drawing& drawing, const Model& model, const Palette& palette)
{
  const std::string title = model.input_file + ", sheet " + std::to_string(i + 1);
  output.write(sheet_file(i, "svg"), [&](std::ostream& out) { write_svg(out, drawing, palette); });
  output.write(sheet_file(i, "dxf"), [&](std::ostream& out) { write_dxf(out, drawing); });
  output.write(sheet_file(i, "pdf"), [&](std::ostream& out) { write_sheet_pdf(out, drawing, palette, title); });
}

} // namespace

void write_sheets(Output& output, const Model& model, const Palette& palette, Report& report)
{
  const Model_settings& s = model.settings;
  std::vector<Sheet_drawing> drawings;
  for (const Sheet& sheet : model.sheets) {
    drawings.push_back(draw_sheet(sheet, model.parts, s.kerf, s.fit));
    const Sheet_drawing& drawing = drawings.back();
    report.warnings.insert(report.warnings.end(), drawing.warnings.begin(), drawing.warnings.end());
    for (const Part_drawing& part : drawing.parts) {
      report.cut_length += cut_length(part);
      report.engraved_length += engraved_length(part);
    }
    write_sheet(output, int(drawings.size()) - 1, drawing, model, palette);
  }
  const Sheet_drawing fit_test = Fit_test(s.thickness, s.kerf, s.fit).drawing();
  output.write("fit-test.svg", [&](std::ostream& out) { write_svg(out, fit_test, palette); });
  output.write("parts.csv", [&](std::ostream& out) { write_parts_csv(out, model, drawings); });
}
