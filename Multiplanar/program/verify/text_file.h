// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_TEXT_FILE_H
#define MULTIPLANAR_VERIFY_TEXT_FILE_H

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// The bytes of a file. \throw Unreadable if it cannot be opened or read
std::string read_text(const std::filesystem::path& file);

struct Parsed_number
{
  double value;
  std::size_t end; ///< position behind it
};

/// The finite number that starts at `at`, whatever the locale. Nothing if there is none.
std::optional<Parsed_number> parse_number(const std::string& text, std::size_t at);

/// All numbers of a text, parted by spaces or commas; empty if there is anything else.
std::vector<double> parse_numbers(const std::string& text);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_TEXT_FILE_H
