// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ANY_DEFORMATION_SOLVER_H
#define CGAL_MULTIPLANAR_INTERNAL_ANY_DEFORMATION_SOLVER_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/Ceres_deformation_solver.h>
#include <CGAL/Multiplanar/Cholmod_deformation_solver.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A model of `MultiplanarDeformationSolver` chosen at run time.
class Any_deformation_solver
{
public:
  virtual ~Any_deformation_solver() = default;
  virtual bool solve(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals,
                     double w_p, const std::vector<double>& similarity_scale, Points& target) = 0;
};

template <class Model>
class Wrapped_deformation_solver : public Any_deformation_solver
{
public:
  Wrapped_deformation_solver(const Connectivity& c, const Points& rest, const Deformation_weights& weights, int threads)
      : model(c, rest, weights, threads)
  {}
  bool solve(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals, double w_p,
             const std::vector<double>& similarity_scale, Points& target) override
  {
    return model.solve(current, labels, normals, w_p, similarity_scale, target);
  }

private:
  Model model;
};

/// `automatic` is the direct solver: `benchmark/deformation_benchmark` shows it faster than Ceres at every size.
inline std::unique_ptr<Any_deformation_solver> make_deformation_solver(Solver kind, const Connectivity& c,
                                                                       const Points& rest,
                                                                       const Deformation_weights& weights, int threads)
{
  if (kind == Solver::ceres)
    return std::make_unique<Wrapped_deformation_solver<Ceres_deformation_solver>>(c, rest, weights, threads);
  return std::make_unique<Wrapped_deformation_solver<Cholmod_deformation_solver>>(c, rest, weights, threads);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ANY_DEFORMATION_SOLVER_H
