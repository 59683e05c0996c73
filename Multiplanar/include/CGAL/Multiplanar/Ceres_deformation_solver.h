// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_CERES_DEFORMATION_SOLVER_H
#define CGAL_MULTIPLANAR_CERES_DEFORMATION_SOLVER_H

#include <CGAL/Multiplanar/Deformation_weights.h>
#include <CGAL/Multiplanar/internal/deformation_terms.h>
#include <CGAL/Multiplanar/internal/elimination_order.h>
#include <CGAL/Multiplanar/internal/serial_libraries.h>

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <thread>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What the cost functions of one problem read: it outlives them and changes between solves.
struct Ceres_deformation_state
{
  Ceres_deformation_state(const Connectivity& c, const Points& rest, const Deformation_weights& w) : terms(c, rest, w)
  {
    x.resize(3 * rest.size());
    previous.resize(3 * rest.size());
  }

  Deformation_terms terms;
  std::vector<double> x;        // the unknowns, three a vertex
  std::vector<double> previous; // v'
};

/// Equations 8 (residuals 0..5) and 6 (residuals 6, 7) of one triangle.
class Ceres_triangle_cost : public ceres::SizedCostFunction<8, 3, 3, 3>
{
public:
  Ceres_triangle_cost(const Ceres_deformation_state& state, int face) : state_(&state), face_(face) {}

  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override
  {
    const Transformation_rows& rows = state_->terms.transformation(face_);
    const Vector_3& n = state_->terms.weighted_normal(face_);
    const auto& t = state_->terms.connectivity().triangles[face_];
    for (int d = 0; d < 3; ++d) {
      double u[3];
      for (int j = 0; j < 3; ++j) u[j] = x[j][d] - state_->previous[3 * std::size_t(t[j]) + d];
      for (int i = 0; i < 2; ++i) residuals[3 * i + d] = rows[i][0] * u[0] + rows[i][1] * u[1] + rows[i][2] * u[2];
    }
    for (int i = 0; i < 2; ++i)
      residuals[6 + i] =
          n.x() * (x[i + 1][0] - x[0][0]) + n.y() * (x[i + 1][1] - x[0][1]) + n.z() * (x[i + 1][2] - x[0][2]);
    if (jacobians != nullptr)
      for (int j = 0; j < 3; ++j)
        if (jacobians[j] != nullptr) write_jacobian(rows, n, j, jacobians[j]);
    return true;
  }

private:
  /// The 8 x 3 derivative by vertex j, row by row.
  static void write_jacobian(const Transformation_rows& rows, const Vector_3& n, int j, double* out)
  {
    for (int i = 0; i < 2; ++i)
      for (int d = 0; d < 3; ++d)
        for (int e = 0; e < 3; ++e) out[3 * (3 * i + d) + e] = d == e ? rows[i][j] : 0;
    for (int i = 0; i < 2; ++i) {
      const double sign = j == 0 ? -1 : j == i + 1 ? 1 : 0;
      for (int e = 0; e < 3; ++e) out[3 * (6 + i) + e] = sign * n[e];
    }
  }

  const Ceres_deformation_state* state_;
  int face_;
};

/// Equation 5 of one vertex.
class Ceres_similarity_cost : public ceres::SizedCostFunction<3, 3>
{
public:
  Ceres_similarity_cost(const Ceres_deformation_state& state, int vertex) : state_(&state), vertex_(vertex) {}

  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override
  {
    const double root = std::sqrt(state_->terms.similarity(vertex_));
    const Point_3& rest = state_->terms.rest()[vertex_];
    for (int d = 0; d < 3; ++d) residuals[d] = root * (x[0][d] - rest[d]);
    if (jacobians != nullptr && jacobians[0] != nullptr)
      for (int d = 0; d < 3; ++d)
        for (int e = 0; e < 3; ++e) jacobians[0][3 * d + e] = d == e ? root : 0;
    return true;
  }

private:
  const Ceres_deformation_state* state_;
  int vertex_;
};

/// Equation 9 of one vertex: the parameters are the vertex, then its neighbours.
class Ceres_smoothness_cost : public ceres::CostFunction
{
public:
  Ceres_smoothness_cost(double weight, int valence) : root_(std::sqrt(weight))
  {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(std::size_t(valence) + 1, 3);
  }

  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override
  {
    const int valence = int(parameter_block_sizes().size()) - 1;
    for (int d = 0; d < 3; ++d) {
      double mean = 0;
      for (int j = 1; j <= valence; ++j) mean += x[j][d];
      residuals[d] = root_ * (x[0][d] - mean / valence);
    }
    if (jacobians == nullptr) return true;
    for (int j = 0; j <= valence; ++j)
      if (jacobians[j] != nullptr)
        for (int d = 0; d < 3; ++d)
          for (int e = 0; e < 3; ++e) jacobians[j][3 * d + e] = d != e ? 0 : j == 0 ? root_ : -root_ / valence;
    return true;
  }

private:
  double root_;
};

} // namespace internal

