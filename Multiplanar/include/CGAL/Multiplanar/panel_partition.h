// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_PARTITION_H
#define CGAL_MULTIPLANAR_PANEL_PARTITION_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/panel_junctions.h>
#include <CGAL/Multiplanar/internal/panel_pieces.h>
#include <CGAL/Multiplanar/internal/panel_repair.h>
#include <CGAL/Multiplanar/internal/panel_seeds.h>
#include <CGAL/Multiplanar/internal/panel_splitting.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>
#include <CGAL/Multiplanar/label_costs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What `make_panels()` is to make.
struct Panel_partition_options
{
  int max_panels = 0;     ///< k
  double min_area = 0;    ///< smaller panels are merged, in the squared unit of the points
  double min_width = 0;   ///< so are narrower ones; the width of a panel is 4 area / perimeter (that of a disc: its
                          ///< diameter)
  bool realisable = true; ///< false: only connected panels that do not touch themselves, in a fraction of the time
};

/// What `make_panels()` did.
struct Panel_partition_report
{
  bool ok = false;       ///< whether the labels keep all promises
  int panels = 0;        ///< labels are 0 .. panels - 1
  int pieces_before = 0; ///< connected pieces of the labels given
  int merges = 0;
  int splits = 0;
  int relabelled_faces = 0; ///< in local repairs
  int attempt = 0;          ///< 0 if the labels given could be repaired, else how many other starts were tried
  double cost_before = 0;   ///< data cost (eq. 2) of the labels given and of the result, planes refitted
  double cost_after = 0;
  std::array<int, 8> corner_valences{}; ///< corners of 0, 1, ... panels; the last entry counts 7 and more
};

namespace internal {

/// One run of `make_panels()`.
class Panel_partitioner
{
public:
  Panel_partitioner(const Connectivity& c, const Points& points, const Label_costs& costs,
                    const Panel_partition_options& options)
      : c(c), points(points), costs(costs), options(options)
  {
  }

  Panel_partition_report report;

  /// Connected panels that do not touch themselves.
  std::vector<int> make_connected(std::vector<int> labels, int target)
  {
    label_connected_pieces(c, labels);
    {
      Panel_labelling panels(c, std::move(labels));
      Panel_fits fits(costs, panels);
      report.merges += merge_cheapest(panels, fits, target);
      labels = panels.labels();
    }
    compress_labels(labels);
    return labels;
  }

  std::vector<int> make_light(const std::vector<int>& labels)
  {
    Panel_labelling panels(c, make_connected(labels, options.max_panels));
    Panel_fits fits(costs, panels);
    panels.start_watching();
    report.merges += repair_touches(panels, fits);
    std::vector<int> result = panels.labels();
    finish(result, panels, true);
    return result;
  }

  /// Panels that can be flat, starting from at most `pieces` connected pieces of `labels`.
  std::vector<int> make_realisable(const std::vector<int>& labels, int pieces)
  {
    Panel_work work(costs, Panel_labelling(c, make_connected(labels, pieces)));
    Panel_repair repair(work);
    const bool repaired = repair.run();
    report.merges += repair.merges;
    report.splits += repair.splits;
    if (repaired) {
      report.merges += merge_down_to(work, options.max_panels);
      merge_small(work);
      if (work.panels.number_of_panels() <= options.max_panels)
        report.splits += split_up_to(work, options.max_panels, [&](int p) { return is_large_enough(work.panels, p); });
      simplify_corners(work);
    }
    report.relabelled_faces += work.relabelled;
    std::vector<int> result = work.panels.labels();
    const bool ok = repaired && work.panels.number_of_panels() <= options.max_panels &&
                    work.panels.number_of_local_problems() == 0 &&
                    topology_problems(work.panels, used_labels(work.panels)) == 0;
    finish(result, work.panels, ok);
    return result;
  }

private:
  void finish(std::vector<int>& result, const Panel_labelling& panels, bool ok)
  {
    report.ok = ok;
    report.panels = compress_labels(result);
    report.corner_valences.fill(0);
    for (int v = 0; v < c.number_of_vertices(); ++v)
      if (panels.labels_at(v).size() > 2)
        ++report.corner_valences[(std::min)(std::size_t(7), panels.labels_at(v).size())];
  }

