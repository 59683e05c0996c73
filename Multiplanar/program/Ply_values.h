// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PLY_VALUES_H
#define MULTIPLANAR_PROGRAM_PLY_VALUES_H

#include "Text_scanner.h"
#include "number_parsing.h"
#include "ply_header.h"

#include <string>
#include <string_view>

/// The numbers behind the header of a PLY file, one after the other, whatever their encoding.
class Ply_values
{
public:
  /// \param scanner stands behind the header
  Ply_values(std::string_view bytes, Text_scanner scanner, Ply_header::Encoding encoding, const std::string& name);

  /// The next number. Whole numbers of all types are exact in a double.
  double next(Ply_type type) { return encoding == Ply_header::Encoding::ascii ? next_word() : next_binary(type); }
  /// At least so many further values cannot be there.
  bool holds_fewer_than(long long values) const;
  /// \param where names the element that is read, for instance "face 12"
  Failure error(const std::string& where, const std::string& what) const;

private:
  double next_word();
  double next_binary(Ply_type type);

  std::string_view bytes;
  Text_scanner scanner;
  Ply_header::Encoding encoding;
  std::string name;
  std::size_t position;
};

#endif // MULTIPLANAR_PROGRAM_PLY_VALUES_H
