// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_FLAT_PANELS_H
#define CGAL_MULTIPLANAR_FLAT_PANELS_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/hausdorff.h>
#include <CGAL/Multiplanar/internal/Panel_search.h>
#include <CGAL/Multiplanar/internal/panel_places.h>
#include <CGAL/Multiplanar/panel_triangulation.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What `flat_panels()` is asked for.
struct Flat_panels_options
{
  int max_panels = 50;            ///< k
  Effort effort = Effort::normal; ///< how long to look for better partitions
  double work = 1;                ///< multiplies the work of the search
  double time_limit = 0;          ///< seconds after which the search stops, 0: none. If it strikes, results vary
  int threads = 0;                ///< 0: all that the machine has; the result does not depend on it
  std::uint64_t seed = 0;         ///< of the random choices of the search
  double min_edge = 0.002;        ///< shortest edge aimed at, in diagonals of the bounding box
  double min_width = 0.002;       ///< smallest width of a panel, in diagonals
  double thickness = 0;           ///< of the sheets, in diagonals: edges should have room for joints; 0: they need not
  int max_questions = 0;          ///< asked about obstacles, but for those of a last resort; 0: any number
  bool last_resort = false;       ///< try panels merged from many small ones however large the mesh: that can take long
  bool merge_triangles = false;   ///< look at no partition, but merge the triangles of the mesh: slow, and fails least
  std::vector<double> importance; ///< by face: a distance there counts so many times, e.g. 1 + W s; empty: once
};

struct Flat_panels_result;

/// Tells which panels of a result the caller cannot use, worst first; none if all is well. Asked of several results at
/// once, in different threads. It may leave something with the result that it is asked of (`companion`).
using Flat_panels_obstacles = std::function<std::vector<int>(Flat_panels_result&)>;

/// Tells which panels of a result the caller cannot use as it is. It may name some where `Flat_panels_obstacles` would
/// find a way, but is fast for results that are mostly the same.
using Flat_panels_check = std::function<std::vector<int>(const Flat_panels_result&)>;

/// Exactly flat panels near a model.
struct Flat_panels_result
{
  bool ok = false;                 ///< all promises hold: simple flat panels, closed, no intersections, at most k
  Panel_complex complex;           ///< in the units of the source
  std::vector<int> panel_of_face;  ///< the labelling that `complex` has the combinatorics of
  double hausdorff = 0;            ///< symmetric distance between the source and the panels: an upper bound, certified
  double to_panels = 0;            ///< from the source to the panels
  double to_input = 0;             ///< from the panels to the source
  double hausdorff_error = 0;      ///< how far these may exceed what is attained
  double mean = 0;                 ///< mean distance of the source from the panels
  double obstacle_seconds = 0;     ///< until no obstacles were left
  int fewest = 0;                  ///< if triangles were merged: the number of panels left where no more could be
  int questions = 0;               ///< asked about obstacles, but for those of a last resort
  std::shared_ptr<void> companion; ///< what the caller's obstacles left with this result; nobody else looks at it
  std::vector<std::string> notes;  ///< where accuracy was given up, a sentence each
};

/// Receives the part of the work done, 0..1; false stops the search (what was found so far is returned).
using Flat_panels_progress = std::function<bool(double)>;

namespace internal {

inline void measure_panels(const Connectivity& c, const Points& source, double diagonal, Flat_panels_result& result)
{
  Points corners;
  for (const auto& corner : result.complex.corners) corners.push_back(corner.point);
  const auto triangles = triangulate_panels(result.complex).triangles;
  result.hausdorff_error = 1e-4 * diagonal;
  const auto d = symmetric_hausdorff(source, c.triangles, corners, triangles, result.hausdorff_error);
  result.hausdorff = d.upper();
  result.to_panels = d.to_second.upper;
  result.to_input = d.to_first.upper;
  result.mean = mean_distance(source, c.triangles, corners, triangles);
}

inline Flat_panels_result result_of(const Connectivity& c, const Points& source, const Input_surface& input,
                                    const Panel_model& model)
{
  Flat_panels_result result;
  result.panel_of_face = model.labels;
  result.complex = make_panel_complex(c, source, model.labels, model.panels());
  write_state(model.state, input, result.complex);
  result.ok = true;
  for (int p = 0; p < model.panels(); ++p) result.ok = result.ok && is_simple_panel(result.complex, p);
  return result;
}

/// What is smaller than it should be, and where.
inline std::string note_of_offences(const Input_surface& input, const Panel_search& search, const Panel_model& model,
                                    const Panel_complex& complex)
{
  std::vector<std::string> places;
  char size[32];
  for (const auto& e : model.topology->edges)
    if (search.modelled().is_short(model, e)) {
      const double length = (model.state.corner[e.corners[0]] - model.state.corner[e.corners[1]]).norm();
      std::snprintf(size, sizeof size, "%.3g", length * input.scale);
      places.push_back("an edge of length " + std::string(size) + " " +
                       near_corners(complex, {e.corners[0], e.corners[1]}));
    }
  for (int p = 0; p < model.panels(); ++p)
    if (search.modelled().is_narrow(model, p)) places.push_back("a panel " + near_panel(complex, p));
  return "smaller than wanted, for the panels could not be flat without: " + some_of(places);
}

/// Changes panels until a caller's obstacles are gone.
class Panel_rework
{
public:
  /// \param max_questions how often `run()` may ask
  Panel_rework(const Connectivity& c, const Points& source, const Input_surface& input, Panel_search& search,
               const Flat_panels_obstacles& obstacles, int max_questions)
      : c(c), source(source), in(input), search(search), obstacles(obstacles), left(max_questions)
  {
  }

