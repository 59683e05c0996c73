// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "loops.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

using CGAL::Exact_rational;

constexpr double flatness = 1e-9; ///< of the diagonal

Exact_rational squared_diagonal(const Written_model& model)
{
  CGAL::Bbox_3 box;
  for (const Point_3& p : model.corners) box += p.bbox();
  Exact_rational sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact_rational d = Exact_rational(box.max(i)) - Exact_rational(box.min(i));
    sum += d * d;
  }
  return sum;
}

/// The squared distance of a corner from the plane of a panel, exactly.
Exact_rational squared_deviation(const Written_panel& panel, const Point_3& p)
{
  const auto n = Vec<Exact_rational>::from(panel.normal);
  const Exact_rational d = dot(n, Vec<Exact_rational>::from(p)) - Exact_rational(panel.offset);
  return d * d / dot(n, n);
}

/// \return the largest deviation in units of the diagonal
double check_flat(const Written_model& model, Report& report)
{
  const Exact_rational diagonal2 = squared_diagonal(model);
  const Exact_rational limit = diagonal2 * Exact_rational(flatness) * Exact_rational(flatness);
  Exact_rational worst = 0;
  for (const Written_panel& panel : model.panels) {
    const double length2 = panel.normal.squared_length();
    if (!(std::abs(length2 - 1) < 1e-8)) {
      report.violation("panel " + panel.id + ": its normal is not of length 1");
      if (!(length2 > 1e-6)) continue;
    }
    std::set<int> corners;
    for (const auto& loop : panel.loops) corners.insert(loop.begin(), loop.end());
    Exact_rational most = 0;
    int where = -1;
    for (int c : corners) {
      const Exact_rational d = squared_deviation(panel, model.corners[c]);
      if (d > most) most = d, where = c;
    }
    if (most > worst) worst = most;
    if (most > limit)
      report.violation("panel " + panel.id + " is not flat: corner " + std::to_string(where) + " at " +
                       shown(model.corners[where]) + " lies " + shown(std::sqrt(CGAL::to_double(most))) +
                       " mm off its plane");
  }
  return diagonal2 > 0 ? std::sqrt(CGAL::to_double(Exact_rational(worst / diagonal2))) : 0;
}

/// \return whether all panels are polygons with holes
bool check_loops(const Written_model& model, Report& report)
{
  bool sound = true;
  for (const Written_panel& panel : model.panels) {
    std::string problem;
    std::vector<Loop> loops = projected_loops(model, panel);
    if (loops.empty()) problem = "it has no loop";
    else {
      const Loop outline = loops.front();
      const std::vector<Loop> holes(loops.begin() + 1, loops.end());
      problem = problem_of_region(outline, holes);
      if (problem.empty() && !is_counter_clockwise(outline)) problem = "its outline runs clockwise, seen from outside";
      for (std::size_t i = 0; i < holes.size() && problem.empty(); ++i)
        if (is_counter_clockwise(holes[i])) problem = "hole " + std::to_string(i + 1) + " runs counter-clockwise";
    }
    if (problem.empty()) continue;
    report.violation("panel " + panel.id + ": " + problem);
    sound = false;
  }
  return sound;
}

/// By directed side (from corner, to corner): the panels that have it.
std::map<std::pair<int, int>, std::vector<int>> directed_sides(const Written_model& model)
{
  std::map<std::pair<int, int>, std::vector<int>> sides;
  for (std::size_t p = 0; p < model.panels.size(); ++p)
    for (const auto& loop : model.panels[p].loops)
      for (std::size_t i = 0; i < loop.size(); ++i) sides[{loop[i], loop[(i + 1) % loop.size()]}].push_back(int(p));
  return sides;
}

bool check_closed(const Written_model& model, Report& report)
{
  bool closed = true;
  const auto sides = directed_sides(model);
  for (const auto& side : sides) {
    const int a = side.first.first, b = side.first.second;
    const std::string name = "between corners " + std::to_string(a) + " and " + std::to_string(b);
    const std::string& panel = model.panels[side.second[0]].id;
    if (side.second.size() > 1)
      report.violation("the surface is not a manifold: panels " + panel + " and " + model.panels[side.second[1]].id +
                       " run the same way along the side " + name);
    else if (!sides.count({b, a}))
      report.violation("the surface is open: panel " + panel + " has no neighbour at its side " + name);
    else continue;
    closed = false;
  }
  return closed;
}

