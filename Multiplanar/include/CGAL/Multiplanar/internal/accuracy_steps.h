// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ACCURACY_STEPS_H
#define CGAL_MULTIPLANAR_INTERNAL_ACCURACY_STEPS_H

#include <CGAL/Multiplanar/internal/two_sided_distance.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Levenberg-Marquardt for the p-norm of all distances (two_sided_distance.h), under flatness
// ------------------------------------------------------------------------------------------
// With N = E_p^(1/p) at the start of a step, the step lowers
//   F = 1/p sum_i a_i (r_i / N)^p + barriers.
// To first order r_i moves by J_i y, so grad F = sum a_i (r_i/N)^(p-1) J_i / N and, the part of the Hessian that is
// always positive, H = (p-1) sum a_i (r_i/N)^(p-2) J_i^T J_i / N^2. The damping lambda (|planes|^2 + |corners|^2) keeps
// motions small where H says nothing, and bounds ill-conditioned corners.
//
// An edge shorter than L = 1.5 min_edge adds kappa ((L - l) / L)^2. Two panels folded upon each other by more than a
// limit, n_1.n_2 < -g, add kappa ((n_1.n_2 + g) / (1 - g))^2.
//
// A step counts only if F falls, all panels remain simple polygons and no panels meet that should not: exact.

struct Accuracy_options
{
  double min_edge = 0.002; ///< fraction of the diagonal
  double max_step = 0.03;  ///< of a corner, in diagonals
  double barrier = 0.05;   ///< kappa
  double fold = 0.9;       ///< g: the cosine of the sharpest angle between panels that is not held off
  std::vector<int> powers{2, 4, 8, 16, 32};
  int steps = 12;           ///< for every power
  int refresh = 4;          ///< accepted steps between new samples
  double least_gain = 1e-3; ///< relative fall of the p-norm below which a step counts as stalled
  double expected = 0;      ///< the p-norm that results are compared with: much smaller distances need not be known
  double hopeless = 1e300;  ///< p-norm that is not worth going on with after a few steps
};

class Accuracy_steps
{
public:
  Accuracy_steps(const Input_surface& input, const Complex_topology& topology, std::vector<char> free,
                 std::vector<int> active, std::vector<int> likely, double spacing, const Accuracy_options& options)
      : t(topology), options(options), system(topology, std::move(free)),
        distance(input, topology, system, std::move(active), std::move(likely), spacing), trial_surface(topology)
  {
    for (int e = 0; e < int(t.edges.size()); ++e)
      if (system.moves(t.edges[e].corners[0]) || system.moves(t.edges[e].corners[1])) edges.push_back(e);
  }

  /// Improves `s`. `surface` must stand at `s`, and does so again afterwards. Panels that are not simple and conflicts
  /// may not become more.
  void run(Flat_state& s, Panel_surface& surface)
  {
    trial_surface = surface;
    surface.build_tree(s);
    faults = faults_before_ = count_faults(s, surface, 1 << 20);
    distance.set_enough(enough(options.powers[0], options.expected));
    distance.measure_active(s, surface, base);
    distance.resample(s, surface, base);
    since_refresh = 0;
    if (system.free_panels().empty()) return;
    for (int p : options.powers) run_power(p, s, surface);
  }

  const Two_sided_distance& distances() const { return distance; }
  /// Distances at the state that `run` returned, with its last samples.
  const Evaluation& last() const { return base; }
  int evaluations() const { return evaluations_; }
  /// Faults among the panels that change, before and after `run`.
  int faults_before() const { return faults_before_; }
  int number_of_faults() const { return faults; }

private:
  void run_power(int p, Flat_state& s, Panel_surface& surface)
  {
    double lambda = 1e-2;
    int stalled = 0;
    for (int step = 0; step < options.steps; ++step) {
      if (since_refresh >= options.refresh) {
        distance.resample(s, surface, base);
        since_refresh = 0;
      }
      const double largest = (std::max)(base.largest(), 1e-300);
      const double unit = largest * std::pow(distance.energy(base, p, largest), 1.0 / p);
      if (!(unit > 1e-14) || (step == 3 && unit > options.hopeless)) return;
      distance.set_enough(enough(p, options.expected > 0 ? (std::min)(unit, options.expected) : unit));
      system.linearise(s);
      assemble(p, unit, s);
      const double merit = 1.0 / p + barrier(s);
      bool accepted = false;
      for (int attempt = 0; attempt < 6 && !accepted; ++attempt) {
        const double gain = try_step(p, unit, merit, lambda, s, surface);
        if (gain > 0) {
          accepted = true;
          lambda = (std::max)(lambda * 0.25, 1e-7);
          ++since_refresh;
          stalled = gain < options.least_gain ? stalled + 1 : 0;
        } else {
          lambda *= attempt == 0 ? 4 : 16;
        }
      }
      if (!accepted || stalled >= 2) return;
    }
  }

