// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SUMMARY_H
#define MULTIPLANAR_PROGRAM_SUMMARY_H

#include "Progress.h"

#include <CGAL/Multiplanar/io/write_report_json.h>

#include <string>

/// Tells what a run came to, on standard output: in words, as one JSON object, or not at all, like its progress.
/// \param output what was written; \param look_at the file in it to be opened first
void print_summary(const CGAL::Multiplanar::Report& report, const CGAL::Multiplanar::Model& model, double seconds,
                   const std::string& output, const std::string& look_at, Progress::Style style);

#endif // MULTIPLANAR_PROGRAM_SUMMARY_H