/// Does the surface touch itself in corners: is the fan of panels around every corner one? \pre closed
bool check_corners(const Written_model& model, Report& report)
{
  // By corner: the corner after it in a loop -> the corner before it in that loop. Going round the corner, the side
  // that leaves one panel enters the next.
  std::vector<std::map<int, int>> before(model.corners.size());
  for (const Written_panel& panel : model.panels)
    for (const auto& loop : panel.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        before[loop[i]][loop[(i + 1) % loop.size()]] = loop[(i + loop.size() - 1) % loop.size()];
  bool sound = true;
  for (std::size_t c = 0; c < before.size(); ++c) {
    if (before[c].empty()) continue;
    const int start = before[c].begin()->first;
    std::size_t steps = 0;
    int at = start;
    do {
      at = before[c].at(at);
      ++steps;
    } while (at != start && steps <= before[c].size());
    if (steps == before[c].size()) continue;
    report.violation("the surface touches itself in corner " + std::to_string(c) + " at " + shown(model.corners[c]));
    sound = false;
  }
  return sound;
}

/// Do two triangles have more in common than the corners that they share? Exact.
bool cross(const Boundary& boundary, const Boundary::Triangle& s, const Boundary::Triangle& t)
{
  const auto& corners = boundary.model->corners;
  std::vector<int> shared, s_only, t_only;
  for (int c : s.corners)
    (std::find(t.corners.begin(), t.corners.end(), c) != t.corners.end() ? shared : s_only).push_back(c);
  for (int c : t.corners)
    if (std::find(s.corners.begin(), s.corners.end(), c) == s.corners.end()) t_only.push_back(c);
  const auto solid = [&](const Boundary::Triangle& x) {
    return Kernel::Triangle_3(corners[x.corners[0]], corners[x.corners[1]], corners[x.corners[2]]);
  };
  switch (shared.size()) {
  case 0:
    return CGAL::do_intersect(solid(s), solid(t));
  case 1: // a line through the shared corner leaves one of the triangles through the opposite side
    return CGAL::do_intersect(Kernel::Segment_3(corners[s_only[0]], corners[s_only[1]]), solid(t)) ||
           CGAL::do_intersect(Kernel::Segment_3(corners[t_only[0]], corners[t_only[1]]), solid(s));
  case 2: {
    const Point_3 &a = corners[shared[0]], &b = corners[shared[1]], &c = corners[s_only[0]], &d = corners[t_only[0]];
    return CGAL::orientation(a, b, c, d) == CGAL::COPLANAR && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }
  default:
    return true;
  }
}

bool check_intersections(const Boundary& boundary, Report& report)
{
  std::vector<CGAL::Bbox_3> boxes;
  for (const auto& t : boundary.triangles)
    boxes.push_back(boundary.point(t, 0).bbox() + boundary.point(t, 1).bbox() + boundary.point(t, 2).bbox());
  std::set<std::pair<int, int>> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &s = boundary.triangles[i], &t = boundary.triangles[j];
      if (s.panel == t.panel || !CGAL::do_overlap(boxes[i], boxes[j])) continue; // one panel: disjoint in projection
      if (!found.count({t.panel, s.panel}) && cross(boundary, s, t)) found.insert({t.panel, s.panel});
    }
  for (const auto& pair : found)
    report.violation("panels " + boundary.model->panels[pair.first].id + " and " +
                     boundary.model->panels[pair.second].id + " of the surface intersect");
  return found.empty();
}

bool check_orientation(const Boundary& boundary, Report& report)
{
  double volume = 0;
  const Point_3& o = boundary.model->corners.front();
  for (const auto& t : boundary.triangles)
    volume += CGAL::determinant(boundary.point(t, 0) - o, boundary.point(t, 1) - o, boundary.point(t, 2) - o);
  if (volume > 0) return true;
  report.violation("the surface is inside out: its panels face inward");
  return false;
}

} // namespace

