// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair.h"
#include "failure.h"
#include "repair_steps.h"
#include "soup_topology.h"
#include "triangulate_faces.h"

#include <algorithm>
#include <utility>

namespace {

using Triangle = Repair_mesh::Triangle;

/// One face of a soup as a soup of its own.
Polygon_soup single_face(const Polygon_soup& soup, int f)
{
  Polygon_soup result;
  for (int i = 0; i < soup.face_size(f); ++i) {
    result.indices.push_back(i);
    result.points.push_back(soup.points[std::size_t(soup.face(f)[i])]);
  }
  result.close_face();
  return result;
}

/// Triangles of a polygon as triples of its corners: a fan where it crosses itself.
std::vector<Triangle> triangles_of(const Polygon_soup& soup, int f)
{
  if (soup.face_size(f) == 3) return {{0, 1, 2}};
  try {
    return triangulate_faces(single_face(soup, f), "").triangles;
  } catch (const Failure&) {
    std::vector<Triangle> fan;
    for (int i = 2; i < soup.face_size(f); ++i) fan.push_back({0, i - 1, i});
    return fan;
  }
}

Repair_mesh triangulated(const Polygon_soup& soup)
{
  Repair_mesh mesh;
  mesh.points = soup.points;
  for (int f = 0; f < soup.number_of_faces(); ++f)
    for (const Triangle& t : triangles_of(soup, f)) {
      const int first = int(soup.face_begin[std::size_t(f)]);
      mesh.corners.push_back({first + t[0], first + t[1], first + t[2]});
      mesh.triangles.push_back({soup.face(f)[t[0]], soup.face(f)[t[1]], soup.face(f)[t[2]]});
    }
  return mesh;
}

/// The looks of new triangles: no texture, no material, grey.
Soup_appearance looks_of(const Repair_mesh& mesh, const Polygon_soup& soup)
{
  Soup_appearance result = soup.appearance;
  result.texture_points.clear();
  result.corner_colours.clear();
  result.face_materials.clear();
  for (const Triangle& corners : mesh.corners) {
    const bool is_new = corners[0] == Repair_mesh::no_corner;
    for (int corner : corners) {
      if (!soup.appearance.texture_points.empty())
        result.texture_points.push_back(is_new ? no_texture_point()
                                               : soup.appearance.texture_points[std::size_t(corner)]);
      if (!soup.appearance.corner_colours.empty())
        result.corner_colours.push_back(is_new ? Soup_material().colour
                                               : soup.appearance.corner_colours[std::size_t(corner)]);
    }
    if (soup.appearance.face_materials.empty()) continue;
    const auto end = std::upper_bound(soup.face_begin.begin(), soup.face_begin.end(), std::size_t(corners[0]));
    const std::size_t face = std::size_t(end - soup.face_begin.begin()) - 1;
    result.face_materials.push_back(is_new ? -1 : soup.appearance.face_materials[face]);
  }
  return result;
}

void say_what_became_of_looks(Repair_mesh& mesh, const Polygon_soup& soup)
{
  if (soup.appearance.texture_points.empty() && soup.appearance.corner_colours.empty() &&
      soup.appearance.face_materials.empty())
    return;
  const auto plain = std::count_if(mesh.corners.begin(), mesh.corners.end(),
                                   [](const Triangle& c) { return c[0] == Repair_mesh::no_corner; });
  const std::string all = std::to_string(mesh.triangles.size());
  if (plain == std::ptrdiff_t(mesh.triangles.size())) mesh.say("texture coordinates and colours were dropped");
  else if (plain > 0)
    mesh.say("texture coordinates and colours were dropped on " + std::to_string(plain) + " new triangles of " + all);
}

Polygon_soup soup_of(const Repair_mesh& mesh, const Polygon_soup& soup)
{
  Polygon_soup result;
  result.points = mesh.points;
  for (const Triangle& t : mesh.triangles) {
    result.indices.insert(result.indices.end(), t.begin(), t.end());
    result.close_face();
  }
  result.appearance = looks_of(mesh, soup);
  remove_unused_points(result);
  return result;
}

} // namespace

Polygon_soup repair(Polygon_soup soup, std::vector<std::string>& notes)
{
  Repair_mesh mesh = triangulated(soup);
  weld(mesh);
  remove_useless_triangles(mesh);
  const Repair_mesh welded = mesh;
  if (!mesh.triangles.empty()) orient(mesh);
  if (mesh.triangles.empty() || !mend_surface(mesh)) {
    std::vector<std::string> said = std::move(mesh.notes);
    mesh = welded;
    mesh.notes = std::move(said);
    if (mesh.triangles.empty()) return soup; // nothing to wrap: refused with the rest
    wrap(mesh);
    mend_surface(mesh); // pieces too far apart are wrapped one by one
  }
  if (mesh.notes.empty()) return soup;
  say_what_became_of_looks(mesh, soup);
  notes.insert(notes.end(), mesh.notes.begin(), mesh.notes.end());
  return soup_of(mesh, soup);
}
