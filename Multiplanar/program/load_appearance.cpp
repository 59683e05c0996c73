// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "load_appearance.h"
#include "failure.h"
#include "read_image.h"
#include "read_mesh.h"

#include <cmath>
#include <exception>
#include <utility>

using namespace CGAL::Multiplanar;

namespace {

bool is_texture_point(const Texture_point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }

/// Loads the pictures of the materials, each once. \return by material: its texture, or -1
std::vector<int> load_textures(const Soup_appearance& soup, std::vector<Texture>& textures,
                               std::vector<std::string>& notes)
{
  std::vector<int> texture_of_material;
  for (const Soup_material& material : soup.materials) {
    texture_of_material.push_back(-1);
    if (!material.has_texture() || soup.texture_points.empty()) continue;
    try {
      const std::string file = material.texture_bytes.empty() ? read_file(material.texture_file) : std::string();
      Image image = read_image(material.texture_bytes.empty() ? file : material.texture_bytes);
      if (material.ignores_alpha)
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
      textures.emplace_back(std::move(image), material.wrap_s, material.wrap_t);
      texture_of_material.back() = int(textures.size()) - 1;
    } catch (const Failure& failure) {
      notes.push_back(std::string(failure.what()) + ": the material " + ::quoted(material.name) + " stays plain");
    } catch (const std::runtime_error& error) {
      const std::string where = material.texture_file.empty() ? "the embedded picture" : material.texture_file;
      notes.push_back(where + ": " + error.what() + ": the material " + ::quoted(material.name) + " stays plain");
    }
  }
  return texture_of_material;
}

/// Is there anything but one grey?
bool is_colourful(const Surface_appearance& looks)
{
  if (!looks.textures.empty()) return true;
  for (const auto& corners : looks.colours)
    for (const Linear_colour& c : corners)
      if (c != looks.colours[0][0] || c[0] != c[1] || c[1] != c[2]) return true;
  return false;
}

/// Fills in triangle after triangle of a mesh.
class Appearance_maker
{
public:
  Appearance_maker(const Input_mesh& mesh, std::vector<std::string>& notes)
      : mesh(mesh), soup(mesh.appearance), texture_of_material(load_textures(soup, result.textures, notes))
  {
  }

  Surface_appearance make()
  {
    for (std::size_t f = 0; f < mesh.corners.size(); ++f) add(int(f));
    return is_colourful(result) ? std::move(result) : Surface_appearance();
  }

private:
  const Soup_material* material_of(int f) const
  {
    if (soup.face_materials.empty()) return nullptr;
    const int m = soup.face_materials[std::size_t(mesh.face_of_triangle[std::size_t(f)])];
    return m < 0 ? nullptr : &soup.materials[std::size_t(m)];
  }

  void add(int f)
  {
    const std::array<int, 3>& corners = mesh.corners[std::size_t(f)];
    const Soup_material* material = material_of(f);
    int texture = material ? texture_of_material[std::size_t(material - soup.materials.data())] : -1;
    for (int corner : corners)
      if (texture >= 0 && !is_texture_point(soup.texture_points[std::size_t(corner)])) texture = -1;
    std::array<Linear_colour, 3> colours;
    std::array<Texture_point, 3> points{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = std::size_t(corners[i]);
      colours[i] = colour(material, texture >= 0, corner);
      for (std::size_t k = 0; k < 2 && texture >= 0; ++k)
        points[i][k] = soup.texture_points[corner][k] * material->scale[k] + material->offset[k];
    }
    result.colours.push_back(colours);
    if (result.textures.empty()) return;
    result.texture_points.push_back(points);
    result.texture_of_triangle.push_back(texture);
  }

  /// Colours of vertices multiply those of materials in glTF; elsewhere they take their place, and textures take
  /// theirs.
  Linear_colour colour(const Soup_material* material, bool textured, std::size_t corner) const
  {
    const Linear_colour of_material = !material ? Soup_material().colour : textured ? material->tint : material->colour;
    if (soup.corner_colours.empty()) return of_material;
    const Linear_colour& own = soup.corner_colours[corner];
    if (!soup.colours_multiply) return textured ? of_material : own;
    return {own[0] * of_material[0], own[1] * of_material[1], own[2] * of_material[2]};
  }

  const Input_mesh& mesh;
  const Soup_appearance& soup;
  Surface_appearance result;
  std::vector<int> texture_of_material;
};

} // namespace

std::vector<std::array<Texture_point, 3>> texture_points_of(const Input_mesh& mesh)
{
  std::vector<std::array<Texture_point, 3>> result;
  const auto& points = mesh.appearance.texture_points;
  if (points.empty()) return result;
  for (const auto& corners : mesh.corners) {
    result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Texture_point& p = points[std::size_t(corners[i])];
      result.back()[i] = is_texture_point(p) ? p : Texture_point{{0, 0}};
    }
  }
  return result;
}

Surface_appearance load_appearance(const Input_mesh& mesh, std::vector<std::string>& notes)
{
  notes.insert(notes.end(), mesh.appearance.notes.begin(), mesh.appearance.notes.end());
  return Appearance_maker(mesh, notes).make();
}
