// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/internal/initial_partitions.h>
#include <CGAL/Multiplanar/internal/teleport.h>
#include <CGAL/Multiplanar/panel_partition.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

struct Panel_search_options
{
  int max_panels = 50;
  Effort effort = Effort::normal;
  double time_limit = 0;
  int threads = 0;
  std::uint64_t seed = 0;
  double min_edge = 0.002, min_width = 0.002;
};

/// From partitions to the best model found.
class Panel_search
{
public:
  Panel_search(const Input_surface& input, const Panel_search_options& options, std::function<bool(double)> progress)
      : in(input), c(*input.connectivity), options(options), progress(std::move(progress)),
        modeller(input, std::sqrt(input.area / 3000)), start(std::chrono::steady_clock::now())
  {
    for (const Vec3& x : in.points) frame_points.push_back(as_point(x));
  }

  std::vector<std::string> notes;

  bool run(std::vector<std::vector<int>> partitions, Panel_model& best)
  {
    add_partitions(partitions);
    const Label_costs costs(c, frame_points);
    bool found = false;
    for (auto& labels : partitions) {
      Panel_model m;
      if (!start_model(costs, labels, m)) continue;
      if (!found || better(m, best)) best = std::move(m), found = true;
      if (stopped(0.2)) break;
    }
    if (!found || best.faults > 0) return false;
    search(best);
    return finish(costs, best);
  }

private:
  int trial_budget() const
  {
    return options.effort == Effort::fast ? 0 : options.effort == Effort::normal ? 300 : 1 << 30;
  }

  Accuracy_options accuracy() const
  {
    Accuracy_options a;
    a.min_edge = options.min_edge;
    return a;
  }

  void add_partitions(std::vector<std::vector<int>>& partitions) const
  {
    const int wanted = options.effort == Effort::fast ? 1 : options.effort == Effort::normal ? 4 : 10;
    Face_cost cost(in, 0.02);
    for (int i = 0; int(partitions.size()) < wanted; ++i)
      partitions.push_back(grow_partition(in, modeller.moments_of_faces(), cost, options.max_panels,
                                          options.seed * 1000 + std::uint64_t(i), i % 2 == 0 ? 1.1 : 1.5));
  }

  /// A repaired model of a partition with accuracy steps. \return false if it cannot be made realisable
  bool start_model(const Label_costs& costs, std::vector<int> labels, Panel_model& m)
  {
    Panel_partition_options partition;
    partition.max_panels = options.max_panels;
    const auto report = make_panels(c, frame_points, costs, labels, partition);
    if (!report.ok) return false;
    std::vector<char> touched;
    if (!modeller.rebuild(nullptr, no_edit(labels, report.panels), m, touched)) return false;
    Teleport_search t(modeller, options.max_panels);
    t.local_options = accuracy();
    while (m.faults > 0 && t.repair_once(m)) {
    }
    modeller.improve_all(m, accuracy());
    return true;
  }

  void search(Panel_model& m)
  {
    Teleport_search t(modeller, options.max_panels);
    t.local_options = accuracy();
    t.local_options.powers = {8, 32};
    t.local_options.steps = 6;
    while (t.trials < trial_budget() && !stopped(0.2 + 0.7 * t.trials / trial_budget()) && t.improve_once(m)) {
    }
    modeller.improve_all(m, accuracy());
  }

  /// Chords are mended, so that the mesh can follow; the model is adapted where that changed corners.
  bool finish(const Label_costs& costs, Panel_model& m)
  {
    Panel_labelling panels(c, m.labels);
    Panel_fits fits(costs, panels);
    panels.start_watching();
    if (panels.number_of_local_problems() == 0) return true;
    Panel_mender mender(panels, fits);
    mender.mend_all();
    if (panels.number_of_local_problems() > 0)
      notes.push_back("some triangles of the mesh lie between corners of one edge of a panel");
    Label_edit edit = no_edit(panels.labels(), m.panels());
    Panel_model mended;
    std::vector<char> touched;
    if (!modeller.rebuild(&m, edit, mended, touched) || mended.faults > 0) return true;
    Accuracy_options a = accuracy();
    a.powers = {32};
    modeller.improve(mended, with_ring(*mended.topology, touched), a);
    m = std::move(mended);
    return true;
  }

  static bool better(const Panel_model& a, const Panel_model& b)
  {
    return a.faults != b.faults ? a.faults < b.faults : a.merit < b.merit;
  }

  bool stopped(double done)
  {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (options.time_limit > 0 && seconds > options.time_limit) return true;
    return progress && !progress((std::min)(done, 1.0));
  }

  const Input_surface& in;
  const Connectivity& c;
  Panel_search_options options;
  std::function<bool(double)> progress;
  Panel_modeller modeller;
  Points frame_points;
  std::chrono::steady_clock::time_point start;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_H
