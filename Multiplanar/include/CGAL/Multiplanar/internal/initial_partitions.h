// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_INITIAL_PARTITIONS_H
#define CGAL_MULTIPLANAR_INTERNAL_INITIAL_PARTITIONS_H

#include <CGAL/Multiplanar/internal/label_edits.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A partition of the faces into `k` connected pieces that are nearly flat: variational shape approximation (regions
/// grown from seeds, planes fitted, repeated), with proxies inserted where the cost is highest until there are k. The
/// first quarter of the seeds is random, later ones are the faces that cost most.
/// \param growth by how much the number of pieces grows per round, > 1: small steps place pieces more evenly
inline std::vector<int> grow_partition(const Input_surface& in, const std::vector<Moments>& moments,
                                       const Face_cost& cost, int k, std::uint64_t seed, double growth)
{
  const Connectivity& c = *in.connectivity;
  const int faces = c.number_of_faces();
  std::mt19937_64 random(seed);
  std::vector<int> region(faces), labels(faces, 0);
  for (int f = 0; f < faces; ++f) region[f] = f;
  std::vector<Proxy> proxies;
  std::vector<int> names, seeds;
  // At a distance r from the middle of a region, squared differences of normals are as r^2, squared distances as r^4:
  // regions whose proxies weigh w^(3/2) end where the next ones begin if they are w times as dense.
  const auto weight = [](double importance) { return importance * std::sqrt(importance); };
  const auto add = [&](int face) {
    CGAL_assertion(face >= 0 && face < faces);
    const auto& t = c.triangles[face];
    const Vec3 n = (in.points[t[1]] - in.points[t[0]]).cross(in.points[t[2]] - in.points[t[0]]).normalized();
    proxies.push_back({n, n.dot(in.points[t[0]]), weight(in.importance_of(face))});
    names.push_back(int(names.size()));
    seeds.push_back(face);
  };
  const auto draw = [&] { // in proportion to the importance
    int f;
    do f = int(random() % std::uint64_t(faces));
    while (!in.importance.empty() && double(random() >> 11) * 0x1p-53 * in.largest_importance >= in.importance[f]);
    return f;
  };
  for (int i = 0; i < (std::max)(1, k / 4); ++i) add(draw());
  const auto round = [&] {
    flood(c, region, proxies, names, seeds, cost, labels);
    std::vector<Moments> sums(proxies.size());
    std::vector<double> importance(proxies.size(), 0);
    for (int f = 0; f < faces; ++f) {
      sums[labels[f]] += moments[f];
      importance[labels[f]] += in.importance_of(f) * moments[f].area;
    }
    for (std::size_t i = 0; i < proxies.size(); ++i) {
      if (!in.importance.empty() && sums[i].area > 0) proxies[i].weight = weight(importance[i] / sums[i].area);
      if (sums[i].area > 0) fit_plane(sums[i], proxies[i].normal, proxies[i].offset);
      seeds[i] = -1;
    }
  };
  round();
  while (int(proxies.size()) < k) {
    const int more = (std::min)(k - int(proxies.size()), (std::max)(1, int(proxies.size() * (growth - 1))));
    // The worst face of each of the pieces that cost most.
    std::vector<double> total(proxies.size(), 0), worst(proxies.size(), -1);
    std::vector<int> worst_face(proxies.size(), -1), order;
    for (int f = 0; f < faces; ++f) {
      const double d = cost(f, proxies[labels[f]]), e = d / (moments[f].area > 0 ? moments[f].area : 1);
      total[labels[f]] += in.importance_of(f) * d;
      if (e > worst[labels[f]]) worst[labels[f]] = e, worst_face[labels[f]] = f;
    }
    for (std::size_t i = 0; i < proxies.size(); ++i) order.push_back(int(i));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return total[a] > total[b]; });
    for (int i = 0; i < more; ++i) { // a piece whose seed was taken by another one has no faces
      const int face = worst_face[order[i]];
      add(face >= 0 ? face : draw());
    }
    round();
    if (more > 1 || proxies.size() % 4 == 0) round();
  }
  for (int i = 0; i < 6; ++i) round();
  return labels;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_INITIAL_PARTITIONS_H
