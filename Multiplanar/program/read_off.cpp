// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "read_mesh.h"

#include <algorithm>

namespace {

/// The counts after the keyword; the number of edges may be missing.
std::array<long long, 2> read_counts(Text_scanner& scanner, std::string_view first)
{
  std::array<long long, 2> counts;
  for (int i = 0; i < 2; ++i) {
    const std::string_view word =
        i == 0 && !first.empty() ? first : scanner.word_across_lines("the number of elements");
    counts[i] = scanner.integer(word, "a number of elements");
    if (counts[i] < 0) throw scanner.error("a negative number of elements");
    if (counts[i] > 1'000'000'000)
      throw scanner.error("more than 1e9 elements are announced: more than can be handled");
  }
  scanner.skip_line();
  return counts;
}

void read_face(Text_scanner& scanner, long long vertices, Polygon_soup& soup)
{
  const long long size = scanner.integer(scanner.word(), "the number of vertices of a face");
  if (size < 3) throw scanner.error("a face with " + std::to_string(size) + " vertices");
  for (long long i = 0; i < size; ++i) {
    const long long v = scanner.integer(scanner.word_across_lines("a vertex of a face"), "a vertex number");
    if (v < 0 || v >= vertices)
      throw scanner.error("a face names vertex " + std::to_string(v) + ", but there are vertices 0 to " +
                          std::to_string(vertices - 1) + " only");
    soup.indices.push_back(int(v));
  }
  soup.close_face();
  scanner.skip_line(); // a colour may follow
}

} // namespace

Polygon_soup read_off(std::string_view text, const std::string& name)
{
  Text_scanner scanner(text, name);
  if (!scanner.next_line()) throw input_error(name + ": the file is empty: give a mesh");
  std::string_view word = scanner.word();
  if (word.find("OFF") != std::string_view::npos) {
    if (word.find('4') != std::string_view::npos || word.find('n') != std::string_view::npos)
      throw scanner.error("OFF with other than three coordinates is not a surface in space");
    word = scanner.word();
    if (word == "BINARY") throw scanner.error("binary OFF cannot be read: save it as text, or as PLY");
  }
  const std::array<long long, 2> counts = read_counts(scanner, word);
  Polygon_soup soup;
  soup.points.reserve(std::min<std::size_t>(counts[0], text.size() / 6));
  for (long long i = 0; i < counts[0]; ++i) {
    if (!scanner.next_line())
      throw scanner.error("the file ends after " + std::to_string(i) + " of " + std::to_string(counts[0]) +
                          " vertices");
    soup.points.push_back(scanner.point());
    scanner.skip_line(); // normals and colours may follow
  }
  soup.face_begin.reserve(std::min<std::size_t>(counts[1], text.size() / 8) + 1);
  for (long long i = 0; i < counts[1]; ++i) {
    if (!scanner.next_line())
      throw scanner.error("the file ends after " + std::to_string(i) + " of " + std::to_string(counts[1]) + " faces");
    read_face(scanner, counts[0], soup);
  }
  return soup;
}