  /// How often `run()` may still ask.
  int questions_left() const { return left; }

  /// `result` is not ok in the end if obstacles are left.
  void run(Panel_model& model, Flat_panels_result& result)
  {
    std::vector<int> blocked = result.ok ? obstacles(result) : std::vector<int>();
    left -= result.ok;
    const double cost = model.cost();
    const bool changed = !blocked.empty();
    for (int round = 0; !blocked.empty() && result.ok; ++round) {
      const std::string place = near_panel(result.complex, blocked[0]);
      result.ok = round < max_rounds && improve(model, result, blocked);
      if (result.ok) search.notes.push_back("the panel " + place + " was changed: the mesh could not be moved into it");
    }
    if (changed && result.ok) regain(cost, model, result);
  }

  /// The way for a mesh that cannot be moved into the panels of a model, nor into others like it: many panels, down to
  /// about a triangle each, which are merged as long as it can. \return false if that does not lead to few panels
  bool coarsen(Panel_model& model, Flat_panels_result& result)
  {
    Panel_model coarse;
    const auto accepted = [&](const Panel_model& m) {
      Trial trial;
      attempt(m, trial);
      return trial.result.ok && trial.blocked.empty();
    };
    if (!search.coarsened(accepted, coarse)) return false;
    Trial trial;
    attempt(coarse, trial);
    model = std::move(coarse);
    result = std::move(trial.result);
    regain(0, model, result);
    search.notes.push_back("the mesh could not be moved into panels that follow it best: others were merged from "
                           "smaller ones, one by one");
    return true;
  }

  /// The way for a mesh that no partition leads to panels for: its triangles are merged.
  /// \param check asked of every step
  /// \return false if that does not lead to few panels; `result.fewest` tells to how many
  bool merge_triangles(const Flat_panels_check& check, Panel_model& model, Flat_panels_result& result)
  {
    const auto unmapped = [&](const Panel_model& m) {
      const Flat_panels_result r = result_of(c, source, in, m);
      if (r.ok) return check ? check(r) : std::vector<int>();
      std::vector<int> bad;
      for (int p = 0; p < m.panels(); ++p)
        if (!is_simple_panel(r.complex, p)) bad.push_back(p);
      return bad;
    };
    int fewest = 0;
    Panel_model merged;
    Trial trial;
    if (search.merged_from_triangles(unmapped, merged, fewest)) attempt(merged, trial);
    result.fewest = fewest;
    if (!trial.result.ok || !trial.blocked.empty()) return false;
    model = std::move(merged);
    result = std::move(trial.result);
    regain(0, model, result);
    result.fewest = fewest;
    search.notes.push_back(
        "no partition led to flat panels that the mesh fits into: they were merged from its triangles");
    return true;
  }

private:
  struct Trial
  {
    Flat_panels_result result;
    std::vector<int> blocked;
  };

  bool improve(Panel_model& model, Flat_panels_result& result, std::vector<int>& blocked)
  {
    const std::vector<int> places(blocked.begin(), blocked.begin() + (std::min)(max_places, int(blocked.size())));
    for (int p : places)
      if (improve_at(p, model, result, blocked)) return true;
    return false;
  }

  /// Takes the first of the models around a blocked panel that has fewer blocked panels, or else fewer panels. They are
  /// tried on several threads and judged in order, so the result does not depend on the number of threads.
  bool improve_at(int p, Panel_model& model, Flat_panels_result& result, std::vector<int>& blocked)
  {
    std::vector<Panel_model> models = search.reworked(model, p);
    const int most = (std::max)(0, (std::min)(max_trials, left));
    if (int(models.size()) > most) models.resize(most);
    std::vector<Trial> trials(models.size());
    int chosen = -1;
    for (int begin = 0; begin < int(models.size()) && chosen < 0; begin += search.number_of_threads()) {
      const int end = (std::min)(begin + search.number_of_threads(), int(models.size()));
      for_each_parallel(end - begin, end - begin, [&](int i) { attempt(models[begin + i], trials[begin + i]); });
      for (int i = begin; i < end && chosen < 0; ++i)
        if (trials[i].result.ok && trials[i].blocked.size() < blocked.size()) chosen = i;
    }
    left -= chosen < 0 ? int(models.size()) : chosen + 1;
    for (int i = 0; i < int(models.size()) && chosen < 0; ++i)
      if (trials[i].result.ok && models[i].panels() < model.panels()) chosen = i;
    if (chosen < 0) return false;
    model = std::move(models[chosen]);
    result = std::move(trials[chosen].result);
    blocked = std::move(trials[chosen].blocked);
    return true;
  }

