// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_FABRICATE_H
#define MULTIPLANAR_PROGRAM_FABRICATE_H

#include "Output.h"
#include "Settings.h"

#include <CGAL/Multiplanar/io/write_report_json.h>

#include <string>
#include <vector>

/// From panels to parts on sheets. \param complex in input units. \throws Failure
CGAL::Multiplanar::Model make_model(const CGAL::Multiplanar::Panel_complex& complex, const Settings& settings,
                                    std::vector<std::string>& warnings);

/// Writes what is known of the model but `shell.ply`; adds what went wrong with drawings to the report before.
void write_model(Output& output, const CGAL::Multiplanar::Model& model,
                 const CGAL::Multiplanar::Palette& palette, CGAL::Multiplanar::Report& report);

#endif // MULTIPLANAR_PROGRAM_FABRICATE_H
