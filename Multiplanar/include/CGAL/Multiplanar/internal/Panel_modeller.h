// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_MODELLER_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_MODELLER_H

#include <CGAL/Multiplanar/internal/Model_distances.h>
#include <CGAL/Multiplanar/internal/Panel_model.h>
#include <CGAL/Multiplanar/internal/accuracy_steps.h>
#include <CGAL/Multiplanar/internal/cutting_limits.h>
#include <CGAL/Multiplanar/internal/first_fit.h>
#include <CGAL/Multiplanar/internal/free_pieces.h>
#include <CGAL/Multiplanar/internal/label_edits.h>
#include <CGAL/Multiplanar/internal/model_surface.h>
#include <CGAL/Multiplanar/internal/trace_topology.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Makes and improves models of one input.
class Panel_modeller
{
public:
  /// \param min_edge, min_width what counts as an offence, in diagonals
  /// \param thickness of the sheets, in diagonals; 0: room for joints does not count
  Panel_modeller(const Input_surface& input, double spacing, double min_edge = 0, double min_width = 0,
                 double thickness = 0)
      : in(input), c(*input.connectivity), limits{min_edge, min_width},
        distances(input, spacing, limits, Joint_room(thickness)), face_moments(internal::face_moments(c, input.points))
  {
  }

  /// The model of an edited labelling. Panels that exist before and after keep their planes; corners likewise. What is
  /// new is fitted, with `refit` and every panel around a new corner free.
  /// \param old the model before, or null: everything is new
  /// Panels that are free in different places are fitted apart.
  /// \param touched receives the panels that were free
  /// \param unfit if given, receives all free panels where a fit failed, in place of those of the first only; it is for
  /// many changes of small panels, and corners that can be are pinned then (`Plane_corner_system`)
  /// \return false if the labels cannot be made flat, or a fit fails
  bool rebuild(const Panel_model* old, const Label_edit& edit, Panel_model& m, std::vector<char>& touched,
               std::vector<int>* unfit = nullptr) const
  {
    const int n = int(edit.old_panel.size());
    if (n < 4) return false;
    auto topology = std::make_shared<Complex_topology>();
    m.labels = edit.labels;
    m.work = 0.3 * c.number_of_faces();
    if (!Topology_tracer(c, m.labels, n).trace(*topology, m.corner_vertex)) return false;
    m.topology = topology;
    touched.assign(n, 0);
    std::vector<char> refit(n, 0);
    for (int p = 0; p < n; ++p) refit[p] = touched[p] = !old || edit.old_panel[p] < 0 || edit.refit[p];
    sum_moments(old, edit, m);
    place_planes(old, edit, refit, m);
    place_corners(old, edit, refit, m, touched);
    put_outer_loops_first(m, *topology);
    if (!fit(m.moments, *topology, touched, refit, m.state, unfit)) return false;
    const std::vector<char> changed = changed_panels(m, touched);
    make_surface(old, edit, changed, old ? corners_now(*old, m) : std::vector<int>(), m);
    distances.carry(old, edit, changed, m);
    return true;
  }

  /// The model with a panel for every triangle: the input as it is, nothing fitted.
  /// \return false if that is not realisable
  bool of_triangles(Panel_model& m) const
  {
    const int n = c.number_of_faces();
    const Label_edit edit = no_edit(identity(n), n);
    auto topology = std::make_shared<Complex_topology>();
    m = Panel_model();
    m.labels = edit.labels;
    if (!Topology_tracer(c, m.labels, n).trace(*topology, m.corner_vertex)) return false;
    m.topology = topology;
    m.moments = face_moments;
    for (int v : m.corner_vertex) m.state.corner.push_back(in.points[v]);
    for (int f = 0; f < n; ++f) {
      const auto& t = c.triangles[f];
      m.state.normal.push_back(face_moments[f].normal.normalized());
      m.state.offset.push_back(m.state.normal[f].dot(in.points[t[0]]));
    }
    make_surface(nullptr, edit, std::vector<char>(n, 1), {}, m);
    m.r.assign(in.samples.size(), 0);
    m.near_panel.assign(in.samples.size(), -1);
    return true;
  }

