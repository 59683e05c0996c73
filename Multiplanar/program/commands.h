// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_COMMANDS_H
#define MULTIPLANAR_PROGRAM_COMMANDS_H

#include "Settings.h"

/// Each does one command of the program and prints a summary. \throws Failure
void make(const Settings& settings, Progress& progress);
void approximate(const Settings& settings, Progress& progress);
void fabricate(const Settings& settings, Progress& progress);
void verify(const Settings& settings);
void compare(const Settings& settings, Progress& progress);
void preview(const Settings& settings, Progress& progress);

#endif // MULTIPLANAR_PROGRAM_COMMANDS_H
