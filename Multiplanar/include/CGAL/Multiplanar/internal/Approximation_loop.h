// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_APPROXIMATION_LOOP_H
#define CGAL_MULTIPLANAR_INTERNAL_APPROXIMATION_LOOP_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/Deformation_weights.h>
#include <CGAL/Multiplanar/Labelling_record.h>
#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>
#include <CGAL/Multiplanar/internal/Any_deformation_solver.h>
#include <CGAL/Multiplanar/internal/Guarded_motion.h>
#include <CGAL/Multiplanar/internal/Stopwatch.h>
#include <CGAL/Multiplanar/internal/Unit_frame.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

// The paper's loop (section 3.1). A pass is
//   1. segmentation: labels by alpha-expansion (eqs. 1-4), cut down to at most k connected panels, then their planes;
//   2. deformation:  the vertices that minimise eqs. 5-9 for these planes and the pass's flattening weight w_p;
//   3. motion:       the mesh goes there as far as it stays embedded; a debug build then checks it whole.
// The last fifth of the passes keeps its labels: they are then panels that can be flat, and only w_p still grows.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// How many faces have changed hands, whatever the labels are called: all but those that the best matches of labels
/// before and labels now share, counted from the side where they are fewer. 0 exactly if both make the same pieces.
inline int changed_faces(const std::vector<int>& before, const std::vector<int>& now)
{
  std::map<std::pair<int, int>, int> shared;
  for (std::size_t f = 0; f < before.size(); ++f) ++shared[{before[f], now[f]}];
  std::map<int, int> most_before, most_now;
  for (const auto& s : shared) {
    int &a = most_before[s.first.first], &b = most_now[s.first.second];
    a = (std::max)(a, s.second);
    b = (std::max)(b, s.second);
  }
  int kept_before = 0, kept_now = 0;
  for (const auto& m : most_before) kept_before += m.second;
  for (const auto& m : most_now) kept_now += m.second;
  return int(before.size()) - (std::min)(kept_before, kept_now);
}

class Approximation_loop
{
public:
  /// \param source the input's vertices, in input units
  /// \pre the mesh is embedded; 4 + 3 genus <= options.panels <= faces
  Approximation_loop(const Connectivity& c, const Points& source, const Approximation_options& options,
                     std::uint64_t seed, int threads)
      : c(c), options(options), frame(source), moved(source), rest(frame.to_unit(source)), guard(c, 3, 4, threads),
        threads(threads), w_t(saliency_weights(options.saliency, options.saliency_weight))
  {
    deformation_weights.smoothness = options.smoothness;
    first_labelling(seed);
  }

  /// Does one pass. \return false if there is nothing left to do
  bool step()
  {
    if (is_done()) return false;
    const bool labels_changed = !labels_frozen() && segment();
    if (pass == first_frozen_pass()) freeze_labels();
    const double moved_by = deform();
    ++pass;
    still_passes = !labels_changed && moved_by <= still ? still_passes + 1 : 0;
    return !is_done();
  }

  bool is_done() const { return pass >= options.iterations || converged() || crumpled(); }
  /// Two passes in a row changed nothing, so none of the others would.
  bool converged() const { return still_passes >= 2; }
  /// The guard refused one move in ten. The next passes would refuse more and take ever longer to find that out, for
  /// labels of a shape that is less and less the model's.
  bool crumpled() const { return refused > std::size_t(c.number_of_vertices()) / 10; }
  int passes() const { return pass; }
  const Points& points() const { return moved; }
  const std::vector<int>& labels() const { return face_labels; }
  int number_of_labels() const { return int(planes.size()); }
  const std::map<std::string, double>& seconds() const { return clock.seconds(); }
  const std::map<std::string, double>& processor_seconds() const { return clock.processor_seconds(); }
  const Panel_partition_report& partition_report() const { return report; }
  std::size_t refused_moves() const { return refused; }
  /// One for every labelling so far, the first from the seeds.
  const std::vector<Labelling_record>& labellings() const { return records; }

  /// Labels that can be flat, whatever the pass.
  void finish_labels()
  {
    if (!labels_frozen() || pass <= first_frozen_pass()) freeze_labels();
  }

  /// The present labels, changed as little as is needed so that they can be flat.
  std::vector<int> realisable_labels() const
  {
    const Points current = frame.to_unit(moved);
    const Label_costs costs(c, current, {}, w_t);
    std::vector<int> labels = face_labels;
    make_panels(c, current, costs, labels, partition_options(true));
    return labels;
  }

private:
  static constexpr double still = 1e-9; // of the diagonal, per pass

  int first_frozen_pass() const { return options.iterations - options.iterations / 5 - 1; }
  bool labels_frozen() const { return pass > first_frozen_pass(); }

  void first_labelling(std::uint64_t seed)
  {
    const Stopwatch::Lap lap(clock, "segmentation");
    const Label_costs costs(c, rest, {}, w_t);
    planes = seed_planes(costs, options.panels, seed);
    face_labels = cheapest_labels(c.number_of_faces(), int(planes.size()), costs.data_cost(planes), threads);
    relabel(costs, rest);
  }

