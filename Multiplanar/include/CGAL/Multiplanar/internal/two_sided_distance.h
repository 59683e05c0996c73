// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TWO_SIDED_DISTANCE_H
#define CGAL_MULTIPLANAR_INTERNAL_TWO_SIDED_DISTANCE_H

#include <CGAL/Multiplanar/internal/Input_surface.h>
#include <CGAL/Multiplanar/internal/Panel_surface.h>
#include <CGAL/Multiplanar/internal/plane_corner_system.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// The objective
// -------------
// r_v = distance of the model's sample v from the panels; r_q = distance of the panels' sample q from the model.
//   E_p = sum_v a_v r_v^p / sum_v a_v + sum_q a_q r_q^p / sum_v a_v,
// whose p-th root tends to the symmetric Hausdorff distance. A sample q of a panel, and the point of a panel closest to
// a sample v, are convex combinations q = sum_i w_i x_i of the three corners of a triangle. With u the unit direction
// of the distance, to first order r changes by
//   dr = u.dq = sum_i w_i u.dx_i:
// the other end of the shortest connection moves across it, or not at all. Where v is closest to the inside of a panel,
// u is the panel's normal and dr is the motion of its plane alone; where u is not the panel's normal, q moves with the
// corners.

/// A point of a panel by the corners of a triangle.
struct Panel_sample
{
  std::array<int, 3> corner;
  Barycentric weights;
  int panel;
  double area;
  int near;                 ///< the model's face that was closest last time
  std::array<int, 3> owner; ///< panels that it lies on; at a corner with more, some of them
};

/// A distance as it stands: how long (times the importance of the place), in which direction the panel's point lies,
/// and whose point that is.
struct Distance
{
  double r = 0;
  double importance = 1;
  Vec3 u = Vec3::Zero(); ///< of unit length
  Vec3 point = Vec3::Zero();
  std::array<int, 3> corner{{-1, -1, -1}};
  Barycentric weights{{1, 0, 0}};
  int panel = -1;
  double slack = 0; ///< it may be longer by so much: not measured to the end, or moved since
};

/// r^p for a power of two p.
inline double power(double r, int p)
{
  for (; p > 1; p /= 2) r *= r;
  return r;
}

/// Places samples on panels: a grid in the plane of each, points along edges, and corners.
class Panel_sampler
{
public:
  Panel_sampler(const Complex_topology& topology, double spacing) : t(topology), spacing(spacing) {}

  /// Samples of the panels in `changed`, and of their edges and corners.
  void sample(const Flat_state& s, const Panel_surface& surface, const std::vector<char>& changed,
              std::vector<Panel_sample>& samples) const
  {
    samples.clear();
    for (int p = 0; p < t.number_of_panels(); ++p)
      if (changed[p]) sample_inside(s, surface, p, samples);
    for (const auto& e : t.edges)
      if (changed[e.panels[0]] || changed[e.panels[1]]) sample_edge(s, e, samples);
    for (int c = 0; c < t.number_of_corners(); ++c) {
      const auto& around = t.corner_panels[c];
      if (changed[around[0]] || changed[around[1]] || changed[around[2]])
        samples.push_back(
            {{c, c, c}, {{1, 0, 0}}, around[0], 0.5 * spacing * spacing, -1, {{around[0], around[1], around[2]}}});
    }
  }

private:
  void sample_inside(const Flat_state& s, const Panel_surface& surface, int p, std::vector<Panel_sample>& samples) const
  {
    const auto frame = tangents(s.normal[p]);
    for (const auto& q : surface.triangles_of(p)) {
      const Vec3 &a = s.corner[q[0]], &b = s.corner[q[1]], &c = s.corner[q[2]];
      Eigen::Vector2d A(a.dot(frame[0]), a.dot(frame[1])), B(b.dot(frame[0]), b.dot(frame[1])),
          C(c.dot(frame[0]), c.dot(frame[1]));
      const Eigen::Vector2d low = A.cwiseMin(B).cwiseMin(C) / spacing, high = A.cwiseMax(B).cwiseMax(C) / spacing;
      const Eigen::Vector2d u = B - A, v = C - A;
      const double det = u.x() * v.y() - u.y() * v.x();
      if (std::abs(det) < 1e-14) continue;
      for (int i = int(std::ceil(low.x())); i <= high.x(); ++i)
        for (int j = int(std::ceil(low.y())); j <= high.y(); ++j) {
          const Eigen::Vector2d d = Eigen::Vector2d(i, j) * spacing - A;
          const double wb = (d.x() * v.y() - d.y() * v.x()) / det, wc = (u.x() * d.y() - u.y() * d.x()) / det;
          if (wb < 0 || wc < 0 || wb + wc > 1) continue;
          samples.push_back({q, {{1 - wb - wc, wb, wc}}, p, spacing * spacing, -1, {{p, p, p}}});
        }
    }
  }

