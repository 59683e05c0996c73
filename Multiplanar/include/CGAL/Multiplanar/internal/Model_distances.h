// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MODEL_DISTANCES_H
#define CGAL_MULTIPLANAR_INTERNAL_MODEL_DISTANCES_H

#include <CGAL/Multiplanar/internal/Input_surface.h>
#include <CGAL/Multiplanar/internal/Joint_room.h>
#include <CGAL/Multiplanar/internal/Panel_model.h>
#include <CGAL/Multiplanar/internal/accuracy_steps.h>
#include <CGAL/Multiplanar/internal/cutting_limits.h>
#include <CGAL/Multiplanar/internal/label_edits.h>
#include <CGAL/Multiplanar/internal/model_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// How far models of one input are from it: what is measured, taken over from another model, and summed up.
class Model_distances
{
public:
  Model_distances(const Input_surface& input, double spacing, const Cutting_limits& limits, const Joint_room& room)
      : in(input), spacing_(spacing), limits(limits), room(room)
  {
  }

  double spacing() const { return spacing_; } ///< of samples, in diagonals

  /// Takes over the distances of the model before, but for those that depend on panels in `changed`.
  void carry(const Panel_model* old, const Label_edit& edit, const std::vector<char>& changed, Panel_model& m) const
  {
    m.r.assign(in.samples.size(), 0);
    m.near_panel.assign(in.samples.size(), -1);
    m.records.clear();
    m.panel_error.clear(), m.panel_worst.clear(); // nothing is summed up
    if (!old) return;
    std::vector<int> now = panels_now(*old, edit);
    for (int p = 0; p < m.panels(); ++p)
      if (changed[p] && edit.old_panel[p] >= 0) now[edit.old_panel[p]] = -1; // its shape changed
    for (std::size_t i = 0; i < m.r.size(); ++i)
      if (old->near_panel[i] >= 0) m.r[i] = old->r[i], m.near_panel[i] = now[old->near_panel[i]];
    for (Sample_record q : old->records) {
      bool kept = true;
      for (int& p : q.owner) p = now[p], kept = kept && p >= 0;
      if (kept) m.records.push_back(q);
    }
  }

  /// Measures what depends on the panels in `changed`, or was never measured.
  void measure(Panel_model& m, const std::vector<char>& changed) const
  {
    for (std::size_t i = 0; i < in.samples.size(); ++i)
      if (m.near_panel[i] < 0 || changed[m.near_panel[i]]) {
        const auto q = m.surface->closest(in.samples[i].point, m.labels[in.samples[i].face]);
        m.r[i] = in.importance_of(in.samples[i].face) * std::sqrt(q.squared_distance);
        m.near_panel[i] = m.surface->panel_of(q.triangle);
      }
    renew_records(m, changed);
    sum_up(m);
  }

  /// Takes over what accuracy steps measured last.
  void take(Panel_model& m, const Accuracy_steps& steps) const
  {
    drop_records(m, steps.distances().changed());
    const auto& samples = steps.distances().samples();
    for (std::size_t i = 0; i < samples.size(); ++i)
      m.records.push_back({steps.last().to_input[i].r, samples[i].area / in.area, samples[i].near, samples[i].owner});
    const auto& active = steps.distances().active();
    for (std::size_t i = 0; i < active.size(); ++i) {
      m.r[active[i]] = steps.last().to_panels[i].r;
      m.near_panel[active[i]] = steps.last().to_panels[i].panel;
    }
    sum_up(m);
  }

private:
  static void drop_records(Panel_model& m, const std::vector<char>& changed)
  {
    const auto lost = [&](const Sample_record& q) {
      return changed[q.owner[0]] || changed[q.owner[1]] || changed[q.owner[2]];
    };
    m.records.erase(std::remove_if(m.records.begin(), m.records.end(), lost), m.records.end());
  }

  /// Samples the panels in `changed` anew.
  void renew_records(Panel_model& m, const std::vector<char>& changed) const
  {
    drop_records(m, changed);
    std::vector<Panel_sample> samples;
    Panel_sampler(*m.topology, spacing_).sample(m.state, *m.surface, changed, samples);
    for (const Panel_sample& sample : samples) {
      Vec3 x = Vec3::Zero();
      for (int j = 0; j < 3; ++j) x += sample.weights.w[j] * m.state.corner[sample.corner[j]];
      const auto q = in.tree.closest(x, in.nearby(x));
      m.records.push_back({in.importance_of(q.triangle) * std::sqrt(q.squared_distance), sample.area / in.area,
                           q.triangle, sample.owner});
    }
  }

  void sum_up(Panel_model& m) const
  {
    m.offences = limits.count_offences(*m.topology, m.state);
    m.lack = room.lack(*m.topology, m.state);
    m.panel_error.assign(m.panels(), 0);
    m.panel_worst.assign(m.panels(), -1);
    m.largest = 0;
    const auto note = [&](double r, int face) {
      const int p = m.labels[face];
      if (r > m.panel_error[p] || m.panel_worst[p] < 0) m.panel_error[p] = r, m.panel_worst[p] = face;
      m.largest = (std::max)(m.largest, r);
    };
    for (std::size_t i = 0; i < m.r.size(); ++i) note(m.r[i], in.samples[i].face);
    for (const auto& q : m.records) note(q.r, q.face);
    for (int f = 0; f < int(m.labels.size()); ++f) // panels so small that no sample is on them
      if (m.panel_worst[m.labels[f]] < 0) m.panel_worst[m.labels[f]] = f;
    if (!(m.largest > 0)) {
      m.merit = 0;
      return;
    }
    double sum = 0;
    for (std::size_t i = 0; i < m.r.size(); ++i) sum += in.samples[i].area / in.area * power(m.r[i] / m.largest, 32);
    for (const auto& q : m.records) sum += q.area * power(q.r / m.largest, 32);
    m.merit = m.largest * std::pow(sum, 1.0 / 32);
  }

  const Input_surface& in;
  double spacing_;
  Cutting_limits limits;
  Joint_room room;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MODEL_DISTANCES_H
