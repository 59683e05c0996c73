// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "joint_geometry.h"

#include "loops.h"

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// A point in the frame of a part: x, y, and z as depth below the outer face.
Point_3 in_frame(const Written_frame& f, const Point_3& p)
{
  const Vector_3 d = p - f.origin;
  return Point_3(d * f.u, d * f.v, -(d * f.normal));
}

Point_3 in_model(const Written_frame& f, const Point_2& p, double z)
{
  return f.origin + p.x() * f.u + p.y() * f.v - z * f.normal;
}

Loop tab_polygon(const Written_part& connector, std::size_t tab)
{
  Loop polygon;
  for (int i : tab_vertices(connector, tab)) polygon.push_back(connector.outline[i]);
  return polygon;
}

/// What is left of a polygon at depths d(z) >= 0, d linear.
template <class Depth>
std::vector<Point_3> clipped(const std::vector<Point_3>& polygon, Depth d)
{
  std::vector<Point_3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point_3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = d(a.z()), db = d(b.z());
    if (da >= 0) result.push_back(a);
    if ((da < 0) != (db < 0)) result.push_back(a + da / (da - db) * (b - a));
  }
  return result;
}

} // namespace

std::vector<int> tab_vertices(const Written_part& part, std::size_t tab)
{
  const int n = int(part.outline.size());
  int i = part.tabs[tab][0], j = part.tabs[tab][1];
  if (j < i) j += n;
  if (j - i < 2) --i, ++j;
  std::vector<int> vertices;
  for (; i <= j; ++i) vertices.push_back((i + n) % n);
  return vertices;
}

Tab_section tab_in_part(const Written_part& connector, std::size_t tab, const Written_part& part, double thickness)
{
  Tab_section section{{}, 1e300, -1e300};
  const Loop polygon = tab_polygon(connector, tab);
  for (double face : {0.0, thickness}) {
    std::vector<Point_3> points;
    for (const Point_2& p : polygon) points.push_back(in_frame(part.frame, in_model(connector.frame, p, face)));
    points = clipped(points, [](double z) { return z + slot_tolerance; });
    points = clipped(points, [&](double z) { return thickness + slot_tolerance - z; });
    for (const Point_3& p : points) {
      section.points.emplace_back(p.x(), p.y());
      section.low = (std::min)(section.low, p.z());
      section.high = (std::max)(section.high, p.z());
    }
  }
  // A tab that only touches the faces of the slab is not in it; nor is one beside the part.
  if (section.high - section.low < 10 * slot_tolerance) section.points.clear();
  if (!section.points.empty()) {
    const CGAL::Bbox_2 box = CGAL::bbox_2(section.points.begin(), section.points.end());
    if (!CGAL::do_overlap(box, box_of(part.outline))) section.points.clear();
  }
  return section;
}

bool section_in_hole(const Tab_section& section, const Loop& hole)
{
  return std::all_of(section.points.begin(), section.points.end(), [&](const Point_2& p) {
    return side_of(hole, p) >= 0 || distance_to_boundary(p, hole) <= slot_tolerance;
  });
}

double play_in_hole(const Tab_section& section, const Loop& hole)
{
  Loop hull;
  CGAL::convex_hull_2(section.points.begin(), section.points.end(), std::back_inserter(hull));
  if (hull.size() < 3) return 1e300;
  double play = 0;
  for (const Point_2& p : hole)
    if (side_of(hull, p) < 0) play = (std::max)(play, distance_to_boundary(p, hull));
  return play;
}

bool is_slot(const Loop& hole, double thickness)
{
  if (hole.size() != 4) return false;
  double off = 1e300, skew = 0; // from the thickness, from right angles
  for (int i = 0; i < 4; ++i) {
    const Vector_2<Kernel> d = hole[(i + 1) % 4] - hole[i], e = hole[(i + 2) % 4] - hole[(i + 1) % 4];
    const double length = std::sqrt(d.squared_length());
    off = (std::min)(off, std::abs(length - thickness));
    skew = (std::max)(skew, std::abs(d * e) / length);
  }
  return skew < slot_tolerance && off < slot_tolerance;
}

