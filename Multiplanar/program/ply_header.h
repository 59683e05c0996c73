// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PLY_HEADER_H
#define MULTIPLANAR_PROGRAM_PLY_HEADER_H

#include "Text_scanner.h"

#include <string>
#include <vector>

enum class Ply_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

std::size_t size_of(Ply_type type);

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::int32;
  bool is_list = false;
  Ply_type count_type = Ply_type::uint8; ///< of a list
};

struct Ply_element
{
  std::string name;
  long long count = 0;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  enum class Encoding
  {
    ascii,
    little_endian,
    big_endian
  };

  Encoding encoding = Encoding::ascii;
  std::vector<Ply_element> elements;
  std::vector<std::string> texture_files; ///< what lines "comment TextureFile ..." name
};

/// Reads up to and with the line `end_header`. \pre the scanner stands at the beginning of the file
Ply_header read_ply_header(Text_scanner& scanner);

#endif // MULTIPLANAR_PROGRAM_PLY_HEADER_H
