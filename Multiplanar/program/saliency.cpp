// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "saliency.h"
#include "Text_scanner.h"
#include "load_appearance.h"
#include "read_image.h"
#include "read_mesh.h"

#include <CGAL/Multiplanar/saliency_image.h>

#include <stdexcept>

namespace {

std::vector<double> values_of_text(std::string_view text, const std::string& file)
{
  Text_scanner scanner(text, file);
  std::vector<double> values;
  while (scanner.next_line())
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      values.push_back(scanner.coordinate(word));
  return values;
}

std::vector<double> values_of_ply(std::string_view bytes, const std::string& file)
{
  Polygon_soup soup = read_ply(bytes, file, {"saliency"});
  if (soup.face_properties.count("saliency") == 0)
    throw input_error(file + ": the faces have no property \"saliency\": add it as float, 0 to 1");
  return soup.face_properties["saliency"];
}

bool is_picture(std::string_view bytes)
{
  return bytes.substr(0, 4) == "\x89PNG" || bytes.substr(0, 2) == "\xff\xd8" || bytes.substr(0, 2) == "BM" ||
         bytes.substr(0, 4) == "GIF8";
}

/// By triangle: the mean of the picture over its place in the texture.
std::vector<double> values_of_picture(std::string_view bytes, const std::string& file, const Input_mesh& mesh)
{
  if (mesh.appearance.texture_points.empty())
    throw input_error(mesh.file + ": has no texture coordinates, so the picture " + file +
                      " says nothing of its faces: give a value a face, as text or PLY");
  try {
    return CGAL::Multiplanar::saliency_of_image(read_image(bytes), texture_points_of(mesh));
  } catch (const std::runtime_error& error) {
    throw input_error(file + ": " + error.what());
  }
}

} // namespace

std::vector<double> read_saliency(const std::string& file, const Input_mesh& mesh)
{
  const std::string bytes = read_file(file);
  if (is_picture(bytes)) return values_of_picture(bytes, file, mesh);
  const bool ply = bytes.compare(0, 4, "ply\n") == 0 || bytes.compare(0, 4, "ply\r") == 0;
  const std::vector<double> values = ply ? values_of_ply(bytes, file) : values_of_text(bytes, file);
  if (int(values.size()) != mesh.faces_in_file)
    throw input_error(file + ": " + std::to_string(values.size()) + " saliency values for the " +
                      std::to_string(mesh.faces_in_file) + " faces of " + mesh.file + ": give one a face");
  for (std::size_t f = 0; f < values.size(); ++f)
    if (!(values[f] >= 0 && values[f] <= 1))
      throw input_error(file + ": the saliency of face " + std::to_string(f) + " is " + std::to_string(values[f]) +
                        ": it must lie between 0 and 1");
  std::vector<double> by_triangle;
  by_triangle.reserve(mesh.face_of_triangle.size());
  for (int f : mesh.face_of_triangle) by_triangle.push_back(values[f]);
  return by_triangle;
}