  /// The same panels in the same places under other labels: what changes is the vertices that corners stand on.
  /// \return false, with `m` as it was, if the complex of these labels is another
  bool relabel(std::vector<int> labels, Panel_model& m) const
  {
    Panel_model next;
    auto topology = std::make_shared<Complex_topology>();
    next.labels = std::move(labels);
    if (!Topology_tracer(c, next.labels, m.panels()).trace(*topology, next.corner_vertex)) return false;
    next.topology = topology;
    std::vector<int> corner_now;
    if (!same_complex(*m.topology, *topology, corner_now)) return false;
    next.state = m.state;
    for (std::size_t i = 0; i < corner_now.size(); ++i) next.state.corner[corner_now[i]] = m.state.corner[i];
    put_outer_loops_first(next, *topology);
    const Label_edit edit = no_edit(next.labels, m.panels());
    sum_moments(&m, edit, next);
    const std::vector<char> changed(m.panels(), 0);
    make_surface(&m, edit, changed, corner_now, next);
    distances.carry(&m, edit, changed, next);
    if (!m.panel_error.empty()) distances.measure(next, changed); // which panel has which distance is another
    next.work = m.work;
    m = std::move(next);
    return true;
  }

  /// Accuracy steps with the panels of `free`.
  void improve(Panel_model& m, const std::vector<char>& free, const Accuracy_options& options) const
  {
    const std::vector<int> active = active_samples(m, free);
    std::vector<int> likely;
    for (int i : active) likely.push_back(m.near_panel[i] >= 0 ? m.near_panel[i] : m.labels[in.samples[i].face]);
    Accuracy_steps steps(in, *m.topology, free, active, std::move(likely), distances.spacing(), options);
    auto surface = std::make_shared<Panel_surface>(*m.surface);
    steps.run(m.state, *surface);
    m.surface = surface;
    m.faults += steps.number_of_faults() - steps.faults_before();
    if (!m.contacts.empty()) renew_contacts(m, steps.distances().changed());
    m.work += double(steps.distances().measured());
    distances.take(m, steps);
  }

  void improve_all(Panel_model& m, const Accuracy_options& options) const
  {
    improve(m, std::vector<char>(m.panels(), 1), options);
  }

  /// Measures the distances that depend on panels around the corners of `free`.
  void measure(Panel_model& m, const std::vector<char>& free) const { distances.measure(m, changed_panels(m, free)); }

  void measure_all(Panel_model& m) const
  {
    std::fill(m.near_panel.begin(), m.near_panel.end(), -1);
    measure(m, std::vector<char>(m.panels(), 1));
  }

  bool is_short(const Panel_model& m, const Complex_topology::Edge& e) const { return limits.is_short(m.state, e); }
  bool is_narrow(const Panel_model& m, int p) const { return limits.is_narrow(m.topology->loops[p], m.state, p); }

  /// How far a corner is from its vertex of the mesh.
  double displacement(const Panel_model& m, int corner) const
  {
    return (m.state.corner[corner] - in.points[m.corner_vertex[corner]]).norm();
  }

  double largest_displacement(const Panel_model& m) const
  {
    double result = 0;
    for (int i = 0; i < m.topology->number_of_corners(); ++i) result = (std::max)(result, displacement(m, i));
    return result;
  }

