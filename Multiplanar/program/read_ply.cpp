// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_looks.h"
#include "Ply_values.h"
#include "read_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using Names = std::vector<std::string>;

double coordinate(const Ply_values& values, double x, const std::string& where)
{
  if (!std::isfinite(x)) throw values.error(where, "a coordinate is not finite: repair the mesh first");
  return x;
}

/// Reads a property and hands each of its values on.
template <class Take>
void read_property(const Ply_property& property, Ply_values& values, const std::string& where, const Take& take)
{
  long long count = 1;
  if (property.is_list) {
    const double announced = values.next(property.count_type);
    if (!(announced >= 0) || announced > 1e15) throw values.error(where, "a list with an impossible length");
    count = (long long)(announced);
    if (values.holds_fewer_than(count)) throw values.error(where, "the file ends within a list: it is cut short");
  }
  for (long long i = 0; i < count; ++i) take(values.next(property.type));
}

void read_vertex(const Ply_element& element, long long v, Ply_values& values, Polygon_soup& soup, Ply_looks& looks)
{
  const std::string where = "vertex " + std::to_string(v);
  std::array<double, 3> point{};
  looks.begin_vertex();
  for (const Ply_property& property : element.properties)
    if (!property.is_list && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
      point[property.name[0] - 'x'] = coordinate(values, values.next(property.type), where);
    else
      read_property(property, values, where, [&](double value) {
        if (!property.is_list) looks.value(property, value);
      });
  soup.points.push_back(point);
  looks.end_vertex();
}

void read_indices(const Ply_property& property, Ply_values& values, const std::string& where, long long vertices,
                  Polygon_soup& soup)
{
  const double size = values.next(property.count_type);
  if (!(size >= 3)) throw values.error(where, "fewer than three vertices");
  if (size > 1e9 || values.holds_fewer_than((long long)(size)))
    throw values.error(where, "the file ends within a list: it is cut short");
  for (long long i = 0; i < (long long)(size); ++i) {
    const double index = values.next(property.type);
    if (!(index >= 0 && index < double(vertices)) || index != std::floor(index))
      throw values.error(where,
                         "names a vertex that is not there (vertices are 0 to " + std::to_string(vertices - 1) + ")");
    soup.indices.push_back(int(index));
  }
}

bool is_vertex_list(const Ply_property& p)
{
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

void read_face(const Ply_element& element, long long f, Ply_values& values, const Names& wanted, long long vertices,
               Polygon_soup& soup, Ply_looks& looks)
{
  const std::string where = "face " + std::to_string(f);
  looks.begin_face();
  for (const Ply_property& property : element.properties)
    if (is_vertex_list(property)) read_indices(property, values, where, vertices, soup);
    else if (!property.is_list && std::find(wanted.begin(), wanted.end(), property.name) != wanted.end())
      soup.face_properties[property.name].push_back(values.next(property.type));
    else
      read_property(property, values, where, [&](double value) {
        if (!property.is_list) looks.value(property, value);
        else if (property.name == "texcoord") looks.texture_coordinate(value);
      });
  soup.close_face();
  looks.end_face(soup.face_size(soup.number_of_faces() - 1));
}

/// \throws Failure unless exactly one of the properties is meant by `is_meant`
template <class Predicate>
void require_once(const Ply_element& element, const Text_scanner& scanner, const std::string& what, Predicate is_meant)
{
  if (std::count_if(element.properties.begin(), element.properties.end(), is_meant) != 1)
    throw scanner.error("the element " + quoted(element.name) + " needs the property " + what + " once");
}

void check_elements(const Ply_header& header, const Text_scanner& scanner)
{
  bool vertices = false, faces = false;
  for (const Ply_element& element : header.elements) {
    if (element.name == "vertex") {
      for (const char* axis : {"x", "y", "z"})
        require_once(element, scanner, axis, [&](const Ply_property& p) { return !p.is_list && p.name == axis; });
      if (element.count > std::numeric_limits<int>::max()) throw scanner.error("too many vertices");
      if (vertices) throw scanner.error("two elements are called \"vertex\"");
      vertices = true;
    }
    if (element.name == "face") {
      require_once(element, scanner, "vertex_indices", is_vertex_list);
      if (!vertices) throw scanner.error("faces stand before the vertices");
      if (faces) throw scanner.error("two elements are called \"face\"");
      faces = true;
    }
  }
  if (!vertices || !faces) throw scanner.error("the file has no vertices or no faces: a surface is needed");
}

} // namespace

Polygon_soup read_ply(std::string_view bytes, const std::string& name, const Names& face_properties)
{
  Text_scanner scanner(bytes, name);
  const Ply_header header = read_ply_header(scanner);
  check_elements(header, scanner);
  Ply_values values(bytes, scanner, header.encoding, name);
  Polygon_soup soup;
  Ply_looks looks;
  long long vertices = 0;
  for (const Ply_element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (values.holds_fewer_than(element.count))
      throw values.error("element " + quoted(element.name),
                         std::to_string(element.count) + " are announced, but the file is too short for them");
    if (element.name == "vertex") vertices = element.count;
    for (long long i = 0; i < element.count; ++i)
      if (element.name == "vertex") read_vertex(element, i, values, soup, looks);
      else if (element.name == "face") read_face(element, i, values, face_properties, vertices, soup, looks);
      else
        for (const Ply_property& property : element.properties)
          read_property(property, values, quoted(element.name) + " " + std::to_string(i), [](double) {});
  }
  looks.finish(soup, header, name);
  return soup;
}
