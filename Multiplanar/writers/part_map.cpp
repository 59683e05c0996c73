// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_map.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace CGAL::Multiplanar;

namespace {

Pdf_painter::Colour tinted(const Linear_colour& colour)
{
  Pdf_painter::Colour result;
  for (int c = 0; c < 3; ++c) result[c] = srgb_of_linear(colour[c] + 0.45f * (1 - colour[c]));
  return result;
}

/// From a sheet to the page.
struct Page_map
{
  double x, y, scale; ///< the sheet's lower left corner on the page
  Pdf_painter::Place operator()(const Point_2& p) const { return {x + scale * p.x(), y - scale * p.y()}; }
};

std::vector<Pdf_painter::Place> drawn(const Outline& loop, const Placement& placement, const Page_map& map)
{
  std::vector<Pdf_painter::Place> result;
  for (const Point_2& p : loop) result.push_back(map(placement(p)));
  return result;
}

/// Where the id is engraved, or the middle of the box.
Point_2 label_place(const Part& part)
{
  if (!part.engraving.empty()) return part.engraving[0].at;
  CGAL::Bbox_2 box;
  for (const Point_2& p : part.outline) box += p.bbox();
  return Point_2((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2);
}

} // namespace

void draw_part_map(const Pdf_painter& page, const Assembly_guide& guide, int number, double page_width,
                   double page_height, double margin)
{
  const Sheet& sheet = guide.model.sheets[number];
  page.text(margin, 18, "Sheet " + std::to_string(number + 1), {6, true, Pdf_painter::ink});
  page.text(page_width - margin, 18, sheet_file(number, "svg") + " · seen from the inside of the model",
            {3.2, false, Pdf_painter::soft}, 1);
  const double scale = (std::min)((page_width - 2 * margin) / sheet.width, (page_height - 24 - margin) / sheet.height);
  const Page_map map{(page_width - scale * sheet.width) / 2, 24 + scale * sheet.height, scale};
  page.polygon({{{map.x, map.y},
                 {map.x + scale * sheet.width, map.y},
                 {map.x + scale * sheet.width, map.y - scale * sheet.height},
                 {map.x, map.y - scale * sheet.height}}},
               {{0.985, 0.98, 0.97}}, Pdf_painter::line);
  for (const Placement& placement : sheet.placements) {
    const Part& part = guide.model.parts[placement.part];
    std::vector<std::vector<Pdf_painter::Place>> loops{drawn(part.outline, placement, map)};
    for (const Outline& hole : part.holes) loops.push_back(drawn(hole, placement, map));
    page.polygon(loops, tinted(guide.colour[placement.part]), Pdf_painter::soft);
  }
  for (const Placement& placement : sheet.placements) {
    const Part& part = guide.model.parts[placement.part];
    const auto at = map(placement(label_place(part)));
    const double size = guide.is_panel(placement.part) ? 3 : 1.7;
    page.caption(at[0], at[1], part.id, {size, guide.is_panel(placement.part), Pdf_painter::ink});
  }
}