  /// Improves `model` until it costs about as much as before it was changed; what brings obstacles back does not count.
  void regain(double cost, Panel_model& model, Flat_panels_result& result)
  {
    Panel_model next = model;
    for (int failures = 0, steps = 0; failures < max_failures && steps < max_steps && left > 0 &&
                                      model.cost() > 1.02 * cost && search.improve_once(next);
         --left, ++steps) {
      Trial trial;
      attempt(next, trial);
      if (trial.result.ok && trial.blocked.empty()) model = next, result = std::move(trial.result), failures = 0;
      else ++failures;
    }
  }

  void attempt(const Panel_model& model, Trial& trial) const
  {
    trial.result = result_of(c, source, in, model);
    if (trial.result.ok) trial.blocked = obstacles(trial.result);
  }

  static constexpr int max_rounds = 16, max_places = 4, max_trials = 12, max_failures = 4, max_steps = 200;

  const Connectivity& c;
  const Points& source;
  const Input_surface& in;
  Panel_search& search;
  const Flat_panels_obstacles& obstacles;
  int left;
};

} // namespace internal

/*!
\ingroup PkgMultiplanarComplex

Finds at most k exactly flat panels near a closed triangle mesh.

\param c, source the mesh
\param partitions labellings of the faces to start from; more are made as `options.effort` allows
\param options see `Flat_panels_options`
\param progress called now and then
\param obstacles asked of the result; where it names panels, they are changed or merged and it is asked again
\param check a fast form of `obstacles`, asked of the many steps of `options.merge_triangles`

The result is a closed polygon mesh without intersections, with the combinatorics of `panel_of_face`; corners lie in the
planes of their panels to 1e-12 of the diagonal. If `ok` is false, no partition could be made so.
*/
inline Flat_panels_result flat_panels(const internal::Connectivity& c, const Points& source,
                                      const std::vector<std::vector<int>>& partitions,
                                      const Flat_panels_options& options, const Flat_panels_progress& progress = {},
                                      const Flat_panels_obstacles& obstacles = {}, const Flat_panels_check& check = {})
{
  CGAL_precondition(int(source.size()) == c.number_of_vertices());
  internal::Panel_search_options search_options;
  search_options.max_panels = options.max_panels;
  search_options.effort = options.effort;
  search_options.work = options.work;
  search_options.time_limit = options.time_limit;
  search_options.threads = options.threads;
  search_options.seed = options.seed;
  search_options.min_edge = options.min_edge;
  search_options.min_width = options.min_width;
  search_options.thickness = options.thickness;
  CGAL_precondition(options.importance.empty() || int(options.importance.size()) == c.number_of_faces());
  internal::Input_surface input = internal::make_input_surface(c, source);
  input.set_importance(options.importance);
  internal::Panel_search search(input, search_options, progress);
  internal::Panel_model model;
  Flat_panels_result result;
  if (options.merge_triangles) {
    const Flat_panels_obstacles none = [](Flat_panels_result&) { return std::vector<int>(); };
    internal::Panel_rework rework(c, source, input, search, obstacles ? obstacles : none, 64);
    result.ok = rework.merge_triangles(check, model, result);
    if (result.ok && model.offences > 0)
      search.notes.push_back(internal::note_of_offences(input, search, model, result.complex));
    if (result.ok) internal::measure_panels(c, source, input.scale, result);
    result.notes = search.notes;
    return result;
  }
  if (!search.run(partitions, model)) {
    result.notes = search.notes;
    return result;
  }
  result = internal::result_of(c, source, input, model);
  if (obstacles) {
    const auto start = std::chrono::steady_clock::now();
    const int questions = options.max_questions > 0 ? options.max_questions : (std::numeric_limits<int>::max)();
    internal::Panel_rework rework(c, source, input, search, obstacles, questions);
    rework.run(model, result);
    const int asked = questions - rework.questions_left();
    if (!result.ok && (options.last_resort || c.number_of_faces() <= internal::quickly_coarsened))
      rework.coarsen(model, result);
    result.questions = asked;
    result.obstacle_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  if (model.offences > 0) search.notes.push_back(internal::note_of_offences(input, search, model, result.complex));
  if (result.ok) internal::measure_panels(c, source, input.scale, result);
  result.notes = search.notes;
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_FLAT_PANELS_H
