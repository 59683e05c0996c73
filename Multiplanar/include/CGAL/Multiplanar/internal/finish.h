// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FINISH_H
#define CGAL_MULTIPLANAR_INTERNAL_FINISH_H

#include <CGAL/Multiplanar/No_flat_panels.h>
#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>
#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/internal/Mapping_check.h>
#include <CGAL/Multiplanar/internal/Stopwatch.h>
#include <CGAL/Multiplanar/internal/Unit_frame.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/internal/follow_panels.h>
#include <CGAL/Multiplanar/internal/isotopic_change.h>
#include <CGAL/Multiplanar/internal/map_to_panels.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// The last part of an approximation: exactly flat polygons, the mesh mapped into them, and the mesh moved there. A
// sphere is put there at once, other surfaces by guarded motion; see isotopic_change.h for why that is as good.
// What stands in the way costs accuracy, never a promise: panels that the mesh cannot be mapped into, or cannot reach,
// are merged with a neighbour, and the work is done again with one panel less.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The fewest panels that a closed surface of this genus is asked to consist of.
inline int fewest_panels(int genus) { return 4 + 3 * genus; }

/// Flat polygons and the mesh in them.
struct Finished_surface
{
  Flat_panels_result flat;
  Points points;
  std::vector<int> blocked; ///< panels where the mesh did not arrive, most troubled first; empty if all is well
};

/// The panels around the vertices that are not at their targets, those with most of them first.
inline std::vector<int> panels_around(const Connectivity& c, const std::vector<int>& labels,
                                      const std::vector<int>& vertices)
{
  std::map<int, int> count;
  for (int v : vertices)
    for (int f : c.star(v)) ++count[labels[f]];
  std::vector<std::pair<int, int>> order;
  for (const auto& p : count) order.emplace_back(-p.second, p.first);
  std::sort(order.begin(), order.end());
  std::vector<int> panels;
  for (const auto& p : order) panels.push_back(p.second);
  return panels;
}

/// The mesh mapped into the polygons of a result of `flat_panels_or_fewer()`.
inline const Panel_mapping& mapping_of(const Flat_panels_result& flat)
{
  CGAL_precondition(flat.companion != nullptr);
  return *static_cast<const Panel_mapping*>(flat.companion.get());
}

/// Puts `points` to `targets` if that is known to change nothing but the shape.
/// \param blocked where the targets are not embedded: receives the panels
/// \pre the points are embedded
inline bool put(const Connectivity& c, const Points& targets, const std::vector<int>& labels, Points& points,
                std::vector<int>& blocked)
{
  blocked.clear();
  if (!certainly_isotopic(c, points, targets)) return false;
  if (const auto fault = find_embedding_fault(c, targets)) {
    blocked = {labels[fault->first]};
    if (labels[fault->second] != blocked[0]) blocked.push_back(labels[fault->second]);
    return false;
  }
  points = targets;
  return true;
}

/// Moves `points` from the source to `targets`. \return the panels where the mesh did not arrive
inline std::vector<int> move_to(const Connectivity& c, const Points& targets, const std::vector<int>& labels,
                                Points& points)
{
  std::vector<int> blocked;
  if (c.genus() == 0) {
    if (put(c, targets, labels, points, blocked) || !blocked.empty()) return blocked;
  }
  Guarded_motion guard(c);
  follow(c, guard, targets, 20, 40, points);
  const std::vector<int> away = vertices_away(points, targets);
  if (away.empty() || put(c, targets, labels, points, blocked) || !blocked.empty()) return blocked;
  return panels_around(c, labels, away);
}

/// Moves the mesh from the source to where `flat` has it mapped.
inline Finished_surface move_to_panels(const Connectivity& c, const Points& source, Flat_panels_result flat,
                                       Stopwatch& clock)
{
  Finished_surface done;
  const Panel_mapping& mapping = mapping_of(flat);
  flat.panel_of_face = mapping.labels();
  flat.complex = mapping.complex();
  done.points = source;
  if (mapping.failed().empty()) {
    const Stopwatch::Lap lap(clock, "motion to the panels");
    done.blocked = move_to(c, mapping.targets(), flat.panel_of_face, done.points);
  } else {
    done.blocked = mapping.failed();
  }
  done.flat = std::move(flat);
  return done;
}

