// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_mesh.h"
#include "failure.h"
#include "soup_topology.h"
#include "triangulate_faces.h"

#include <CGAL/Multiplanar/internal/embedding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using CGAL::Multiplanar::Points;
using CGAL::Multiplanar::internal::Connectivity;

namespace {

/// Closes seams, and takes out what no face uses.
void tidy(Polygon_soup& soup, std::vector<std::string>& notes)
{
  const bool is_triangle_list = soup.indices.size() == soup.points.size(); // as STL is: welding is no news
  if (has_boundary(soup)) {
    const int welded = weld_equal_points(soup);
    if (welded > 0 && !is_triangle_list)
      notes.push_back(std::to_string(welded) + " vertices were welded to others with the same coordinates");
  }
  const int removed = remove_unused_points(soup);
  if (removed > 0) notes.push_back(std::to_string(removed) + " vertices that no face uses were left out");
}

/// The diagonal of the bounding box. Beyond these limits products of coordinates leave the range of doubles.
double checked_diagonal(const Polygon_soup& soup, const std::string& file)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  double largest = 0;
  for (const auto& p : soup.points)
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
      largest = (std::max)(largest, std::abs(p[i]));
    }
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (largest > 1e30 || (diagonal > 0 && diagonal < 1e-30))
    throw input_error(file + ": coordinates too large or too small to compute with (diagonal " +
                      std::to_string(std::log10(diagonal)) + " as a power of ten): scale the mesh first");
  return diagonal;
}

Points points_of(const Polygon_soup& soup)
{
  Points points;
  points.reserve(soup.points.size());
  for (const auto& p : soup.points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

void refuse_flat_triangles(const Triangulated_faces& faces, const Points& points, const std::string& file)
{
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    const auto& t = faces.triangles[i];
    if (CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
      throw input_error(file + ": face " + std::to_string(faces.face_of_triangle[i]) +
                        " is degenerate: its vertices lie on a line: --repair removes such faces");
  }
}

/// Six times the volume is negative if the faces look inward. Taken around the first point: moderate numbers.
bool is_inside_out(const std::vector<Connectivity::Triangle>& triangles, const Points& points)
{
  double volume = 0;
  for (const auto& t : triangles)
    volume += CGAL::determinant(points[t[0]] - points[0], points[t[1]] - points[0], points[t[2]] - points[0]);
  return volume < 0;
}

Connectivity connect(const Triangulated_faces& faces, int vertices, const std::string& file)
{
  try {
    return CGAL::Multiplanar::internal::make_connectivity(faces.triangles, vertices);
  } catch (const std::invalid_argument& error) { // the polygons were fine: their diagonals clash
    throw input_error(file + ": splitting faces into triangles leaves no manifold (" + error.what() +
                      "): triangulate the mesh first");
  }
}

void refuse_intersections(const Input_mesh& mesh)
{
  const auto fault = CGAL::Multiplanar::internal::find_embedding_fault(mesh.connectivity, mesh.points);
  if (fault)
    throw input_error(mesh.file + ": self-intersecting: the faces " +
                      std::to_string(mesh.face_of_triangle[fault->first]) + " and " +
                      std::to_string(mesh.face_of_triangle[fault->second]) + " intersect: --repair resolves it");
}

} // namespace

Input_mesh make_input_mesh(Polygon_soup soup, const std::string& file)
{
  Input_mesh mesh;
  mesh.file = file;
  mesh.diagonal = checked_diagonal(soup, file);
  tidy(soup, mesh.notes);
  check_topology(soup, file);
  Triangulated_faces faces = triangulate_faces(soup, file);
  mesh.points = points_of(soup);
  refuse_flat_triangles(faces, mesh.points, file);
  if (is_inside_out(faces.triangles, mesh.points)) {
    for (auto& t : faces.triangles) std::swap(t[1], t[2]);
    for (auto& c : faces.corners) std::swap(c[1], c[2]);
    mesh.notes.push_back("all faces looked inward: they were turned");
  }
  mesh.connectivity = connect(faces, int(mesh.points.size()), file);
  mesh.face_of_triangle = std::move(faces.face_of_triangle);
  mesh.corners = std::move(faces.corners);
  mesh.appearance = std::move(soup.appearance);
  mesh.faces_in_file = soup.number_of_faces();
  mesh.face_properties = std::move(soup.face_properties);
  refuse_intersections(mesh);
  return mesh;
}

void check_number_of_panels(const Input_mesh& mesh, int panels)
{
  const int genus = mesh.connectivity.genus(), least = 4 + 3 * genus, faces = mesh.connectivity.number_of_faces();
  if (panels < least)
    throw input_error(mesh.file + ": " + std::to_string(panels) + " panels are too few: a closed surface of genus " +
                      std::to_string(genus) + " needs at least " + std::to_string(least) + " (--panels)");
  if (panels > faces)
    throw input_error(mesh.file + ": " + std::to_string(panels) + " panels are more than the " + std::to_string(faces) +
                      " faces of the mesh: ask for fewer (--panels)");
}
