// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
#define CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <ceres/first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Maps of a triangulated planar domain into a polygon whose boundary positions are given, all triangles positive.
//
// 1. The discrete map with Floater's mean value weights, taken from the triangles' shapes on the model. It is injective
//    whenever the polygon is convex, and usually when it is not.
// 2. Where it is not, the *total lifted content* is minimised from there (Du, Aigerman, Zhou, Kovalsky, Yan, Kaufman, Ju:
//    Lifting Simplices to Find Injectivity, 2020): E = sum over triangles of the area of the triangle lifted to R^4 by
//    sqrt(alpha) times an equilateral triangle. As alpha -> 0, E tends to the sum of unsigned areas, whose minimum for a
//    fixed boundary is the polygon's area and is taken exactly by the injective maps.

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Point_2d = Eigen::Vector2d;
using Triangles = std::vector<std::array<int, 3>>;

/// Twice the signed area of a triangle.
inline double doubled_area(const Point_2d& a, const Point_2d& b, const Point_2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The number of triangles that are not positive by more than `tolerance` (in doubled area).
inline int count_inverted(const Triangles& triangles, const std::vector<Point_2d>& points, double tolerance)
{
  int n = 0;
  for (const auto& t : triangles) n += !(doubled_area(points[t[0]], points[t[1]], points[t[2]]) > tolerance);
  return n;
}

/// Mean value weights of every half-edge: `weights[t][i]` belongs to corner i of triangle t and holds tan(angle / 2).
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

/// Total lifted content over the free vertices, for Ceres' unconstrained minimiser.
class Total_lifted_content : public ceres::FirstOrderFunction
{
public:
  Total_lifted_content(const Triangles& triangles, const std::vector<Point_2d>& points, const std::vector<char>& fixed,
                       double alpha)
      : triangles(triangles), points(points), unknown(points.size(), -1), lifted_edge2(alpha)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!fixed[v]) unknown[v] = n++;
  }
  int NumParameters() const override { return 2 * n; }

  bool Evaluate(const double* x, double* cost, double* gradient) const override
  {
    *cost = 0;
    if (gradient) std::fill(gradient, gradient + 2 * n, 0.0);
    for (const auto& t : triangles) {
      const Point_2d a = at(x, t[0]), e1 = at(x, t[1]) - a, e2 = at(x, t[2]) - a;
      // Lifted edges are orthogonal sums of e_i and an edge of an equilateral triangle of squared side lifted_edge2.
      const double g11 = e1.squaredNorm() + lifted_edge2, g22 = e2.squaredNorm() + lifted_edge2;
      const double g12 = e1.dot(e2) + lifted_edge2 / 2;
      const double content = std::sqrt((std::max)(g11 * g22 - g12 * g12, 0.0)); // twice the area in R^4
      *cost += content;
      if (!gradient || content == 0) continue;
      const Point_2d d1 = (g22 * e1 - g12 * e2) / content, d2 = (g11 * e2 - g12 * e1) / content;
      add(gradient, t[1], d1);
      add(gradient, t[2], d2);
      add(gradient, t[0], -(d1 + d2));
    }
    return std::isfinite(*cost);
  }

  /// The vertices for the parameter vector `x`.
  std::vector<Point_2d> positions(const double* x) const
  {
    std::vector<Point_2d> result(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) result[v] = at(x, int(v));
    return result;
  }
  std::vector<double> parameters() const
  {
    std::vector<double> x(2 * std::size_t(n));
    for (std::size_t v = 0; v < points.size(); ++v)
      if (unknown[v] >= 0) x[2 * unknown[v]] = points[v].x(), x[2 * unknown[v] + 1] = points[v].y();
    return x;
  }

private:
  Point_2d at(const double* x, int v) const
  {
    return unknown[v] < 0 ? points[v] : Point_2d(x[2 * unknown[v]], x[2 * unknown[v] + 1]);
  }
  void add(double* gradient, int v, const Point_2d& d) const
  {
    if (unknown[v] < 0) return;
    gradient[2 * unknown[v]] += d.x();
    gradient[2 * unknown[v] + 1] += d.y();
  }

  const Triangles& triangles;
  const std::vector<Point_2d>& points;
  std::vector<int> unknown;
  int n = 0;
  double lifted_edge2;
};

/// Stops the minimisation as soon as every triangle is positive.
class Stop_when_injective : public ceres::IterationCallback
{
public:
  Stop_when_injective(const Total_lifted_content& content, const Triangles& triangles, const std::vector<double>& x,
                      double tolerance)
      : content(content), triangles(triangles), x(x), tolerance(tolerance)
  {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override
  {
    if (summary.iteration % 10 != 0) return ceres::SOLVER_CONTINUE;
    return count_inverted(triangles, content.positions(x.data()), tolerance) == 0 ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                                                   : ceres::SOLVER_CONTINUE;
  }

private:
  const Total_lifted_content& content;
  const Triangles& triangles;
  const std::vector<double>& x;
  double tolerance;
};

/// Minimises the total lifted content from `points`, with alpha lowered until the map is injective.
/// \return true if every triangle came out positive
inline bool untangle(const Triangles& triangles, const std::vector<char>& fixed, double polygon_area, double tolerance,
                     std::vector<Point_2d>& points)
{
  if (std::all_of(fixed.begin(), fixed.end(), [](char f) { return f; })) return false;
  const double mean_area = polygon_area / double(triangles.size());
  for (double alpha = 1e-2; alpha >= 1e-8; alpha *= 1e-1) {
    const std::vector<Point_2d> start = points;
    auto* content = new Total_lifted_content(triangles, start, fixed, alpha * mean_area);
    std::vector<double> x = content->parameters();
    ceres::GradientProblem problem(content); // takes ownership
    Stop_when_injective stop(*content, triangles, x, tolerance);
    ceres::GradientProblemSolver::Options options;
    options.line_search_direction_type = ceres::LBFGS;
    options.max_num_iterations = 300;
    options.function_tolerance = 1e-12;
    options.gradient_tolerance = 1e-14;
    options.logging_type = ceres::SILENT;
    options.update_state_every_iteration = true;
    options.callbacks.push_back(&stop);
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, x.data(), &summary);
    points = content->positions(x.data());
    if (count_inverted(triangles, points, tolerance) == 0) return true;
  }
  return false;
}

/// Positions of the free vertices such that every triangle is positive.
/// \param shape the triangles' shape on the model, which the weights come from
/// \param fixed whether a vertex keeps its place in `points`; every boundary vertex does
/// \param points in: the fixed places; out: all of them
/// \param tolerance the doubled area that counts as positive
/// \return false if some triangle could not be made positive; the best found is in `points`
inline bool injective_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                          const std::vector<char>& fixed, double polygon_area, double tolerance,
                          std::vector<Point_2d>& points)
{
  CGAL_precondition(shape.size() == points.size() && fixed.size() == points.size());
  if (mean_value_map(triangles, shape, fixed, points) && count_inverted(triangles, points, tolerance) == 0) return true;
  return untangle(triangles, fixed, polygon_area, tolerance, points);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
