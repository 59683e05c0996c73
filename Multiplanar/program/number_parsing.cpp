// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_parsing.h"

#include <charconv>
#include <limits>
#include <string>
#include <system_error>

namespace {

std::string_view without_plus(std::string_view text)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

/// from_chars reports numbers too large and too small for a double alike: the sign of the exponent tells which.
double out_of_range(std::string_view text)
{
  const bool negative = text[0] == '-';
  const std::size_t e = text.find_first_of("eE");
  const bool tiny = e != std::string_view::npos ? e + 1 < text.size() && text[e + 1] == '-'
                                                : text.substr(negative, 2) == "0." || text.substr(negative, 1) == ".";
  if (tiny) return 0;
  return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

} // namespace

bool parse_number(std::string_view text, double& value)
{
  text = without_plus(text);
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ptr != text.data() + text.size() || text.empty()) return false;
  if (result.ec == std::errc::result_out_of_range) value = out_of_range(text);
  return result.ec == std::errc() || result.ec == std::errc::result_out_of_range;
}

bool parse_integer(std::string_view text, long long& value)
{
  text = without_plus(text);
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size() && !text.empty();
}
