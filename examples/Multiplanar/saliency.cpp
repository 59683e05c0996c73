// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What saliency does, and on what scale: a sphere whose upper half is painted salient (s = 1, below s = 0),
// approximated with more and more saliency weight W. A line for each W: the panels with most of their faces in the
// upper and in the lower half; how much denser they are in the upper one, away from the equator, where panels lie in
// both; and how far the halves are from the panels, in per cent of the diagonal of the sphere's bounding box.
//   saliency [panels [fast|normal [W ...]]]

#include "painted_sphere.h"

#include <CGAL/multiplanar_approximation.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace MP = CGAL::Multiplanar;

namespace {

void print_line(double weight, const Sphere& sphere, const MP::Approximation_result& result)
{
  // The faces have nearly equal areas, so they are counted.
  const std::vector<int>& panel = result.panel_of_face;
  std::vector<double> faces(result.complex.number_of_panels(), 0), above = faces;
  for (std::size_t f = 0; f < panel.size(); ++f) {
    faces[panel[f]] += 1;
    above[panel[f]] += sphere.height[f] > 0;
  }
  int panels[2] = {0, 0};
  for (std::size_t p = 0; p < faces.size(); ++p) ++panels[above[p] > faces[p] / 2];
  double density[2] = {0, 0};
  for (std::size_t f = 0; f < panel.size(); ++f)
    if (std::abs(sphere.height[f]) > 0.4) density[sphere.height[f] > 0] += 1 / faces[panel[f]];

  double mean[2], largest[2];
  const double percent = 100 / std::sqrt(12.);
  for (int s : {0, 1}) {
    mean[s] = percent * MP::mean_distance(sphere.points, sphere.half[s], result.points, sphere.triangles);
    largest[s] =
        percent * MP::directed_hausdorff(sphere.points, sphere.half[s], result.points, sphere.triangles, 1e-3).upper;
  }
  std::printf("%3g  |  %6d  %6d  |  %7.2f  |  %6.2f  %6.2f  |  %6.2f  %6.2f\n", weight, panels[1], panels[0],
              density[1] / density[0], mean[1], mean[0], largest[1], largest[0]);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 40;
  const MP::Effort effort = argc > 2 && std::string(argv[2]) == "normal" ? MP::Effort::normal : MP::Effort::fast;
  std::vector<double> weights;
  for (int i = 3; i < argc; ++i) weights.push_back(std::atof(argv[i]));
  if (weights.empty()) weights = {0, 1, 2, 4, 8, 16, 32};

  const Mesh mesh = unit_sphere();
  const Sphere sphere(mesh);
  std::printf("     |      panels      |  density  |   mean distance  |     largest\n"
              "  W  |   s = 1   s = 0  |    ratio  |   s = 1   s = 0  |   s = 1   s = 0\n");
  for (double weight : weights) {
    Mesh result_mesh = mesh;
    auto saliency = result_mesh.add_property_map<Mesh::Face_index, double>("f:saliency", 0).first;
    for (auto f : result_mesh.faces()) saliency[f] = sphere.height[f] > 0 ? 1 : 0;
    auto panel = result_mesh.add_property_map<Mesh::Face_index, int>("f:panel").first;
    const auto np =
        MP::parameters::number_of_panels(k).effort(effort).face_saliency_map(saliency).saliency_weight(weight);
    print_line(weight, sphere, CGAL::multiplanar_approximation(result_mesh, panel, np));
  }
  return EXIT_SUCCESS;
}
