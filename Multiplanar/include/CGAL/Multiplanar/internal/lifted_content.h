// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_LIFTED_CONTENT_H
#define CGAL_MULTIPLANAR_INTERNAL_LIFTED_CONTENT_H

#include <Eigen/Core>

#include <ceres/first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Total lifted content (Du, Aigerman, Zhou, Kovalsky, Yan, Kaufman, Ju: Lifting Simplices to Find Injectivity, 2020):
// the sum over triangles of the area of the triangle lifted to R^4 by sqrt(alpha) times an equilateral triangle. As
// alpha -> 0 it tends to the sum of unsigned areas, whose minimum for a given boundary is the area inside, taken
// exactly by the maps whose triangles are all positive. Unlike areas themselves it is smooth, and it has a slope at
// inverted triangles.

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Point_2d = Eigen::Vector2d;

/// Twice the signed area of a triangle.
inline double doubled_area(const Point_2d& a, const Point_2d& b, const Point_2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// A vertex of a planar triangulation as a function of the parameters x: fixed at `base`; or sliding along a line,
/// base + x[unknown] along; or free, (x[unknown], x[unknown + 1]).
struct Planar_node
{
  enum class Kind
  {
    fixed,
    sliding,
    free
  };
  Kind kind = Kind::fixed;
  Point_2d base = Point_2d::Zero(), along = Point_2d::Zero();
  int unknown = -1;

  Point_2d at(const double* x) const
  {
    if (kind == Kind::fixed) return base;
    if (kind == Kind::sliding) return base + x[unknown] * along;
    return {x[unknown], x[unknown + 1]};
  }
  void add_gradient(const Point_2d& d, double* gradient) const
  {
    if (kind == Kind::sliding) gradient[unknown] += d.dot(along);
    if (kind == Kind::free) gradient[unknown] += d.x(), gradient[unknown + 1] += d.y();
  }
};

/// Triangles over nodes, with the doubled area that counts as positive for each.
struct Planar_complex
{
  std::vector<Planar_node> nodes;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> tolerance;
  int unknowns = 0;

  int count_inverted(const double* x) const
  {
    int n = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      n += !(doubled_area(nodes[t[0]].at(x), nodes[t[1]].at(x), nodes[t[2]].at(x)) > tolerance[i]);
    }
    return n;
  }

  /// How many triangles are not positive wherever the others go: none of their vertices can move.
  int count_inverted_for_good() const
  {
    const auto is_fixed = [&](int v) { return nodes[v].kind == Planar_node::Kind::fixed; };
    int n = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      n += is_fixed(t[0]) && is_fixed(t[1]) && is_fixed(t[2]) &&
           !(doubled_area(nodes[t[0]].base, nodes[t[1]].base, nodes[t[2]].base) > tolerance[i]);
    }
    return n;
  }
};

/// Total lifted content as a function of the parameters, for Ceres' unconstrained minimiser.
class Total_lifted_content : public ceres::FirstOrderFunction
{
public:
  /// \param lift squared side of the equilateral triangle
  Total_lifted_content(const Planar_complex& complex, double lift) : complex(complex), lift(lift) {}
  int NumParameters() const override { return complex.unknowns; }

  bool Evaluate(const double* x, double* cost, double* gradient) const override
  {
    *cost = 0;
    if (gradient) std::fill(gradient, gradient + complex.unknowns, 0.0);
    for (const auto& t : complex.triangles) {
      const Planar_node &a = complex.nodes[t[0]], &b = complex.nodes[t[1]], &c = complex.nodes[t[2]];
      const Point_2d p = a.at(x), e1 = b.at(x) - p, e2 = c.at(x) - p;
      // The lifted edges are orthogonal sums of e_i and two edges of the equilateral triangle.
      const double g11 = e1.squaredNorm() + lift, g22 = e2.squaredNorm() + lift, g12 = e1.dot(e2) + lift / 2;
      const double content = std::sqrt((std::max)(g11 * g22 - g12 * g12, 0.0)); // twice the area in R^4
      *cost += content;
      if (!gradient || content == 0) continue;
      const Point_2d d1 = (g22 * e1 - g12 * e2) / content, d2 = (g11 * e2 - g12 * e1) / content;
      b.add_gradient(d1, gradient);
      c.add_gradient(d2, gradient);
      a.add_gradient(-(d1 + d2), gradient);
    }
    return std::isfinite(*cost);
  }

private:
  const Planar_complex& complex;
  double lift;
};

/// Stops the minimisation as soon as every triangle is positive that can be.
class Stop_when_injective : public ceres::IterationCallback
{
public:
  Stop_when_injective(const Planar_complex& complex, const std::vector<double>& x)
      : complex(complex), x(x), fewest(complex.count_inverted_for_good())
  {
  }
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override
  {
    const bool look = summary.iteration % 10 == 0;
    return look && complex.count_inverted(x.data()) == fewest ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                         : ceres::SOLVER_CONTINUE;
  }

private:
  const Planar_complex& complex;
  const std::vector<double>& x;
  int fewest;
};

/// Moves `x` towards a minimum of the total lifted content; ends early where every triangle is positive that can be.
inline void minimise_lifted_content(const Planar_complex& complex, double lift, std::vector<double>& x)
{
  ceres::GradientProblem problem(new Total_lifted_content(complex, lift)); // takes ownership
  Stop_when_injective stop(complex, x);
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::LBFGS;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-9;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  options.callbacks.push_back(&stop);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, x.data(), &summary);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_LIFTED_CONTENT_H
