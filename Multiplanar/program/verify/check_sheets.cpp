// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "loops.h"
#include "placing.h"

#include <cmath>
#include <map>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// A part as it lies on its sheet: flat bodies of thickness 1 over its eroded region.
struct Laid
{
  std::string id;
  std::vector<Body> bodies;
};

Laid lay(const Solid& solid, const Written_placement& placement)
{
  // Mirrored triangles run clockwise: prisms take any orientation.
  const Written_frame sheet = {Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)};
  Laid laid{placement.part, {}};
  for (const Eroded_triangle& t : solid.triangles)
    laid.bodies.push_back(prism(
        sheet, {placed(placement, t.vertices[0]), placed(placement, t.vertices[1]), placed(placement, t.vertices[2])},
        0, 1));
  return laid;
}

void check_on_sheet(const Written_sheet& sheet, const Written_placement& placement, const Written_part& part,
                    Report& report)
{
  double out = 0;
  for (const Point_2& p : placed(placement, part.outline))
    out = (std::max)({out, -p.x(), -p.y(), p.x() - sheet.width, p.y() - sheet.height});
  if (out > erosion_depth)
    report.violation(sheet.file + ": part " + part.id + " lies " + shown(out) + " mm beyond the edge of the sheet");
}

void check_sheet(const Written_model& model, const Written_sheet& sheet,
                 const std::map<std::string, const Solid*>& solid_of, std::map<std::string, int>& times, Report& report)
{
  if (sheet.width <= 0 || sheet.height <= 0) report.violation(sheet.file + ": the sheet has no area");
  std::vector<Laid> laid;
  for (const Written_placement& placement : sheet.placements) {
    const int index = model.part_index(placement.part);
    if (index < 0) {
      report.violation(sheet.file + " places " + placement.part + ", which is no part");
      continue;
    }
    ++times[placement.part];
    check_on_sheet(sheet, placement, model.parts[index], report);
    if (const auto found = solid_of.find(placement.part); found != solid_of.end())
      laid.push_back(lay(*found->second, placement));
  }
  for (std::size_t i = 0; i < laid.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (CGAL::do_overlap(box_of(laid[i].bodies), box_of(laid[j].bodies)))
        if (const auto contact = find_contact(laid[i].bodies, laid[j].bodies))
          report.violation(sheet.file + ": parts " + laid[j].id + " and " + laid[i].id + " overlap near " +
                           shown(Point_2(contact->middle.x(), contact->middle.y())));
}

} // namespace

void check_sheets(const Written_model& model, const std::vector<Solid>& solids, Report& report)
{
  report.begin("sheets");
  if (model.sheets.empty()) return report.not_claimed("model.json lists no sheets");
  std::map<std::string, const Solid*> solid_of;
  for (const Solid& solid : solids) solid_of[solid.part->id] = &solid;
  std::map<std::string, int> times;
  for (const Written_sheet& sheet : model.sheets) check_sheet(model, sheet, solid_of, times, report);
  for (const Written_part& part : model.parts)
    if (times[part.id] != 1)
      report.violation("part " + part.id + " lies on " + (times[part.id] == 0 ? "no sheet" : "sheets more than once"));
  report.checked(counted(model.parts.size(), "part") + " on " + counted(model.sheets.size(), "sheet") +
                 ", disjoint and inside");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
