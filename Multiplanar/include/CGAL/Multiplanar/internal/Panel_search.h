// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H

#include <CGAL/Multiplanar/internal/Panel_search_options.h>
#include <CGAL/Multiplanar/internal/coarsen_panels.h>
#include <CGAL/Multiplanar/internal/initial_partitions.h>
#include <CGAL/Multiplanar/internal/mend_ears.h>
#include <CGAL/Multiplanar/internal/merge_triangles.h>
#include <CGAL/Multiplanar/internal/panel_places.h>
#include <CGAL/Multiplanar/internal/teleport.h>
#include <CGAL/Multiplanar/panel_partition.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// From partitions to the best model found.
class Panel_search
{
public:
  Panel_search(const Input_surface& input, const Panel_search_options& options, std::function<bool(double)> progress)
      : in(input), c(*input.connectivity), options(options), budget(search_budget(options.effort)),
        threads(options.threads > 0 ? options.threads : (std::max)(1, int(std::thread::hardware_concurrency()))),
        progress(std::move(progress)),
        modeller(input, std::sqrt(input.area / 3000), options.min_edge, options.min_width, options.thickness),
        start(std::chrono::steady_clock::now())
  {
    for (const Vec3& x : in.points) frame_points.push_back(as_point(x));
  }

  std::vector<std::string> notes;

  /// \return false if no partition led to panels without faults
  bool run(std::vector<std::vector<int>> partitions, Panel_model& best)
  {
    const Label_costs costs = label_costs();
    std::vector<Panel_model> models;
    for (int attempt = 0; attempt < 3 && models.empty(); ++attempt) {
      add_partitions(attempt, partitions);
      start_models(costs, partitions, models);
      partitions.clear();
    }
    if (models.empty() && !start_from_many(costs, models)) return false;
    search(models);
    best = std::move(models[0]);
    tidy(best);
    mend(costs, best, &notes);
    return true;
  }

  const Panel_modeller& modelled() const { return modeller; }
  int number_of_threads() const { return threads; }

  /// Models with panel `p` of a result of `run` or its surroundings changed: to choose from where `p` is of no use.
  std::vector<Panel_model> reworked(const Panel_model& m, int p)
  {
    Teleport_search t(modeller, options.max_panels, threads);
    t.local_options = local_accuracy();
    std::vector<Panel_model> models = t.reworked(m, p);
    const Label_costs costs = label_costs();
    for_each_parallel(int(models.size()), threads, [&](int i) { mend(costs, models[i], nullptr); });
    return models;
  }

  /// Makes the best change near the worst places of a result of `run`. \return false if none lowers the cost
  bool improve_once(Panel_model& m)
  {
    Teleport_search t(modeller, options.max_panels, threads);
    t.local_options = local_accuracy();
    if (!t.improve_once(m)) return false;
    mend(label_costs(), m, nullptr);
    return true;
  }

  /// An accepted model from many small panels, merged one by one; then improved as far as it stays accepted.
  /// \return false if there is none
  bool coarsened(const Model_test& accepted, Panel_model& m)
  {
    const Label_costs costs = label_costs();
    const auto mended = [&](Panel_model& changed) { mend(costs, changed, nullptr); };
    const Panel_coarsening coarsening(modeller, costs, frame_points, accuracy(), options.seed, mended, accepted);
    if (!coarsening.run(options.max_panels, m)) return false;
    improve_accepted(accepted, m);
    return true;
  }

  /// A model merged from the triangles of the mesh, all panels of use; then improved as far as they stay so.
  /// \param unmapped names the panels that are of no use as they are
  /// \param fewest receives the number of panels that were left; 0 if nothing was merged, or it was stopped
  /// \return false if there is none
  bool merged_from_triangles(const std::function<std::vector<int>(const Panel_model&)>& unmapped, Panel_model& m,
                             int& fewest)
  {
    Accuracy_options few = accuracy();
    few.powers = {4}, few.steps = 3;
    const auto mended = [&](Panel_model& changed) {
      std::vector<int> bad = unmapped(changed);
      if (bad.empty()) return bad;
      Ear_mender ears(c, changed);
      if (ears.run(bad) && modeller.relabel(ears.labels, changed)) bad = unmapped(changed);
      return bad;
    };
    bool stopped = false;
    const auto go_on = [&](int panels) {
      const double all = c.number_of_faces(), done = std::log(all / panels) / std::log(all / options.max_panels);
      stopped = stopped || out_of_time() || (progress && !progress(0.15 + 0.8 * (std::min)(1.0, done)));
      return !stopped;
    };
    const bool found = merge_triangles(modeller, few, options.max_panels, mended, m, go_on);
    fewest = !stopped && m.topology && m.panels() < c.number_of_faces() ? m.panels() : 0;
    if (!found) return false;
    improve_accepted([&](const Panel_model& x) { return unmapped(x).empty(); }, m);
    if (!stopped) search_usable([&](Panel_model& x) { return mended(x).empty() && x.faults == 0; }, m);
    return true;
  }

private:
  /// One chain of improvements and kicks through models of use only.
  void search_usable(const std::function<bool(Panel_model&)>& usable, Panel_model& best) const
  {
    Teleport_search t(modeller, options.max_panels, threads);
    t.local_options = local_accuracy();
    t.usable = usable;
    std::mt19937_64 random(options.seed * 1000003 + 7);
    Panel_model m = best;
    while (t.work < budget.merged * options.work && !out_of_time()) {
      if (progress && !progress(0.95 + 0.05 * (std::min)(1.0, t.work / (budget.merged * options.work)))) break;
      if (t.improve_once(m)) continue;
      if (ranks_before(m, best)) best = m;
      m = best;
      if (!t.kick(m, random) || !usable(m)) m = best, t.work += 0.01 * budget.merged;
    }
    if (ranks_before(m, best)) best = m;
  }

