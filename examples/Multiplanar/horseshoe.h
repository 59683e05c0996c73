// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_EXAMPLES_HORSESHOE_H
#define MULTIPLANAR_EXAMPLES_HORSESHOE_H

#include <cmath>
#include <vector>

/// A closed tube of radius 0.3 along five sixths of a circle of radius 1, its ends pointing at each other.
template <class Mesh, class Point>
Mesh horseshoe(int around, int along)
{
  Mesh mesh;
  const double pi = std::acos(-1.);
  std::vector<typename Mesh::Vertex_index> ring, start;
  const auto place = [&](double angle, double radius, double turn) {
    const double r = 1 + radius * std::cos(turn);
    return mesh.add_vertex(Point(r * std::cos(angle), r * std::sin(angle), radius * std::sin(turn)));
  };
  const auto first_tip = place(0, 0, 0);
  for (int i = 0; i <= along; ++i) {
    const double angle = 5. / 3 * pi * i / along;
    std::vector<typename Mesh::Vertex_index> next;
    for (int j = 0; j < around; ++j) next.push_back(place(angle, 0.3, 2 * pi * j / around));
    for (int j = 0; j < around; ++j) {
      const int k = (j + 1) % around;
      if (i == 0) mesh.add_face(first_tip, next[j], next[k]);
      else {
        mesh.add_face(ring[j], next[k], ring[k]);
        mesh.add_face(ring[j], next[j], next[k]);
      }
    }
    ring = next;
  }
  const auto last_tip = place(5. / 3 * pi, 0, 0);
  for (int j = 0; j < around; ++j) mesh.add_face(last_tip, ring[(j + 1) % around], ring[j]);
  return mesh;
}

#endif // MULTIPLANAR_EXAMPLES_HORSESHOE_H
