// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What saliency does, and on what scale: a sphere whose upper half is painted salient, approximated with more and more
// saliency weight W. A line for each W: the panels in either half, and how far the halves are from the panels, in per
// cent of the diagonal of the sphere's bounding box.
//   saliency [panels [fast|normal [W ...]]]

#include <CGAL/multiplanar_approximation.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace MP = CGAL::Multiplanar;
using Mesh = CGAL::Surface_mesh<MP::Point_3>;
using Triangles = std::vector<std::array<int, 3>>;

namespace {

Mesh unit_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, MP::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for (auto v : mesh.vertices()) {
    const MP::Vector_3 d = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + d / std::sqrt(d.squared_length());
  }
  return mesh;
}

MP::Points points_of(const Mesh& mesh)
{
  MP::Points points;
  for (auto v : mesh.vertices()) points.push_back(mesh.point(v));
  return points;
}

// The triangles with this saliency, or all if it is negative.
Triangles triangles_of(const Mesh& mesh, const Mesh::Property_map<Mesh::Face_index, float>& saliency, float which)
{
  Triangles triangles;
  for (auto f : mesh.faces()) {
    if (which >= 0 && saliency[f] != which) continue;
    std::array<int, 3> t;
    int i = 0;
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh)) t[i++] = int(v);
    triangles.push_back(t);
  }
  return triangles;
}

} // namespace

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 40;
  const MP::Effort effort = argc > 2 && std::string(argv[2]) == "normal" ? MP::Effort::normal : MP::Effort::fast;
  std::vector<double> weights;
  for (int i = 3; i < argc; ++i) weights.push_back(std::atof(argv[i]));
  if (weights.empty()) weights = {0, 1, 2, 4, 8, 16, 32};
  Mesh sphere = unit_sphere();
  auto saliency = sphere.add_property_map<Mesh::Face_index, float>("f:saliency", 0).first;
  for (auto f : sphere.faces()) {
    double height = 0;
    for (auto v : vertices_around_face(sphere.halfedge(f), sphere)) height += sphere.point(v).z();
    saliency[f] = height > 0 ? 1 : 0;
  }

  const MP::Points source = points_of(sphere);
  const Triangles all = triangles_of(sphere, saliency, -1);
  const double percent = 100 / std::sqrt(12.); // of the diagonal
  std::printf("     W   panels where s = 1, s = 0   ratio   mean distance s = 1, s = 0   largest s = 1, s = 0\n");
  for (double weight : weights) {
    Mesh mesh = sphere;
    auto painted = mesh.property_map<Mesh::Face_index, float>("f:saliency").first;
    auto panel = mesh.add_property_map<Mesh::Face_index, int>("f:panel").first;
    const auto result = CGAL::multiplanar_approximation(
        mesh, panel,
        MP::parameters::number_of_panels(k).effort(effort).face_saliency_map(painted).saliency_weight(weight));

    std::vector<double> height(result.complex.number_of_panels(), 0);
    for (auto f : sphere.faces()) height[panel[f]] += saliency[f] == 1 ? 1 : -1;
    int panels[2] = {0, 0};
    for (double h : height) ++panels[h > 0];
    double mean[2], largest[2];
    for (int s : {0, 1}) {
      const Triangles half = triangles_of(sphere, saliency, float(s));
      mean[s] = MP::mean_distance(source, half, result.points, all) * percent;
      largest[s] = MP::directed_hausdorff(source, half, result.points, all, 1e-3).upper * percent;
    }
    std::printf("%6g %18d %7d %7.2f %21.2f %6.2f %16.2f %6.2f\n", weight, panels[1], panels[0],
                double(panels[1]) / panels[0], mean[1], mean[0], largest[1], largest[0]);
  }
  return EXIT_SUCCESS;
}
