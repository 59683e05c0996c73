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
#include <limits>
#include <utility>
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
/// \param pull by vertex, what the weights towards it are multiplied by; empty: 1
/// \return false if the system is singular
inline bool mean_value_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                           const std::vector<char>& fixed, std::vector<Point_2d>& points,
                           const std::vector<double>& pull = {})
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
    const double w = tangent / (std::max)((shape[j] - shape[i]).norm(), 1e-12) * (pull.empty() ? 1 : pull[j]);
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

/// The doubled area of the smallest triangle in relation to the mean, the polygon being convex or the map injective.
inline double smallest_share(const Triangles& triangles, const std::vector<Point_2d>& points)
{
  double least = (std::numeric_limits<double>::max)(), sum = 0;
  for (const auto& t : triangles) {
    const double area = doubled_area(points[t[0]], points[t[1]], points[t[2]]);
    least = (std::min)(least, area);
    sum += area;
  }
  return least * double(triangles.size()) / sum;
}

/// The mean value map of a convex polygon, and where it makes triangles very small, as it does with what stands out of
/// the panel far, maps with weights that pull less towards vertices whose triangles are small (Yoshizawa, Belyaev,
/// Seidel: A fast and simple stretch-minimizing mesh parameterization, 2004). All of them are injective.
inline bool balanced_mean_value_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                                    const std::vector<char>& fixed, std::vector<Point_2d>& points)
{
  if (!mean_value_map(triangles, shape, fixed, points)) return false;
  std::vector<Point_2d> best = points;
  std::vector<double> pull(points.size(), 1);
  double share = smallest_share(triangles, points);
  for (int round = 0; round < 16 && share < 1e-4; ++round) {
    std::vector<double> flat(points.size(), 0), form(points.size(), 0);
    for (const auto& t : triangles) {
      const double area = doubled_area(points[t[0]], points[t[1]], points[t[2]]);
      const double model = (shape[t[1]] - shape[t[0]]).cross(shape[t[2]] - shape[t[0]]).norm();
      for (int v : t) flat[v] += area, form[v] += model;
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (flat[v] > 0 && form[v] > 0) pull[v] *= std::sqrt(flat[v] / form[v]);
    const double most = *std::max_element(pull.begin(), pull.end());
    for (double& w : pull) w = (std::max)(w / most, 1e-12);
    if (!mean_value_map(triangles, shape, fixed, points, pull)) break;
    const double next = smallest_share(triangles, points);
    if (next > share) share = next, best = points;
  }
  points = std::move(best);
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MEAN_VALUE_MAP_H
