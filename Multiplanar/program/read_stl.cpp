// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "read_mesh.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

template <class T>
T little_endian(const char* bytes)
{
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8 | (unsigned char)(bytes[i]);
  T value;
  static_assert(sizeof value == sizeof bits, "32-bit values only");
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::size_t announced_size(std::string_view bytes)
{
  return header_size + triangle_size * std::size_t(little_endian<std::uint32_t>(bytes.data() + 80));
}

void add_vertex(Polygon_soup& soup, const std::array<double, 3>& point)
{
  soup.indices.push_back(int(soup.points.size()));
  soup.points.push_back(point);
}

Polygon_soup read_binary(std::string_view bytes, const std::string& name)
{
  Polygon_soup soup;
  const std::size_t triangles = (bytes.size() - header_size) / triangle_size;
  if (triangles > 500'000'000) throw input_error(name + ": more than 5e8 triangles: more than can be handled");
  for (std::size_t f = 0; f < triangles; ++f) {
    for (int i = 0; i < 3; ++i) {
      const char* vertex = bytes.data() + header_size + triangle_size * f + 12 * (i + 1);
      std::array<double, 3> p;
      for (int k = 0; k < 3; ++k) {
        p[k] = little_endian<float>(vertex + 4 * k);
        if (!std::isfinite(p[k]))
          throw input_error(name + ": face " + std::to_string(f) +
                            ": a coordinate is not finite: repair the mesh first");
      }
      add_vertex(soup, p);
    }
    soup.close_face();
  }
  return soup;
}

Polygon_soup read_text(std::string_view text, const std::string& name)
{
  Text_scanner scanner(text, name);
  Polygon_soup soup;
  std::size_t face_begin = 0;
  bool ended = false;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    ended = keyword == "endsolid";
    if (keyword == "vertex") add_vertex(soup, scanner.point());
    if (keyword == "endloop") {
      if (soup.indices.size() - face_begin != 3)
        throw scanner.error("a facet with " + std::to_string(soup.indices.size() - face_begin) + " vertices");
      face_begin = soup.indices.size();
      soup.close_face();
    }
    scanner.skip_line();
  }
  if (!ended || soup.indices.size() != face_begin) throw scanner.error("the file ends within a solid: it is cut short");
  return soup;
}

} // namespace

bool is_binary_stl(std::string_view bytes)
{
  return bytes.size() >= header_size && announced_size(bytes) == bytes.size();
}

Polygon_soup read_stl(std::string_view bytes, const std::string& name)
{
  if (is_binary_stl(bytes)) return read_binary(bytes, name);
  Text_scanner scanner(bytes, name);
  if (scanner.next_line() && scanner.word() == "solid" && bytes.find("facet") != std::string_view::npos)
    return read_text(bytes, name);
  if (bytes.size() < header_size) throw input_error(name + ": too short for STL: the file is cut short or not STL");
  throw input_error(name + ": announces " + std::to_string(little_endian<std::uint32_t>(bytes.data() + 80)) +
                    " triangles, which takes " + std::to_string(announced_size(bytes)) + " bytes, but holds " +
                    std::to_string(bytes.size()) + ": the file is cut short or not STL");
}
