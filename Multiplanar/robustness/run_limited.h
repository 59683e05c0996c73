// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_ROBUSTNESS_RUN_LIMITED_H
#define MULTIPLANAR_ROBUSTNESS_RUN_LIMITED_H

#include <string>
#include <vector>

/// What a process may use.
struct Limits
{
  double seconds = 600;    ///< of the processor; ten times as much by the clock
  double megabytes = 2048; ///< resident
};

/// What a process came to.
struct Process_result
{
  int exit_code = -1; ///< -1: ended by a signal
  int signal = 0;
  bool out_of_time = false, out_of_memory = false;
  double seconds = 0, megabytes = 0; ///< processor time; largest resident size
  std::string output, errors;        ///< the first megabyte of each
};

/// Runs a program under limits, its output taken to files in `folder`, and waits for it.
/// \throws std::runtime_error if it cannot be started
Process_result run_limited(const std::vector<std::string>& command, const std::string& folder, const Limits& limits);

#endif // MULTIPLANAR_ROBUSTNESS_RUN_LIMITED_H
