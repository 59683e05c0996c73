// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_CHOLMOD_DEFORMATION_SOLVER_H
#define CGAL_MULTIPLANAR_CHOLMOD_DEFORMATION_SOLVER_H

#include <CGAL/Multiplanar/Deformation_weights.h>
#include <CGAL/Multiplanar/internal/Block_cholesky.h>
#include <CGAL/Multiplanar/internal/deformation_terms.h>
#include <CGAL/Multiplanar/internal/elimination_order.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Where the last solve spent its time, in seconds.
struct Deformation_stage_times
{
  double coefficients = 0;  // of the objectives: Deformation_terms::update
  double assembly = 0;      // of the normal equations
  double factorization = 0; // numerical
  double substitution = 0;
};

/// Normal equations of one deformation problem, H u = -g for the displacement u = v - v' from the previous pass:
/// g is half the gradient of the energy at v', H half its second derivative. At v' the transformation objective has
/// no gradient.
class Deformation_normal_equations
{
public:
  /// Orders and analyses the system; keeps a pointer to `connectivity`.
  Deformation_normal_equations(const Connectivity& connectivity, const Points& rest, const Deformation_weights& weights,
                               int threads)
      : terms_(connectivity, rest, weights),
        system_(vertex_graph(connectivity, weights.smoothness > 0 ? 2 : 1), threads)
  {
    if (!system_.is_valid()) return;
    const Connectivity& c = connectivity;
    vertex_slots_.reserve(c.number_of_vertices());
    for (int v = 0; v < c.number_of_vertices(); ++v) vertex_slots_.push_back(system_.slot(v, v));
    edge_slots_.reserve(c.number_of_faces());
    for (const auto& t : c.triangles)
      edge_slots_.push_back({system_.slot(t[0], t[1]), system_.slot(t[1], t[2]), system_.slot(t[2], t[0])});
    if (terms_.has_smoothness()) prepare_smoothness();
  }

  /// Writes the displacements by vertex, three numbers each. Returns false if the system cannot be solved.
  bool solve(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals, double w_p,
             const std::vector<double>& similarity_scale, std::vector<double>& displacement)
  {
    if (!system_.is_valid()) return false;
    return timed(times_.coefficients, [&] { return terms_.update(current, labels, normals, w_p, similarity_scale); }) &&
           timed(times_.assembly, [&] { return assemble(current); }) &&
           timed(times_.factorization, [&] { return system_.factorize(); }) &&
           timed(times_.substitution, [&] { return system_.solve(right_side_, displacement); });
  }

  int rank(int v) const { return system_.rank(v); }
  std::size_t factor_bytes() const { return system_.factor_bytes(); }
  const Deformation_stage_times& stage_times() const { return times_; }

private:
  template <class Stage>
  static bool timed(double& seconds, Stage stage)
  {
    const auto begin = std::chrono::steady_clock::now();
    const bool success = stage();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return success;
  }

  bool assemble(const Points& current)
  {
    const Connectivity& c = terms_.connectivity();
    system_.set_zero();
    right_side_.assign(3 * current.size(), 0.);
    for (int v = 0; v < c.number_of_vertices(); ++v) add_similarity(v, current[v]);
    for (int f = 0; f < c.number_of_faces(); ++f) add_triangle(f, current);
    if (terms_.has_smoothness()) add_smoothness(current);
    return true;
  }

  /// Equation 5.
  void add_similarity(int v, const Point_3& p)
  {
    const double weight = terms_.similarity(v);
    system_.add_diagonal(vertex_slots_[v], {weight, 0, 0, weight, 0, weight});
    add_to_right_side(v, weight * (terms_.rest()[v] - p));
  }

  /// Equations 8 and 6.
  void add_triangle(int f, const Points& current)
  {
    const auto& t = terms_.connectivity().triangles[f];
    const Transformation_rows& r = terms_.transformation(f);
    const Vector_3& m = terms_.weighted_normal(f);
    const Symmetric_block mm = {m.x() * m.x(), m.y() * m.x(), m.z() * m.x(),
                                m.y() * m.y(), m.z() * m.y(), m.z() * m.z()};
    const auto block = [&](int i, int j, double flattening) {
      const double stiffness = r[0][i] * r[0][j] + r[1][i] * r[1][j];
      Symmetric_block b;
      for (int k = 0; k < 6; ++k) b[k] = flattening * mm[k];
      b[0] += stiffness;
      b[3] += stiffness;
      b[5] += stiffness;
      return b;
    };
    // Flattening: the squares of (v2 - v1) . m and (v3 - v1) . m.
    system_.add_diagonal(vertex_slots_[t[0]], block(0, 0, 2));
    system_.add_diagonal(vertex_slots_[t[1]], block(1, 1, 1));
    system_.add_diagonal(vertex_slots_[t[2]], block(2, 2, 1));
    system_.add_off_diagonal(edge_slots_[f][0], block(0, 1, -1));
    system_.add_off_diagonal(edge_slots_[f][1], block(1, 2, 0));
    system_.add_off_diagonal(edge_slots_[f][2], block(2, 0, -1));
    const double height2 = m * (current[t[1]] - current[t[0]]), height3 = m * (current[t[2]] - current[t[0]]);
    add_to_right_side(t[0], (height2 + height3) * m);
    add_to_right_side(t[1], -height2 * m);
    add_to_right_side(t[2], -height3 * m);
  }

