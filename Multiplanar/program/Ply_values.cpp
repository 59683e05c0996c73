// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_values.h"

#include <cstdint>
#include <cstring>

namespace {

template <class Target, class Bits>
double as(std::uint64_t bits)
{
  const Bits narrow = Bits(bits);
  Target value;
  static_assert(sizeof value == sizeof narrow, "same size");
  std::memcpy(&value, &narrow, sizeof value);
  return double(value);
}

double value_of(Ply_type type, std::uint64_t bits)
{
  switch (type) {
  case Ply_type::int8:
    return as<std::int8_t, std::uint8_t>(bits);
  case Ply_type::uint8:
    return as<std::uint8_t, std::uint8_t>(bits);
  case Ply_type::int16:
    return as<std::int16_t, std::uint16_t>(bits);
  case Ply_type::uint16:
    return as<std::uint16_t, std::uint16_t>(bits);
  case Ply_type::int32:
    return as<std::int32_t, std::uint32_t>(bits);
  case Ply_type::uint32:
    return as<std::uint32_t, std::uint32_t>(bits);
  case Ply_type::float32:
    return as<float, std::uint32_t>(bits);
  case Ply_type::float64:
    return as<double, std::uint64_t>(bits);
  }
  return 0;
}

/// Behind the line break that ends the header.
std::size_t body_begin(std::string_view bytes, std::size_t position)
{
  if (position < bytes.size() && bytes[position] == '\r') ++position;
  if (position < bytes.size() && bytes[position] == '\n') ++position;
  return position;
}

} // namespace

Ply_values::Ply_values(std::string_view bytes, Text_scanner scanner, Ply_header::Encoding encoding,
                       const std::string& name)
    : bytes(bytes), scanner(scanner), encoding(encoding), name(name), position(body_begin(bytes, scanner.offset()))
{
}

bool Ply_values::holds_fewer_than(long long values) const
{
  const bool ascii = encoding == Ply_header::Encoding::ascii;
  return (unsigned long long)(values) > (ascii ? scanner.remaining() : bytes.size() - position);
}

Failure Ply_values::error(const std::string& where, const std::string& what) const
{
  if (encoding == Ply_header::Encoding::ascii) return scanner.error(where + ": " + what);
  return input_error(name + ": " + where + ": " + what);
}

double Ply_values::next_word()
{
  const std::string_view word = scanner.word_across_lines("a value");
  double value = 0;
  if (!parse_number(word, value)) throw scanner.error(quoted(std::string(word)) + " is not a number");
  return value;
}

double Ply_values::next_binary(Ply_type type)
{
  const std::size_t size = size_of(type);
  if (bytes.size() - position < size) throw input_error(name + ": the file ends early: it is cut short");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = encoding == Ply_header::Encoding::little_endian ? position + size - 1 - i : position + i;
    bits = bits << 8 | std::uint64_t((unsigned char)(bytes[at]));
  }
  position += size;
  return value_of(type, bits);
}
