// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "text_file.h"

#include "written_model.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

namespace CGAL {
namespace Multiplanar {
namespace verification {

std::string read_text(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) throw Unreadable(file.filename().string() + ": cannot be opened");
  return text;
}

std::optional<Parsed_number> parse_number(const std::string& text, std::size_t at)
{
  if (at < text.size() && text[at] == '+') ++at;
  if (at >= text.size()) return std::nullopt;
  double value;
  const auto result = std::from_chars(text.data() + at, text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  return Parsed_number{value, std::size_t(result.ptr - text.data())};
}

std::vector<double> parse_numbers(const std::string& text)
{
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(" ,\t\r\n"); at < text.size();
       at = text.find_first_not_of(" ,\t\r\n", at)) {
    const auto n = parse_number(text, at);
    if (!n) return {};
    numbers.push_back(n->value);
    at = n->end;
  }
  return numbers;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
