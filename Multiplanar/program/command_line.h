// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_COMMAND_LINE_H
#define MULTIPLANAR_PROGRAM_COMMAND_LINE_H

#include "Settings.h"

#include <optional>

/// Reads the command line. Nothing if it asked for help or the version only: that is printed.
/// \throws Failure: exit_usage for what cannot be understood, exit_input for absurd measures
std::optional<Settings> parse_command_line(int argc, char** argv);

#endif // MULTIPLANAR_PROGRAM_COMMAND_LINE_H