  double area(const Panel_labelling& panels, int p) const
  {
    double sum = 0;
    for (int f : panels.faces(p)) sum += costs.area(f);
    return sum;
  }

  double perimeter(const Panel_labelling& panels, int p) const
  {
    double sum = 0;
    for (int f : panels.faces(p))
      for (int i = 0; i < 3; ++i)
        if (panels.label(c.neighbours[f][i]) != p)
          sum += std::sqrt(CGAL::squared_distance(points[c.triangles[f][i]], points[c.triangles[f][(i + 1) % 3]]));
    return sum;
  }

  bool is_large_enough(const Panel_labelling& panels, int p) const
  {
    if (options.min_area <= 0 && options.min_width <= 0) return true;
    const double a = area(panels, p);
    return a >= options.min_area && (options.min_width <= 0 || 4 * a >= options.min_width * perimeter(panels, p));
  }

  /// Merges panels that are too small, each with the neighbour that costs least.
  void merge_small(Panel_work& work)
  {
    for (bool changed = options.min_area > 0 || options.min_width > 0; changed;) {
      changed = false;
      for (int p : used_labels(work.panels)) {
        if (work.panels.faces(p).empty() || is_large_enough(work.panels, p)) continue;
        std::vector<std::pair<double, int>> neighbours;
        for (int q : neighbouring_panels(work.panels, p)) neighbours.emplace_back(work.fits.merge_cost(p, q), q);
        std::sort(neighbours.begin(), neighbours.end());
        for (const auto& q : neighbours) {
          const int before = work.panels.number_of_panels();
          if (!merge_validly(work, p, q.second, 2)) continue;
          report.merges += before - work.panels.number_of_panels();
          work.panels.commit();
          changed = true;
          break;
        }
      }
    }
  }

  const Connectivity& c;
  const Points& points;
  const Label_costs& costs;
  const Panel_partition_options& options;
};

/// Data cost of labels with refitted planes.
inline double refitted_cost(const Label_costs& costs, const std::vector<int>& labels)
{
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < int(labels.size()); ++f) {
    if (labels[f] >= int(faces.size())) faces.resize(labels[f] + 1);
    faces[labels[f]].push_back(f);
  }
  double sum = 0;
  for (const auto& list : faces)
    if (!list.empty()) sum += faces_cost(costs, list, fitted_plane(costs, plane_sums(costs, list)));
  return sum;
}

} // namespace internal

inline Panel_partition_report make_panels(const internal::Connectivity& c, const Points& points,
                                          const Label_costs& costs, std::vector<int>& labels,
                                          const Panel_partition_options& options)
{
  CGAL_precondition(int(labels.size()) == c.number_of_faces());
  CGAL_precondition(options.max_panels >= 1);
  const int k = options.max_panels;
  std::vector<int> pieces = labels;
  const int pieces_before = internal::label_connected_pieces(c, pieces);
  const double cost_before = internal::refitted_cost(costs, labels);

  Panel_partition_report report;
  std::vector<int> result;
  for (int attempt = 0; attempt < (options.realisable ? 8 : 1); ++attempt) {
    internal::Panel_partitioner partitioner(c, points, costs, options);
    std::vector<int> made;
    if (!options.realisable) made = partitioner.make_light(labels);
    else if (attempt < 3) made = partitioner.make_realisable(labels, k << attempt);
    else {
      const int cells = (std::min)(c.number_of_faces(), (k + 4) << (attempt - 3));
      made = partitioner.make_realisable(internal::evenly_spread_labels(c, costs, cells), cells);
    }
    if (attempt == 0 || (partitioner.report.ok && !report.ok)) {
      report = partitioner.report;
      report.attempt = attempt;
      result = std::move(made);
    }
    if (report.ok) break;
  }
  labels = std::move(result);
  report.pieces_before = pieces_before;
  report.cost_before = cost_before;
  report.cost_after = internal::refitted_cost(costs, labels);
  CGAL_postcondition(!report.ok || report.panels <= k);
  return report;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_PARTITION_H
