// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_FAILURE_H
#define MULTIPLANAR_PROGRAM_FAILURE_H

#include <stdexcept>
#include <string>

/// What the program tells its caller.
enum Exit_code
{
  exit_done = 0,
  exit_broken_promise = 1, ///< the result is not what was promised
  exit_usage = 2,
  exit_input = 3,   ///< the input cannot be read or is not what the job needs
  exit_resource = 4 ///< disk full, no memory
};

/// An error as the user sees it: one line that says what is wrong, where, and what to do.
struct Failure : std::runtime_error
{
  Failure(Exit_code code, const std::string& line) : std::runtime_error(line), code(code) {}
  Exit_code code;
};

inline Failure usage_error(const std::string& line) { return Failure(exit_usage, line); }
inline Failure input_error(const std::string& line) { return Failure(exit_input, line); }
inline Failure resource_error(const std::string& line) { return Failure(exit_resource, line); }

constexpr const char* out_of_memory_line = "out of memory: take a smaller mesh or a machine with more memory";

/// Text from a file made fit for a one-line message: shortened, and what cannot be printed replaced.
std::string quoted(const std::string& text);

#endif // MULTIPLANAR_PROGRAM_FAILURE_H
