// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_PARTITIONER_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_PARTITIONER_H

#include <CGAL/Multiplanar/Panel_partition_options.h>
#include <CGAL/Multiplanar/internal/panel_junctions.h>
#include <CGAL/Multiplanar/internal/panel_pieces.h>
#include <CGAL/Multiplanar/internal/panel_repair.h>
#include <CGAL/Multiplanar/internal/panel_sizes.h>
#include <CGAL/Multiplanar/internal/panel_smoothing.h>
#include <CGAL/Multiplanar/internal/panel_splitting.h>
#include <CGAL/Multiplanar/internal/panel_surgery.h>
#include <CGAL/Multiplanar/internal/panel_teleport.h>
#include <CGAL/Multiplanar/label_costs.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// One way from labels to panels, with a report.
class Panel_partitioner
{
public:
  Panel_partitioner(const Connectivity& c, const Points& points, const Label_costs& costs,
                    const Panel_partition_options& options)
      : c(c), points(points), costs(costs), options(options)
  {
  }

  Panel_partition_report report;

  /// At most `options.max_panels` connected panels that do not touch themselves. This always succeeds.
  std::vector<int> make_connected(std::vector<int> labels)
  {
    Panel_work work(costs, Panel_labelling(c, few_pieces(std::move(labels), options.max_panels)), false);
    report.merges += repair_touches(work.panels, work.fits);
    use_free_labels(work);
    return finish(work, true);
  }

  /// At most `options.max_panels` panels that can be flat, made from at most `pieces` connected pieces of `labels`.
  /// `report.ok` tells whether it succeeded.
  std::vector<int> make_realisable(std::vector<int> labels, int pieces)
  {
    Panel_work work(costs, Panel_labelling(c, few_pieces(std::move(labels), pieces)), true);
    Panel_repair repair(work);
    const bool repaired = repair.run();
    report.merges += repair.merges;
    report.splits += repair.splits;
    if (repaired) {
      report.merges += merge_down_to(work, options.max_panels);
      report.merges += merge_flush_panels(work);
      report.merges += merge_small_panels(work, points, {options.min_area, options.min_width});
      use_free_labels(work);
      simplify_corners(work);
      work.relabelled += Boundary_smoother(work, costs.potts_graph()).run();
    }
    return finish(work, repaired);
  }

private:
  /// The connected pieces of labels, merged at least cost until at most `pieces` are left.
  std::vector<int> few_pieces(std::vector<int> labels, int pieces)
  {
    label_connected_pieces(c, labels);
    Panel_labelling panels(c, std::move(labels));
    Panel_fits fits(costs, panels);
    report.merges += merge_cheapest(panels, fits, pieces);
    std::vector<int> result = panels.labels();
    compress_labels(result);
    return result;
  }

  void use_free_labels(Panel_work& work)
  {
    const Least_size least{options.min_area, options.min_width};
    const auto accept = [&](int p) { return is_large_enough(work, points, least, p); };
    report.splits += split_up_to(work, options.max_panels, accept);
    report.teleports += teleport_panels(work, options.max_teleports, accept);
  }

  std::vector<int> finish(const Panel_work& work, bool repaired)
  {
    const Panel_labelling& panels = work.panels;
    report.ok = repaired && panels.number_of_panels() <= options.max_panels && is_sound(work, used_labels(panels));
    report.relabelled_faces += work.relabelled;
    const std::size_t last = report.corner_valences.size() - 1;
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      const std::size_t valence = panels.labels_at(v).size();
      if (valence > 2) ++report.corner_valences[(std::min)(valence, last)];
    }
    std::vector<int> result = panels.labels();
    report.panels = compress_labels(result);
    return result;
  }

  const Connectivity& c;
  const Points& points;
  const Label_costs& costs;
  const Panel_partition_options& options;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_PARTITIONER_H
