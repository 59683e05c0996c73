// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "read_mesh.h"

#include <limits>

namespace {

/// The vertex of a face corner "v", "v/vt", "v//vn" or "v/vt/vn": counted from 1, or back from the last one if
/// negative.
int face_vertex(const Text_scanner& scanner, std::string_view word, std::size_t vertices)
{
  const long long index = scanner.integer(word.substr(0, word.find('/')), "a vertex number");
  const long long count = (long long)(vertices);
  const long long vertex = index > 0 ? index - 1 : count + index;
  if (index == 0) throw scanner.error("a face names vertex 0: OBJ counts from 1");
  if (vertex < 0 || vertex >= count)
    throw scanner.error("a face names vertex " + std::to_string(index) + " where " + std::to_string(count) +
                        " vertices are known");
  return int(vertex);
}

/// A backslash at the end of a line continues it on the next.
std::string_view next_word(Text_scanner& scanner)
{
  std::string_view word = scanner.word();
  while (word == "\\" && scanner.next_line()) word = scanner.word();
  return word;
}

void read_face(Text_scanner& scanner, Polygon_soup& soup)
{
  int size = 0;
  for (std::string_view word = next_word(scanner); !word.empty(); word = next_word(scanner), ++size)
    soup.indices.push_back(face_vertex(scanner, word, soup.points.size()));
  if (size < 3) throw scanner.error("a face with " + std::to_string(size) + " vertices");
  soup.close_face();
}

} // namespace

Polygon_soup read_obj(std::string_view text, const std::string& name)
{
  Text_scanner scanner(text, name);
  Polygon_soup soup;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      if (soup.points.size() == std::size_t(std::numeric_limits<int>::max())) throw scanner.error("too many vertices");
      soup.points.push_back(scanner.point());
    } else if (keyword == "f") read_face(scanner, soup);
    scanner.skip_line(); // weights, colours, and statements that do not concern the surface
  }
  return soup;
}
