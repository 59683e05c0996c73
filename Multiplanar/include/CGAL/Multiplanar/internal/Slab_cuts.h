// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLAB_CUTS_H
#define CGAL_MULTIPLANAR_INTERNAL_SLAB_CUTS_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/internal/Slab.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Cuts = std::vector<Exact_loop>;

/// What sheets of one panel take off the sheet of another: projections of overlaps, exact, each made wider by `noise`.
///
/// In doubles a corner lies on all of its planes only about, so that cuts which should meet an outline or each other
/// may miss by a little and leave a web of slivers behind; widening closes it.
class Slab_cuts
{
public:
  Slab_cuts(const Panel_complex& complex, const std::vector<Slab>& panels, double thickness, double approach)
      : panels(panels), thickness(thickness), approach(approach)
  {
    double extent = 0;
    for (const auto& corner : complex.corners)
      for (int i = 0; i < 3; ++i) extent = (std::max)(extent, std::abs(corner.point[i]));
    noise = 1e-9 + 1e-13 * extent + 4 * complex.planarity_deviation();
  }

  /// Where the columns of panel `p` cross the surface piece `piece` of panel `q`.
  void add_crossings(const Exact_convex& piece, int q, int p, Cuts& cuts) const
  {
    add(piece, {Exact_number(0), Exact_number(0)}, q, p, {Exact_number(-noise), Exact_number(thickness)}, cuts);
  }

  /// What the sheets of panels `q` and `p` share over a piece of the former.
  void add_overlap(const Exact_convex& piece, int q, int p, Cuts& cuts) const
  {
    add(piece, sheet(), q, p, {Exact_number(-noise), Exact_number(thickness)}, cuts);
  }

  /// Where a piece of the sheet of panel `q` lies above panel `p`, in the last part of the way that `p` comes.
  void add_overhang(const Exact_convex& piece, int q, int p, Cuts& cuts) const
  {
    add(piece, sheet(), q, p, {Exact_number(-approach), Exact_number(-noise)}, cuts);
  }

  static void subtract(const Cuts& cuts, Exact_polygon_set& set)
  {
    Exact_polygon_set all;
    all.join(cuts.begin(), cuts.end());
    set.difference(all);
  }

private:
  Depths<Exact_number> sheet() const { return {Exact_number(0), Exact_number(thickness)}; }

  void add(const Exact_convex& piece, const Depths<Exact_number>& depths, int q, int p,
           const Depths<Exact_number>& range, Cuts& cuts) const
  {
    const Exact_convex shadow = slab_projection<Exact_kernel>(piece, depths, map(q, p), range);
    if (shadow.empty()) return;
    std::vector<Exact_point_2> wider;
    for (const Exact_point_2& x : shadow)
      for (int i = 0; i < 4; ++i)
        wider.push_back(x + Exact_kernel::Vector_2(i % 2 ? noise : -noise, i / 2 ? noise : -noise));
    cuts.emplace_back();
    CGAL::convex_hull_2(wider.begin(), wider.end(), std::back_inserter(cuts.back()));
  }

  const Affine_map<Exact_number>& map(int from, int to) const
  {
    const auto found = maps.find({from, to});
    if (found != maps.end()) return found->second;
    auto result = slab_to_slab<Exact_number>(panels[from].frame, panels[to].frame);
    for (auto& row : result.matrix) // evaluated once, so that no expression trees grow from here
      for (auto& x : row) CGAL::exact(x);
    for (auto& x : result.shift) CGAL::exact(x);
    return maps.emplace(std::make_pair(from, to), std::move(result)).first->second;
  }

  const std::vector<Slab>& panels;
  double thickness, approach, noise;
  mutable std::map<std::pair<int, int>, Affine_map<Exact_number>> maps;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLAB_CUTS_H
