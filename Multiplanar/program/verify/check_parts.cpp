// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "loops.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// Are the axes orthonormal and right-handed, as far as doubles go?
bool is_orthonormal(const Written_frame& f)
{
  const auto near = [](double x, double y) { return std::abs(x - y) < 1e-9; };
  const Vector_3 x = CGAL::cross_product(f.u, f.v) - f.normal;
  return near(f.u * f.u, 1) && near(f.v * f.v, 1) && near(f.u * f.v, 0) && near(x.squared_length(), 0) &&
         near(f.normal * f.normal, 1);
}

/// The farthest that the outer face of a panel part lies from the plane of its panel, in mm.
double distance_from_plane(const Written_part& part, const Written_panel& panel)
{
  double worst = 0;
  const Written_frame& f = part.frame;
  for (const Point_2& p : part.outline) {
    const Vector_3 x = (f.origin - CGAL::ORIGIN) + p.x() * f.u + p.y() * f.v;
    worst = (std::max)(worst, std::abs(x * panel.normal - panel.offset));
  }
  return worst;
}

bool check_frame(const Written_model& model, const Written_part& part, Report& report)
{
  if (!is_orthonormal(part.frame)) {
    report.violation("part " + part.id + ": its frame is not orthonormal and right-handed");
    return false;
  }
  if (!part.is_panel) return true;
  const int p = model.panel_of_part(part);
  if (p < 0) {
    report.violation("part " + part.id + " is a panel, but the model has no panel of that id");
    return true;
  }
  const double off = distance_from_plane(part, model.panels[p]);
  if (!(part.frame.normal * model.panels[p].normal > 0)) report.violation("part " + part.id + " faces inward");
  else if (!(off <= erosion_depth))
    report.violation("part " + part.id + ": its outer face lies " + shown(off) + " mm off the plane of panel " +
                     model.panels[p].id);
  return true;
}

void check_area(const Written_part& part, Report& report)
{
  double area = std::abs(signed_area(part.outline));
  for (const Loop& hole : part.holes) area -= std::abs(signed_area(hole));
  if (!(std::abs(area - part.area) <= 1e-6 * (1 + std::abs(area))))
    report.violation("part " + part.id + " says that its area is " + shown(part.area) + " mm2; it is " + shown(area));
}

void check_all_panels_have_parts(const Written_model& model, const std::set<std::string>& explained, Report& report)
{
  std::set<int> with_part;
  for (const Written_part& part : model.parts) with_part.insert(model.panel_of_part(part));
  for (std::size_t p = 0; p < model.panels.size(); ++p) {
    if (with_part.count(int(p))) continue;
    const std::string& id = model.panels[p].id;
    if (explained.count(id)) report.note("panel " + id + " has no part; report.json has a warning about it");
    else report.violation("panel " + id + " has no part, and report.json has no warning about it");
  }
}

} // namespace

std::vector<Solid> check_parts(const Written_model& model, const std::set<std::string>& explained, Report& report)
{
  report.begin("parts");
  std::vector<Solid> solids;
  if (model.parts.empty()) {
    report.not_claimed("model.json lists no parts");
    return solids;
  }
  check_all_panels_have_parts(model, explained, report);
  for (const Written_part& part : model.parts) {
    const std::string problem = problem_of_region(part.outline, part.holes);
    if (!problem.empty()) report.violation("part " + part.id + ": " + problem);
    const bool framed = check_frame(model, part, report);
    check_area(part, report);
    if (framed && problem.empty()) solids.push_back(make_solid(part, model.thickness));
  }
  std::size_t panels = 0;
  for (const Written_part& part : model.parts) panels += part.is_panel;
  report.checked(counted(panels, "panel") + " and " + counted(model.parts.size() - panels, "connector") +
                 ", each a simple outline with its holes, panels in their planes");
  return solids;
}

void check_disjoint(const std::vector<Solid>& solids, Report& report)
{
  report.begin("overlaps");
  if (solids.empty()) return report.not_claimed("no parts");
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      if (!CGAL::do_overlap(solids[i].box, solids[j].box)) continue;
      ++pairs;
      if (const auto contact = find_contact(solids[i].bodies, solids[j].bodies))
        report.violation("parts " + solids[i].part->id + " and " + solids[j].part->id + " overlap near " +
                         shown(contact->middle) + ", " + shown(contact->depth + 2 * erosion_depth) + " mm deep");
    }
  report.checked("part interiors pairwise disjoint (" + counted(pairs, "pair") + " close to each other)");
}

namespace {

/// A point of every connected piece of the solid: the centroid of its largest triangle, at half its thickness.
std::vector<Point_3> point_of_each_piece(const Solid& solid)
{
  std::map<int, std::pair<double, Point_3>> best;
  for (const Eroded_triangle& t : solid.triangles) {
    const double area = CGAL::area(t.vertices[0], t.vertices[1], t.vertices[2]);
    const auto found = best.find(t.piece);
    if (found != best.end() && found->second.first >= area) continue;
    const Point_2 c = CGAL::centroid(t.vertices[0], t.vertices[1], t.vertices[2]);
    const Written_frame& f = solid.part->frame;
    best[t.piece] = {area, f.origin + c.x() * f.u + c.y() * f.v - (solid.low + solid.high) / 2 * f.normal};
  }
  std::vector<Point_3> points;
  for (const auto& entry : best) points.push_back(entry.second.second);
  return points;
}

} // namespace

void check_inside(const std::vector<Solid>& solids, const Boundary* boundary, Report& report)
{
  report.begin("outline");
  if (solids.empty()) return report.not_claimed("no parts");
  if (!boundary) return report.not_checked("the surface bounds no solid");
  std::vector<std::vector<Body>> faces(boundary->model->panels.size());
  for (const auto& t : boundary->triangles)
    faces[t.panel].push_back(triangle(boundary->point(t, 0), boundary->point(t, 1), boundary->point(t, 2)));
  std::vector<CGAL::Bbox_3> boxes;
  for (const auto& face : faces) boxes.push_back(box_of(face));
  // A part that no face of the model crosses is inside or outside as a whole, piece by piece.
  for (const Solid& solid : solids) {
    bool crossed = false;
    for (std::size_t p = 0; p < faces.size(); ++p) {
      if (!CGAL::do_overlap(solid.box, boxes[p])) continue;
      const auto contact = find_contact(solid.bodies, faces[p]);
      if (!contact) continue;
      crossed = true;
      report.violation("part " + solid.part->id + " leaves the model through panel " + boundary->model->panels[p].id +
                       " near " + shown(contact->middle) + ", " + shown(contact->depth + erosion_depth) + " mm deep");
    }
    if (crossed) continue;
    for (const Point_3& p : point_of_each_piece(solid))
      if (!boundary->contains(p)) report.violation("part " + solid.part->id + " lies outside the model at " + shown(p));
  }
  report.checked("no part leaves the model");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
