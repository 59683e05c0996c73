// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MEAN_VALUE_MAP_H
#define CGAL_MULTIPLANAR_INTERNAL_MEAN_VALUE_MAP_H

#include <CGAL/Multiplanar/internal/local_untangling.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Triangles = std::vector<std::array<int, 3>>;

/// tan(angle / 2) at corner i of triangle t, in `result[t][i]`.
inline std::vector<std::array<double, 3>> half_angle_tangents(const Triangles& triangles,
                                                              const std::vector<Eigen::Vector3d>& shape)
{
  std::vector<std::array<double, 3>> result(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d u = shape[triangles[t][(i + 1) % 3]] - shape[triangles[t][i]];
      const Eigen::Vector3d v = shape[triangles[t][(i + 2) % 3]] - shape[triangles[t][i]];
      const double lengths = u.norm() * v.norm(), cosine = lengths > 0 ? u.dot(v) / lengths : 0;
      // tan(x/2) = sqrt((1 - cos x) / (1 + cos x)), bounded where triangles are needles
      result[t][i] = std::sqrt((std::max)(1 - cosine, 1e-8) / (std::max)(1 + cosine, 1e-8));
    }
  return result;
}

/// Places the free vertices at the mean-value average of their neighbours. Sparse LU: the weights are not symmetric.
/// \return false if the system is singular
inline bool mean_value_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                           const std::vector<char>& fixed, std::vector<Point_2d>& points)
{
  std::vector<int> unknown(points.size(), -1);
  int n = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!fixed[v]) unknown[v] = n++;
  if (n == 0) return true;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  const auto tangents = half_angle_tangents(triangles, shape);
  const auto add = [&](int i, int j, double tangent) {
    const int row = unknown[i];
    if (row < 0) return;
    const double w = tangent / (std::max)((shape[j] - shape[i]).norm(), 1e-12);
    entries.emplace_back(row, row, w);
    if (unknown[j] >= 0) entries.emplace_back(row, unknown[j], -w);
    else right.row(row) += w * points[j].transpose();
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      add(triangles[t][i], triangles[t][(i + 1) % 3], tangents[t][i]);
      add(triangles[t][i], triangles[t][(i + 2) % 3], tangents[t][i]);
    }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
  if (lu.info() != Eigen::Success) return false;
  const Eigen::MatrixX2d solution = lu.solve(right);
  if (!solution.allFinite()) return false;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (unknown[v] >= 0) points[v] = solution.row(unknown[v]).transpose();
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MEAN_VALUE_MAP_H