  void sample_edge(const Flat_state& s, const Complex_topology::Edge& edge, std::vector<Panel_sample>& samples) const
  {
    const int a = edge.corners[0], b = edge.corners[1], p = edge.panels[0], q = edge.panels[1];
    const double length = (s.corner[a] - s.corner[b]).norm();
    const int n = int(length / spacing) + 1;
    for (int i = 1; i < n; ++i)
      samples.push_back(
          {{a, b, b}, {{1 - double(i) / n, double(i) / n, 0}}, p, 0.5 * spacing * length / n, -1, {{p, p, q}}});
  }

  const Complex_topology& t;
  double spacing;
};

/// All distances of a state in which a part of the panels may move.
struct Evaluation
{
  std::vector<Distance> to_panels, to_input;

  double largest() const
  {
    double r = 0;
    for (const Distance& d : to_panels) r = (std::max)(r, d.r);
    for (const Distance& d : to_input) r = (std::max)(r, d.r);
    return r;
  }
};

/// The distances that depend on the free panels of a system.
class Two_sided_distance
{
public:
  /// \param active which of the model's samples are looked at
  /// \param likely for each of them a panel that may be the closest
  Two_sided_distance(const Input_surface& input, const Complex_topology& topology, const Plane_corner_system& system,
                     std::vector<int> active, std::vector<int> likely, double spacing)
      : in(input), t(topology), system(system), active_(std::move(active)), likely_(std::move(likely)),
        sampler_(topology, spacing), changed_(topology.number_of_panels(), 0)
  {
    for (int c : system.free_corners())
      for (int p : t.corner_panels[c]) changed_[p] = 1;
    for (int p = 0; p < t.number_of_panels(); ++p)
      if (changed_[p]) changed_panels_.push_back(p);
  }

  const std::vector<int>& active() const { return active_; }
  const std::vector<char>& changed() const { return changed_; }
  const std::vector<int>& changed_panels() const { return changed_panels_; }
  const std::vector<Panel_sample>& samples() const { return samples_; }
  long measured() const { return measured_; }
  double area_of_active(int i) const { return in.samples[active_[i]].area / in.area; }
  double area_of_sample(int i) const { return samples_[i].area / in.area; }

  /// From now on, distances up to `r` need not be known better than that.
  void set_enough(double r) { enough_ = r; }

  /// Places new samples on the panels that change and measures them. \pre `surface` stands at `s`
  void resample(const Flat_state& s, const Panel_surface& surface, Evaluation& e)
  {
    sampler_.sample(s, surface, changed_, samples_);
    e.to_input.assign(samples_.size(), Distance());
    for (std::size_t i = 0; i < samples_.size(); ++i) measure_sample(s, int(i), e.to_input[i]);
  }

  /// Measures the distances of all active samples from the panels. \pre the tree of `surface` stands at `s`
  void measure_active(const Flat_state& s, const Panel_surface& surface, Evaluation& e)
  {
    e.to_panels.assign(active_.size(), Distance());
    for (std::size_t i = 0; i < active_.size(); ++i) measure_active_sample(s, surface, int(i), e.to_panels[i]);
  }

