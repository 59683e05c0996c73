// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_NUMBER_PARSING_H
#define MULTIPLANAR_PROGRAM_NUMBER_PARSING_H

#include <string_view>

/// The number that the whole of `text` says, whatever the locale ("nan" and "inf" count; what exceeds the range of
/// doubles becomes infinite). False if it says none.
bool parse_number(std::string_view text, double& value);
bool parse_integer(std::string_view text, long long& value);

#endif // MULTIPLANAR_PROGRAM_NUMBER_PARSING_H
