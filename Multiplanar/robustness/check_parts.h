// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_ROBUSTNESS_CHECK_PARTS_H
#define MULTIPLANAR_ROBUSTNESS_CHECK_PARTS_H

#include "Verdict.h"
#include "run_limited.h"

/// What `multiplanar verify`, which shares no code with what made the parts, said of a folder, as verdicts: one a kind,
/// with the first line of it.
void check_parts(const Process_result& verified, Broken_promises& broken);

#endif // MULTIPLANAR_ROBUSTNESS_CHECK_PARTS_H
