// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_PARTITION_H
#define CGAL_MULTIPLANAR_PANEL_PARTITION_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Panel_partition_options.h>
#include <CGAL/Multiplanar/internal/Panel_partitioner.h>
#include <CGAL/Multiplanar/internal/panel_seeds.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/panel_partition_problems.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Data cost of labels >= 0, planes refitted to them.
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

/// Tries one start after another: the labels given, with more and more pieces; then cells spread evenly over the
/// surface. If none can be repaired, the labels are only made connected and the report is not ok.
inline Panel_partition_report make_realisable_panels(const Connectivity& c, const Points& points,
                                                     const Label_costs& costs, std::vector<int>& labels,
                                                     const Panel_partition_options& options)
{
  constexpr int starts_from_labels = 3, starts = 8;
  const int k = options.max_panels;
  for (int attempt = 0; attempt < starts; ++attempt) {
    Panel_partitioner partitioner(c, points, costs, options);
    const bool given = attempt < starts_from_labels;
    const int pieces =
        given ? k << attempt : (std::min)(c.number_of_faces(), (k + 4) << (attempt - starts_from_labels));
    std::vector<int> made =
        partitioner.make_realisable(given ? labels : evenly_spread_labels(c, costs, pieces), pieces);
    if (!partitioner.report.ok) continue;
    labels = std::move(made);
    partitioner.report.attempt = attempt;
    return partitioner.report;
  }
  Panel_partitioner partitioner(c, points, costs, options);
  labels = partitioner.make_connected(labels);
  partitioner.report.attempt = starts;
  partitioner.report.ok = false;
  return partitioner.report;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSegmentation

Turns labels into at most k *panels*, 0 .. `report.panels` - 1, such that
- each panel is one connected piece and forms one run of faces around each of its vertices;

and, if `options.realisable`, no combinatorial obstruction keeps them from being flat polygons with area while the mesh
keeps its connectivity:
- each panel is a planar domain: a handle of the surface never lies inside one;
- `panel_complex_problems()` finds nothing: in particular each loop passes at least three neighbours, and no three
panels meet at two corners;
- no edge inside a panel has both ends on the line that the panel shares with one other, and no face all its vertices,
  for these would degenerate when chains of edges become straight.

Panels meet in threes at corners wherever relabelling a few faces around the corner does it; `report.corner_valences`
tells how many other corners remain. k panels are used as far as panels can be split soundly into parts that are not in
one plane. Panels that lie flush with a neighbour, or are smaller than asked for, are merged with one where that can be
done soundly.

How: connected pieces are merged at least cost (eq. 2, planes refitted to the merged piece) down to k. Then vertices
where a panel touches itself are closed or opened; panels with handles are split; a panel wholly inside another is
merged into it or split in three; chords and repeated corners go by handing over few faces, each time fewer of them, or
else by larger parts, mergers and splits. From there on every merger, split and handover keeps the labelling sound or is
taken back: mergers bring the number of panels down to k, splits of the panels of largest data cost bring it up to k
again, corners are simplified, and faces at boundaries change hands where that lowers the energy of eq. 1. If a start
cannot be repaired, others are tried.

\param c the connectivity of the mesh, connected and closed
\param points its vertices
\param costs the label costs of the mesh; they guide all choices. They may be those of other positions of the vertices,
       for instance of the undeformed mesh
\param labels labels >= 0 of the faces, replaced
\param options k and more
\return what was done. `ok` is false only if no start could be repaired, as on meshes with hardly more faces than panels
        or of genus g with k < 4 + 3 g; the labels are then connected panels without self-touches, at most k

\pre `options.max_panels` >= 1; a label per face
Deterministic. About O(F log F) time for F faces and fixed k.
*/
inline Panel_partition_report make_panels(const internal::Connectivity& c, const Points& points,
                                          const Label_costs& costs, std::vector<int>& labels,
                                          const Panel_partition_options& options)
{
  CGAL_precondition(int(labels.size()) == c.number_of_faces());
  CGAL_precondition(int(points.size()) == c.number_of_vertices() && costs.faces() == c.number_of_faces());
  CGAL_precondition(std::all_of(labels.begin(), labels.end(), [](int p) { return p >= 0; }));
  CGAL_precondition(options.max_panels >= 1);
  std::vector<int> pieces = labels;
  const int pieces_before = internal::label_connected_pieces(c, pieces);
  const double cost_before = internal::refitted_cost(costs, labels);

  Panel_partition_report report;
  if (options.realisable) {
    report = internal::make_realisable_panels(c, points, costs, labels, options);
    CGAL_expensive_postcondition(!report.ok || partition_problems(c, points, labels, report.panels).empty());
  } else {
    internal::Panel_partitioner partitioner(c, points, costs, options);
    labels = partitioner.make_connected(std::move(labels));
    report = partitioner.report;
    CGAL_postcondition(report.ok);
  }
  report.pieces_before = pieces_before;
  report.cost_before = cost_before;
  report.cost_after = internal::refitted_cost(costs, labels);
  CGAL_postcondition(report.panels <= options.max_panels);
  return report;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_PARTITION_H
