// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <map>

// Here are all steps that need the slow templates of CGAL's polygon mesh processing.

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Face = Surface_mesh::Face_index;
using Triangle = Repair_mesh::Triangle;

std::string counted(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

Surface_mesh surface_of(const Repair_mesh& mesh)
{
  std::vector<Point_3> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const Triangle& t : mesh.triangles) polygons.emplace_back(t.begin(), t.end());
  Surface_mesh surface;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, surface);
  return surface;
}

std::array<Point_3, 3> points_of(const Surface_mesh& surface, Face f)
{
  std::array<Point_3, 3> result;
  std::size_t i = 0;
  for (auto v : surface.vertices_around_face(surface.halfedge(f))) result[i++ % 3] = surface.point(v);
  return result;
}

/// Turned round until the smallest comes first. \return by how many places
template <class T>
std::size_t begin_with_smallest(std::array<T, 3>& values)
{
  const auto smallest = std::min_element(values.begin(), values.end());
  const std::size_t places = std::size_t(smallest - values.begin());
  std::rotate(values.begin(), smallest, values.end());
  return places;
}

/// The corners of triangles, found again by where their vertices are.
class Corners_by_place
{
public:
  explicit Corners_by_place(const Repair_mesh& mesh)
  {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      std::array<Point_3, 3> points;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& p = mesh.points[std::size_t(mesh.triangles[f][i])];
        points[i] = Point_3(p[0], p[1], p[2]);
      }
      Triangle corners = mesh.corners[f];
      std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(begin_with_smallest(points)), corners.end());
      known.emplace(points, corners);
    }
  }

  Triangle find(std::array<Point_3, 3> points) const
  {
    const std::size_t places = begin_with_smallest(points);
    const auto found = known.find(points);
    if (found == known.end()) return {Repair_mesh::no_corner, Repair_mesh::no_corner, Repair_mesh::no_corner};
    Triangle corners = found->second;
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t((3 - places) % 3), corners.end());
    return corners;
  }

private:
  std::map<std::array<Point_3, 3>, Triangle> known;
};

/// Triangles that are still where they were keep their corners.
void take_over(Surface_mesh& surface, Repair_mesh& mesh)
{
  surface.collect_garbage();
  const Corners_by_place corners(mesh);
  mesh.points.clear();
  mesh.triangles.clear();
  mesh.corners.clear();
  for (auto v : surface.vertices()) {
    const Point_3& p = surface.point(v);
    mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  for (Face f : surface.faces()) {
    Triangle t{};
    std::size_t i = 0;
    for (auto v : surface.vertices_around_face(surface.halfedge(f))) t[i++ % 3] = int(v);
    mesh.triangles.push_back(t);
    mesh.corners.push_back(corners.find(points_of(surface, f)));
  }
}

std::size_t number_of_flat_triangles(const Surface_mesh& surface)
{
  std::size_t count = 0;
  for (Face f : surface.faces()) count += PMP::is_degenerate_triangle_face(f, surface);
  return count;
}

/// What was cut apart and fits goes together again.
void stitch(Surface_mesh& surface, Repair_mesh& mesh)
{
  const std::size_t stitched = CGAL::is_closed(surface) ? 0 : PMP::stitch_borders(surface);
  if (stitched > 0) mesh.say("stitched " + counted(stitched, "pair", "pairs") + " of open edges");
}

void remove_flat_triangles(Surface_mesh& surface, Repair_mesh& mesh)
{
  const std::size_t before = number_of_flat_triangles(surface);
  if (before == 0) return;
  PMP::remove_degenerate_faces(surface);
  const std::size_t after = number_of_flat_triangles(surface);
  if (after < before) mesh.say("removed " + counted(before - after, "face", "faces") + " without area");
}

void fill_holes(Surface_mesh& surface, Repair_mesh& mesh)
{
  std::vector<Surface_mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(surface, std::back_inserter(borders));
  std::size_t holes = 0, triangles = 0;
  for (auto h : borders) {
    std::vector<Face> patch;
    PMP::triangulate_hole(surface, h, std::back_inserter(patch));
    holes += !patch.empty();
    triangles += patch.size();
  }
  if (holes > 0)
    mesh.say("filled " + counted(holes, "hole", "holes") + " with " + counted(triangles, "triangle", "triangles"));
}

/// Six times what a triangle adds to the volume, around a point of the surface.
double volume_under(const Surface_mesh& surface, Face f, const Point_3& origin)
{
  const std::array<Point_3, 3> p = points_of(surface, f);
  return CGAL::determinant(p[0] - origin, p[1] - origin, p[2] - origin);
}

void keep_largest_component(Surface_mesh& surface, Repair_mesh& mesh)
{
  std::map<Face, std::size_t> component;
  const std::size_t count = PMP::connected_components(surface, boost::make_assoc_property_map(component));
  if (count < 2) return;
  std::vector<double> volume(count, 0);
  const Point_3 origin = surface.point(*surface.vertices().begin());
  for (const auto& f : component) volume[f.second] += volume_under(surface, f.first, origin);
  std::size_t largest = 0;
  for (std::size_t c = 1; c < count; ++c)
    if (std::abs(volume[c]) > std::abs(volume[largest])) largest = c;
  PMP::keep_connected_components(surface, std::vector<std::size_t>{largest}, boost::make_assoc_property_map(component));
  mesh.say("kept the component of largest volume, left out " + counted(count - 1, "other", "others"));
}

/// Closed, and no degenerate faces: what the search for intersections needs.
bool is_sound(const Surface_mesh& surface)
{
  return !is_empty(surface) && CGAL::is_closed(surface) && number_of_flat_triangles(surface) == 0;
}

bool is_embedded(const Surface_mesh& surface) { return is_sound(surface) && !PMP::does_self_intersect(surface); }

void resolve_intersections(Surface_mesh& surface, Repair_mesh& mesh)
{
  if (!is_sound(surface)) return;
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(surface, std::back_inserter(pairs));
  if (pairs.empty()) return;
  Surface_mesh copy = surface;
  PMP::experimental::remove_self_intersections(copy, CGAL::parameters::preserve_genus(false));
  remove_flat_triangles(copy, mesh);
  if (!is_embedded(copy)) return;
  surface = copy;
  mesh.say("resolved self-intersections: " + counted(pairs.size(), "pair", "pairs") +
           " of faces intersected, the surface around them was replaced");
}

} // namespace

bool mend_surface(Repair_mesh& mesh)
{
  Surface_mesh surface = surface_of(mesh);
  stitch(surface, mesh);
  remove_flat_triangles(surface, mesh);
  fill_holes(surface, mesh);
  remove_flat_triangles(surface, mesh);
  keep_largest_component(surface, mesh);
  resolve_intersections(surface, mesh);
  keep_largest_component(surface, mesh);
  take_over(surface, mesh);
  return is_embedded(surface);
}
