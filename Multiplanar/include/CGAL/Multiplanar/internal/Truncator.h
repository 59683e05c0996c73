// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H
#define CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H

#include <CGAL/Multiplanar/Truncation_options.h>
#include <CGAL/Multiplanar/internal/Alternation.h>
#include <CGAL/Multiplanar/internal/Slab_cuts.h>
#include <CGAL/Multiplanar/internal/outline_cleaning.h>
#include <CGAL/Multiplanar/internal/flat_panel_check.h>
#include <CGAL/Multiplanar/internal/truncation_order.h>
#include <CGAL/Multiplanar/internal/truncation_warnings.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The construction described at `truncate_panels()`. What does not depend on teeth is computed once, and panels that
/// teeth do not concern are remembered, so that the truncation can be asked for again with other teeth.
class Truncator
{
public:
  Truncator(const Panel_complex& complex, const Truncation_options& options)
      : complex(complex), options(options), order(truncation_order(complex)), panels(whole_panels(complex, options)),
        cuts_of(complex, panels, options.thickness, options.approach_length()), memory(panels.size())
  {
    lost.resize(panels.size());
    for (int p = 0; p < complex.number_of_panels(); ++p) within.push_back(columns_within_model(p, lost[p]));
  }
  Truncator(const Truncator&) = delete;
  Truncator& operator=(const Truncator&) = delete;

  /// The outlines, with teeth on the edges listed.
  Truncation truncation(const std::vector<Alternation>& teeth = {})
  {
    Truncation result;
    result.order = order;
    result.panels.resize(panels.size());
    std::vector<const Slab*> done(panels.size()); // final for the panels that the loop has passed
    for (std::size_t p = 0; p < panels.size(); ++p) done[p] = &within[p];
    for (int i = 0; i < int(order.size()); ++i) {
      const int p = order[i];
      const Outcome& outcome = cut(i, teeth, done);
      done[p] = &outcome.slab;
      result.panels[p] = {panels[p].frame, outcome.slab.polygons, outcome.dropped_area};
      for (int q : outcome.overhung_by) result.overhangs.push_back({q, p});
      for (int q : outcome.blocked_by) result.blocked.push_back({q, p});
    }
    for (int p = 0; p < complex.number_of_panels(); ++p) warn_about_panel(complex, options, p, result);
    return result;
  }

private:
  /// What is left of a panel, and the panels that it must come after or cannot come after.
  struct Outcome
  {
    Slab slab;
    double dropped_area;
    std::vector<int> overhung_by, blocked_by;
  };

  /// One that can cut a panel: another panel, as it is by now, and its teeth.
  struct Cutter
  {
    int panel;
    const Slab* slab;
    std::vector<Alternation> teeth;
    bool keeps; ///< it stays where it has no teeth of the panel to be cut

    bool operator==(const Cutter& other) const
    {
      return panel == other.panel && slab == other.slab && keeps == other.keeps && teeth == other.teeth;
    }
  };

  static std::vector<Slab> whole_panels(const Panel_complex& complex, const Truncation_options& options)
  {
    if (!(options.thickness > 0)) throw std::invalid_argument("the thickness must be positive");
    require_flat_panels(complex);
    std::vector<Slab> panels;
    for (int p = 0; p < complex.number_of_panels(); ++p) {
      const Part part = part_from_panel(complex, p);
      panels.emplace_back(part.frame, std::vector<Flat_polygon>{{part.outline, part.holes}}, options.thickness);
    }
    return panels;
  }

  /// Step 1. A column that leaves the model does so through a panel that faces away from the column's own.
  Slab columns_within_model(int p, double& lost) const
  {
    Exact_polygon_set set = panels[p].polygon_set();
    Cuts cuts;
    for (int q = 0; q < int(panels.size()); ++q)
      if (q != p && panels[p].frame.normal * panels[q].frame.normal < 0 && boxes_meet(panels[p], panels[q], 0))
        for (const Exact_convex& piece : panels[q].pieces) cuts_of.add_crossings(piece, q, p, cuts);
    Slab_cuts::subtract(cuts, set);
    return Slab(panels[p].frame, cleaned_pieces(set, lost), options.thickness);
  }

