// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "number_parsing.h"
#include "read_mesh.h"
#include "read_mtl.h"
#include "texture_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using CGAL::Multiplanar::Linear_colour;
using CGAL::Multiplanar::Texture_point;

namespace {

/// Reads a file line by line into a soup; remembers what later lines refer to.
class Obj_reader
{
public:
  Obj_reader(std::string_view text, const std::string& name) : scanner(text, name), name(name) {}

  Polygon_soup read()
  {
    while (scanner.next_line()) {
      const std::string_view keyword = scanner.word();
      if (keyword == "v") read_vertex();
      else if (keyword == "vt") read_texture_point();
      else if (keyword == "f") read_face();
      else if (keyword == "usemtl") material = material_called(std::string(scanner.rest_of_line()));
      else if (keyword == "mtllib") libraries.emplace_back(scanner.rest_of_line());
      scanner.skip_line(); // weights, and statements that do not concern the surface
    }
    if (!has_texture_points) soup.appearance.texture_points.clear();
    if (!has_colours) soup.appearance.vertex_colours.clear();
    read_materials();
    return std::move(soup);
  }

private:
  /// The element that a face means by a number: counted from 1, or back from the last one if negative.
  int element(std::string_view word, std::size_t size, const char* what, const char* many) const
  {
    const long long index = scanner.integer(word, what);
    const long long count = (long long)(size);
    const long long found = index > 0 ? index - 1 : count + index;
    if (index == 0) throw scanner.error(std::string("a face names ") + what + " 0: OBJ counts from 1");
    if (found < 0 || found >= count)
      throw scanner.error(std::string("a face names ") + what + " " + std::to_string(index) + " where " +
                          std::to_string(count) + " " + many + " are known");
    return int(found);
  }

  /// "v x y z", maybe with a weight, or with the colour that several programs put there.
  void read_vertex()
  {
    if (soup.points.size() == std::size_t(std::numeric_limits<int>::max())) throw scanner.error("too many vertices");
    soup.points.push_back(scanner.point());
    std::vector<double> extra;
    double value = 0;
    for (std::string_view word = scanner.word(); extra.size() < 4 && parse_number(word, value); word = scanner.word())
      extra.push_back(value);
    Linear_colour colour{{1, 1, 1}};
    if (extra.size() >= 3) {
      const std::size_t first = extra.size() - 3; // behind the weight, if there is one
      const double whole = *std::max_element(extra.begin() + std::ptrdiff_t(first), extra.end()) > 1 ? 255 : 1;
      for (int c = 0; c < 3; ++c)
        colour[c] =
            CGAL::Multiplanar::linear_of_srgb(float(std::min(1., std::max(0., extra[first + std::size_t(c)] / whole))));
      has_colours = true;
    }
    soup.appearance.vertex_colours.push_back(colour);
  }

  void read_texture_point()
  {
    Texture_point point{{0, 0}};
    for (int i = 0; i < 2; ++i) {
      const std::string_view word = scanner.word();
      if (word.empty() && i == 0) throw scanner.error("a texture point needs coordinates");
      if (!word.empty()) point[i] = float(scanner.coordinate(word));
    }
    texture_points.push_back(point);
  }

  /// A backslash at the end of a line continues it on the next.
  std::string_view next_word()
  {
    std::string_view word = scanner.word();
    while (word == "\\" && scanner.next_line()) word = scanner.word();
    return word;
  }

  /// "v", "v/vt", "v//vn" or "v/vt/vn".
  void read_corner(std::string_view word)
  {
    const std::size_t slash = word.find('/');
    soup.indices.push_back(element(word.substr(0, slash), soup.points.size(), "vertex", "vertices"));
    Texture_point place = no_texture_point();
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1), index = rest.substr(0, rest.find('/'));
      if (!index.empty()) {
        place = texture_points[std::size_t(element(index, texture_points.size(), "texture point", "texture points"))];
        has_texture_points = true;
      }
    }
    soup.appearance.texture_points.push_back(place);
  }

  void read_face()
  {
    int size = 0;
    for (std::string_view word = next_word(); !word.empty(); word = next_word(), ++size) read_corner(word);
    if (size < 3) throw scanner.error("a face with " + std::to_string(size) + " vertices");
    soup.close_face();
    soup.appearance.face_materials.push_back(material);
  }

  int material_called(const std::string& called)
  {
    const auto place = materials.emplace(called, int(materials.size()));
    if (place.second) names.push_back(called);
    return place.first->second;
  }

  /// A statement names one library, in which spaces are allowed, or several.
  std::vector<std::string> files_of_libraries()
  {
    std::vector<std::string> files;
    for (const std::string& library : libraries) {
      std::string reason;
      const std::string whole = file_below(folder_of(name), library, reason);
      if (!whole.empty()) files.push_back(whole);
      Text_scanner words(whole.empty() ? std::string_view(library) : std::string_view(), name);
      if (!words.next_line()) continue;
      for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
        std::string file = file_below(folder_of(name), std::string(word), reason);
        if (file.empty()) soup.appearance.notes.push_back("materials: " + reason + ": what they colour stays plain");
        else files.push_back(std::move(file));
      }
    }
    return files;
  }

  /// The materials that faces use, in the order in which they first do.
  void read_materials()
  {
    Soup_appearance& appearance = soup.appearance;
    if (names.empty()) {
      appearance.face_materials.clear();
      return;
    }
    std::vector<Soup_material> known;
    std::vector<std::string> notes;
    for (const std::string& file : files_of_libraries()) read_mtl(read_file(file), file, known, notes);
    for (const std::string& called : names) {
      const auto found =
          std::find_if(known.begin(), known.end(), [&](const Soup_material& m) { return m.name == called; });
      appearance.materials.push_back(found == known.end() ? Soup_material() : *found);
      appearance.materials.back().name = called;
      if (found == known.end() && !libraries.empty())
        appearance.notes.push_back("the material " + ::quoted(called) + " is in no library: it stays plain");
    }
    appearance.notes.insert(appearance.notes.end(), notes.begin(), notes.end());
  }

  Text_scanner scanner;
  std::string name;
  Polygon_soup soup;
  std::vector<Texture_point> texture_points;
  std::vector<std::string> libraries, names; ///< files; materials in the order of their numbers
  std::map<std::string, int> materials;
  int material = -1;
  bool has_texture_points = false, has_colours = false;
};

} // namespace

Polygon_soup read_obj(std::string_view text, const std::string& name) { return Obj_reader(text, name).read(); }
