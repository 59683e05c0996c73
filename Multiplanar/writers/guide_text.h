// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_GUIDE_TEXT_H
#define MULTIPLANAR_WRITERS_GUIDE_TEXT_H

#include "Assembly_guide.h"

#include <string>
#include <vector>

// What all forms of the guide say in words.

/// "49 panels, 146 connectors, 2 sheets of 3 mm, 300 × 297 × 233 mm"
std::string facts_in_words(const Assembly_guide& guide);

/// What to do in a step.
std::string step_text(const Assembly_guide& guide, int step);

/// What to have at hand: a line each.
std::vector<std::string> materials_in_words(const Assembly_guide& guide);
std::vector<std::string> tools_in_words(const Assembly_guide& guide);

/// How ids and joints are to be understood: a line each.
std::vector<std::string> hints_in_words(const Assembly_guide& guide);

/// "P03-P07" for every edge that nothing joins, both of whose panels have parts.
std::vector<std::string> glued_edges(const Assembly_guide& guide);

#endif // MULTIPLANAR_WRITERS_GUIDE_TEXT_H
