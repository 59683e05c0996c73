// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PROOF_H
#define MULTIPLANAR_PROGRAM_PROOF_H

#include <string>

/// Has the verifier look at a folder as it was written, before anybody is given it.
/// \param shown what the folder is called in messages
/// \throws Failure (exit_broken_promise) with the first violation, and how many there are
void require_proof(const std::string& folder, const std::string& shown);

#endif // MULTIPLANAR_PROGRAM_PROOF_H