  /// Step 2 for the panel at position `i` of the order; remembered.
  const Outcome& cut(int i, const std::vector<Alternation>& teeth, const std::vector<const Slab*>& done)
  {
    const int p = order[i];
    const auto cutters = cutters_of(i, teeth, done);
    for (const auto& known : memory[p])
      if (known.first == cutters) return *known.second;
    Exact_polygon_set set = within[p].polygon_set();
    Cuts cuts;
    for (const Cutter& cutter : cutters) add_overlaps(cutter, p, cuts);
    Slab_cuts::subtract(cuts, set);
    std::vector<int> overhung_by, blocked_by;
    for (int j = 0; j < i; ++j) clear_approach(p, order[j], *done[order[j]], set, overhung_by, blocked_by);
    double dropped = lost[p];
    std::vector<Flat_polygon> pieces = cleaned_pieces(set, options.thinnest, dropped);
    dropped += drop_small_pieces(options, pieces);
    memory[p].emplace_back(cutters, std::make_unique<Outcome>(Outcome{Slab(panels[p].frame, pieces, options.thickness),
                                                                      dropped, overhung_by, blocked_by}));
    return *memory[p].back().second;
  }

  std::vector<Cutter> cutters_of(int i, const std::vector<Alternation>& teeth,
                                 const std::vector<const Slab*>& done) const
  {
    std::vector<Cutter> result;
    for (int j = 0; j < int(order.size()); ++j) {
      const int p = order[i], q = order[j];
      if (q == p || !boxes_meet(panels[p], *done[q], options.approach_length())) continue;
      Cutter cutter{q, done[q], teeth_between(p, q, teeth), j < i};
      if (cutter.keeps || !cutter.teeth.empty()) result.push_back(std::move(cutter));
    }
    return result;
  }

  std::vector<Alternation> teeth_between(int p, int q, const std::vector<Alternation>& teeth) const
  {
    std::vector<Alternation> result;
    for (const Alternation& a : teeth) {
      const auto& sides = complex.edges[a.edge].panels;
      if ((sides[0] == p && sides[1] == q) || (sides[0] == q && sides[1] == p)) result.push_back(a);
    }
    return result;
  }

  void add_overlaps(const Cutter& cutter, int p, Cuts& cuts) const
  {
    const auto cells = cells_along(complex, cutter.teeth, panels[cutter.panel].frame, panels[p].frame, !cutter.keeps);
    for (const Exact_convex& piece : cutter.slab->pieces)
      for (const auto& cell : cells) {
        Exact_convex part = piece;
        for (const Exact_half_plane& h : cell) part = clipped(part, h);
        if (!part.empty()) cuts_of.add_overlap(part, cutter.panel, p, cuts);
      }
  }

  bool is_freed(int p) const { return std::find(options.freed.begin(), options.freed.end(), p) != options.freed.end(); }

  /// Cuts panel `p` free of panel `q`, placed before it, over the last part of the way it comes; unless that costs more
  /// than a quarter of it (and is not called for).
  void clear_approach(int p, int q, const Slab& slab, Exact_polygon_set& set, std::vector<int>& overhung_by,
                      std::vector<int>& blocked_by) const
  {
    if (!boxes_meet(panels[p], slab, options.approach_length())) return;
    Cuts cuts;
    for (const Exact_convex& piece : slab.pieces) cuts_of.add_overhang(piece, q, p, cuts);
    if (cuts.empty()) return;
    Exact_polygon_set freed = set;
    Slab_cuts::subtract(cuts, freed);
    const double before = area_of(set), after = area_of(freed);
    if (after > before - smallest_overhang) return;
    if (after < 0.75 * before && !(is_freed(p) && is_freed(q))) return blocked_by.push_back(q);
    overhung_by.push_back(q);
    set = freed;
  }

  /// Less is rounding, in mm^2: a hundred-thousandth of a micrometre along a millimetre. What is more must go, for the
  /// proof that a panel can be put on forgives no more.
  static constexpr double smallest_overhang = 1e-8;

  static double area_of(const Exact_polygon_set& set)
  {
    double sum = 0;
    for (const Exact_polygon& polygon : polygons_of(set)) sum += area(polygon);
    return sum;
  }

  const Panel_complex& complex;
  Truncation_options options;
  std::vector<int> order;
  std::vector<Slab> panels; ///< the panels themselves
  Slab_cuts cuts_of;
  std::vector<Slab> within; ///< their columns inside the model (step 1)
  std::vector<double> lost; ///< area that step 1 could not keep, by panel
  std::vector<std::vector<std::pair<std::vector<Cutter>, std::unique_ptr<Outcome>>>> memory; ///< by panel
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H
