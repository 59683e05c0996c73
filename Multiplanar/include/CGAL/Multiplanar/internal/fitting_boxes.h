// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FITTING_BOXES_H
#define CGAL_MULTIPLANAR_INTERNAL_FITTING_BOXES_H

#include <CGAL/Multiplanar/Part_too_large.h>
#include <CGAL/Multiplanar/internal/turned_boxes.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What a sheet offers to the boxes of parts: its borders taken off, and half a cut on every side.
struct Usable_area
{
  explicit Usable_area(const Sheet_options& o)
      : width(o.width - 2 * o.border - o.kerf), height(o.height - 2 * o.border - o.kerf)
  {
  }
  double width, height;

  /// Up to rounding, a millionth of a micrometre.
  bool fits(const Turned_box& b) const { return b.width <= width + 1e-9 && b.height <= height + 1e-9; }
  double factor(const Turned_box& b) const { return (std::min)(width / b.width, height / b.height); }
};

inline Part_too_large too_large(const Part& part, const Turned_boxes& boxes, double factor)
{
  const auto smallest = *std::min_element(boxes.along_sides.begin(), boxes.along_sides.end(), smaller_box);
  return Part_too_large(part.id, (std::max)(smallest.width, smallest.height),
                        (std::min)(smallest.width, smallest.height), factor);
}

/// The smallest box of every part that fits the sheet, preferring those along a side of the part.
/// \throws Part_too_large, for the part that would have to shrink most
inline std::vector<Turned_box> fitting_boxes(const std::vector<Part>& parts, const Sheet_options& options)
{
  const Usable_area area(options);
  std::vector<Turned_box> chosen;
  double smallest_factor = 1;
  std::size_t worst = parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Turned_boxes boxes = turned_boxes(parts[i], options.mirrored);
    const Turned_box* best = nullptr;
    double factor = 0;
    for (const auto* list : {&boxes.along_sides, &boxes.at_degrees}) {
      for (const Turned_box& b : *list) {
        factor = (std::max)(factor, area.factor(b));
        if (area.fits(b) && (!best || smaller_box(b, *best))) best = &b;
      }
      if (best) break;
    }
    chosen.push_back(best ? *best : Turned_box());
    if (!best && factor < smallest_factor) smallest_factor = factor, worst = i;
  }
  if (worst < parts.size())
    throw too_large(parts[worst], turned_boxes(parts[worst], options.mirrored), smallest_factor);
  return chosen;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FITTING_BOXES_H
