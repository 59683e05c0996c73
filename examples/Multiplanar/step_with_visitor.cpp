// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Watching the iteration pass by pass, and ending it: a visitor tells how many faces change their label and how far the
// mesh has come, and stops the loop as soon as five passes in a row change nothing.
//   step_with_visitor [panels]

#include "shapes.h"

#include <CGAL/multiplanar_approximation.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace MP = CGAL::Multiplanar;
using Mesh = CGAL::Surface_mesh<MP::Point_3>;

struct Watcher : MP::Approximation_visitor
{
  explicit Watcher(const Mesh& mesh) : start(mesh.points().begin(), mesh.points().end()) {}

  /// What the labelling at the beginning of a pass did to the energy of eq. 1.
  void labelled(const MP::Labelling_record& r) override
  {
    energy = r.panels;
    quiet_passes = r.changed_faces == 0 ? quiet_passes + 1 : 0;
    changed = r.changed_faces;
  }

  /// After deformation and guarded motion.
  void pass_done(int pass, const std::vector<MP::Point_3>& points, const std::vector<int>&) override
  {
    double farthest = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
      farthest = (std::max)(farthest, CGAL::squared_distance(points[v], start[v]));
    passes = pass + 1;
    std::printf("pass %2d: energy %.4f, %4d faces changed their label, farthest vertex at %.4f\n", pass, energy,
                changed, std::sqrt(farthest));
  }

  /// False ends the loop; the panels are then made of what there is.
  bool progress(const std::string& stage, double) override { return stage != "approximate" || quiet_passes < 5; }

  std::vector<MP::Point_3> start;
  double energy = 0;
  int changed = 0, quiet_passes = 0, passes = 0;
};

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 20;
  Mesh mesh = pebble<Mesh, MP::Point_3>(16);
  auto panel = mesh.add_property_map<Mesh::Face_index, int>("f:panel").first;
  Watcher watcher(mesh);
  const auto result = CGAL::multiplanar_approximation(
      mesh, panel,
      MP::parameters::number_of_panels(k).number_of_iterations(50).effort(MP::Effort::fast).visitor(std::ref(watcher)));
  std::printf("ended after %d of 50 passes: %d panels, largest distance %.4f\n", watcher.passes,
              result.complex.number_of_panels(), result.hausdorff);
  return result.embedded && watcher.passes == result.iterations ? EXIT_SUCCESS : EXIT_FAILURE;
}