  /// The coefficients of equation 9 never change: they are kept, one number for each pair of vertices that meet in
  /// one vertex's row (e_v - mean of e_u over its neighbours u).
  void prepare_smoothness()
  {
    const Connectivity& c = terms_.connectivity();
    std::vector<int> row;
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      row.assign(1, v);
      append_neighbours(c, v, row);
      const double share = -1. / double(row.size() - 1);
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = i; j < row.size(); ++j)
          smoothness_.emplace_back(system_.slot(row[i], row[j]),
                                   terms_.smoothness() * (i == 0 ? 1 : share) * (j == 0 ? 1 : share));
    }
  }

  void add_smoothness(const Points& current)
  {
    const Connectivity& c = terms_.connectivity();
    for (const auto& entry : smoothness_) system_.add_isotropic(entry.first, entry.second);
    std::vector<int> ring;
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      ring.clear();
      append_neighbours(c, v, ring);
      Vector_3 residual = NULL_VECTOR;
      for (int u : ring) residual = residual + (current[v] - current[u]);
      residual = (terms_.smoothness() / double(ring.size())) * residual;
      add_to_right_side(v, -residual);
      for (int u : ring) add_to_right_side(u, residual / double(ring.size()));
    }
  }

  void add_to_right_side(int v, const Vector_3& d)
  {
    double* const b = right_side_.data() + 3 * std::size_t(system_.rank(v));
    for (int i = 0; i < 3; ++i) b[i] += d[i];
  }

  Deformation_terms terms_;
  Block_cholesky system_;
  std::vector<Block_cholesky::Slot> vertex_slots_;
  std::vector<std::array<Block_cholesky::Slot, 3>> edge_slots_;
  std::vector<std::pair<Block_cholesky::Slot, double>> smoothness_;
  std::vector<double> right_side_; // by rank
  Deformation_stage_times times_;
};

} // namespace internal

/// \ingroup PkgMultiplanarRef
///
/// The deformation solved by a direct sparse Cholesky factorisation over CHOLMOD's ordering and supernodes.
///
/// \cgalModels `MultiplanarDeformationSolver`
///
/// The order of elimination (nested dissection) and the symbolic analysis are computed once, in the constructor; each
/// pass fills the fixed pattern and factorises. For a mesh of n faces the factor takes O(n log n) memory (measured:
/// 1.2 kB a face at 10^4 faces, 1.7 kB at 2 10^5) and O(n^1.5) time. Move-only. Results are the same bits for any
/// number of threads: see `internal::Serial_libraries`.
class Cholmod_deformation_solver
{
public:
  /// \copydoc MultiplanarDeformationSolver::MultiplanarDeformationSolver()
  Cholmod_deformation_solver(const internal::Connectivity& connectivity, const Points& rest,
                             const Deformation_weights& weights, int threads)
      : equations_(new internal::Deformation_normal_equations(connectivity, rest, weights, threads))
  {
  }

  /// \copydoc MultiplanarDeformationSolver::solve()
  bool solve(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals, double w_p,
             const std::vector<double>& similarity_scale, Points& target)
  {
    const bool solved = equations_->solve(current, labels, normals, w_p, similarity_scale, displacement_);
    target = current;
    if (!solved) return false;
    for (std::size_t v = 0; v < target.size(); ++v) {
      const double* const u = displacement_.data() + 3 * std::size_t(equations_->rank(int(v)));
      target[v] = target[v] + Vector_3(u[0], u[1], u[2]);
    }
    return true;
  }

  /// Where the last solve spent its time.
  const internal::Deformation_stage_times& stage_times() const { return equations_->stage_times(); }

  /// Bytes of the numerical factor.
  std::size_t factor_bytes() const { return equations_->factor_bytes(); }

private:
  std::unique_ptr<internal::Deformation_normal_equations> equations_;
  std::vector<double> displacement_; // by rank
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_CHOLMOD_DEFORMATION_SOLVER_H
