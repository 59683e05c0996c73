// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_CHECK_MEASURES_H
#define MULTIPLANAR_PROGRAM_CHECK_MEASURES_H

#include "Settings.h"

/// Refuses numbers that no job can be done with. \throws Failure: exit_input for measures of the model and the
/// material, exit_usage for the others
void check_measures(const Settings& settings);

#endif // MULTIPLANAR_PROGRAM_CHECK_MEASURES_H