  /// H, f and the damping matrix D at `s`, where `base` stands.
  void assemble(int p, double unit, const Flat_state& s)
  {
    const int n = system.unknowns();
    H.setZero(n, n), D.setZero(n, n), f.setZero(n), zero.setZero(n);
    Linear_form form;
    const auto add = [&](const Distance& d, double area) {
      const double w = area * power_of(d.r / unit, p - 2);
      if (w < 1e-9) return;
      distance.linear_form(d, s, form);
      add_square(form, (p - 1) * w / (unit * unit), d.r / (p - 1), H, f);
    };
    for (std::size_t i = 0; i < base.to_panels.size(); ++i) add(base.to_panels[i], distance.area_of_active(int(i)));
    for (std::size_t i = 0; i < base.to_input.size(); ++i) add(base.to_input[i], distance.area_of_sample(int(i)));
    for (int e : edges) {
      add_length_barrier(e, s, form);
      add_fold_barrier(e, s, form);
    }
    for (int c : system.free_corners())
      for (int i = 0; i < 3; ++i) {
        form.clear();
        system.add_corner_motion(c, Vec3::Unit(i), form);
        form.constant = 0;
        add_square(form, 1, 0, D, zero);
      }
    D.diagonal().array() += 0.1;
    damping_scale = H.trace() / D.trace();
  }

  static double power_of(double r, int q) // q = 2^i - 2
  {
    double result = 1;
    for (; q > 0; q /= 2, r *= r)
      if (q % 2) result *= r;
    return result;
  }

  void add_length_barrier(int e, const Flat_state& s, Linear_form& form)
  {
    const Vec3 v = s.corner[t.edges[e].corners[1]] - s.corner[t.edges[e].corners[0]];
    const double length = v.norm(), L = 1.5 * options.min_edge;
    if (length >= L || length < 1e-12) return;
    form.clear();
    system.add_corner_motion(t.edges[e].corners[1], v / length, form);
    system.add_corner_motion(t.edges[e].corners[0], -v / length, form);
    add_square(form, 2 * options.barrier / (L * L), length - L, H, f);
  }

  void add_fold_barrier(int e, const Flat_state& s, Linear_form& form)
  {
    const int p = t.edges[e].panels[0], q = t.edges[e].panels[1];
    const double cosine = s.normal[p].dot(s.normal[q]), width = 1 - options.fold;
    if (cosine >= -options.fold) return;
    form.clear();
    system.add_turn(p, s.normal[q], form);
    system.add_turn(q, s.normal[p], form);
    add_square(form, 2 * options.barrier / (width * width), cosine + options.fold, H, f);
  }

  double barrier(const Flat_state& s) const
  {
    double sum = 0;
    const double L = 1.5 * options.min_edge, width = 1 - options.fold;
    for (int e : edges) {
      const auto& edge = t.edges[e];
      const double length = (s.corner[edge.corners[1]] - s.corner[edge.corners[0]]).norm();
      if (length < L) sum += (1 - length / L) * (1 - length / L);
      const double over = -options.fold - s.normal[edge.panels[0]].dot(s.normal[edge.panels[1]]);
      if (over > 0) sum += over * over / (width * width);
    }
    return options.barrier * sum;
  }

  /// Distances below this part of the p-norm contribute less than 1e-4 to E_p together.
  static double negligible(int p) { return p <= 4 ? 0 : std::pow(1e-4, 1.0 / p); }
  static double enough(int p, double norm) { return 0.9 * negligible(p) * norm; }

  /// \return the relative fall of the p-norm, or 0 if the step was refused
  double try_step(int p, double unit, double merit, double lambda, Flat_state& s, Panel_surface& surface)
  {
    const Eigen::MatrixXd damped = H + (lambda * damping_scale) * D;
    Eigen::VectorXd y = system.solve(damped, f);
    if (!y.allFinite()) return 0;
    trial = s;
    system.move_linearly(y, trial);
    const double largest = largest_motion(s, trial);
    trial = s;
    if (largest > options.max_step) y *= options.max_step / largest;
    if (!system.move(y, trial) || largest_motion(s, trial) > 2 * options.max_step) return 0;
    trial_surface.update(trial, distance.changed_panels());
    int bad = 0;
    for (int q : distance.changed_panels()) bad += !trial_surface.is_simple(q);
    if (bad > faults) return 0;
    trial_surface.build_tree(trial);
    distance.update(trial, trial_surface, base, largest_motion(s, trial), unit * negligible(p), trial_distances);
    ++evaluations_;
    const double now = distance.energy(trial_distances, p, unit);
    const double fall = merit - (now / p + barrier(trial));
    if (!(fall > 1e-7)) return 0;
    const int now_faults = count_faults(trial, trial_surface, faults + 1);
    if (now_faults > faults) return 0;
    faults = now_faults;
    std::swap(s, trial);
    std::swap(surface, trial_surface);
    std::swap(base, trial_distances);
    return fall;
  }

  double largest_motion(const Flat_state& a, const Flat_state& b) const
  {
    double worst = 0;
    for (int c : system.free_corners()) worst = (std::max)(worst, (a.corner[c] - b.corner[c]).norm());
    return worst;
  }

  int count_faults(const Flat_state& s, const Panel_surface& surface, int limit) const
  {
    int bad = 0;
    for (int q : distance.changed_panels()) bad += !surface.is_simple(q);
    return bad + int(surface.conflicts(s, distance.changed(), limit).size());
  }

  const Complex_topology& t;
  Accuracy_options options;
  Plane_corner_system system;
  Two_sided_distance distance;
  Panel_surface trial_surface;
  Flat_state trial;
  Evaluation base, trial_distances;
  std::vector<int> edges;
  Eigen::MatrixXd H, D;
  Eigen::VectorXd f, zero;
  double damping_scale = 1;
  int since_refresh = 0, evaluations_ = 0, faults = 0, faults_before_ = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ACCURACY_STEPS_H
