// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mtl.h"
#include "Text_scanner.h"
#include "number_parsing.h"
#include "texture_path.h"

#include <algorithm>
#include <cmath>

using CGAL::Multiplanar::linear_of_srgb;
using CGAL::Multiplanar::Texture_wrap;

namespace {

bool is_finite_number(std::string_view word, double& value)
{
  return parse_number(word, value) && std::isfinite(value);
}

/// Takes the first word off `rest`.
std::string_view take_word(std::string_view& rest)
{
  const std::size_t begin = std::min(rest.find_first_not_of(" \t"), rest.size());
  const std::size_t end = std::min(rest.find_first_of(" \t", begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
  return word;
}

/// Takes up to `most` numbers off `rest`.
std::vector<double> take_numbers(std::string_view& rest, int most)
{
  std::vector<double> numbers;
  double value = 0;
  while (int(numbers.size()) < most) {
    std::string_view after = rest;
    if (!is_finite_number(take_word(after), value) || after.empty()) break; // the last word is the file's name
    numbers.push_back(value);
    rest = after;
  }
  return numbers;
}

void read_pair(const std::vector<double>& numbers, CGAL::Multiplanar::Texture_point& pair)
{
  for (std::size_t i = 0; i < 2 && i < numbers.size(); ++i) pair[i] = float(numbers[i]);
}

/// Reads the options of a map and takes them off: what remains is the file's name, spaces and all.
void read_options(std::string_view& rest, Soup_material& material)
{
  while (!rest.empty() && rest[0] == '-') {
    std::string_view after = rest;
    const std::string_view option = take_word(after);
    if (option == "-clamp") {
      const bool on = take_word(after) == "on";
      material.wrap_s = material.wrap_t = on ? Texture_wrap::clamp : Texture_wrap::repeat;
    } else if (option == "-s") read_pair(take_numbers(after, 3), material.scale);
    else if (option == "-o") read_pair(take_numbers(after, 3), material.offset);
    else if (option == "-t") take_numbers(after, 3);
    else if (option == "-mm") take_numbers(after, 2);
    else if (option == "-bm" || option == "-boost" || option == "-texres") take_numbers(after, 1);
    else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-imfchan" || option == "-type")
      take_word(after);
    else return; // a name that begins with '-'
    rest = after;
  }
}

void read_colour(Text_scanner& scanner, Soup_material& material)
{
  double rgb[3];
  for (int c = 0; c < 3; ++c) {
    const std::string_view word = scanner.word();
    if (c > 0 && word.empty()) rgb[c] = rgb[0]; // one value stands for all
    else if (!is_finite_number(word, rgb[c])) return;
  }
  for (int c = 0; c < 3; ++c) material.colour[c] = linear_of_srgb(float(std::min(1., std::max(0., rgb[c]))));
}

} // namespace

void read_mtl(std::string_view text, const std::string& file, std::vector<Soup_material>& materials,
              std::vector<std::string>& notes)
{
  Text_scanner scanner(text, file);
  Soup_material* material = nullptr;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "newmtl") {
      materials.emplace_back();
      material = &materials.back();
      material->name = std::string(scanner.rest_of_line());
    } else if (material && keyword == "Kd") read_colour(scanner, *material);
    else if (material && (keyword == "map_Kd" || keyword == "map_kd")) {
      std::string_view rest = scanner.rest_of_line();
      read_options(rest, *material);
      std::string reason;
      material->texture_file = file_below(folder_of(file), std::string(rest), reason);
      if (material->texture_file.empty())
        notes.push_back("texture of material " + ::quoted(material->name) + ": " + reason + ": it stays plain");
    }
    scanner.skip_line();
  }
}
