// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H

#include <CGAL/Multiplanar/internal/accuracy_steps.h>
#include <CGAL/Multiplanar/internal/first_fit.h>
#include <CGAL/Multiplanar/internal/label_edits.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>

#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// An approximation under work: labels of the faces, the complex that follows from them, where its planes and corners
/// are, and how far the surfaces are apart.
struct Panel_model
{
  std::vector<int> labels;
  std::shared_ptr<const Complex_topology> topology;
  std::vector<int> corner_vertex; ///< the mesh vertex of each corner
  Flat_state state;
  std::shared_ptr<Panel_surface> surface;
  std::vector<Moments> moments; ///< of the faces of each panel
  int faults = 0;               ///< panels that are not simple, and pairs that meet outside shared corners and edges

  std::vector<int> near_panel;     ///< of every sample of the model
  std::vector<double> panel_error; ///< largest distance by panel, both ways
  std::vector<int> panel_worst;    ///< the face of the model where it is
  double merit = 0;                ///< p-norm of all distances, p = 32
  double largest = 0;

  int panels() const { return topology->number_of_panels(); }
};

/// Makes and improves models of one input.
class Panel_modeller
{
public:
  Panel_modeller(const Input_surface& input, double spacing)
      : in(input), c(*input.connectivity), spacing(spacing), face_moments(internal::face_moments(c, input.points))
  {
    for (const Vec3& x : in.points) frame_points.push_back(as_point(x));
  }

  /// The model of an edited labelling. Panels that exist before and after keep their planes; corners likewise. What is
  /// new is fitted, with `refit` and every panel around a new corner free.
  /// \param old the model before, or null: everything is new
  /// \return false if the labels cannot be made flat, or the fit fails
  bool rebuild(const Panel_model* old, const Label_edit& edit, Panel_model& m,
               std::vector<char>* touched = nullptr) const
  {
    const int n = int(edit.old_panel.size());
    if (n < 4) return false;
    const Panel_complex complex = make_panel_complex(c, frame_points, edit.labels, n);
    if (!panel_complex_problems(complex).empty()) return false;
    m.labels = edit.labels;
    m.topology = std::make_shared<const Complex_topology>(complex_topology(complex));
    const Complex_topology& t = *m.topology;
    m.corner_vertex.clear();
    for (const auto& corner : complex.corners) m.corner_vertex.push_back(corner.vertex);
    m.moments.assign(n, Moments());
    for (int f = 0; f < c.number_of_faces(); ++f) m.moments[m.labels[f]] += face_moments[f];

    std::vector<char> free(n, 0);
    m.state.normal.resize(n), m.state.offset.resize(n), m.state.corner.resize(t.number_of_corners());
    for (int p = 0; p < n; ++p) {
      const int q = edit.old_panel[p];
      if (q < 0 || edit.refit[p] || !old) {
        fit_plane(m.moments[p], m.state.normal[p], m.state.offset[p]);
        free[p] = 1;
      } else {
        m.state.normal[p] = old->state.normal[q], m.state.offset[p] = old->state.offset[q];
      }
    }
    const std::vector<char> refit = free;
    place_corners(old, edit, m, free);
    Plane_corner_system system(t, free);
    if (!first_fit(t, m.moments, system, refit, m.state, 0.3 / double(system.free_corners().size() + 1))) return false;
    if (touched) *touched = free;
    m.surface = std::make_shared<Panel_surface>(*m.topology);
    std::vector<int> all(n);
    for (int p = 0; p < n; ++p) all[p] = p;
    m.surface->update(m.state, all);
    m.surface->build_tree(m.state);
    m.faults = int(m.surface->conflicts(m.state, std::vector<char>(n, 1), 1 << 20).size());
    for (int p = 0; p < n; ++p) m.faults += !m.surface->is_simple(p);
    return true;
  }

  /// Accuracy steps with the panels of `free` (all if empty).
  void improve(Panel_model& m, std::vector<char> free, const Accuracy_options& options) const
  {
    if (free.empty()) free.assign(m.panels(), 1);
    std::vector<char> changed(m.panels(), 0);
    for (const auto& around : m.topology->corner_panels) {
      bool moves = false;
      for (int p : around) moves = moves || free[p];
      for (int p : around) changed[p] = changed[p] || moves;
    }
    std::vector<int> active;
    for (int i = 0; i < int(in.samples.size()); ++i)
      if (m.near_panel.empty() || m.near_panel[i] < 0 || changed[m.near_panel[i]] ||
          changed[m.labels[in.samples[i].face]])
        active.push_back(i);
    auto surface = std::make_shared<Panel_surface>(*m.surface);
    Accuracy_steps steps(in, *m.topology, free, std::move(active), spacing, options);
    steps.run(m.state, *surface);
    m.surface = surface;
    m.faults = steps.number_of_faults() + (m.faults - steps.faults_before());
  }

