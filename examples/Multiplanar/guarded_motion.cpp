// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inflates a mesh into itself. Every vertex wants to go along its normal until fingers, legs and ears run into each
// other. Moved freely, the surface would soon pass through itself; with guarded motion it stops at the contact.
//
// Usage: guarded_motion [mesh.off] [output.off] [steps]. Without a mesh: a horseshoe made in code.

#include "horseshoe.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multiplanar/guarded_motion.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc < 2) mesh = horseshoe<Mesh, Kernel::Point_3>(24, 60);
  else if (!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const int steps = argc > 3 ? std::atoi(argv[3]) : 40;

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  auto target = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:target").first;
  Mesh unguarded = mesh;
  const auto inflated = [&](const Mesh& m, Mesh::Vertex_index v) {
    return m.point(v) + 0.01 * size * PMP::compute_vertex_normal(v, m);
  };

  try {
    for (int step = 0; step < steps; ++step) {
      for (auto v : mesh.vertices()) target[v] = inflated(mesh, v);
      const auto done = CGAL::Multiplanar::guarded_move(mesh, target);
      if (step % 5 == 4)
        std::cout << "step " << step + 1 << ": " << done.moved << " vertices moved, " << done.partial
                  << " part of the way, " << done.refused << " stayed" << std::endl;
    }
  } catch (const std::invalid_argument& error) {
    std::cerr << "the mesh cannot be guarded: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  // What would have happened without: the same steps, unchecked.
  for (int step = 0; step < steps; ++step) {
    for (auto v : unguarded.vertices()) target[v] = inflated(unguarded, v);
    for (auto v : unguarded.vertices()) unguarded.point(v) = target[v];
  }
  const bool guarded_intersects = PMP::does_self_intersect(mesh);
  std::cout << "inflated freely, the surface intersects itself: "
            << (PMP::does_self_intersect(unguarded) ? "yes" : "no") << std::endl
            << "inflated by guarded motion, it does: " << (guarded_intersects ? "yes" : "no") << std::endl;
  if (argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17)))
    std::cerr << argv[2] << ": cannot be written" << std::endl;
  return guarded_intersects ? EXIT_FAILURE : EXIT_SUCCESS;
}
