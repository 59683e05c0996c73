// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_looks.h"
#include "texture_path.h"

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

/// The place among {red, green, blue} or {s, t} that a property's name says; -1: none.
int colour_channel(const std::string& name)
{
  if (name == "red" || name == "diffuse_red") return 0;
  if (name == "green" || name == "diffuse_green") return 1;
  if (name == "blue" || name == "diffuse_blue") return 2;
  return -1;
}

int texture_axis(const std::string& name)
{
  if (name == "s" || name == "u" || name == "texture_u" || name == "texture_s") return 0;
  if (name == "t" || name == "v" || name == "texture_v" || name == "texture_t") return 1;
  return -1;
}

/// What stands for full light.
double largest(Ply_type type)
{
  switch (type) {
  case Ply_type::float32:
  case Ply_type::float64:
    return 1;
  case Ply_type::int16:
  case Ply_type::uint16:
    return 65535;
  default:
    return 255;
  }
}

} // namespace

void Ply_looks::value(const Ply_property& property, double value)
{
  const int channel = colour_channel(property.name), axis = texture_axis(property.name);
  if (channel >= 0) {
    colour[channel] = linear_of_srgb(float(std::min(1., std::max(0., value / largest(property.type)))));
    (in_faces ? has_face_colours : has_vertex_colours) = true;
  } else if (axis >= 0 && !in_faces) {
    point[axis] = float(value);
    has_points = true;
  } else if (property.name == "texnumber" && in_faces) texture = value >= 0 && value < 1e9 ? int(value) : -1;
}

void Ply_looks::end_vertex()
{
  vertex_points.push_back(point);
  vertex_colours.push_back(colour);
}

void Ply_looks::end_face(int size)
{
  const bool complete = int(corners.size()) == 2 * size;
  for (int i = 0; i < size; ++i)
    corner_points.push_back(complete ? Texture_point{{corners[2 * i], corners[2 * i + 1]}} : no_texture_point());
  has_corners = has_corners || complete;
  face_colours.push_back(colour);
  face_textures.push_back(texture);
}

void Ply_looks::finish(Polygon_soup& soup, const Ply_header& header, const std::string& file)
{
  Soup_appearance& looks = soup.appearance;
  if (has_corners) looks.texture_points = std::move(corner_points);
  else if (has_points)
    for (int v : soup.indices) looks.texture_points.push_back(vertex_points[v]);
  if (has_vertex_colours) looks.vertex_colours = std::move(vertex_colours);
  else if (has_face_colours)
    for (int f = 0; f < soup.number_of_faces(); ++f)
      looks.corner_colours.insert(looks.corner_colours.end(), soup.face_size(f), face_colours[f]);
  for (const std::string& name : header.texture_files) {
    std::string reason;
    looks.materials.emplace_back();
    looks.materials.back().name = name;
    looks.materials.back().texture_file = file_below(folder_of(file), name, reason);
    if (looks.materials.back().texture_file.empty())
      looks.notes.push_back("texture: " + reason + ": what it covers stays plain");
  }
  if (looks.materials.empty()) return;
  for (int& t : face_textures)
    if (t >= int(looks.materials.size())) t = -1;
  looks.face_materials = std::move(face_textures);
}
