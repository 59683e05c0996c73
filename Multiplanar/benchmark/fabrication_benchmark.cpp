// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From flat panels to parts that fit: how long it takes and how much of the edges is joined.
//
//   fabrication_benchmark [--size MM] [--thickness MM] [SHELL.ply ...]
//
// Shells are what `multiplanar approximate` writes. Without any, polyhedra made here are used: n planes tangent to a
// sphere. Prints a line per model: panels, edges by kind of joint, the part of the length of all edges longer than 5
// thicknesses that is joined, and of all edges, the pieces, and processor seconds.

#include <CGAL/Multiplanar/internal/compatibility.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/parts_from_joints.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/convex_hull_3.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL::Multiplanar;
using Mesh = CGAL::Surface_mesh<Point_3>;

namespace {

Panel_complex read_shell(const std::string& file)
{
  Mesh mesh;
  std::ifstream in(file, std::ios::binary);
  std::string comments;
  if (!CGAL::IO::read_PLY(in, mesh, comments)) throw std::runtime_error(file + ": cannot be read");
  const auto panel = internal::found_property_map(mesh.property_map<Mesh::Face_index, int>("f:panel"));
  if (!panel.second) throw std::runtime_error(file + ": its faces have no property \"panel\"");
  Points points;
  for (auto v : mesh.vertices()) points.push_back(mesh.point(v));
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> labels;
  int panels = 0;
  for (auto f : mesh.faces()) {
    triangles.emplace_back();
    int i = 0;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) triangles.back()[i++] = int(v);
    labels.push_back(panel.first[f]);
    panels = (std::max)(panels, labels.back() + 1);
  }
  return make_panel_complex(internal::make_connectivity(triangles, int(points.size())), points, labels, panels);
}

/// The polyhedron of n planes tangent to the unit sphere, spread along a spiral, with every fifth one turned aside.
Panel_complex tangent_planes(int n)
{
  Points directions;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, a = i * 2.399963229728653 + (i % 5 == 0 ? 0.3 : 0),
                 s = std::sqrt(1 - z * z);
    directions.emplace_back(s * std::cos(a), s * std::sin(a), z);
  }
  Mesh hull;
  CGAL::convex_hull_3(directions.begin(), directions.end(), hull);
  Points corners;
  std::map<Mesh::Face_index, int> corner_of;
  for (auto f : hull.faces()) {
    std::vector<Vector_3> m;
    for (auto v : hull.vertices_around_face(hull.halfedge(f))) m.push_back(hull.point(v) - CGAL::ORIGIN);
    const Vector_3 sum =
        CGAL::cross_product(m[1], m[2]) + CGAL::cross_product(m[2], m[0]) + CGAL::cross_product(m[0], m[1]);
    corner_of[f] = int(corners.size());
    corners.push_back(CGAL::ORIGIN + sum / CGAL::determinant(m[0], m[1], m[2]));
  }
  std::vector<std::vector<std::vector<int>>> panels;
  for (auto v : hull.vertices()) {
    std::vector<int> loop; // clockwise as seen from outside
    for (auto f : hull.faces_around_target(hull.halfedge(v))) loop.push_back(corner_of[f]);
    panels.push_back({{loop.rbegin(), loop.rend()}});
  }
  return make_panel_complex_from_polygons(corners, panels);
}

void measure(const std::string& name, const Panel_complex& model, double size, const Joint_options& options)
{
  const Panel_complex complex = scaled(model, size / longest_side(model));
  const std::clock_t start = std::clock();
  const Joined_parts joined = make_joined_parts(complex, options);
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  int count[3] = {0, 0, 0}, pieces = 0;
  double all = 0, all_joined = 0, wide = 0, wide_joined = 0;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    const double length = complex.edge_length(e);
    const bool is_joined = joined.joints[e].kind != Edge_joint::Kind::none;
    ++count[int(joined.joints[e].kind)];
    all += length;
    all_joined += is_joined ? length : 0;
    if (length <= 5 * options.thickness) continue;
    wide += length;
    wide_joined += is_joined ? length : 0;
  }
  for (int panel : joined.panel_of_part) pieces += panel >= 0;
  std::printf("%-18s %6d %6d %6d %6d %6d %7.1f%% %7.1f%% %6d %6zu %7.2f\n", name.c_str(), complex.number_of_panels(),
              complex.number_of_edges(), count[0], count[1], count[2], 100 * wide_joined / wide, 100 * all_joined / all,
              pieces, joined.parts.size() - std::size_t(pieces), seconds);
}

} // namespace

int main(int argc, char** argv)
{
  double size = 300;
  Joint_options options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--size" && i + 1 < argc) size = std::atof(argv[++i]);
    else if (argument == "--thickness" && i + 1 < argc) options.thickness = std::atof(argv[++i]);
    else files.push_back(argument);
  }
  std::printf("%-18s %6s %6s %6s %6s %6s %8s %8s %6s %6s %7s\n", "model", "panels", "edges", "conn.", "teeth", "none",
              "> 5t", "all", "pieces", "conns", "CPU s");
  try {
    for (const std::string& file : files) measure(file.substr(file.rfind('/') + 1), read_shell(file), size, options);
    for (int n = 25; files.empty() && n <= 200; n *= 2)
      measure("tangent planes " + std::to_string(n), tangent_planes(n), size, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