Joint_line line_in_overlap(const Written_panel& p, const Written_panel& q, const Point_3& a, const Point_3& b,
                           double thickness)
{
  // Notation: n, m outward normals. The point with n.x = m.x = -t/2, seen from the edge, is -(t/2) (n + m) / (1 + n.m).
  const double cosine = p.normal * q.normal;
  const double sine = std::sqrt(CGAL::cross_product(p.normal, q.normal).squared_length());
  Joint_line line{false, a, b, 0, 0, 0};
  if (!(1 + cosine > 1e-9 && sine > 1e-6) || a == b) return line;
  const Vector_3 x = -(thickness / 2) / (1 + cosine) * (p.normal + q.normal);
  line.exists = true;
  const double length = std::sqrt((b - a).squared_length()), beyond = 20 * thickness + length;
  line.from = a + x - beyond / length * (b - a);
  line.to = b + x + beyond / length * (b - a);
  line.begin = beyond;
  line.end = beyond + length;
  // Notation: theta = 180 - angle(n, m) is the angle inside the solid, t the thickness. The panel that gives way ends
  // before the other: by t sin(theta) if theta is 90 degrees or more, else by t cot(theta/2) - t cot(theta), which is
  // t / sin(theta).
  line.tooth_depth = cosine >= 0 ? thickness * sine : thickness / sine;
  return line;
}

namespace {

/// Where the segment ab crosses the loops of a part, as fractions of its length.
void add_crossings(const Point_2& a, const Point_2& b, const Loop& loop, std::vector<double>& fractions)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  const auto side = [&](const Point_2& p) { return dx * (p.y() - a.y()) - dy * (p.x() - a.x()); };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point_2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    const double sp = side(p), sq = side(q);
    if ((sp < 0) == (sq < 0)) continue;
    const double s = sp / (sp - sq), x = p.x() + s * (q.x() - p.x()), y = p.y() + s * (q.y() - p.y());
    const double f = ((x - a.x()) * dx + (y - a.y()) * dy) / (dx * dx + dy * dy);
    if (f > 0 && f < 1) fractions.push_back(f);
  }
}

bool has_material(const Written_part& part, const Point_2& p)
{
  return side_of(part.outline, p) >= 0 &&
         std::none_of(part.holes.begin(), part.holes.end(), [&](const Loop& hole) { return side_of(hole, p) > 0; });
}

Point_2 flat(const Written_part& part, const Point_3& p)
{
  const Point_3 q = in_frame(part.frame, p);
  return Point_2(q.x(), q.y());
}

} // namespace

bool reaches(const Written_part& part, const Point_3& p, double thickness)
{
  const Point_3 q = in_frame(part.frame, p);
  return q.z() >= 0 && q.z() <= thickness && has_material(part, Point_2(q.x(), q.y()));
}

std::vector<Owned> owners_along(const Joint_line& line, const std::vector<const Written_part*>& p,
                                const std::vector<const Written_part*>& q)
{
  std::vector<double> fractions = {0, 1};
  for (const auto* parts : {&p, &q})
    for (const Written_part* part : *parts) {
      const Point_2 a = flat(*part, line.from), b = flat(*part, line.to);
      add_crossings(a, b, part->outline, fractions);
      for (const Loop& hole : part->holes) add_crossings(a, b, hole, fractions);
    }
  std::sort(fractions.begin(), fractions.end());

  const Vector_3 d = line.to - line.from;
  const double length = std::sqrt(d.squared_length());
  std::vector<Owned> owners;
  for (std::size_t i = 1; i < fractions.size(); ++i) {
    const double begin = fractions[i - 1] * length, end = fractions[i] * length;
    if (end - begin < 1e-3) continue;
    const Point_3 middle = line.from + (fractions[i] + fractions[i - 1]) / 2 * d;
    int owner = 0;
    for (const Written_part* part : p) owner |= has_material(*part, flat(*part, middle)) ? 1 : 0;
    for (const Written_part* part : q) owner |= has_material(*part, flat(*part, middle)) ? 2 : 0;
    if (owner == 0 && end - begin > largest_play) {
      if (begin >= line.end) break;
      if (end <= line.begin) owners.clear();
    }
    if (!owners.empty() && owners.back().owner == owner) owners.back().length += end - begin;
    else owners.push_back({owner, end - begin});
  }
  return owners;
}

double widest_held_tooth(const std::vector<Owned>& owners)
{
  std::vector<Owned> runs; // without small gaps
  for (const Owned& o : owners)
    if (o.owner != 0 || o.length > largest_play) runs.push_back(o);
  double widest = 0;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const int tooth = runs[i].owner, other = 3 - tooth;
    if ((tooth == 1 || tooth == 2) && runs[i - 1].owner == other && runs[i + 1].owner == other)
      widest = (std::max)(widest, runs[i].length);
  }
  return widest;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