std::optional<Boundary> check_surface(const Written_model& model, Report& report)
{
  report.begin("surface");
  if (model.panels.empty()) {
    report.violation("model.json has no panels");
    return std::nullopt;
  }
  if (model.most_panels > 0 && int(model.panels.size()) > model.most_panels)
    report.violation("there are " + counted(model.panels.size(), "panel") + ", more than the " +
                     std::to_string(model.most_panels) + " asked for");
  const double deviation = check_flat(model, report);
  const bool simple = check_loops(model, report), closed = check_closed(model, report);
  const bool manifold = closed && check_corners(model, report);
  std::optional<Boundary> boundary;
  if (simple) {
    boundary = make_boundary(model);
    const bool embedded = check_intersections(*boundary, report);
    if (!closed || !manifold || !embedded || !check_orientation(*boundary, report)) boundary.reset();
  }
  report.checked(counted(model.panels.size(), "panel") + " with " + counted(model.corners.size(), "corner") +
                 ": closed, simple, free of intersections, flat to " + shown(deviation) + " of the diagonal");
  return boundary;
}

namespace {

/// The angle inside the solid at an edge that panel `p` runs along from corner a to corner b, in degrees.
double inner_angle(const Written_model& model, int p, int q, int a, int b)
{
  const Vector_3 &n = model.panels[p].normal, &m = model.panels[q].normal;
  Vector_3 d = model.corners[b] - model.corners[a];
  d = d / std::sqrt(d.squared_length());
  // The sign tells convex from reflex; the size comes from the normals alone, so that short edges do no harm.
  const Vector_3 x = CGAL::cross_product(n, m);
  const double sine = std::copysign(std::sqrt(x.squared_length()), x * d), cosine = n * m;
  return 180 - std::atan2(sine, cosine) * 180 / 3.14159265358979323846;
}

void check_edge(const Written_model& model, const Written_edge& edge,
                std::map<std::pair<int, int>, std::vector<int>>& sides, Report& report)
{
  int p = model.panel_index(edge.panels[0]), q = model.panel_index(edge.panels[1]);
  if (p < 0 || q < 0) {
    report.violation("edge " + edge.id + " names panel " + edge.panels[p < 0 ? 0 : 1] + ", which does not exist");
    return;
  }
  int a = edge.corners[0], b = edge.corners[1];
  const auto runs = [&](int panel, int from, int to) {
    const auto found = sides.find({from, to});
    return found != sides.end() && found->second[0] == panel;
  };
  if (!runs(p, a, b)) std::swap(a, b);
  if (!runs(p, a, b) || !runs(q, b, a)) {
    report.violation("edge " + edge.id + ": panels " + edge.panels[0] + " and " + edge.panels[1] +
                     " have no common side between corners " + std::to_string(a) + " and " + std::to_string(b));
    return;
  }
  sides.erase({a, b});
  sides.erase({b, a});
  if (!edge.dihedral) return;
  const double angle = inner_angle(model, p, q, a, b);
  // A flat edge may be read as 0 or 360 just as well when its panels are folded onto each other.
  if (std::abs(angle - *edge.dihedral) > 0.01 && std::abs(std::abs(angle - *edge.dihedral) - 360) > 0.01)
    report.violation("edge " + edge.id + " says that its dihedral is " + shown(*edge.dihedral) + " degrees; it is " +
                     shown(angle));
}

} // namespace

void check_edges(const Written_model& model, Report& report)
{
  report.begin("edges");
  if (model.edges.empty()) return report.not_claimed("model.json lists no edges");
  auto sides = directed_sides(model);
  for (const Written_edge& edge : model.edges) check_edge(model, edge, sides, report);
  for (const auto& side : sides)
    if (side.first.first < side.first.second)
      report.violation("the side between corners " + std::to_string(side.first.first) + " and " +
                       std::to_string(side.first.second) + " is in no edge");
  report.checked(counted(model.edges.size(), "edge") + " agree with the panels in corners and angles");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
