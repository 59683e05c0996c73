// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ROW_PACKING_H
#define CGAL_MULTIPLANAR_ROW_PACKING_H

#include <CGAL/Multiplanar/Sheet.h>
#include <CGAL/Multiplanar/internal/fitting_boxes.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Multiplanar {

namespace internal {

/// A row of parts: it begins at the left border of its sheet and grows to the right.
struct Row
{
  std::size_t sheet;
  double y, height, used; // used: from the left border to the right end of the last box
};

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

The simple alternative to nest_parts(), for a quick look: lays parts on as many sheets as needed, in rows: each part
turned so that the rectangle around it is smallest, the highest first, each into the first row with room. Rectangles
keep `gap` of material between their cuts and `border` from the edge. Deterministic; O(n (rows + h log h)) for n parts
with h vertices.

\pre all measures in `options` are finite and not negative, every part has an area
\throws Part_too_large if a part fits the sheet at no angle; it says how much the model would have to shrink
*/
inline std::vector<Sheet> pack_in_rows(const std::vector<Part>& parts, const Sheet_options& options)
{
  const internal::Usable_area area(options);
  const std::vector<internal::Turned_box> boxes = internal::fitting_boxes(parts, options);
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

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ROW_PACKING_H
