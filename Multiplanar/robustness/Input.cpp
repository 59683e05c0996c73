// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Polygons = std::vector<std::vector<std::size_t>>;

bool read_soup(const std::string& file, Input& input)
{
  try {
    if (!CGAL::IO::read_polygon_soup(file, input.points, input.polygons)) return false;
  } catch (const std::exception&) {
    return false;
  }
  for (const auto& polygon : input.polygons) {
    if (polygon.size() < 3) return false;
    for (std::size_t v : polygon)
      if (v >= input.points.size()) return false;
  }
  for (const Point_3& p : input.points)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) return false;
  return !input.polygons.empty();
}

bool has_open_edge(const Polygons& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of_edge;
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++faces_of_edge[std::minmax({polygon[i], polygon[(i + 1) % polygon.size()]})];
  return std::any_of(faces_of_edge.begin(), faces_of_edge.end(), [](const auto& edge) { return edge.second == 1; });
}

/// Equal points become the first of them; points that no polygon uses go; the order stays.
void compact(Input& input, bool weld)
{
  std::vector<std::size_t> first(input.points.size());
  std::map<Point_3, std::size_t> known;
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = weld ? known.emplace(input.points[i], i).first->second : i;
  std::vector<char> used(first.size(), 0);
  for (auto& polygon : input.polygons)
    for (std::size_t& v : polygon) used[v = first[v]] = 1;
  std::vector<std::size_t> place(first.size());
  std::vector<Point_3> kept;
  for (std::size_t i = 0; i < first.size(); ++i) {
    place[i] = kept.size();
    if (used[i]) kept.push_back(input.points[i]);
  }
  for (auto& polygon : input.polygons)
    for (std::size_t& v : polygon) v = place[v];
  input.points = std::move(kept);
}

bool repeats_a_vertex(std::vector<std::size_t> polygon)
{
  std::sort(polygon.begin(), polygon.end());
  return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
}

void judge_mesh(Input& input)
{
  Surface_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(input.points, input.polygons, mesh);
  if (!CGAL::is_closed(mesh)) input.faults.insert(Fault::open);
  std::map<Surface_mesh::Face_index, std::size_t> pieces;
  if (PMP::connected_components(mesh, boost::make_assoc_property_map(pieces)) > 1)
    input.faults.insert(Fault::components);
  if (!CGAL::is_triangle_mesh(mesh) && !PMP::triangulate_faces(mesh)) {
    input.faults.insert(Fault::not_triangulable);
    return;
  }
  input.faces = int(num_faces(mesh));
  for (auto f : faces(mesh))
    if (PMP::is_degenerate_triangle_face(f, mesh)) input.faults.insert(Fault::degenerate);
  if (input.faults.empty() && PMP::does_self_intersect(mesh)) input.faults.insert(Fault::intersecting);
  if (input.faults.empty())
    input.genus = (2 - int(num_vertices(mesh)) + int(num_edges(mesh)) - int(num_faces(mesh))) / 2;
}

struct Words
{
  const char* words;
  Fault fault;
};

/// What the program says, and what it means by it.
const Words vocabulary[] = {{"boundary loop", Fault::open},
                            {"not manifold", Fault::not_manifold},
                            {"not consistently oriented", Fault::not_manifold},
                            {"not orientable", Fault::not_manifold},
                            {"components", Fault::components},
                            {"degenerate", Fault::degenerate},
                            {"self-intersecting", Fault::intersecting},
                            {"cannot be triangulated", Fault::not_triangulable},
                            {"panels are too few", Fault::panels},
                            {"panels are more than", Fault::panels}};

} // namespace

Input read_input(const std::string& file)
{
  Input input;
  if (!read_soup(file, input)) {
    input.faults.insert(Fault::unreadable);
    return input;
  }
  compact(input, has_open_edge(input.polygons));
  if (std::any_of(input.polygons.begin(), input.polygons.end(), repeats_a_vertex))
    input.faults.insert(Fault::degenerate);
  if (!PMP::is_polygon_soup_a_polygon_mesh(input.polygons)) input.faults.insert(Fault::not_manifold);
  if (has_open_edge(input.polygons)) input.faults.insert(Fault::open);
  if (input.faults.count(Fault::not_manifold) + input.faults.count(Fault::degenerate) == 0) judge_mesh(input);
  return input;
}

bool is_right_message(const std::string& message, const std::set<Fault>& faults)
{
  for (const Words& said : vocabulary)
    if (message.find(said.words) != std::string::npos) return faults.count(said.fault) > 0;
  return faults.count(Fault::unreadable) > 0;
}
