// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H
#define CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H

#include <CGAL/Multiplanar/Truncation_options.h>
#include <CGAL/Multiplanar/internal/Alternation.h>
#include <CGAL/Multiplanar/internal/Slab.h>
#include <CGAL/Multiplanar/internal/outline_cleaning.h>
#include <CGAL/Multiplanar/internal/flat_panel_check.h>
#include <CGAL/Multiplanar/internal/truncation_order.h>
#include <CGAL/Multiplanar/internal/truncation_warnings.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The construction described at `truncate_panels()`. What does not depend on teeth is computed once, so that the
/// truncation can be asked for again with teeth.
class Truncator
{
public:
  Truncator(const Panel_complex& complex, const Truncation_options& options)
      : complex(complex), options(options), order(truncation_order(complex)), noise(noise_of(complex))
  {
    if (!(options.thickness > 0)) throw std::invalid_argument("the thickness must be positive");
    require_flat_panels(complex);
    for (int p = 0; p < complex.number_of_panels(); ++p) {
      const Part part = part_from_panel(complex, p);
      panels.emplace_back(part.frame, std::vector<Flat_polygon>{{part.outline, part.holes}}, options.thickness);
    }
    for (int p = 0; p < complex.number_of_panels(); ++p) within.push_back(columns_within_model(p));
  }

  const Slab& whole_panel(int p) const { return panels[p]; }

  /// The outlines, with teeth on the edges listed.
  Truncation truncation(const std::vector<Alternation>& teeth = {}) const
  {
    Truncation result;
    result.order = order;
    result.panels.resize(panels.size());
    std::vector<Slab> done = within; // final for the panels that the loop has passed
    for (std::size_t i = 0; i < order.size(); ++i) {
      const int p = order[i];
      Exact_polygon_set set = done[p].polygon_set();
      remove_overlaps(int(i), teeth, done, set);
      for (std::size_t j = 0; j < i; ++j) clear_approach(p, order[j], done[order[j]], set, result);
      Truncated_panel& panel = result.panels[p];
      panel.frame = panels[p].frame;
      panel.pieces = cleaned_pieces(set);
      done[p] = Slab(panel.frame, panel.pieces, options.thickness);
      drop_small_pieces(options, panel);
    }
    for (int p = 0; p < complex.number_of_panels(); ++p) warn_about_panel(complex, options, p, result);
    return result;
  }

private:
  Depths<Exact_number> sheet() const { return {Exact_number(0), Exact_number(options.thickness)}; }
  Depths<Exact_number> reach() const { return {Exact_number(-noise), Exact_number(options.thickness)}; }
  Depths<Exact_number> approach() const
  {
    return {Exact_number(-options.approach_length()), Exact_number(options.thickness)};
  }

  /// In doubles a corner lies on all of its planes only about, so cuts that should meet an outline or each other may
  /// miss by this much, in mm, and leave a web of slivers behind. Every cut is made wider by it.
  static double noise_of(const Panel_complex& complex)
  {
    CGAL::Bbox_3 box;
    for (const auto& corner : complex.corners) box += corner.point.bbox();
    double extent = 0;
    for (int i = 0; i < 3; ++i) extent = (std::max)({extent, std::abs((box.min)(i)), std::abs((box.max)(i))});
    return 1e-9 + 1e-13 * extent + 4 * complex.planarity_deviation();
  }

  /// Step 1. A column that leaves the model does so through a panel that faces away from the column's own.
  Slab columns_within_model(int p) const
  {
    Exact_polygon_set set = panels[p].polygon_set();
    std::vector<Exact_loop> cuts;
    for (int q = 0; q < int(panels.size()); ++q)
      if (q != p && panels[p].frame.normal * panels[q].frame.normal < 0 && boxes_meet(panels[p], panels[q], 0))
        for (const Exact_convex& piece : panels[q].pieces)
          add_cut(slab_projection<Exact_kernel>(piece, {Exact_number(0), Exact_number(0)}, to_slab(q, p), reach()),
                  cuts);
    subtract(set, cuts);
    return Slab(panels[p].frame, cleaned_pieces(set), options.thickness);
  }

