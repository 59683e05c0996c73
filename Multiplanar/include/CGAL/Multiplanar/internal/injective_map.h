// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
#define CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/local_untangling.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Maps of a triangulated planar domain into a polygon whose boundary positions are given, all triangles positive:
// 1. the discrete map with Floater's mean value weights, taken from the triangles' shapes on the model. It is injective
//    whenever the polygon is convex, and usually when it is not;
// 2. where it is not, the total lifted content is minimised from there.

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

/// Positions of the free vertices such that every triangle is positive.
/// \param shape the vertices on the model, whose triangles the weights come from
/// \param fixed whether a vertex keeps its place in `points`; every boundary vertex does
/// \param polygon_area in the plane
/// \param tolerance the doubled area that counts as positive
/// \param points in: the fixed places; out: all of them
/// \return false if some triangle could not be made positive; the best found is in `points`
inline bool injective_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                          const std::vector<char>& fixed, double polygon_area, double tolerance,
                          std::vector<Point_2d>& points)
{
  CGAL_precondition(shape.size() == points.size() && fixed.size() == points.size());
  mean_value_map(triangles, shape, fixed, points);
  Planar_complex complex;
  complex.triangles = triangles;
  complex.tolerance.assign(triangles.size(), tolerance);
  std::vector<double> x;
  for (std::size_t v = 0; v < points.size(); ++v) {
    Planar_node node;
    node.base = points[v];
    if (!fixed[v]) {
      node.kind = Planar_node::Kind::free;
      node.unknown = int(x.size());
      x.push_back(points[v].x());
      x.push_back(points[v].y());
    }
    complex.nodes.push_back(node);
  }
  complex.unknowns = int(x.size());
  if (complex.count_inverted(x.data()) == 0) return true;
  const bool ok = untangle(complex, std::abs(polygon_area) / double(triangles.size()), x);
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = complex.nodes[v].at(x.data());
  return ok;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