  double sample_spacing() const { return distances.spacing(); }
  const Input_surface& input() const { return in; }
  const Connectivity& connectivity() const { return c; }
  const std::vector<Moments>& moments_of_faces() const { return face_moments; }

private:
  static std::vector<int> identity(int n)
  {
    std::vector<int> result(n);
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  /// `first_fit()` of every piece of the free panels: panels of different pieces share no corner.
  static bool fit(const std::vector<Moments>& moments, const Complex_topology& t, const std::vector<char>& free,
                  const std::vector<char>& refit, Flat_state& s, std::vector<int>* unfit)
  {
    bool fits = true;
    for (const std::vector<int>& piece : free_pieces(t, free)) {
      std::vector<char> in_piece(t.number_of_panels(), 0);
      for (int p : piece) in_piece[p] = 1;
      Plane_corner_system system(t, std::move(in_piece), unfit != nullptr);
      if (first_fit(moments, system, refit, s, 0.3 / double(system.free_corners().size() + 1))) continue;
      if (!unfit) return false;
      fits = false;
      unfit->insert(unfit->end(), piece.begin(), piece.end());
    }
    return fits;
  }

  static std::vector<char> changed_panels(const Panel_model& m, const std::vector<char>& free)
  {
    std::vector<char> changed(m.panels(), 0);
    for (const auto& around : m.topology->corner_panels) {
      bool moves = false;
      for (int p : around) moves = moves || free[p];
      for (int p : around) changed[p] = changed[p] || moves;
    }
    return changed;
  }

  std::vector<int> active_samples(const Panel_model& m, const std::vector<char>& free) const
  {
    const std::vector<char> changed = changed_panels(m, free);
    std::vector<int> active;
    for (int i = 0; i < int(in.samples.size()); ++i)
      if (m.near_panel[i] < 0 || changed[m.near_panel[i]] || changed[m.labels[in.samples[i].face]]) active.push_back(i);
    return active;
  }

  void sum_moments(const Panel_model* old, const Label_edit& edit, Panel_model& m) const
  {
    const int n = int(edit.old_panel.size());
    m.moments.assign(n, Moments());
    std::vector<char> differs(n, !old);
    if (old) {
      for (int p = 0; p < n; ++p) differs[p] = edit.old_panel[p] < 0;
      const std::vector<int> now = panels_now(*old, edit);
      for (int f = 0; f < c.number_of_faces(); ++f) {
        const int before = now[old->labels[f]];
        if (before == m.labels[f]) continue;
        differs[m.labels[f]] = 1;
        if (before >= 0) differs[before] = 1;
      }
      for (int p = 0; p < n; ++p)
        if (!differs[p]) m.moments[p] = old->moments[edit.old_panel[p]];
    }
    for (int f = 0; f < c.number_of_faces(); ++f)
      if (differs[m.labels[f]]) m.moments[m.labels[f]] += face_moments[f];
  }

  static void place_planes(const Panel_model* old, const Label_edit& edit, const std::vector<char>& refit,
                           Panel_model& m)
  {
    const int n = int(edit.old_panel.size());
    m.state.normal.resize(n), m.state.offset.resize(n);
    for (int p = 0; p < n; ++p) {
      if (refit[p]) fit_plane(m.moments[p], m.state.normal[p], m.state.offset[p]);
      else
        m.state.normal[p] = old->state.normal[edit.old_panel[p]],
        m.state.offset[p] = old->state.offset[edit.old_panel[p]];
    }
  }

  /// Corners that stand on the same vertex between the same panels stay; others start where their planes meet, if that
  /// is near, or else on the mesh. All panels around a corner that is new become free.
  void place_corners(const Panel_model* old, const Label_edit& edit, const std::vector<char>& refit, Panel_model& m,
                     std::vector<char>& free) const
  {
    const Complex_topology& t = *m.topology;
    std::unordered_map<int, int> before;
    if (old)
      for (std::size_t i = 0; i < old->corner_vertex.size(); ++i) before[old->corner_vertex[i]] = int(i);
    m.state.corner.resize(t.number_of_corners());
    for (int i = 0; i < t.number_of_corners(); ++i) {
      m.state.corner[i] = in.points[m.corner_vertex[i]];
      const auto found = before.find(m.corner_vertex[i]);
      if (found != before.end() && same_panels(old->topology->corner_panels[found->second], t.corner_panels[i], edit)) {
        m.state.corner[i] = old->state.corner[found->second];
        continue;
      }
      bool refitted = false;
      for (int p : t.corner_panels[i]) refitted = refitted || refit[p];
      if (edit.near_old && found != before.end()) m.state.corner[i] = old->state.corner[found->second];
      else if (!refitted) meet(m, i);
      for (int p : t.corner_panels[i])
        if (!edit.is_held(p)) free[p] = 1;
    }
  }

  static void meet(Panel_model& m, int corner)
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

  static void put_outer_loops_first(const Panel_model& m, Complex_topology& t)
  {
    for (int p = 0; p < t.number_of_panels(); ++p) {
      auto& loops = t.loops[p];
      double largest = 0;
      for (std::size_t l = 0; loops.size() > 1 && l < loops.size(); ++l) {
        Vec3 area = Vec3::Zero();
        for (std::size_t i = 0; i < loops[l].size(); ++i)
          area += m.state.corner[loops[l][i]].cross(m.state.corner[loops[l][(i + 1) % loops[l].size()]]);
        const double a = area.dot(m.state.normal[p]);
        if (l == 0 || a > largest) {
          largest = a;
          std::swap(loops[0], loops[l]);
        }
      }
    }
  }

  const Input_surface& in;
  const Connectivity& c;
  Cutting_limits limits;
  Model_distances distances;
  std::vector<Moments> face_moments;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_MODELLER_H
