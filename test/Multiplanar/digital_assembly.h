// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_DIGITAL_ASSEMBLY_H
#define MULTIPLANAR_TEST_DIGITAL_ASSEMBLY_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/Part.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Puts parts together as solids and looks for overlaps. Shares nothing with the construction of the parts: every part
/// is eroded by a micrometre, cut into triangular prisms, and pairs of prisms are separated by exact search for a
/// separating plane.
namespace Multiplanar_test {

using CGAL::Multiplanar::Frame;
using CGAL::Multiplanar::Outline;
using CGAL::Multiplanar::Panel_complex;
using CGAL::Multiplanar::Part;
using CGAL::Multiplanar::Point_2;
using CGAL::Multiplanar::Point_3;
using CGAL::Multiplanar::Points;
using CGAL::Multiplanar::Vector_3;

constexpr double micrometre = 1e-3; // in mm

/// Every side moved inward (to its left) by `distance`; corners move to where their sides meet, at most 4 `distance`.
inline Outline eroded(const Outline& loop, double distance)
{
  Outline result;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point_2 &a = loop[(i + n - 1) % n], &b = loop[i], &c = loop[(i + 1) % n];
    const auto unit = [](const CGAL::Multiplanar::Kernel::Vector_2& v) { return v / std::sqrt(v.squared_length()); };
    const auto d = unit(b - a), e = unit(c - b);
    const CGAL::Multiplanar::Kernel::Vector_2 m(-d.y() - e.y(), d.x() + e.x()); // sum of the inner normals
    const double scale = (std::min)(2 / m.squared_length(), 4 / std::sqrt(m.squared_length()));
    result.push_back(b + distance * scale * m);
  }
  return result;
}

/// A convex solid, or a flat triangle.
struct Convex_solid
{
  Points points;
  std::vector<Vector_3> edge_directions; // up to sign and length; the last one is the depth, if there is any
  CGAL::Bbox_3 box;

  Convex_solid(const Points& base, const Vector_3& depth)
  {
    for (const Point_3& p : base) points.push_back(p);
    const bool flat = depth == CGAL::NULL_VECTOR;
    if (!flat)
      for (const Point_3& p : base) points.push_back(p + depth);
    for (std::size_t i = 0; i < base.size(); ++i) {
      edge_directions.push_back(base[(i + 1) % base.size()] - base[i]);
    }
    if (!flat) edge_directions.push_back(depth);
    for (const Point_3& p : points) box += p.bbox();
  }
};

/// Does the plane with this normal leave the two solids on different sides (touching allowed)? Exact.
inline bool separates_exactly(const std::array<CGAL::Exact_rational, 3>& axis, const Convex_solid& a,
                              const Convex_solid& b)
{
  using Number = CGAL::Exact_rational;
  const auto range = [&](const Convex_solid& s) {
    std::pair<Number, Number> r;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const Number x =
          axis[0] * Number(s.points[i].x()) + axis[1] * Number(s.points[i].y()) + axis[2] * Number(s.points[i].z());
      if (i == 0 || x < r.first) r.first = x;
      if (i == 0 || x > r.second) r.second = x;
    }
    return r;
  };
  const auto ra = range(a), rb = range(b);
  return ra.second <= rb.first || rb.second <= ra.first;
}

/// By how much the solids overlap along a unit vector: negative if there is a gap.
inline double overlap_along(const Vector_3& axis, const Convex_solid& a, const Convex_solid& b)
{
  double a0 = 1e300, a1 = -1e300, b0 = 1e300, b1 = -1e300;
  for (const Point_3& p : a.points) {
    const double x = axis * (p - CGAL::ORIGIN);
    a0 = (std::min)(a0, x), a1 = (std::max)(a1, x);
  }
  for (const Point_3& p : b.points) {
    const double x = axis * (p - CGAL::ORIGIN);
    b0 = (std::min)(b0, x), b1 = (std::max)(b1, x);
  }
  return (std::min)(a1 - b0, b1 - a0);
}

/// Do the interiors meet? Exact on the coordinates given: two convex solids are apart iff a plane parallel to a face of
/// one of them, or to an edge of each, separates them.
inline bool interiors_meet(const Convex_solid& a, const Convex_solid& b)
{
  if (!CGAL::do_overlap(a.box, b.box)) return false;
  std::vector<std::pair<Vector_3, Vector_3>> axes; // cross products; exact in the second pass
  const auto faces = [&](const Convex_solid& s) {
    for (std::size_t i = 0; i + 1 < s.edge_directions.size(); ++i)
      axes.push_back({s.edge_directions[i], s.edge_directions.back()});
    axes.push_back({s.edge_directions[0], s.edge_directions[1]});
  };
  faces(a);
  faces(b);
  for (const Vector_3& d : a.edge_directions)
    for (const Vector_3& e : b.edge_directions) axes.push_back({d, e});
  std::vector<std::pair<Vector_3, Vector_3>> doubtful;
  for (const auto& axis : axes) {
    const Vector_3 cross = CGAL::cross_product(axis.first, axis.second);
    const double length = std::sqrt(cross.squared_length());
    if (length < 1e-9 * std::sqrt(axis.first.squared_length() * axis.second.squared_length())) continue;
    const double overlap = overlap_along(cross / length, a, b);
    if (overlap < -1e-9) return false;
    if (overlap < 1e-6) doubtful.push_back(axis);
  }
  for (const auto& axis : doubtful) {
    const auto exact = [](const Vector_3& v) {
      return std::array<CGAL::Exact_rational, 3>{CGAL::Exact_rational(v.x()), CGAL::Exact_rational(v.y()),
                                                 CGAL::Exact_rational(v.z())};
    };
    const auto d = exact(axis.first), e = exact(axis.second);
    if (separates_exactly({d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]}, a, b))
      return false;
  }
  return true;
}