  void improve_accepted(const Model_test& accepted, Panel_model& m) const
  {
    modeller.measure_all(m);
    for (int power : accuracy().powers) {
      Panel_model improved = m;
      Accuracy_options a = accuracy();
      a.powers = {power};
      modeller.improve_all(improved, a);
      if (improved.faults == 0 && accepted(improved)) m = std::move(improved);
    }
  }

  /// Costs that make panels as dense as the importance says (`Label_costs::seed_density()`).
  Label_costs label_costs() const
  {
    std::vector<double> w_t;
    for (double w : in.importance) w_t.push_back(4 * (in.largest_importance / w - 1));
    return Label_costs(c, frame_points, {}, w_t);
  }

  Accuracy_options accuracy() const
  {
    Accuracy_options a;
    a.min_edge = options.min_edge;
    return a;
  }

  Accuracy_options local_accuracy() const
  {
    Accuracy_options a = accuracy();
    a.powers = {16, 32};
    a.steps = 5;
    a.refresh = 1 << 20;
    return a;
  }

  /// Grown partitions, from seeds that differ with the attempt; later attempts with fewer panels.
  void add_partitions(int attempt, std::vector<std::vector<int>>& partitions) const
  {
    const int given = int(partitions.size()), wanted = given + budget.partitions;
    const int least = 4 + 3 * c.genus();
    const int k = (std::max)((std::min)(least, options.max_panels), int(options.max_panels * (1 - 0.1 * attempt)));
    partitions.resize(wanted);
    const Face_cost cost(in, 0.02);
    for_each_parallel(wanted - given, threads, [&](int i) {
      partitions[given + i] =
          grow_partition(in, modeller.moments_of_faces(), cost, k,
                         options.seed * 1000 + std::uint64_t(100 * attempt + i), i % 2 == 0 ? 1.1 : 1.5);
    });
  }

  /// Models without faults, best first.
  void start_models(const Label_costs& costs, const std::vector<std::vector<int>>& partitions,
                    std::vector<Panel_model>& models)
  {
    std::vector<Panel_model> started(partitions.size());
    std::vector<char> ok(partitions.size(), 0);
    for_each_parallel(int(partitions.size()), threads,
                      [&](int i) { ok[i] = start_model(costs, partitions[i], started[i]) && started[i].faults == 0; });
    for (std::size_t i = 0; i < started.size(); ++i)
      if (ok[i]) models.push_back(std::move(started[i]));
    sort_models(models);
    if (progress) progress(0.15);
  }

  /// The start where few panels cannot be made flat: many are, and merged.
  bool start_from_many(const Label_costs& costs, std::vector<Panel_model>& models)
  {
    const Panel_coarsening coarsening(modeller, costs, frame_points, accuracy(), options.seed);
    Panel_model m;
    if (!coarsening.run(options.max_panels, m)) return false;
    modeller.improve_all(m, accuracy());
    models.push_back(std::move(m));
    return true;
  }

  /// The number of panels if the labels are 0 .. n - 1 and can be made flat as they are, or 0.
  int number_of_realisable_panels(const std::vector<int>& labels) const
  {
    const auto range = std::minmax_element(labels.begin(), labels.end());
    Complex_topology t;
    std::vector<int> vertices;
    if (*range.first < 0 || *range.second >= c.number_of_faces()) return 0;
    const int n = *range.second + 1;
    return Topology_tracer(c, labels, n).trace(t, vertices) ? n : 0;
  }

public:
  /// A repaired model of a partition with accuracy steps. \return false if it cannot be made realisable
  bool start_model(const Label_costs& costs, std::vector<int> labels, Panel_model& m) const
  {
    int panels = number_of_realisable_panels(labels);
    if (panels == 0 || panels > options.max_panels) {
      Panel_partition_options partition;
      partition.max_panels = options.max_panels;
      const auto report = make_panels(c, frame_points, costs, labels, partition);
      if (!report.ok) return false;
      panels = report.panels;
    }
    std::vector<char> touched;
    if (!modeller.rebuild(nullptr, no_edit(labels, panels), m, touched)) return false;
    Teleport_search t(modeller, options.max_panels, 1);
    t.local_options = accuracy();
    if (m.faults > hopeless_faults * panels) return false;
    for (int round = 0; round < 2; ++round) {
      while (m.faults > 0 && t.repair_once(m)) {
      }
      modeller.improve_all(m, accuracy());
      if (m.faults == 0) break;
    }
    return true;
  }

private:
  /// Faults for each panel of a start that repairs would take minutes for, and not mend.
  static constexpr int hopeless_faults = 4;