/// \ingroup PkgMultiplanarRef
///
/// The deformation solved through Ceres: a sparse linear least-squares problem, one Gauss-Newton step a pass.
///
/// \cgalModels `MultiplanarDeformationSolver`
///
/// One `ceres::Problem` serves all passes. Its cost functions, one a triangle (equations 6 and 8), one a vertex (5)
/// and, with smoothness, one more a vertex (9), read the state of the pass from the solver. Since all residuals are
/// linear in the unknowns, one step with a trust region of no effect (radius 1e16) is the minimiser. Ceres analyses
/// and orders the system anew in every call, which is what `Cholmod_deformation_solver` saves. Move-only. Results are
/// the same bits for any number of threads.
class Ceres_deformation_solver
{
public:
  /// \copydoc MultiplanarDeformationSolver::MultiplanarDeformationSolver()
  Ceres_deformation_solver(const internal::Connectivity& connectivity, const Points& rest,
                           const Deformation_weights& weights, int threads)
      : state_(new internal::Ceres_deformation_state(connectivity, rest, weights)),
        problem_(new ceres::Problem(problem_options())), options_(solver_options(threads))
  {
    add_triangles();
    add_vertices();
    set_elimination_groups();
  }

  /// \copydoc MultiplanarDeformationSolver::solve()
  bool solve(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals, double w_p,
             const std::vector<double>& similarity_scale, Points& target)
  {
    target = current;
    if (!state_->terms.update(current, labels, normals, w_p, similarity_scale)) return false;
    std::vector<double>&x = state_->x, &previous = state_->previous;
    for (std::size_t v = 0; v < current.size(); ++v)
      for (int d = 0; d < 3; ++d) x[3 * v + d] = previous[3 * v + d] = current[v][d];

    {
      internal::Serial_libraries serial;
      ceres::Solve(options_, problem_.get(), &summary_);
    }
    if (!is_solved(summary_, w_p)) return false;
    for (std::size_t v = 0; v < current.size(); ++v) target[v] = Point_3(x[3 * v], x[3 * v + 1], x[3 * v + 2]);
    return true;
  }

  /// Ceres's account of the last solve.
  const ceres::Solver::Summary& summary() const { return summary_; }

private:
  static ceres::Problem::Options problem_options()
  {
    ceres::Problem::Options options;
    options.disable_all_safety_checks = true; // the blocks are distinct by construction; the checks take longer
    return options;
  }

  static ceres::Solver::Options solver_options(int threads)
  {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 1;
    options.initial_trust_region_radius = options.max_trust_region_radius = 1e16;
    options.function_tolerance = options.parameter_tolerance = 0; // or a small last step would be discarded
    options.gradient_tolerance = 0;
    options.min_relative_decrease = 0;
    options.jacobi_scaling = false; // Cholesky does not need it
    // Ceres complains about more threads than cores.
    options.num_threads = (std::max)(1, (std::min)(threads, int(std::thread::hardware_concurrency())));
    options.logging_type = ceres::SILENT;
    return options;
  }

  double* block(int v) { return state_->x.data() + 3 * std::size_t(v); }

  void add_triangles()
  {
    const internal::Connectivity& c = state_->terms.connectivity();
    for (int v = 0; v < c.number_of_vertices(); ++v) problem_->AddParameterBlock(block(v), 3);
    for (int f = 0; f < c.number_of_faces(); ++f) {
      const auto& t = c.triangles[f];
      problem_->AddResidualBlock(new internal::Ceres_triangle_cost(*state_, f), nullptr, block(t[0]), block(t[1]),
                                 block(t[2]));
    }
  }

  void add_vertices()
  {
    const internal::Connectivity& c = state_->terms.connectivity();
    std::vector<int> ring;
    std::vector<double*> blocks;
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      problem_->AddResidualBlock(new internal::Ceres_similarity_cost(*state_, v), nullptr, block(v));
      if (!state_->terms.has_smoothness()) continue;
      ring.assign(1, v);
      internal::append_neighbours(c, v, ring);
      blocks.clear();
      for (int u : ring) blocks.push_back(block(u));
      problem_->AddResidualBlock(new internal::Ceres_smoothness_cost(state_->terms.smoothness(), int(ring.size()) - 1),
                                 nullptr, blocks);
    }
  }

  /// Tells Ceres to eliminate the vertices in 64 consecutive groups of a nested dissection: within these it orders by
  /// minimum degree, as it would the whole, but anew in each call. Halves the arithmetic at 2 10^5 faces.
  void set_elimination_groups()
  {
    constexpr std::size_t groups = 64;
    const int rings = state_->terms.has_smoothness() ? 2 : 1;
    const std::vector<int> order =
        internal::elimination_order(internal::vertex_graph(state_->terms.connectivity(), rings));
    if (order.empty()) return; // no memory: Ceres finds an order by itself, or fails later
    auto* const grouped = new ceres::ParameterBlockOrdering;
    for (std::size_t i = 0; i < order.size(); ++i)
      grouped->AddElementToGroup(block(order[i]), int(i * groups / order.size()));
    options_.linear_solver_ordering.reset(grouped);
  }

  /// Ceres refuses a step for two reasons that look alike: the factorisation failed, or `current` already is the
  /// minimum and the step is rounding error. The gradient, whose rounding error grows with w_p^2, tells them apart.
  static bool is_solved(const ceres::Solver::Summary& summary, double w_p)
  {
    if (!summary.IsSolutionUsable() || summary.iterations.empty()) return false;
    if (summary.iterations.back().step_is_valid || summary.termination_type == ceres::CONVERGENCE) return true;
    return summary.iterations.front().gradient_max_norm <= 1e-12 * (1 + w_p * w_p);
  }

  std::unique_ptr<internal::Ceres_deformation_state> state_;
  std::unique_ptr<ceres::Problem> problem_;
  ceres::Solver::Options options_;
  ceres::Solver::Summary summary_;
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_CERES_DEFORMATION_SOLVER_H
