// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_APPROXIMATE_H
#define CGAL_MULTIPLANAR_APPROXIMATE_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/flat_panels.h>
#include <CGAL/Multiplanar/hausdorff.h>
#include <CGAL/Multiplanar/internal/Approximation_loop.h>
#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/internal/finish.h>
#include <CGAL/Multiplanar/internal/parallel_ranges.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// The main job on flat arrays: the paper's loop from one or several seeds, exact panels, and the mesh moved onto them.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// \throws std::invalid_argument with one line for the user if the options do not fit the mesh
inline void check_options(const Connectivity& c, const Points& source, const Approximation_options& options)
{
  if (int(source.size()) != c.number_of_vertices()) throw std::invalid_argument("one point per vertex is needed");
  const int genus = c.genus(), least = fewest_panels(genus);
  if (options.panels < least)
    throw std::invalid_argument("a surface of genus " + std::to_string(genus) + " needs at least " +
                                std::to_string(least) + " panels; " + std::to_string(options.panels) +
                                " were asked for");
  if (options.panels > c.number_of_faces())
    throw std::invalid_argument(std::to_string(options.panels) + " panels were asked for, but the mesh has only " +
                                std::to_string(c.number_of_faces()) + " faces");
  if (options.iterations < 1) throw std::invalid_argument("at least one iteration is needed");
  if (options.restarts < 1) throw std::invalid_argument("at least one restart is needed");
  if (options.threads < 0) throw std::invalid_argument("the number of threads must not be negative");
  if (!(options.smoothness >= 0)) throw std::invalid_argument("the smoothness weight must be a number >= 0");
  if (!(options.min_edge >= 0) || !(options.min_width >= 0) || !(options.sheet_thickness >= 0))
    throw std::invalid_argument("the shortest edge, the smallest width and the thickness must be numbers >= 0");
  if (!options.saliency.empty() && options.saliency.size() != std::size_t(c.number_of_faces()))
    throw std::invalid_argument("the saliency has " + std::to_string(options.saliency.size()) +
                                " values, but the mesh has " + std::to_string(c.number_of_faces()) + " faces");
}

inline int thread_count(int wanted)
{
  return wanted > 0 ? wanted : (std::max)(1, int(std::thread::hardware_concurrency()));
}

/// What one run of the loop leaves.
struct Loop_outcome
{
  Points points;
  std::vector<std::vector<int>> partitions; ///< that can be flat: of the input's own shape, and of the final one
  int passes = 0;
  bool converged = false;
  std::map<std::string, double> seconds;
  std::vector<Labelling_record> labellings;
};

inline Loop_outcome run_loop(const Connectivity& c, const Points& source, const Approximation_options& options,
                             std::uint64_t seed, int threads, Approximation_visitor& visitor)
{
  Approximation_loop loop(c, source, options, seed, threads);
  std::size_t told = 0;
  const auto tell_labellings = [&] {
    while (told < loop.labellings().size()) visitor.labelled(loop.labellings()[told++]);
  };
  const std::vector<int> first_labels = loop.realisable_labels();
  for (bool more = true; more;) {
    more = loop.step();
    tell_labellings();
    visitor.pass_done(loop.passes() - 1, loop.points(), loop.labels());
    if (!visitor.progress("approximate", double(loop.passes()) / options.iterations)) more = false;
  }
  loop.finish_labels();
  tell_labellings();
  return {loop.points(),    {first_labels, loop.labels()}, loop.passes(), loop.converged(), loop.seconds(),
          loop.labellings()};
}

/// One of several runs at a time, as it is told to the visitor of all of them: only what the calling thread does is.
struct Restart_visitor : Approximation_visitor
{
  Restart_visitor(Approximation_visitor* all, std::atomic<int>& done, std::atomic<bool>& stopped, int runs)
      : all(all), done(done), stopped(stopped), runs(runs)
  {
  }
  bool progress(const std::string& stage, double fraction) override
  {
    if (all && !all->progress(stage, (done + fraction) / runs)) stopped = true;
    return !stopped;
  }
  void pass_done(int pass, const std::vector<Point_3>& points, const std::vector<int>& labels) override
  {
    if (all) all->pass_done(pass, points, labels);
  }
  Approximation_visitor* all; ///< null on other threads
  std::atomic<int>& done;
  std::atomic<bool>& stopped;
  int runs;
};

