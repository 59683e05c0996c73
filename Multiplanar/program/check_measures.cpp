// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_measures.h"
#include "failure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

std::string text(double x)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", x);
  return buffer;
}

/// Not-a-number is in no range.
void require_measure(const char* option, double value, double least, double most)
{
  if (!(value >= least && value <= most))
    throw input_error(std::string(option) + " " + text(value) + ": give a measure from " + text(least) + " to " +
                      text(most) + " mm");
}

void require_count(const char* option, long long value, long long least, long long most)
{
  if (value < least || value > most)
    throw usage_error(std::string(option) + " " + std::to_string(value) + ": give a number from " +
                      std::to_string(least) + " to " + std::to_string(most));
}

void require_weight(const char* option, double value)
{
  if (!(value >= 0 && value <= 1e6))
    throw usage_error(std::string(option) + " " + text(value) + ": give a number from 0 to 1e+06");
}

void check_sheet(const Settings& s)
{
  require_measure("--sheet width", s.sheet.width, 20, 100000);
  require_measure("--sheet height", s.sheet.height, 20, 100000);
}

void check_material(const Settings& s)
{
  require_measure("--size", s.model.size, 1, 100000);
  require_measure("--thickness", s.model.thickness, 0.01, 1000);
  require_measure("--kerf", s.model.kerf, 0, 5);
  require_measure("--fit", s.model.fit, 0, 1);
  if (s.model.thickness >= s.model.size)
    throw input_error("--thickness " + text(s.model.thickness) + ": not thinner than the model, whose --size is " +
                      text(s.model.size) + " mm");
}

void check_nesting(const Settings& s)
{
  require_measure("--gap", s.model.gap, 0, 1000);
  require_measure("--margin", s.model.margin, 0, 1000);
  if (2 * s.model.margin + s.model.kerf >= (std::min)(s.sheet.width, s.sheet.height))
    throw input_error("--margin " + text(s.model.margin) + ": nothing of the sheet is left");
  require_count("--rotations", s.sheet.rotations, 1, 3600);
  if (s.sheet.seconds != -1 && !(s.sheet.seconds >= 0 && s.sheet.seconds <= 1e6))
    throw usage_error("--nest-seconds " + text(s.sheet.seconds) + ": give a number from 0 to 1e+06");
}

} // namespace

void check_measures(const Settings& s)
{
  check_sheet(s);
  check_material(s);
  check_nesting(s);
  if (!(s.dpi >= 10 && s.dpi <= 2400))
    throw usage_error("--dpi " + text(s.dpi) + ": give a number from 10 to 2400 dots per inch");
  require_count("--iterations", s.approximation.iterations, 1, 100000);
  require_count("--restarts", s.approximation.restarts, 1, 100000);
  require_count("--threads", s.approximation.threads, 0, 1024);
  if (s.min_edge != -1) require_measure("--min-edge", s.min_edge, 0, s.model.size / 4);
  if (s.min_width != -1) require_measure("--min-width", s.min_width, 0, s.model.size / 4);
  require_weight("--smoothness", s.approximation.smoothness);
  require_weight("--saliency-weight", s.approximation.saliency_weight);
}
