// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PRESS_FIT_H
#define CGAL_MULTIPLANAR_PRESS_FIT_H

#include <CGAL/Multiplanar/exact_polygons.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline Kernel::Vector_2 scaled_to(const Kernel::Vector_2& v, double length)
{
  return v * (length / std::sqrt(v.squared_length()));
}

/// What a flank of a tab gains: a strip of width `growth` outside of the side from outline vertex `i` to the next. At a
/// reflex corner, where the tab stands on the rest of the part, it goes on into the part, so that no gap is left.
inline Exact_loop flank_strip(const Outline& outline, int i, double growth)
{
  const int n = int(outline.size());
  const auto at = [&](int k) { return outline[(k + n) % n]; };
  const auto is_reflex = [&](int k) { return CGAL::right_turn(at(k - 1), at(k), at(k + 1)); };
  const Kernel::Vector_2 along = scaled_to(at(i + 1) - at(i), growth), outward(along.y(), -along.x());
  const Point_2 a = is_reflex(i) ? at(i) - along : at(i), b = is_reflex(i + 1) ? at(i + 1) + along : at(i + 1);
  return exact_loop({a, a + outward, b + outward, b});
}

/// The flanks of a tab: its first and its last side.
inline std::array<int, 2> flanks_of_tab(const Outline& outline, const std::array<int, 2>& tab)
{
  const int n = int(outline.size());
  return {{tab[0], (tab[1] + n - 1) % n}};
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

The outline of a part whose tabs and teeth hold by friction: each flank of a tab grows by `fit` / 2, so that a tab is
wider than its slot by `fit`. Tabs become no longer: their ends stay level with the panel that they go through. Exact
union of the outline with a strip at every flank, rounded to doubles at the end; gaps narrower than the fit close.

\param part nominal; its tabs are ranges of vertices of its outline
\param fit in mm; 0: the outline as it is
\pre the outline is simple and counter-clockwise, `fit` >= 0
*/
inline Outline press_fit_outline(const Part& part, double fit)
{
  using namespace internal;
  CGAL_precondition(fit >= 0);
  std::vector<Exact_loop> strips;
  for (const auto& tab : part.tabs) {
    CGAL_precondition((std::min)(tab[0], tab[1]) >= 0 && (std::max)(tab[0], tab[1]) < int(part.outline.size()));
    for (int i : flanks_of_tab(part.outline, tab)) strips.push_back(flank_strip(part.outline, i, fit / 2));
  }
  if (fit == 0 || strips.empty()) return part.outline;
  Exact_polygon_set set(exact_loop(part.outline));
  for (const Exact_loop& strip : strips)
    if (strip.is_simple() && strip.orientation() == CGAL::COUNTERCLOCKWISE) set.join(strip);
  const auto polygons = polygons_of(set);
  CGAL_postcondition(polygons.size() == 1);
  return rounded(polygons[0].outer_boundary());
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PRESS_FIT_H