/// Runs the loop from `options.restarts` seeds, several at a time. Outcome r depends on `options.seed` + r alone.
inline std::vector<Loop_outcome> run_restarts(const Connectivity& c, const Points& source,
                                              const Approximation_options& options, Approximation_visitor& visitor)
{
  const int threads = thread_count(options.threads), runs = options.restarts;
  std::vector<Loop_outcome> outcomes(runs);
  if (runs == 1) {
    outcomes[0] = run_loop(c, source, options, options.seed, threads, visitor);
    return outcomes;
  }
  std::atomic<int> next(0), done(0);
  std::atomic<bool> stopped(false);
  const int parts = (std::min)(threads, runs);
  parallel_ranges(parts, parts, [&](int part, int, int) { // a thread each, whose exceptions are passed on
    Restart_visitor told(part == 0 ? &visitor : nullptr, done, stopped, runs);
    for (int r = next++; r < runs; r = next++, ++done)
      outcomes[r] = run_loop(c, source, options, options.seed + std::uint64_t(r), 1, told);
  });
  for (int r = 0; r < runs; ++r)
    for (Labelling_record& record : outcomes[r].labellings) {
      record.restart = r;
      visitor.labelled(record);
    }
  return outcomes;
}

/// Fills the figures of the result that are measured on it.
inline void measure(const Connectivity& c, const Points& source, Approximation_result& result)
{
  const double diagonal = Unit_frame(source).diagonal();
  const auto distance = symmetric_hausdorff(source, c.triangles, result.points, c.triangles, 1e-4 * diagonal);
  result.hausdorff = distance.upper();
  result.hausdorff_to_panels = distance.to_second.upper;
  result.hausdorff_to_input = distance.to_first.upper;
  result.mean_distance = (mean_distance(source, c.triangles, result.points, c.triangles) +
                          mean_distance(result.points, c.triangles, source, c.triangles)) /
                         2;
  result.planarity_deviation = 0;
  for (int f = 0; f < c.number_of_faces(); ++f)
    for (int v : c.triangles[f])
      result.planarity_deviation =
          (std::max)(result.planarity_deviation,
                     std::abs(signed_distance(result.complex.panels[result.panel_of_face[f]].plane, result.points[v])));
  result.embedded = is_embedded(c, result.points);
}

/// Approximates a closed embedded mesh by at most `options.panels` flat panels.
/// \throws std::invalid_argument if the options do not fit the mesh
inline Approximation_result approximate(const Connectivity& c, const Points& source,
                                        const Approximation_options& options, Approximation_visitor& visitor)
{
  check_options(c, source, options);
  CGAL_expensive_precondition(is_embedded(c, source));
  const std::vector<Loop_outcome> outcomes = run_restarts(c, source, options, visitor);

  Approximation_result result;
  for (const auto& stage : outcomes[0].seconds) result.seconds[stage.first] = stage.second;
  result.iterations = outcomes[0].passes;
  result.converged = outcomes[0].converged;
  for (std::size_t r = 0; r < outcomes.size(); ++r)
    if (outcomes[r].converged)
      result.notes.push_back((outcomes.size() > 1 ? "restart " + std::to_string(r) + ": " : std::string()) +
                             "nothing changed any more after pass " + std::to_string(outcomes[r].passes));
  std::vector<std::vector<int>> partitions;
  for (const Loop_outcome& outcome : outcomes) {
    partitions.insert(partitions.end(), outcome.partitions.begin(), outcome.partitions.end());
    result.labellings.insert(result.labellings.end(), outcome.labellings.begin(), outcome.labellings.end());
  }
  finish(c, source, partitions, options, visitor, result);
  measure(c, source, result);
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_APPROXIMATE_H
