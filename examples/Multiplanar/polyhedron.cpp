// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Embedding in a program with a mesh of its own: any model of `FaceListGraph` and `HalfedgeListGraph` will do, with any
// kernel whose points have coordinates that become doubles. Here CGAL's `Polyhedron_3`, whose faces have no numbers:
// the panels are kept in a map. Prints the size of each panel.
//   polyhedron [panels]

#include "shapes.h"

#include <CGAL/multiplanar_approximation.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <cstdlib>
#include <iostream>
#include <unordered_map>
#include <vector>

namespace MP = CGAL::Multiplanar;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using Face = boost::graph_traits<Polyhedron>::face_descriptor;

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 16;
  Polyhedron mesh = pebble<Polyhedron, Polyhedron::Point_3>(12);

  std::unordered_map<Face, int> panel_of_face;
  const auto result = CGAL::multiplanar_approximation(mesh, boost::make_assoc_property_map(panel_of_face),
                                                      MP::parameters::number_of_panels(k).effort(MP::Effort::fast));

  std::vector<int> size(result.complex.number_of_panels(), 0);
  for (Face f : faces(mesh)) ++size[panel_of_face.at(f)];
  for (std::size_t p = 0; p < size.size(); ++p) {
    const MP::Plane& plane = result.complex.panels[p].plane;
    std::cout << "panel " << p << ": " << size[p] << " faces in the plane " << plane.normal << " . x = " << plane.offset
              << "\n";
  }

  // The polyhedron itself has moved: its vertices lie in these planes.
  double worst = 0;
  for (Face f : faces(mesh))
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      const auto& q = v->point();
      const MP::Plane& plane = result.complex.panels[panel_of_face.at(f)].plane;
      worst = (std::max)(worst, std::abs(MP::signed_distance(plane, MP::Point_3(q.x(), q.y(), q.z()))));
    }
  std::cout << "farthest vertex from its plane: " << worst << "\n";
  return result.embedded && worst < 1e-8 ? EXIT_SUCCESS : EXIT_FAILURE;
}
