// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ply_header.h"

namespace {

Ply_type ply_type(Text_scanner& scanner)
{
  const std::string_view word = scanner.word();
  if (word == "char" || word == "int8") return Ply_type::int8;
  if (word == "uchar" || word == "uint8") return Ply_type::uint8;
  if (word == "short" || word == "int16") return Ply_type::int16;
  if (word == "ushort" || word == "uint16") return Ply_type::uint16;
  if (word == "int" || word == "int32") return Ply_type::int32;
  if (word == "uint" || word == "uint32") return Ply_type::uint32;
  if (word == "float" || word == "float32") return Ply_type::float32;
  if (word == "double" || word == "float64") return Ply_type::float64;
  throw scanner.error(quoted(std::string(word)) + " is not a type that PLY knows");
}

Ply_header::Encoding ply_encoding(Text_scanner& scanner)
{
  const std::string_view word = scanner.word();
  if (word == "ascii") return Ply_header::Encoding::ascii;
  if (word == "binary_little_endian") return Ply_header::Encoding::little_endian;
  if (word == "binary_big_endian") return Ply_header::Encoding::big_endian;
  throw scanner.error(quoted(std::string(word)) + " is not a format that PLY knows");
}

Ply_property read_property(Text_scanner& scanner)
{
  Ply_property property;
  Text_scanner look_ahead = scanner;
  property.is_list = look_ahead.word() == "list";
  if (property.is_list) {
    scanner = look_ahead;
    property.count_type = ply_type(scanner);
    if (property.count_type == Ply_type::float32 || property.count_type == Ply_type::float64)
      throw scanner.error("the length of a list is not a whole number");
  }
  property.type = ply_type(scanner);
  property.name = std::string(scanner.word());
  if (property.name.empty()) throw scanner.error("a property without a name");
  return property;
}

Ply_element read_element(Text_scanner& scanner)
{
  Ply_element element;
  element.name = std::string(scanner.word());
  element.count = scanner.integer(scanner.word(), "a number of elements");
  if (element.count < 0) throw scanner.error("a negative number of elements");
  return element;
}

} // namespace

std::size_t size_of(Ply_type type)
{
  switch (type) {
  case Ply_type::int8:
  case Ply_type::uint8:
    return 1;
  case Ply_type::int16:
  case Ply_type::uint16:
    return 2;
  case Ply_type::int32:
  case Ply_type::uint32:
  case Ply_type::float32:
    return 4;
  case Ply_type::float64:
    return 8;
  }
  return 0;
}

Ply_header read_ply_header(Text_scanner& scanner)
{
  Ply_header header;
  bool has_format = false;
  for (;;) {
    if (!scanner.next_line()) throw scanner.error("the file ends within the header");
    const std::string_view keyword = scanner.word();
    if (keyword == "format") {
      header.encoding = ply_encoding(scanner);
      has_format = true;
    } else if (keyword == "element") header.elements.push_back(read_element(scanner));
    else if (keyword == "property") {
      if (header.elements.empty()) throw scanner.error("a property before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword == "end_header") break;
    else if (keyword == "comment") {
      if (scanner.word() == "TextureFile") header.texture_files.emplace_back(scanner.rest_of_line());
    } else if (keyword != "ply" && keyword != "obj_info")
      throw scanner.error(quoted(std::string(keyword)) + " is not a statement of a PLY header");
    scanner.skip_line();
  }
  if (!has_format) throw scanner.error("the header names no format");
  return header;
}
