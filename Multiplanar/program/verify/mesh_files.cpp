// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "text_file.h"

#include <cstdint>
#include <cstring>
#include <sstream>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

double to_number(const std::string& word, const std::string& place)
{
  const auto n = parse_number(word, 0);
  if (!n || n->end != word.size()) throw Unreadable(place + ": \"" + word + "\" is no number");
  return n->value;
}

} // namespace

Written_mesh read_obj(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  std::istringstream in(read_text(file));
  Written_mesh mesh;
  std::string text, key, word, group;
  for (int line = 1; std::getline(in, text); ++line) {
    const std::string place = name + ": line " + std::to_string(line);
    std::istringstream words(text);
    if (!(words >> key)) continue;
    if (key == "g" || key == "o") {
      words >> group;
    } else if (key == "v") {
      std::string x, y, z;
      if (!(words >> x >> y >> z)) throw Unreadable(place + ": a vertex has three coordinates");
      mesh.vertices.emplace_back(to_number(x, place), to_number(y, place), to_number(z, place));
    } else if (key == "f") {
      mesh.faces.emplace_back();
      mesh.groups.push_back(group);
      while (words >> word) {
        const double v = to_number(word.substr(0, word.find('/')), place);
        if (!(v >= 1 && v <= double(mesh.vertices.size()))) throw Unreadable(place + ": " + word + " is no vertex");
        mesh.faces.back().push_back(int(v) - 1);
      }
      if (mesh.faces.back().size() < 3) throw Unreadable(place + ": a face has three vertices at least");
    }
  }
  return mesh;
}

namespace {

struct Ply_property
{
  std::string name, type, count_type; ///< count_type is empty but for lists
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

class Ply_reader
{
public:
  Ply_reader(const std::string& text, const std::string& file) : text(text), file(file) {}

  Written_mesh read()
  {
    read_header();
    for (const Ply_element& element : elements)
      for (std::size_t i = 0; i < element.count; ++i) read_row(element);
    return std::move(mesh);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw Unreadable(file + ": " + what); }

  std::string header_line()
  {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) fail("breaks off in the header");
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at = end + 1;
    return line;
  }

  void read_header()
  {
    if (header_line() != "ply") fail("is no PLY");
    for (;;) {
      std::istringstream words(header_line());
      std::string key, type;
      words >> key;
      if (key == "end_header") break;
      if (key == "format") words >> format;
      else if (key == "element") {
        std::string name;
        double count = -1;
        words >> name >> count;
        if (!(count >= 0 && count < 1e9)) fail("element " + name + " has no count");
        elements.push_back({name, std::size_t(count), {}});
      } else if (key == "property") {
        if (elements.empty()) fail("a property belongs to no element");
        Ply_property p;
        words >> p.type;
        if (p.type == "list") words >> p.count_type >> p.type;
        words >> p.name;
        elements.back().properties.push_back(p);
      }
    }
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      fail("has the unknown format \"" + format + "\"");
  }

  void read_row(const Ply_element& element)
  {
    double x[3] = {0, 0, 0}, panel = -1;
    std::vector<int> face;
    for (const Ply_property& p : element.properties) {
      const std::size_t n = p.count_type.empty() ? 1 : std::size_t(value(p.count_type));
      if (n > text.size()) fail("has a list that is too long");
      for (std::size_t i = 0; i < n; ++i) {
        const double v = value(p.type);
        if (p.name == "x" || p.name == "y" || p.name == "z") x[p.name[0] - 'x'] = v;
        if (p.name == "panel") panel = v;
        if (p.name == "vertex_indices" || p.name == "vertex_index") face.push_back(int(v));
      }
    }
    if (element.name == "vertex") mesh.vertices.emplace_back(x[0], x[1], x[2]);
    if (element.name != "face") return;
    for (int v : face)
      if (v < 0 || v >= int(mesh.vertices.size()))
        fail("face " + std::to_string(mesh.faces.size()) + " has no vertex " + std::to_string(v));
    mesh.faces.push_back(face);
    mesh.panels.push_back(int(panel));
  }

  double value(const std::string& type)
  {
    if (format == "ascii") {
      at = text.find_first_not_of(" \t\r\n", at);
      if (at == std::string::npos) at = text.size();
      const auto n = parse_number(text, at);
      if (!n) fail("breaks off");
      at = n->end;
      return n->value;
    }
    if (type == "double" || type == "float64") return binary<double>();
    if (type == "float" || type == "float32") return binary<float>();
    if (type == "int" || type == "int32") return binary<std::int32_t>();
    if (type == "uint" || type == "uint32") return binary<std::uint32_t>();
    if (type == "short" || type == "int16") return binary<std::int16_t>();
    if (type == "ushort" || type == "uint16") return binary<std::uint16_t>();
    if (type == "char" || type == "int8") return binary<std::int8_t>();
    if (type == "uchar" || type == "uint8") return binary<std::uint8_t>();
    fail("has the unknown type \"" + type + "\"");
  }

  template <class T>
  double binary()
  {
    if (text.size() - at < sizeof(T)) fail("breaks off");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const std::size_t byte = format == "binary_little_endian" ? i : sizeof(T) - 1 - i;
      bits |= std::uint64_t(static_cast<unsigned char>(text[at + byte])) << (8 * i);
    }
    at += sizeof(T);
    return from_bits<T>(bits);
  }

  /// The value of the lowest bits, whatever the byte order of this machine.
  template <class T>
  static double from_bits(std::uint64_t bits)
  {
    T x;
    if constexpr (sizeof(T) == 8) {
      std::memcpy(&x, &bits, 8);
    } else if constexpr (sizeof(T) == 4) {
      const std::uint32_t b = std::uint32_t(bits);
      std::memcpy(&x, &b, 4);
    } else {
      x = T(bits);
    }
    return double(x);
  }

  const std::string& text;
  const std::string file;
  std::size_t at = 0;
  std::string format;
  std::vector<Ply_element> elements;
  Written_mesh mesh;
};

} // namespace

Written_mesh read_ply(const std::filesystem::path& file)
{
  const std::string text = read_text(file);
  return Ply_reader(text, file.filename().string()).read();
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
