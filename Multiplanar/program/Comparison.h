// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_COMPARISON_H
#define MULTIPLANAR_PROGRAM_COMPARISON_H

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

/// What one method made of the input. Distances are in per cent of the diagonal of the input's bounding box.
struct Comparison_row
{
  int k = 0; ///< what was asked for
  std::string method;
  bool measured = false; ///< false if the method returned nothing that can be measured: see `note`
  int panels = 0;
  double hausdorff = 0, to_panels = 0, to_input = 0, mean = 0, bend = 0;
  bool closed = false, flat = false;
  int intersections = 0;
  double seconds = 0, processor_seconds = 0;
  std::optional<double> paper; ///< Hausdorff distance in Table 1 of the paper
  std::string note;            ///< empty, or what kept the output from being measured as a mesh
};

/// All methods on one input, for several k.
struct Comparison
{
  std::string input;
  int faces = 0, genus = 0;
  std::string settings; ///< in words
  std::vector<Comparison_row> rows;
};

/// The rows as a table for the eyes, below it what has to be known to read it.
void write_table(std::ostream& out, const Comparison& comparison);

/// The rows as tab-separated values under a line of names. Numbers keep six digits; what there is none of is empty.
void write_tsv(std::ostream& out, const Comparison& comparison);

#endif // MULTIPLANAR_PROGRAM_COMPARISON_H
