// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_WRITE_SHEETS_H
#define MULTIPLANAR_PROGRAM_WRITE_SHEETS_H

#include "Output.h"

#include <CGAL/Multiplanar/Palette.h>
#include <CGAL/Multiplanar/io/write_report_json.h>

/// Writes the sheets as SVG, DXF and PDF, fit-test.svg and parts.csv; adds the lengths of lines, and what went wrong
/// with drawings, to the report.
void write_sheets(Output& output, const CGAL::Multiplanar::Model& model, const CGAL::Multiplanar::Palette& palette,
                  CGAL::Multiplanar::Report& report);

#endif // MULTIPLANAR_PROGRAM_WRITE_SHEETS_H