  /// Chains of improvements and kicks; in the end the best is first.
  void search(std::vector<Panel_model>& models)
  {
    if (budget.chains == 0) {
      modeller.improve_all(models[0], final_accuracy());
      return;
    }
    while (int(models.size()) > budget.chains) models.pop_back();
    const std::size_t chains = models.size();
    std::vector<Panel_model> best = models;
    double last = best[0].cost();
    int idle = 0; // rounds without a gain
    for (int round = 0; idle < 5 && round < budget.rounds && !stopped(round); ++round) {
      for_each_parallel(int(models.size()), threads, [&](int i) { run_chain(round, i, models[i], best[i]); });
      sort_models(best);
      // The better half goes on; with every round there are fewer chains, down to two.
      if (best.size() > 2)
        best.resize((std::max)(std::size_t(2), best.size() - (std::max)(std::size_t(1), chains / 4)));
      models = best;
      idle = best[0].cost() < 0.999 * last ? 0 : idle + 1;
      last = best[0].cost();
    }
    models = std::move(best);
    // The last steps see samples four times as dense.
    const Panel_modeller fine(in, modeller.sample_spacing() / 2, options.min_edge, options.min_width,
                              options.thickness);
    fine.improve_all(models[0], final_accuracy());
  }

  Accuracy_options final_accuracy() const
  {
    Accuracy_options a = accuracy();
    a.powers = {16, 32, 64, 128};
    a.steps = 20;
    a.least_gain = 1e-4;
    return a;
  }

  void run_chain(int round, int chain, Panel_model& m, Panel_model& best) const
  {
    Teleport_search t(modeller, options.max_panels, 1);
    t.local_options = local_accuracy();
    std::mt19937_64 random(options.seed * 1000003 + std::uint64_t(round) * 101 + std::uint64_t(chain));
    while (t.work < budget.work * options.work && !out_of_time()) {
      if (t.improve_once(m)) continue;
      if (ranks_before(m, best)) best = m;
      m = best;
      if (!t.kick(m, random)) t.work += 0.05 * budget.work;
    }
    if (ranks_before(m, best)) best = m;
  }

  /// What is too short or too narrow to be cut is removed; what that costs is regained as far as it can be.
  void tidy(Panel_model& m)
  {
    Teleport_search t(modeller, options.max_panels, threads);
    t.local_options = local_accuracy();
    const double cost = m.cost();
    while (m.offences > 0 && t.tidy_once(m)) {
    }
    for (int i = 0; i < 64 && m.cost() > 1.02 * cost && t.improve_once(m); ++i) {
    }
  }

  /// Chords are mended, so that the mesh can follow; the model is adapted where that changed corners.
  void mend(const Label_costs& costs, Panel_model& m, std::vector<std::string>* notes) const
  {
    Panel_labelling panels(c, m.labels);
    Panel_fits fits(costs, panels);
    panels.start_watching();
    if (panels.number_of_local_problems() == 0) return;
    Panel_mender mender(panels, fits);
    mender.mend_all();
    if (notes && panels.number_of_local_problems() > 0)
      notes->push_back("triangles of the mesh have no area left, on an edge of a panel: " + places_of_chords(panels));
    Label_edit edit = no_edit(panels.labels(), m.panels());
    Panel_model mended;
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, mended, touched) || mended.faults > 0) return;
    Accuracy_options a = accuracy();
    a.powers = {32};
    modeller.improve(mended, with_ring(*mended.topology, touched), a);
    m = std::move(mended);
  }

  std::string places_of_chords(const Panel_labelling& panels) const
  {
    std::vector<std::string> places;
    for (int v = 0; v < c.number_of_vertices(); ++v)
      panels.for_each_chord(v, [&](int w) {
        if (v < w) places.push_back(near_points({in.from_frame(in.points[v]), in.from_frame(in.points[w])}));
      });
    return some_of(places);
  }

  static void sort_models(std::vector<Panel_model>& models)
  {
    std::stable_sort(models.begin(), models.end(),
                     [](const Panel_model& a, const Panel_model& b) { return ranks_before(a, b); });
  }

  bool out_of_time() const
  {
    return options.time_limit > 0 &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.time_limit;
  }

  bool stopped(int round)
  {
    if (out_of_time()) return true;
    const double part = options.effort == Effort::best ? 1 - std::pow(0.9, round) : double(round) / budget.rounds;
    return progress && !progress(0.15 + 0.8 * part);
  }

  const Input_surface& in;
  const Connectivity& c;
  Panel_search_options options;
  Search_budget budget;
  int threads;
  std::function<bool(double)> progress;
  Panel_modeller modeller;
  Points frame_points;
  std::chrono::steady_clock::time_point start;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H
