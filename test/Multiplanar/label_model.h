// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_LABEL_MODEL_H
#define MULTIPLANAR_TEST_LABEL_MODEL_H

#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/seeding.h>

#include "meshes.h"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace Multiplanar_test {

using namespace CGAL::Multiplanar;
namespace internal = CGAL::Multiplanar::internal;

/// A mesh with its costs; keeps the connectivity that the costs refer to.
struct Model
{
  Mesh mesh;
  internal::Connectivity connectivity;
  Label_costs costs;

  explicit Model(Mesh m, const Labelling_weights& weights = {}, const std::vector<double>& saliency_weight = {})
      : mesh(std::move(m)), connectivity(internal::make_connectivity(mesh.triangles, int(mesh.points.size()))),
        costs(connectivity, mesh.points, weights, saliency_weight)
  {
  }
  Model(const Model&) = delete;
};

/// Planes with random unit normals and offsets in -1/2 .. 1/2.
inline std::vector<Plane> random_planes(int n, int seed)
{
  std::mt19937_64 rng(seed);
  std::vector<Plane> planes;
  while (int(planes.size()) < n) {
    const auto coordinate = [&] { return 2 * internal::uniform_real(rng) - 1; };
    const double x = coordinate(), y = coordinate(), z = coordinate(), d = coordinate() / 2;
    const Vector_3 v(x, y, z);
    if (v.squared_length() > 0.1) planes.push_back({v / std::sqrt(v.squared_length()), d});
  }
  return planes;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_LABEL_MODEL_H