  /// \return whether any label changed
  bool segment()
  {
    const Stopwatch::Lap lap(clock, "segmentation");
    const Points current = frame.to_unit(moved);
    relabel(Label_costs(c, current, {}, w_t), current);
    return records.back().changed_faces > 0;
  }

  void freeze_labels()
  {
    const Stopwatch::Lap lap(clock, "segmentation");
    const Points current = frame.to_unit(moved);
    const Label_costs costs(c, current, {}, w_t);
    const Potts_graph graph = costs.potts_graph();
    Labelling_record record;
    record.frozen = true;
    record.before = record.planes = record.expanded = potts_energy(graph, costs.data_cost(planes), face_labels);
    make_panels_of(costs, current, graph, true, record);
  }

  /// New planes for the labels (but for those of the seeds), new labels for the planes, panels from the labels.
  void relabel(const Label_costs& costs, const Points& current)
  {
    const Potts_graph graph = costs.potts_graph();
    Labelling_record record;
    record.before = potts_energy(graph, costs.data_cost(planes), face_labels);
    if (!records.empty()) estimate_planes(costs, face_labels, planes);
    const Plane_costs cost = costs.data_cost(planes);
    record.planes = potts_energy(graph, cost, face_labels);
    const std::vector<int> before = face_labels;
    Alpha_expansion_options expansion;
    expansion.threads = threads;
    const Alpha_expansion_result result = alpha_expansion(graph, int(planes.size()), cost, face_labels, expansion);
    record.expanded = result.energy;
    record.sweeps = result.sweeps;
    record.expansions = result.expansions;
    CGAL_assertion(record.expanded <= record.planes * (1 + 1e-12));
    make_panels_of(costs, current, graph, false, record);
    records.back().changed_faces = changed_faces(before, face_labels);
  }

  Panel_partition_options partition_options(bool realisable) const
  {
    Panel_partition_options partition;
    partition.max_panels = options.panels;
    partition.realisable = realisable;
    // Planes estimated again and again spread evenly, whatever the saliency, unless panels move back where it is high.
    if (std::any_of(w_t.begin(), w_t.end(), [](double w) { return w > 0; })) partition.max_teleports = options.panels;
    return partition;
  }

  void make_panels_of(const Label_costs& costs, const Points& current, const Potts_graph& graph, bool realisable,
                      Labelling_record record)
  {
    report = make_panels(c, current, costs, face_labels, partition_options(realisable));
    planes.assign(report.panels, Plane());
    estimate_planes(costs, face_labels, planes);
    record.panels = potts_energy(graph, costs.data_cost(planes), face_labels);
    record.pass = records.empty() ? 0 : pass + 1;
    record.merges = report.merges;
    record.splits = report.splits;
    record.number_of_panels = report.panels;
    records.push_back(record);
  }

  /// \return the largest displacement, as a share of the diagonal
  double deform()
  {
    Points target;
    {
      const Stopwatch::Lap lap(clock, "deformation");
      if (!solver) solver = make_deformation_solver(options.solver, c, rest, deformation_weights, threads);
      const Points current = frame.to_unit(moved);
      std::vector<Vector_3> normals;
      for (const Plane& p : planes) normals.push_back(p.normal);
      const double w_p = deformation_weights.flattening(pass, options.iterations);
      if (!solver->solve(current, face_labels, normals, w_p, similarity_scale(current), target)) return 0;
    }
    const Stopwatch::Lap lap(clock, "guard");
    double largest = 0;
    for (std::size_t v = 0; v < target.size(); ++v) {
      target[v] = frame.from_unit(target[v]);
      const double d = std::sqrt(CGAL::squared_distance(target[v], moved[v])) / frame.diagonal();
      if (d <= 1e-12) target[v] = moved[v]; // what does not move keeps its digits
      largest = (std::max)(largest, d);
    }
    refused = guard.move(moved, target).refused;
    return largest;
  }

  /// Vertices that are far from home are pulled harder, so that the largest displacements shrink: the sum of squares
  /// becomes nearly one of fourth powers.
  std::vector<double> similarity_scale(const Points& current) const
  {
    std::vector<double> scale(current.size());
    double sum = 0;
    for (std::size_t v = 0; v < current.size(); ++v) sum += scale[v] = CGAL::squared_distance(current[v], rest[v]);
    const double mean = sum / double(current.size());
    if (!(mean > 0)) return {};
    for (double& s : scale) s = (std::min)((std::max)(s / mean, 0.1), 10.0);
    return scale;
  }

  const Connectivity& c;
  Approximation_options options;
  Unit_frame frame;
  Points moved; // in input units
  Points rest;  // the input in the unit frame
  Guarded_motion guard;
  int threads;
  std::vector<double> w_t;
  Deformation_weights deformation_weights;
  std::unique_ptr<Any_deformation_solver> solver;
  std::vector<int> face_labels;
  std::vector<Plane> planes;
  Panel_partition_report report;
  std::vector<Labelling_record> records;
  int pass = 0;
  int still_passes = 0;
  std::size_t refused = 0;
  Stopwatch clock;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_APPROXIMATION_LOOP_H
