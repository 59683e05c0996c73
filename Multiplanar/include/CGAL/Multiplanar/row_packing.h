// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ROW_PACKING_H
#define CGAL_MULTIPLANAR_ROW_PACKING_H

#include <CGAL/Multiplanar/Sheet.h>
#include <CGAL/Multiplanar/internal/turned_boxes.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// Thrown when a part fits no sheet at any angle that was tried.
struct Part_too_large : std::runtime_error
{
  Part_too_large(std::string part, double w, double h, double f)
      : std::runtime_error("part " + part + " is larger than the sheet"), id(std::move(part)), width(w), height(h),
        factor(f)
  {
  }
  std::string id;       ///< the part that exceeds the sheet most
  double width, height; ///< of the smallest rectangle around it, in mm, width >= height
  double factor;        ///< every part fits once everything is scaled by this number (< 1)
};

namespace internal {

/// What a sheet offers to the boxes of parts: its borders taken off, and half a cut on every side.
struct Usable_area
{
  explicit Usable_area(const Sheet_options& o)
      : width(o.width - 2 * o.border - o.kerf), height(o.height - 2 * o.border - o.kerf)
  {
  }
  double width, height;

  bool fits(const Turned_box& b) const { return b.width <= width && b.height <= height; }
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
inline std::vector<Turned_box> choose_boxes(const std::vector<Part>& parts, const Sheet_options& options)
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

/// A row of parts: it begins at the left border of its sheet and grows to the right.
struct Row
{
  std::size_t sheet;
  double y, height, used; // used: from the left border to the right end of the last box
};

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

Lays parts on as many sheets as needed, in rows: each part turned so that the rectangle around it is smallest, the
highest first, each into the first row with room. Rectangles keep `gap` of material between their cuts and `border` from
the edge. Deterministic; O(n (rows + h log h)) for n parts with h vertices.

\pre all measures in `options` are finite and not negative, every part has an area
\throws Part_too_large if a part fits the sheet at no angle; it says how much the model would have to shrink
*/
inline std::vector<Sheet> pack_in_rows(const std::vector<Part>& parts, const Sheet_options& options)
{
  const internal::Usable_area area(options);
  const std::vector<internal::Turned_box> boxes = internal::choose_boxes(parts, options);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].height > boxes[b].height; });
  const double gap = options.gap + options.kerf, start = options.border + options.kerf / 2;
  std::vector<Sheet> sheets;
  std::vector<double> used_height; // by sheet
  std::vector<internal::Row> rows;
  for (std::size_t i : order) {
    const internal::Turned_box& box = boxes[i];
    auto row = std::find_if(rows.begin(), rows.end(), [&](const internal::Row& r) {
      return r.used + gap + box.width <= area.width && box.height <= r.height;
    });
    if (row == rows.end()) {
      std::size_t s = 0;
      while (s < sheets.size() && used_height[s] + gap + box.height > area.height) ++s;
      if (s == sheets.size()) {
        sheets.push_back({options.width, options.height, {}});
        used_height.push_back(-gap);
      }
      rows.push_back({s, used_height[s] + gap, box.height, -gap});
      used_height[s] += gap + box.height;
      row = rows.end() - 1;
    }
    Placement placement;
    placement.part = int(i);
    placement.rotation = box.rotation;
    placement.mirrored = options.mirrored;
    placement.x = start + row->used + gap - box.x;
    placement.y = start + row->y - box.y;
    sheets[row->sheet].placements.push_back(placement);
    row->used += gap + box.width;
  }
  return sheets;
}

/// The part of the sheets' area that becomes parts, in 0..1.
inline double utilisation(const std::vector<Sheet>& sheets, const std::vector<Part>& parts)
{
  double used = 0, total = 0;
  for (const Sheet& sheet : sheets) {
    total += sheet.width * sheet.height;
    for (const Placement& p : sheet.placements) used += parts[p.part].area();
  }
  return total > 0 ? used / total : 0;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ROW_PACKING_H
