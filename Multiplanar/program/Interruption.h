// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_INTERRUPTION_H
#define MULTIPLANAR_PROGRAM_INTERRUPTION_H

#include <mutex>
#include <string>
#include <vector>

// Ctrl-C, termination and hang-up end the program at once, whatever it computes: a thread of its own waits for the
// signals, removes what was begun and ends the process with 128 + the signal's number.

/// To be called once, at the beginning, after take_memory_of_blas().
void watch_for_interruption();

/// Held while the temporary output is made, renamed or removed, so that a signal comes before or after, never between.
std::mutex& output_mutex();

/// What is to be removed when a signal comes: the first with all that it holds, the others if they are empty folders.
/// \pre the caller holds output_mutex()
void remove_when_interrupted(std::vector<std::string> paths);

/// Does not return if a signal has come already: what fails then fails because its output was taken away.
void wait_if_interrupted();

#endif // MULTIPLANAR_PROGRAM_INTERRUPTION_H