  /// Measures all distances.
  void measure(Panel_model& m) const
  {
    const Complex_topology& t = *m.topology;
    const int n = m.panels();
    std::vector<int> all(in.samples.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = int(i);
    const Plane_corner_system system(t, std::vector<char>(n, 1));
    Two_sided_distance distance(in, t, system, all, spacing);
    distance.resample(m.state, *m.surface);
    Evaluation e;
    distance.evaluate(m.state, *m.surface, e);
    m.near_panel.resize(all.size());
    m.panel_error.assign(n, 0);
    m.panel_worst.assign(n, -1);
    const auto note = [&](int p, double r, int face) {
      if (r > m.panel_error[p]) m.panel_error[p] = r, m.panel_worst[p] = face;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      m.near_panel[i] = e.to_panels[i].panel;
      note(m.labels[in.samples[i].face], e.to_panels[i].r, in.samples[i].face);
    }
    for (std::size_t i = 0; i < e.to_input.size(); ++i) {
      const int face = distance.samples()[i].near;
      note(m.labels[face], e.to_input[i].r, face);
    }
    m.largest = e.largest;
    m.merit = e.largest > 0 ? e.largest * std::pow(distance.energy(e, 32, e.largest), 1.0 / 32) : 0;
  }

  const Input_surface& input() const { return in; }
  const Connectivity& connectivity() const { return c; }
  const std::vector<Moments>& moments_of_faces() const { return face_moments; }

private:
  /// Corners that stand on the same vertex between the same panels stay; others start where their planes meet, if that
  /// is near, or else on the mesh. All panels around a corner that is new become free.
  void place_corners(const Panel_model* old, const Label_edit& edit, Panel_model& m, std::vector<char>& free) const
  {
    const Complex_topology& t = *m.topology;
    std::unordered_map<int, int> before;
    if (old)
      for (std::size_t i = 0; i < old->corner_vertex.size(); ++i) before[old->corner_vertex[i]] = int(i);
    std::vector<char> is_new(t.number_of_corners(), 1);
    for (int i = 0; i < t.number_of_corners(); ++i) {
      const Vec3& on_mesh = in.points[m.corner_vertex[i]];
      m.state.corner[i] = on_mesh;
      const auto found = before.find(m.corner_vertex[i]);
      if (found != before.end() && same_panels(old->topology->corner_panels[found->second], t.corner_panels[i], edit)) {
        m.state.corner[i] = old->state.corner[found->second];
        is_new[i] = 0;
      }
    }
    for (int i = 0; i < t.number_of_corners(); ++i) {
      if (!is_new[i]) continue;
      bool refitted = false;
      for (int p : t.corner_panels[i]) refitted = refitted || edit.refit[p] || edit.old_panel[p] < 0 || !old;
      if (!refitted) meet(m, i);
      for (int p : t.corner_panels[i]) free[p] = 1;
    }
  }

  void meet(Panel_model& m, int corner) const
  {
    const auto& panels = m.topology->corner_panels[corner];
    if (panels.size() != 3) return;
    Eigen::Matrix3d N;
    Vec3 d;
    for (int i = 0; i < 3; ++i) N.row(i) = m.state.normal[panels[i]], d[i] = m.state.offset[panels[i]];
    if (std::abs(N.determinant()) < 0.05) return;
    const Vec3 x = N.inverse() * d;
    if ((x - m.state.corner[corner]).norm() < 0.1) m.state.corner[corner] = x;
  }

  static bool same_panels(const std::vector<int>& before, const std::vector<int>& now, const Label_edit& edit)
  {
    if (before.size() != now.size()) return false;
    for (int p : now)
      if (edit.old_panel[p] < 0 || std::find(before.begin(), before.end(), edit.old_panel[p]) == before.end())
        return false;
    return true;
  }

  const Input_surface& in;
  const Connectivity& c;
  double spacing;
  std::vector<Moments> face_moments;
  Points frame_points;
};

/// Free for local work: the panels in `touched` and all that share a corner with them.
inline std::vector<char> with_ring(const Complex_topology& t, const std::vector<char>& touched)
{
  std::vector<char> result = touched;
  for (const auto& around : t.corner_panels) {
    bool any = false;
    for (int p : around) any = any || touched[p];
    if (any)
      for (int p : around) result[p] = 1;
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H