  /// Step 2 for the panel at position `i` of the order.
  void remove_overlaps(int i, const std::vector<Alternation>& teeth, const std::vector<Slab>& done,
                       Exact_polygon_set& set) const
  {
    const int p = order[i];
    std::vector<Exact_loop> cuts;
    for (int j = 0; j < int(order.size()); ++j) {
      const int q = order[j];
      if (q == p || !boxes_meet(panels[p], done[q], 0)) continue;
      const Alternation* alternation = alternation_between(p, q, teeth);
      if (!alternation) {
        if (j < i) add_overlaps(done[q], q, p, {{}}, cuts);
      } else {
        add_overlaps(done[q], q, p, cells_along(complex, *alternation, panels[q].frame, panels[p].frame, j > i), cuts);
      }
    }
    subtract(set, cuts);
  }

  /// Projections onto panel `p` of what the sheet `slab` of panel `q`, within each of `cells`, shares with its sheet.
  void add_overlaps(const Slab& slab, int q, int p, const std::vector<std::vector<Exact_half_plane>>& cells,
                    std::vector<Exact_loop>& cuts) const
  {
    for (const Exact_convex& piece : slab.pieces)
      for (const auto& cell : cells) {
        Exact_convex part = piece;
        for (const Exact_half_plane& h : cell) part = clipped(part, h);
        if (!part.empty()) add_cut(slab_projection<Exact_kernel>(part, sheet(), to_slab(q, p), reach()), cuts);
      }
  }

  /// Cuts panel `p` free of panel `q`, placed before it, over the way it comes; unless that costs more than a quarter
  /// of it.
  void clear_approach(int p, int q, const Slab& slab, Exact_polygon_set& set, Truncation& result) const
  {
    if (!boxes_meet(panels[p], slab, options.approach_length())) return;
    std::vector<Exact_loop> cuts;
    for (const Exact_convex& piece : slab.pieces)
      add_cut(slab_projection<Exact_kernel>(piece, sheet(), to_slab(q, p), approach()), cuts);
    Exact_polygon_set freed = set;
    subtract(freed, cuts);
    const double before = area_of(set), after = area_of(freed);
    if (after > before - 1e-6 * (1 + before)) return;
    if (after < 0.75 * before) {
      result.blocked.push_back({q, p});
      return;
    }
    result.overhangs.push_back({q, p});
    set = freed;
  }

  static double area_of(const Exact_polygon_set& set)
  {
    double sum = 0;
    for (const Exact_polygon& polygon : polygons_of(set)) sum += area(polygon);
    return sum;
  }

  void add_cut(const Exact_convex& polygon, std::vector<Exact_loop>& cuts) const
  {
    if (polygon.empty()) return;
    std::vector<Exact_point_2> wider;
    for (const Exact_point_2& p : polygon)
      for (int i = 0; i < 4; ++i)
        wider.push_back(p + Exact_kernel::Vector_2(i % 2 ? noise : -noise, i / 2 ? noise : -noise));
    cuts.emplace_back();
    CGAL::convex_hull_2(wider.begin(), wider.end(), std::back_inserter(cuts.back()));
  }

  static void subtract(Exact_polygon_set& set, const std::vector<Exact_loop>& cuts)
  {
    Exact_polygon_set all;
    all.join(cuts.begin(), cuts.end());
    set.difference(all);
  }

  const Alternation* alternation_between(int p, int q, const std::vector<Alternation>& teeth) const
  {
    for (const Alternation& a : teeth) {
      const auto& sides = complex.edges[a.edge].panels;
      if ((sides[0] == p && sides[1] == q) || (sides[0] == q && sides[1] == p)) return &a;
    }
    return nullptr;
  }

  const Affine_map<Exact_number>& to_slab(int from, int to) const
  {
    const auto found = maps.find({from, to});
    if (found != maps.end()) return found->second;
    auto map = slab_to_slab<Exact_number>(panels[from].frame, panels[to].frame);
    for (auto& row : map.matrix) // evaluated once, so that no expression trees grow from here
      for (auto& x : row) CGAL::exact(x);
    for (auto& x : map.shift) CGAL::exact(x);
    return maps.emplace(std::make_pair(from, to), map).first->second;
  }

  const Panel_complex& complex;
  Truncation_options options;
  std::vector<int> order;
  double noise;
  std::vector<Slab> panels; ///< the panels themselves
  std::vector<Slab> within; ///< their columns inside the model (step 1)
  mutable std::map<std::pair<int, int>, Affine_map<Exact_number>> maps;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRUNCATOR_H
