// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_ROBUSTNESS_CHECK_SHELL_H
#define MULTIPLANAR_ROBUSTNESS_CHECK_SHELL_H

#include "Input.h"
#include "Verdict.h"

/// What the written mesh of panels shows. \return the number of panels; -1 if it cannot be read
/// Exact, but for flatness: the distance to the plane of least squares, in doubles.
int check_shell(const std::string& file, const Input& input, int most_panels, Broken_promises& broken);

#endif // MULTIPLANAR_ROBUSTNESS_CHECK_SHELL_H
