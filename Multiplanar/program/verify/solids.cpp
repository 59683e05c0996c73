// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "solids.h"

#include "loops.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace verification {

std::vector<Body> Solid::swept(const Vector_3& sweep) const
{
  std::vector<Body> result;
  for (const Eroded_triangle& t : triangles) result.push_back(prism(part->frame, t.vertices, low, high, sweep));
  return result;
}

CGAL::Bbox_3 box_of(const std::vector<Body>& bodies)
{
  CGAL::Bbox_3 box;
  for (const Body& body : bodies) box += body.box;
  return box;
}

Solid make_solid(const Written_part& part, double thickness)
{
  Solid solid{&part, erosion_depth, thickness - erosion_depth, {}, {}, {}};
  if (solid.low < solid.high) solid.triangles = erode(part.outline, part.holes, erosion_depth);
  solid.bodies = solid.swept(Vector_3(0, 0, 0));
  solid.box = box_of(solid.bodies);
  return solid;
}

std::optional<Contact> find_contact(const std::vector<Body>& a, const std::vector<Body>& b)
{
  std::optional<Contact> deepest;
  const CGAL::Bbox_3 box = box_of(b);
  for (const Body& p : a) {
    if (!CGAL::do_overlap(p.box, box)) continue;
    for (const Body& q : b) {
      if (!CGAL::do_overlap(p.box, q.box)) continue;
      if (deepest && penetration(p, q) <= deepest->depth) continue;
      if (interiors_meet(p, q)) deepest = Contact{middle_of_contact(p, q), (std::max)(0.0, penetration(p, q))};
    }
  }
  return deepest;
}

std::vector<Loop> projected_loops(const Written_model& model, const Written_panel& panel)
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(panel.normal[i]) > std::abs(panel.normal[axis])) axis = i;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (panel.normal[axis] < 0) std::swap(u, v);
  std::vector<Loop> loops;
  for (const auto& corners : panel.loops) {
    loops.emplace_back();
    for (int c : corners) loops.back().emplace_back(model.corners[c][u], model.corners[c][v]);
  }
  return loops;
}

Boundary make_boundary(const Written_model& model)
{
  Boundary boundary{&model, {}};
  for (std::size_t p = 0; p < model.panels.size(); ++p) {
    std::vector<Loop> loops = projected_loops(model, model.panels[p]);
    std::vector<int> corners;
    for (const auto& loop : model.panels[p].loops) corners.insert(corners.end(), loop.begin(), loop.end());
    const Loop outline = loops.front();
    loops.erase(loops.begin());
    for (const auto& t : triangulate_region(outline, loops))
      boundary.triangles.push_back({int(p), {corners[t[0]], corners[t[1]], corners[t[2]]}});
  }
  return boundary;
}

namespace {

/// +-1 if the segment pq crosses the interior of the triangle, 0 if it misses it, 2 if it meets its border or ends on
/// it.
int crossing(const Point_3& p, const Point_3& q, const Point_3& a, const Point_3& b, const Point_3& c)
{
  const auto side_p = CGAL::orientation(a, b, c, p), side_q = CGAL::orientation(a, b, c, q);
  if (side_p == side_q && side_p != CGAL::COPLANAR) return 0;
  const auto ab = CGAL::orientation(p, q, a, b), bc = CGAL::orientation(p, q, b, c), ca = CGAL::orientation(p, q, c, a);
  const bool some_positive = ab == CGAL::POSITIVE || bc == CGAL::POSITIVE || ca == CGAL::POSITIVE;
  const bool some_negative = ab == CGAL::NEGATIVE || bc == CGAL::NEGATIVE || ca == CGAL::NEGATIVE;
  if (some_positive && some_negative) return 0;
  if (ab == CGAL::COPLANAR || bc == CGAL::COPLANAR || ca == CGAL::COPLANAR) return 2;
  if (side_p == CGAL::COPLANAR || side_q == CGAL::COPLANAR) return 2;
  return side_p == CGAL::POSITIVE ? 1 : -1;
}

} // namespace

bool Boundary::contains(const Point_3& p) const
{
  CGAL::Bbox_3 box = p.bbox();
  for (const Point_3& c : model->corners) box += c.bbox();
  const double far = 2 * (box.xmax() - box.xmin() + box.ymax() - box.ymin() + box.zmax() - box.zmin()) + 1;
  for (int attempt = 0; attempt < 100; ++attempt) {
    // Directions that lie irregularly: one that hits an edge of the boundary is left for the next.
    const double a = 1 + 2.399963 * attempt, z = 0.377 - 0.007 * attempt;
    const Point_3 q(p.x() + far * std::cos(a), p.y() + far * std::sin(a), p.z() + far * z);
    bool inside = false, degenerate = false;
    for (const Triangle& t : triangles) {
      const int c = crossing(p, q, point(t, 0), point(t, 1), point(t, 2));
      degenerate = degenerate || c == 2;
      if (c != 0) inside = !inside;
    }
    if (!degenerate) return inside;
  }
  return false;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
