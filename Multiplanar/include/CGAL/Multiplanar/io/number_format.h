// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_NUMBER_FORMAT_H
#define CGAL_MULTIPLANAR_IO_NUMBER_FORMAT_H

#include <charconv>
#include <string>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The shortest decimal number that reads back as the same double, whatever the locale.
inline std::string exact_number(double x)
{
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

/// A length in mm for drawings: at most five decimals, no exponent, no trailing zeros, no negative zero.
/// \pre |x| < 1e12
inline std::string drawing_number(double x)
{
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 5).ptr;
  std::string text(buffer, end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_NUMBER_FORMAT_H