/// The labels with panel `p` given to the neighbour that it costs least to be merged with, if the result can be flat.
/// \return false if no neighbour will do
inline bool merge_panel(const Connectivity& c, const Points& source, const Label_costs& costs, int p,
                        std::vector<int>& labels)
{
  const int panels = *std::max_element(labels.begin(), labels.end()) + 1;
  const Panel_complex complex = make_panel_complex(c, source, labels, panels);
  std::vector<std::pair<double, int>> order;
  for (int q : complex.neighbours(p)) {
    std::vector<int> both = complex.panels[p].faces;
    both.insert(both.end(), complex.panels[q].faces.begin(), complex.panels[q].faces.end());
    double cost = 0;
    const Plane plane = mean_plane(c, source, both);
    for (int f : both) cost += costs.data_cost(f, plane);
    for (int r : {p, q})
      for (int f : complex.panels[r].faces) cost -= costs.data_cost(f, complex.panels[r].plane);
    order.emplace_back(cost, q);
  }
  std::sort(order.begin(), order.end());
  for (const auto& candidate : order) {
    std::vector<int> merged = labels;
    for (int& l : merged) {
      if (l == p) l = candidate.second;
      if (l == panels - 1 && p != panels - 1) l = p; // the last label takes the free number
    }
    if (!panel_complex_problems(make_panel_complex(c, source, merged, panels - 1)).empty()) continue;
    labels = merged;
    return true;
  }
  return false;
}

/// How much is done for panels that the mesh fits into before it is given up. What is asked about them costs time in
/// proportion to the faces, a round in proportion to the panels as well.
struct Patience
{
  Patience(int faces, int panels)
      : questions((std::max)(24, 1200000 / faces)),
        rounds(int((std::min)(6.0, (std::max)(1.0, 1.6e6 / (double(faces) * panels))))), last_resort(faces <= 10000)
  {
  }

  int questions;    ///< over all rounds, see `Flat_panels_options::max_questions`
  int rounds;       ///< with fewer panels each
  bool last_resort; ///< see `Flat_panels_options`
};

/// From so many panels on, merging asks at every step whether the mesh is embedded where it is mapped to; that takes
/// time in proportion to all faces, and panels closer than rounding are few before.
constexpr int embedded_when_mapped = 200;

/// Polygons from the partitions; or, if those cannot be made flat, from the triangles of the mesh; or from coarser
/// partitions.
/// \throws No_flat_panels if none were found
/// \return a result with the mesh mapped into the polygons as its companion (`mapping_of()`)
inline Flat_panels_result flat_panels_or_fewer(const Connectivity& c, const Points& source, const Label_costs& costs,
                                               const std::vector<std::vector<int>>& partitions,
                                               Flat_panels_options options, int fewest, Approximation_visitor& visitor,
                                               std::vector<std::string>& notes, double& mapping_seconds)
{
  const auto progress = [&](double done) { return visitor.progress("flat panels", done); };
  const auto obstacles = [&](Flat_panels_result& candidate) {
    const auto mapping = std::make_shared<Panel_mapping>(c, source, candidate.panel_of_face, candidate.complex);
    mapping->repair();
    candidate.companion = mapping;
    return mapping->failed();
  };
  Patience patience(c.number_of_faces(), options.max_panels);
  Flat_panels_result flat;
  const auto attempt = [&](const std::vector<std::vector<int>>& starts) {
    options.max_questions = (std::max)(1, patience.questions);
    flat = flat_panels(c, source, starts, options, progress, obstacles);
    patience.questions -= flat.questions;
    mapping_seconds += flat.obstacle_seconds;
  };
  attempt(partitions);
  const int wanted = options.max_panels;
  int merged_to = 0;
  if (!flat.ok && c.number_of_faces() <= most_merged_triangles) {
    Mapping_check mapping_check(c, source);
    options.merge_triangles = true;
    flat = flat_panels(c, source, {}, options, progress, obstacles, [&](const Flat_panels_result& candidate) {
      std::vector<int> bad = mapping_check.unmapped(candidate.panel_of_face, candidate.complex);
      if (bad.empty() && candidate.complex.number_of_panels() <= embedded_when_mapped)
        bad = mapping_check.touching(candidate.panel_of_face, candidate.complex);
      return bad;
    });
    mapping_seconds += flat.obstacle_seconds;
    merged_to = flat.fewest;
    options.merge_triangles = false;
  }
  options.effort = Effort::fast;
  for (int k = wanted; !flat.ok && k > fewest && patience.rounds > 0; --patience.rounds) {
    k = (std::max)(fewest, k - (std::max)(1, 3 * k / 20));
    notes.push_back("no flat panels were found with more than " + std::to_string(k) + " of them");
    options.max_panels = k;
    ++options.seed;
    Panel_partition_options coarser;
    coarser.max_panels = k;
    std::vector<std::vector<int>> fewer;
    for (std::vector<int> labels : partitions)
      if (make_panels(c, source, costs, labels, coarser).ok) fewer.push_back(labels);
    attempt(fewer);
  }
  if (!flat.ok && patience.last_resort) {
    options.max_panels = wanted;
    options.last_resort = true;
    attempt(partitions);
  }
  if (!flat.ok) throw No_flat_panels(wanted, c.genus(), c.number_of_faces(), merged_to);
  return flat;
}