/// Triangles that cover a polygon with holes.
inline std::vector<std::array<Point_2, 3>> triangulated(const Outline& outline, const std::vector<Outline>& holes)
{
  using CDT =
      CGAL::Constrained_Delaunay_triangulation_2<CGAL::Multiplanar::Kernel, CGAL::Default, CGAL::Exact_predicates_tag>;
  CDT cdt;
  const auto insert = [&cdt](const Outline& loop) { cdt.insert_constraint(loop.begin(), loop.end(), true); };
  insert(outline);
  for (const Outline& hole : holes) insert(hole);
  std::vector<std::array<Point_2, 3>> result;
  for (auto f : cdt.finite_face_handles()) {
    const std::array<Point_2, 3> t{f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()};
    const Point_2 c = CGAL::centroid(t[0], t[1], t[2]);
    bool inside = CGAL::bounded_side_2(outline.begin(), outline.end(), c) == CGAL::ON_BOUNDED_SIDE;
    for (const Outline& hole : holes)
      inside = inside && CGAL::bounded_side_2(hole.begin(), hole.end(), c) != CGAL::ON_BOUNDED_SIDE;
    if (inside) result.push_back(t);
  }
  return result;
}

/// Is a triangle thicker than a nanometre? Thinner ones, whose vertices lie on a line up to rounding, are no solids.
inline bool has_area(const std::array<Point_2, 3>& t)
{
  const double area = 2 * std::abs(CGAL::area(t[0], t[1], t[2]));
  const double longest = (std::max)({CGAL::squared_distance(t[0], t[1]), CGAL::squared_distance(t[1], t[2]),
                                     CGAL::squared_distance(t[2], t[0])});
  return area > 1e-6 * std::sqrt(longest);
}

/// A part, eroded by a micrometre, as prisms.
inline std::vector<Convex_solid> solids(const Part& part, double thickness)
{
  std::vector<Outline> holes;
  for (const Outline& hole : part.holes) holes.push_back(eroded(hole, micrometre));
  std::vector<Convex_solid> result;
  for (const auto& t : triangulated(eroded(part.outline, micrometre), holes)) {
    if (!has_area(t)) continue;
    Points base;
    for (const Point_2& p : t) base.push_back(part.frame(p) - micrometre * part.frame.normal);
    result.emplace_back(base, -(thickness - 2 * micrometre) * part.frame.normal);
  }
  return result;
}

/// The panels of a complex as flat triangles.
inline std::vector<Convex_solid> surface(const Panel_complex& complex)
{
  std::vector<Convex_solid> result;
  for (const auto& panel : complex.panels) {
    Frame frame;
    frame.normal = panel.plane.normal;
    frame.origin = complex.corners[complex.source(panel.loops[0][0])].point;
    frame.u =
        CGAL::cross_product(frame.normal, std::abs(frame.normal.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0));
    frame.u = frame.u / std::sqrt(frame.u.squared_length());
    frame.v = CGAL::cross_product(frame.normal, frame.u);
    std::vector<Outline> loops;
    for (const auto& loop : panel.loops) {
      loops.emplace_back();
      for (int c : complex.loop_corners(loop)) loops.back().push_back(frame.project(complex.corners[c].point));
    }
    for (const auto& t : triangulated(loops[0], {loops.begin() + 1, loops.end()}))
      result.emplace_back(Points{frame(t[0]), frame(t[1]), frame(t[2])}, Vector_3(0, 0, 0));
  }
  return result;
}

/// How often the surface winds around a point: 1 inside, 0 outside (sum of solid angles, van Oosterom and Strackee).
inline double winding_number(const std::vector<Convex_solid>& surface, const Point_3& o)
{
  double sum = 0;
  for (const auto& s : surface) {
    const Vector_3 a = s.points[0] - o, b = s.points[1] - o, c = s.points[2] - o;
    const double la = std::sqrt(a.squared_length()), lb = std::sqrt(b.squared_length()),
                 lc = std::sqrt(c.squared_length());
    sum += std::atan2(CGAL::determinant(a, b, c), la * lb * lc + (a * b) * lc + (b * c) * la + (c * a) * lb);
  }
  return sum / (2 * std::acos(-1.0));
}

/// A line for each promise that the parts break: pairs that overlap, parts that leave the model.
inline std::vector<std::string> violations(const Panel_complex& complex, const std::vector<Part>& parts,
                                           double thickness)
{
  std::vector<std::string> result;
  std::vector<std::vector<Convex_solid>> all;
  std::vector<CGAL::Bbox_3> boxes;
  for (const Part& part : parts) {
    all.push_back(solids(part, thickness));
    CGAL::Bbox_3 box;
    for (const auto& s : all.back()) box += s.box;
    boxes.push_back(box);
  }
  const auto meet = [](const std::vector<Convex_solid>& a, const std::vector<Convex_solid>& b) {
    for (const auto& s : a)
      for (const auto& t : b)
        if (interiors_meet(s, t)) return true;
    return false;
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j]) && meet(all[i], all[j]))
        result.push_back(parts[j].id + " and " + parts[i].id + " overlap");
  const auto skin = surface(complex);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (meet(all[i], skin)) result.push_back(parts[i].id + " crosses the outline of the model");
    const Convex_solid& first = all[i][0];
    Vector_3 sum(0, 0, 0);
    for (const Point_3& p : first.points) sum = sum + (p - CGAL::ORIGIN);
    const Point_3 inside = CGAL::ORIGIN + sum / double(first.points.size());
    if (winding_number(skin, inside) < 0.5) result.push_back(parts[i].id + " lies outside the model");
  }
  return result;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_DIGITAL_ASSEMBLY_H
