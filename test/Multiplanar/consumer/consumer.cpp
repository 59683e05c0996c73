// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a foreign project may do with two rooms of the package.

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/hausdorff.h>

#include <cmath>
#include <cstdio>

namespace MP = CGAL::Multiplanar;

int main()
{
  // Two nodes disagree a little; staying together is cheaper.
  const MP::Potts_graph graph = MP::make_potts_graph(2, {{0, 1}}, {1.0});
  const auto cost = [](int node, int label) { return node == label ? 0.0 : 0.4; };
  std::vector<int> labels = {0, 1};
  const MP::Alpha_expansion_result result = MP::alpha_expansion(graph, 2, cost, labels);

  const MP::Points low = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, high = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  const double distance = MP::symmetric_hausdorff(low, {{0, 1, 2}}, high, {{0, 1, 2}}, 1e-6).upper();

  std::printf("energy %g, distance %g\n", result.energy, distance);
  return labels[0] == labels[1] && std::abs(result.energy - 0.4) < 1e-12 && std::abs(distance - 2) < 1e-5 ? 0 : 1;
}
