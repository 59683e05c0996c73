// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

std::string name_of(const Written_step& step)
{
  std::string ids = step.parts.empty() ? "nothing" : step.parts[0];
  if (step.parts.size() > 1) ids += " and " + std::to_string(step.parts.size() - 1) + " more";
  return "step " + std::to_string(step.number) + " (" + ids + ")";
}

/// Are the steps numbered from 1, and is every part placed once?
void check_list(const Written_model& model, Report& report)
{
  std::map<std::string, int> placed;
  for (std::size_t i = 0; i < model.assembly.size(); ++i) {
    const Written_step& step = model.assembly[i];
    if (step.number != int(i) + 1)
      report.violation("assembly: step " + std::to_string(i + 1) + " is numbered " + std::to_string(step.number));
    if (step.parts.empty()) report.violation(name_of(step) + " places no part");
    for (const std::string& id : step.parts) {
      if (model.part_index(id) < 0) report.violation(name_of(step) + " places " + id + ", which is no part");
      if (++placed[id] == 2) report.violation("assembly places part " + id + " more than once");
    }
  }
  for (const Written_part& part : model.parts)
    if (!placed.count(part.id)) report.violation("assembly never places part " + part.id);
}

/// A panel moves against its outward normal.
void check_direction(const Written_model& model, const Written_step& step, Report& report)
{
  if (!(std::abs(step.direction.squared_length() - 1) < 1e-6)) {
    report.violation(name_of(step) + ": its direction is not of length 1");
    return;
  }
  for (const std::string& id : step.parts) {
    const int index = model.part_index(id);
    if (index < 0 || !model.parts[index].is_panel) continue;
    const Vector_3 off = step.direction + model.parts[index].frame.normal;
    if (off.squared_length() > 1e-6 * 1e-6)
      report.violation(name_of(step) + ": panel " + id + " does not move against its outward normal, but " +
                       shown(std::sqrt(off.squared_length())) + " off it");
  }
}

/// Looks for what is in the way of the last `way` mm of a step. \return whether something is
bool check_way(const Written_step& step, double way, const std::vector<const Solid*>& moving,
               const std::vector<const Solid*>& placed, const std::string& promise, Report& report)
{
  bool blocked = false;
  for (const Solid* m : moving) {
    const std::vector<Body> swept = m->swept(-way * step.direction);
    const CGAL::Bbox_3 box = box_of(swept);
    for (const Solid* p : placed) {
      if (!CGAL::do_overlap(box, p->box)) continue;
      const auto contact = find_contact(swept, p->bodies);
      if (!contact) continue;
      blocked = true;
      report.violation(name_of(step) + ": over " + promise + ", " + m->part->id + " runs into " + p->part->id +
                       " near " + shown(contact->middle));
    }
  }
  return blocked;
}

} // namespace

void check_assembly(const Written_model& model, const std::vector<Solid>& solids, Report& report)
{
  report.begin("assembly");
  if (model.assembly.empty()) return report.not_claimed("model.json lists no steps");
  check_list(model, report);
  std::map<std::string, const Solid*> solid_of;
  for (const Solid& solid : solids) solid_of[solid.part->id] = &solid;

  const double last = model.thickness + 1;
  std::vector<const Solid*> placed;
  double least = 1e300;
  for (const Written_step& step : model.assembly) {
    check_direction(model, step, report);
    std::vector<const Solid*> moving;
    for (const std::string& id : step.parts)
      if (solid_of.count(id)) moving.push_back(solid_of[id]);
    least = (std::min)(least, step.travel);
    if (step.travel < last - erosion_depth)
      report.violation(name_of(step) + ": only " + shown(step.travel) + " mm of its way are claimed to be free, not " +
                       shown(last));
    const bool blocked = check_way(step, last, moving, placed, "the last " + shown(last) + " mm of its way", report);
    if (!blocked && step.travel > last)
      check_way(step, step.travel, moving, placed, "the " + shown(step.travel) + " mm claimed to be free", report);
    placed.insert(placed.end(), moving.begin(), moving.end());
  }
  report.checked(counted(model.assembly.size(), "step") + ", each free over its last " + shown(last) +
                 " mm at least (least travel " + shown(least) + " mm)");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