/// Completes `result` from the labellings in `partitions`.
/// \throws No_flat_panels if none were found that the mesh can be moved to
inline void finish(const Connectivity& c, const Points& source, const std::vector<std::vector<int>>& partitions,
                   const Approximation_options& options, Approximation_visitor& visitor, Approximation_result& result)
{
  Stopwatch clock;
  Flat_panels_options flat_options;
  flat_options.max_panels = options.panels;
  flat_options.effort = options.effort;
  flat_options.threads = options.threads;
  flat_options.seed = options.seed;
  const Unit_frame frame(source);
  if (options.min_edge > 0) flat_options.min_edge = options.min_edge / frame.diagonal();
  if (options.min_width > 0) flat_options.min_width = options.min_width / frame.diagonal();
  flat_options.thickness = options.sheet_thickness / frame.diagonal();
  const Points unit = frame.to_unit(source);
  const Label_costs costs(c, unit, {}, saliency_weights(options.saliency, options.saliency_weight));
  // Panels n times as dense are about n times closer to a curved surface: distances that count so much more are even.
  for (int f = 0; options.saliency_weight > 0 && !options.saliency.empty() && f < costs.faces(); ++f)
    flat_options.importance.push_back(costs.seed_density(f));

  Flat_panels_result flat;
  double mapping_seconds = 0;
  {
    const Stopwatch::Lap lap(clock, "flat panels");
    flat = flat_panels_or_fewer(c, source, costs, partitions, flat_options, fewest_panels(c.genus()), visitor,
                                result.notes, mapping_seconds);
  }
  Finished_surface done = move_to_panels(c, source, flat, clock);
  flat_options.effort = Effort::fast;
  for (int merges = 0; !done.blocked.empty(); ++merges) {
    std::vector<int> labels = done.flat.panel_of_face;
    bool merged = false;
    std::string place;
    for (std::size_t i = 0; i < done.blocked.size() && !merged; ++i) {
      place = near_panel(done.flat.complex, done.blocked[i]);
      merged = merge_panel(c, source, costs, done.blocked[i], labels);
    }
    if (!merged) throw No_flat_panels(options.panels, c.genus(), c.number_of_faces());
    result.notes.push_back("the panel " + place + " was merged with a neighbour: the mesh could not be moved there");
    const Stopwatch::Lap lap(clock, "flat panels");
    flat_options.max_panels = done.flat.complex.number_of_panels() - 1;
    try {
      flat = flat_panels_or_fewer(c, source, costs, {labels}, flat_options, fewest_panels(c.genus()), visitor,
                                  result.notes, mapping_seconds);
    } catch (const No_flat_panels&) { // with as many as were asked for it could not be moved there
      throw No_flat_panels(options.panels, c.genus(), c.number_of_faces());
    }
    done = move_to_panels(c, source, flat, clock);
  }
  result.points = std::move(done.points);
  result.panel_of_face = std::move(done.flat.panel_of_face);
  result.complex = std::move(done.flat.complex);
  result.notes.insert(result.notes.end(), done.flat.notes.begin(), done.flat.notes.end());
  for (const auto& stage : clock.seconds()) result.seconds[stage.first] += stage.second;
  result.seconds["mapping, part of flat panels"] += mapping_seconds;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FINISH_H
