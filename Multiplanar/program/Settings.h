// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SETTINGS_H
#define MULTIPLANAR_PROGRAM_SETTINGS_H

#include "Progress.h"

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/Palette.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
enum class Joint_mode; // in Joint_options.h, which takes long to compile
}
} // namespace CGAL

/// What the command line asks for.
struct Settings
{
  std::string command; ///< make, approximate, fabricate, verify, compare or preview
  std::string input, output;
  std::string saliency_file; ///< empty: none
  std::string source;        ///< the mesh that a shell was made from, for its looks; empty: none
  double dpi = 150;          ///< of textures
  CGAL::Multiplanar::Approximation_options approximation;
  std::vector<int> panel_numbers; ///< compare: each k in turn
  bool tsv = false;               ///< compare: tab-separated values instead of a table
  double min_edge = -1;  ///< mm on the finished model; negative: half the thickness
  double min_width = -1; ///< mm on the finished model; negative: the thickness
  CGAL::Multiplanar::Model_settings model;
  CGAL::Multiplanar::Sheet_options sheet;
  CGAL::Multiplanar::Joint_mode joints = CGAL::Multiplanar::Joint_mode(); ///< automatic
  CGAL::Multiplanar::Palette palette;
  bool repair = false; ///< mends the input before all else
  bool preview = true; ///< pictures are written with the rest
  Progress::Style progress = Progress::Style::lines;
};

#endif // MULTIPLANAR_PROGRAM_SETTINGS_H
