// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Alpha-expansion on its own, without any mesh: the levels of a noisy picture are restored. Pixels are the nodes of a
// graph, grey levels the labels; a pixel pays for its distance from the measured value, and neighbours pay for having
// different labels.

#include <CGAL/Multiplanar/alpha_expansion.h>

#include <cmath>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

namespace {

constexpr int width = 64, height = 24, levels = 4;

int pixel(int x, int y) { return y * width + x; }

// Level 0 outside, a disc of level 3 and a bar of level 1.
int true_level(int x, int y)
{
  if ((x - 20) * (x - 20) + 4 * (y - 12) * (y - 12) < 260) return 3;
  return x > 40 && x < 58 && y > 4 && y < 19 ? 1 : 0;
}

CGAL::Multiplanar::Potts_graph neighbours(double weight)
{
  std::vector<std::pair<int, int>> edges;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) edges.emplace_back(pixel(x, y), pixel(x + 1, y));
      if (y + 1 < height) edges.emplace_back(pixel(x, y), pixel(x, y + 1));
    }
  return CGAL::Multiplanar::make_potts_graph(width * height, edges, std::vector<double>(edges.size(), weight));
}

void print(const std::vector<int>& labelling)
{
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) std::cout << " .o#"[labelling[pixel(x, y)]];
    std::cout << '\n';
  }
}

} // namespace

int main()
{
  std::mt19937 noise(1);
  std::vector<double> measured;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) measured.push_back(true_level(x, y) + 3. * (noise() % 1000) / 1000 - 1.5);

  // A data cost is anything that can be called with a node and a label.
  const auto cost = [&](int node, int label) { return std::abs(measured[node] - label); };
  const CGAL::Multiplanar::Potts_graph graph = neighbours(0.6);

  std::vector<int> labelling = CGAL::Multiplanar::cheapest_labels(graph.nodes(), levels, cost);
  std::cout << "each pixel on its own: energy " << CGAL::Multiplanar::potts_energy(graph, cost, labelling) << '\n';
  print(labelling);

  const CGAL::Multiplanar::Alpha_expansion_result result =
      CGAL::Multiplanar::alpha_expansion(graph, levels, cost, labelling);
  std::cout << "after " << result.expansions << " expansions in " << result.sweeps << " sweeps: energy "
            << result.energy << '\n';
  print(labelling);

  int wrong = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) wrong += labelling[pixel(x, y)] != true_level(x, y);
  std::cout << wrong << " of " << width * height << " pixels are not as they were before the noise\n";
  return result.converged ? 0 : 1;
}
