// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The main job: a closed triangle mesh becomes flat panels. Prints how close they are, and writes the moved mesh.
//   approximate [mesh [panels [output]]]     without a mesh: a pebble made in code

#include "shapes.h"

#include <CGAL/multiplanar_approximation.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace MP = CGAL::Multiplanar;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2) mesh = pebble<Mesh, Kernel::Point_3>(16);
  else if (!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read\n";
    return EXIT_FAILURE;
  }
  const int k = argc > 2 ? std::atoi(argv[2]) : 24;

  // The points of `mesh` move, nothing else; every face learns its panel.
  auto panel = mesh.add_property_map<Mesh::Face_index, int>("f:panel").first;
  const MP::Approximation_result result = CGAL::multiplanar_approximation(
      mesh, panel, MP::parameters::number_of_panels(k).effort(MP::Effort::fast).random_seed(1));

  std::cout << num_faces(mesh) << " faces lie in " << result.complex.number_of_panels() << " flat panels with "
            << result.complex.number_of_edges() << " edges and " << result.complex.number_of_corners() << " corners\n"
            << "largest distance from the model " << result.hausdorff << ", mean " << result.mean_distance << "\n"
            << "largest distance of a vertex from its panel " << result.planarity_deviation << "\n"
            << "closed and free of intersections: " << (result.embedded ? "yes" : "no") << "\n";

  // A panel is a polygon, possibly with holes, over the corners.
  for (int p = 0; p < 3; ++p) {
    std::cout << "panel " << p << ", area " << result.complex.area(p) << ":";
    for (int corner : result.complex.loop_corners(result.complex.panels[p].loops[0])) std::cout << ' ' << corner;
    std::cout << "\n";
  }
  for (const std::string& note : result.notes) std::cout << "note: " << note << "\n";
  if (argc > 3 && !CGAL::IO::write_polygon_mesh(argv[3], mesh, CGAL::parameters::stream_precision(17)))
    return EXIT_FAILURE;
  return result.embedded && result.complex.number_of_panels() <= k ? EXIT_SUCCESS : EXIT_FAILURE;
}
