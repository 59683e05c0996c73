// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "number_parsing.h"
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

/// The numbers left on a line, up to one that is none.
std::vector<std::string_view> numbers_left(Text_scanner& scanner)
{
  std::vector<std::string_view> words;
  double value = 0;
  for (std::string_view word = scanner.word(); words.size() < 16 && parse_number(word, value); word = scanner.word())
    words.push_back(word);
  return words;
}

/// Three or four words as a colour: whole numbers count to 255, others to 1. Anything else is none.
bool colour_of(const std::vector<std::string_view>& words, std::size_t first, CGAL::Multiplanar::Linear_colour& colour)
{
  if (words.size() < first + 3) return false;
  bool whole = true;
  for (std::size_t c = 0; c < 3; ++c) whole = whole && words[first + c].find_first_of(".eE") == std::string_view::npos;
  for (std::size_t c = 0; c < 3; ++c) {
    double value = 0;
    parse_number(words[first + c], value);
    colour[c] = CGAL::Multiplanar::linear_of_srgb(float(std::min(1., std::max(0., value / (whole ? 255 : 1)))));
  }
  return true;
}

/// What the letters before "OFF" say of a vertex: normals and colours may follow its coordinates.
struct Off_vertex
{
  bool has_normal = false, has_colour = false;
};

/// Reads what follows the coordinates of a vertex.
void read_vertex_colour(Text_scanner& scanner, const Off_vertex& form, Polygon_soup& soup)
{
  if (!form.has_colour) return;
  CGAL::Multiplanar::Linear_colour colour{{1, 1, 1}};
  colour_of(numbers_left(scanner), form.has_normal ? 3 : 0, colour);
  soup.appearance.vertex_colours.push_back(colour);
}

/// A colour may follow the vertices of a face; it goes to all its corners.
void read_face_colour(Text_scanner& scanner, long long size, Polygon_soup& soup)
{
  auto& colours = soup.appearance.corner_colours;
  CGAL::Multiplanar::Linear_colour colour{{1, 1, 1}};
  const bool found = colour_of(numbers_left(scanner), 0, colour);
  if (!found && colours.empty()) return;
  colours.resize(soup.indices.size() - std::size_t(size), {{1, 1, 1}}); // faces before that had none
  colours.insert(colours.end(), std::size_t(size), colour);
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
  read_face_colour(scanner, size, soup);
  scanner.skip_line();
}

} // namespace

Polygon_soup read_off(std::string_view text, const std::string& name)
{
  Text_scanner scanner(text, name);
  if (!scanner.next_line()) throw input_error(name + ": the file is empty: give a mesh");
  std::string_view word = scanner.word();
  Off_vertex form;
  if (word.find("OFF") != std::string_view::npos) {
    if (word.find('4') != std::string_view::npos || word.find('n') != std::string_view::npos)
      throw scanner.error("OFF with other than three coordinates is not a surface in space");
    const std::string_view letters = word.substr(0, word.find("OFF"));
    form.has_normal = letters.find('N') != std::string_view::npos;
    form.has_colour = letters.find('C') != std::string_view::npos;
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
    read_vertex_colour(scanner, form, soup);
    scanner.skip_line();
  }
  soup.face_begin.reserve(std::min<std::size_t>(counts[1], text.size() / 8) + 1);
  for (long long i = 0; i < counts[1]; ++i) {
    if (!scanner.next_line())
      throw scanner.error("the file ends after " + std::to_string(i) + " of " + std::to_string(counts[1]) + " faces");
    read_face(scanner, counts[0], soup);
  }
  return soup;
}
