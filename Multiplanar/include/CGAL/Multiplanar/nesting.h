// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_NESTING_H
#define CGAL_MULTIPLANAR_NESTING_H

#include <CGAL/Multiplanar/Sheet.h>
#include <CGAL/Multiplanar/internal/Nest_search.h>
#include <CGAL/Multiplanar/internal/make_nesting_problem.h>
#include <CGAL/Multiplanar/internal/parallel_ranges.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A short way from part to part, beginning at the origin: always the nearest one next.
inline Nested_sheet in_cutting_order(const Nesting_problem& problem, Nested_sheet sheet)
{
  double x = 0, y = 0;
  const auto centre = [&](const Nested_item& item) {
    const Turned_box& box = turned(problem, item).box;
    return Point_2(item.at.x / units_per_mm + box.width / 2, item.at.y / units_per_mm + box.height / 2);
  };
  for (auto next = sheet.begin(); next != sheet.end(); ++next) {
    const auto off = [&](const Nested_item& item) { return CGAL::squared_distance(Point_2(x, y), centre(item)); };
    std::iter_swap(next, std::min_element(next, sheet.end(), [&](const Nested_item& a, const Nested_item& b) {
                     return std::make_pair(off(a), a.item) < std::make_pair(off(b), b.item);
                   }));
    x = centre(*next).x(), y = centre(*next).y();
  }
  return sheet;
}

/// The sheets of a nest, placements in the order in which parts should be cut. A sheet higher than wide is filled up
/// along its height: the nest is turned by 90 degrees then.
inline std::vector<Sheet> sheets_of_nest(const Nesting_problem& problem, const Nest& nest, const Sheet_options& o)
{
  const double start = o.border + o.kerf / 2;
  std::vector<Sheet> sheets;
  for (const Nested_sheet& nested : nest) {
    sheets.push_back({o.width, o.height, {}});
    for (const Nested_item& item : in_cutting_order(problem, nested)) {
      const Turned_box& box = turned(problem, item).box;
      Placement placement;
      placement.part = item.item;
      placement.mirrored = o.mirrored;
      placement.rotation = box.rotation;
      placement.x = start + item.at.x / units_per_mm - box.x;
      placement.y = start + item.at.y / units_per_mm - box.y;
      if (is_filled_upward(o)) {
        placement.rotation += 90;
        const double x = placement.x;
        placement.x = o.width - placement.y;
        placement.y = x;
      }
      sheets.back().placements.push_back(placement);
    }
  }
  return sheets;
}

/// The best of three searches, which begin with parts lying flat, half upright, and upright.
inline Nest best_nest(const Nesting_problem& problem, const Sheet_options& options)
{
  constexpr std::array<double, 3> uprights = {0.5, 0.8, 1.0};
  const int n = int(uprights.size());
  std::array<Nest, 3> nests;
  std::array<double, 3> values;
  const int threads = (std::min)(n, resolved_threads(options.threads));
  Nest_budget budget{options.insertions / n, options.seconds};
  if (budget.seconds > 0) budget.seconds /= (n + threads - 1) / threads; // searches of one thread follow each other
  parallel_ranges(n, threads, [&](int, int first, int last) {
    for (int i = first; i < last; ++i) {
      Nest_search search(problem, uprights[i], std::uint64_t(i));
      nests[i] = search.run(budget);
      values[i] = search.value(nests[i]);
    }
  });
  return nests[std::min_element(values.begin(), values.end()) - values.begin()];
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

Lays parts densely on as many sheets as needed.

Every outline, its tabs grown by `fit`, grows by half the gap and half the kerf and is simplified outward; what is so
obtained must not overlap. That is decided exactly, by no-fit polygons on a grid of 1/1024 mm: sums of convex pieces,
the members of what `CGAL::minkowski_sum_2()` would join. Parts keep at least `gap` + `kerf` from each other, and their
cuts keep `border` from the edge of the sheet. Small parts go into gaps between large ones and into their holes.

Parts are laid by falling area as near to the origin as they go, at each of `rotations` angles; then a search lays some
anew and keeps what is shorter (see `internal::Nest_search`). It ends after `insertions`, which gives the same
sheets on every machine and with any number of threads, or after `seconds`, which does not; with `seconds` = 0 it
does not begin. A part that fits a sheet at none of the angles is tried at every whole degree and along its sides.

Sheets fill up along their longer side, one after the other; the last one is kept short.

\return sheets with placements in an order that makes the ways between cuts short
\pre all measures in `options` are finite and not negative, `rotations` >= 1; every part has an area and simple loops
\throws Part_too_large if a part fits the sheet at no angle; it says how much the model would have to shrink
*/
inline std::vector<Sheet> nest_parts(const std::vector<Part>& parts, const Sheet_options& options)
{
  CGAL_precondition(options.rotations >= 1 && options.insertions >= 0);
  if (parts.empty()) return {};
  const internal::Nesting_problem problem = internal::make_nesting_problem(parts, options);
  const internal::Nest nest = internal::best_nest(problem, options);
  CGAL_postcondition(internal::is_nest_valid(problem, nest));
  return internal::sheets_of_nest(problem, nest, options);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_NESTING_H