  /// Distances after the corners moved by at most `motion` from where `base` was measured. Those that cannot reach
  /// `threshold` are taken over: a distance changes by no more than the corners move.
  void update(const Flat_state& s, const Panel_surface& surface, const Evaluation& base, double motion,
              double threshold, Evaluation& e)
  {
    const auto keep = [&](const Distance& old, Distance& d) {
      if (old.r + old.slack + motion * old.importance > threshold) return false;
      d = old;
      d.slack += motion * old.importance;
      return true;
    };
    e.to_panels.resize(base.to_panels.size());
    e.to_input.resize(base.to_input.size());
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (!keep(base.to_panels[i], e.to_panels[i])) measure_active_sample(s, surface, int(i), e.to_panels[i]);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!keep(base.to_input[i], e.to_input[i])) measure_sample(s, int(i), e.to_input[i]);
  }

  /// E_p with distances in units of `unit`.
  double energy(const Evaluation& e, int p, double unit) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < e.to_panels.size(); ++i)
      sum += area_of_active(int(i)) * power(e.to_panels[i].r / unit, p);
    for (std::size_t i = 0; i < e.to_input.size(); ++i)
      sum += area_of_sample(int(i)) * power(e.to_input[i].r / unit, p);
    return sum;
  }

  /// The first-order change of a distance as a form in the unknowns.
  void linear_form(const Distance& d, const Flat_state& s, Linear_form& form) const
  {
    form.clear();
    const double along = d.u.dot(s.normal[d.panel]);
    if (std::abs(along) > 0.999) {
      system.add_panel_motion(d.panel, d.point, d.importance * along, form);
      return;
    }
    for (int j = 0; j < 3; ++j)
      if (d.weights.w[j] > 1e-12) system.add_corner_motion(d.corner[j], d.importance * d.weights.w[j] * d.u, form);
  }

private:
  void measure_active_sample(const Flat_state& s, const Panel_surface& surface, int i, Distance& d)
  {
    const Vec3& v = in.samples[active_[i]].point;
    d.importance = in.importance_of(in.samples[active_[i]].face);
    ++measured_;
    const auto c = surface.closest(v, likely_[i], enough_ / d.importance);
    d.panel = likely_[i] = surface.panel_of(c.triangle);
    d.corner = surface.triangles()[c.triangle];
    d.weights = c.weights;
    set(d, c.point, v, s.normal[d.panel]);
  }

  void measure_sample(const Flat_state& s, int i, Distance& d)
  {
    Panel_sample& q = samples_[i];
    Vec3 x = Vec3::Zero();
    for (int j = 0; j < 3; ++j) x += q.weights.w[j] * s.corner[q.corner[j]];
    ++measured_;
    const auto c = in.tree.closest(x, q.near >= 0 ? q.near : in.nearby(x), enough_ / in.largest_importance);
    q.near = c.triangle;
    d.panel = q.panel, d.corner = q.corner, d.weights = q.weights;
    d.importance = in.importance_of(c.triangle);
    set(d, x, c.point, s.normal[q.panel]);
  }

  void set(Distance& d, const Vec3& panel_point, const Vec3& other, const Vec3& normal) const
  {
    const Vec3 v = panel_point - other;
    d.point = panel_point;
    const double r = v.norm();
    d.r = d.importance * r;
    d.u = r > 1e-10 ? Vec3(v / r) : normal;
    d.slack = d.r < enough_ ? enough_ - d.r : 0;
  }

  const Input_surface& in;
  const Complex_topology& t;
  const Plane_corner_system& system;
  std::vector<int> active_, likely_;
  Panel_sampler sampler_;
  std::vector<char> changed_;
  std::vector<int> changed_panels_;
  std::vector<Panel_sample> samples_;
  double enough_ = 0;
  long measured_ = 0;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TWO_SIDED_DISTANCE_H
