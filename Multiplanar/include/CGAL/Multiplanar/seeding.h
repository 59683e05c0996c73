// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_SEEDING_H
#define CGAL_MULTIPLANAR_SEEDING_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Plane.h>
#include <CGAL/Multiplanar/label_costs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A number in [0, 1): the upper 53 bits of the generator's next output, so the same on every platform.
inline double uniform_real(std::mt19937_64& generator) { return double(generator() >> 11) * 0x1p-53; }

/// An index drawn with probability weights[i] / sum, or -1 if no weight is positive. Indices of weight 0 are never
/// drawn.
inline int draw_index(const std::vector<double>& weights, std::mt19937_64& generator)
{
  double sum = 0;
  for (double w : weights) sum += w;
  const double target = uniform_real(generator) * sum;
  int last = -1;
  double passed = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    CGAL_precondition(weights[i] >= 0);
    if (weights[i] == 0) continue;
    last = int(i);
    passed += weights[i];
    if (target < passed) break;
  }
  return last;
}

} // namespace internal

/// Draws `k` faces by k-means++ (Arthur and Vassilvitskii 2007): the first with probability proportional to its area,
/// each further one proportional to what it costs under the best of the planes of the faces drawn so far, min_f D_p(f).
/// (D_p is a sum of lengths times an area, so it stands where the squared distance stands in k-means.)
///
/// Saliency weights: eq. 4 can only move the boundaries of the labels that there are, so the seeds follow it too. All
/// probabilities are multiplied by `seed_weight`, after which seeds come out about as dense as `seed_density` says.
///
/// When no face costs anything any more - k is at least the number of faces, or the mesh has fewer than k different
/// planes - faces are drawn as the first one was, so planes repeat. If all areas are zero, face 0 is drawn.
/// \param costs areas, normals and centroids of the faces
/// \param k how many faces are drawn
/// \param seed the result depends on it and on the costs alone, bitwise
/// \pre k >= 0; there is a face if k > 0. O(k F) time.
inline std::vector<int> seed_faces(const Label_costs& costs, int k, std::uint64_t seed)
{
  CGAL_precondition(k >= 0 && (k == 0 || costs.faces() > 0));
  std::mt19937_64 generator(seed);
  const int faces = costs.faces();
  std::vector<double> first(faces), least(faces, (std::numeric_limits<double>::max)()), cost(faces);
  for (int p = 0; p < faces; ++p) first[p] = costs.area(p) * costs.seed_weight(p);
  std::vector<int> drawn;
  while (int(drawn.size()) < k) {
    int face = drawn.empty() ? -1 : internal::draw_index(least, generator);
    if (face == -1) face = (std::max)(0, internal::draw_index(first, generator));
    drawn.push_back(face);
    costs.data_costs(costs.plane_of(face), 0, faces, cost.data());
    cost[face] = 0; // not only up to rounding: a face is never drawn twice while others cost something
    for (int p = 0; p < faces; ++p) least[p] = (std::min)(least[p], cost[p] * costs.seed_weight(p));
  }
  return drawn;
}

/// The planes of the faces that `seed_faces()` draws: the first planes of a labelling with `k` labels.
inline std::vector<Plane> seed_planes(const Label_costs& costs, int k, std::uint64_t seed)
{
  std::vector<Plane> planes;
  for (int face : seed_faces(costs, k, seed)) planes.push_back(costs.plane_of(face));
  return planes;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_SEEDING_H
