// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cctype>

namespace {

enum class Format
{
  off,
  ply,
  stl,
  obj,
  gltf,
  unknown
};

std::string extension_of(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./");
  if (dot == std::string::npos || file[dot] != '.') return "";
  std::string extension = file.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

Format format_of_extension(const std::string& extension)
{
  if (extension == "off") return Format::off;
  if (extension == "ply") return Format::ply;
  if (extension == "stl") return Format::stl;
  if (extension == "obj") return Format::obj;
  if (extension == "glb" || extension == "gltf") return Format::gltf;
  return Format::unknown;
}

bool is_off_keyword(std::string_view word)
{
  return word.size() >= 3 && word.size() <= 8 && word.substr(word.size() - 3) == "OFF" &&
         word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

bool is_obj_keyword(std::string_view word)
{
  for (const char* keyword : {"v", "vt", "vn", "f", "o", "g", "s", "mtllib", "usemtl"})
    if (word == keyword) return true;
  return false;
}

Format format_of_content(std::string_view bytes)
{
  if (bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r") return Format::ply;
  if (bytes.substr(0, 4) == "glTF") return Format::gltf;
  if (is_binary_stl(bytes)) return Format::stl;
  Text_scanner scanner(bytes.substr(0, 1 << 16), "");
  if (!scanner.next_line()) return Format::unknown;
  const std::string_view word = scanner.word();
  if (is_off_keyword(word)) return Format::off;
  if (word == "solid") return Format::stl;
  if (is_obj_keyword(word)) return Format::obj;
  return Format::unknown;
}

/// Colours of vertices become colours of corners, which joining vertices leaves alone.
void spread_colours(Polygon_soup& soup)
{
  Soup_appearance& looks = soup.appearance;
  if (looks.vertex_colours.empty()) return;
  looks.corner_colours.clear();
  for (int v : soup.indices) looks.corner_colours.push_back(looks.vertex_colours[std::size_t(v)]);
  looks.vertex_colours = {};
}

} // namespace

Polygon_soup read_mesh(const std::string& file, const std::vector<std::string>& face_properties)
{
  const std::string bytes = read_file(file);
  if (bytes.empty()) throw input_error(file + ": the file is empty: give a mesh (OFF, PLY, STL, OBJ, GLB)");
  Format format = format_of_content(bytes);
  if (format == Format::unknown) format = format_of_extension(extension_of(file));
  Polygon_soup soup;
  switch (format) {
  case Format::off:
    soup = read_off(bytes, file);
    break;
  case Format::ply:
    soup = read_ply(bytes, file, face_properties);
    break;
  case Format::stl:
    soup = read_stl(bytes, file);
    break;
  case Format::obj:
    soup = read_obj(bytes, file);
    break;
  case Format::gltf:
    soup = read_gltf(bytes, file);
    break;
  case Format::unknown:
    throw input_error(file + ": not a mesh in a known format: give OFF, PLY, STL, OBJ or GLB");
  }
  spread_colours(soup);
  if (soup.points.empty() || soup.number_of_faces() == 0)
    throw input_error(file + ": the mesh is empty (" + std::to_string(soup.points.size()) + " vertices, " +
                      std::to_string(soup.number_of_faces()) + " faces): give a closed surface");
  return soup;
}
