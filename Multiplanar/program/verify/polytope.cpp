// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "polytope.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

using CGAL::Exact_rational;

template <class NT>
Polytope<NT> make_prism(const Written_frame& frame, const std::array<Point_2, 3>& triangle, double low, double high,
                        const Vector_3& sweep)
{
  const Vec<NT> o = Vec<NT>::from(frame.origin), u = Vec<NT>::from(frame.u), v = Vec<NT>::from(frame.v),
                n = Vec<NT>::from(frame.normal), w = Vec<NT>::from(sweep);
  Polytope<NT> p;
  std::array<Vec<NT>, 3> base;
  for (int i = 0; i < 3; ++i) base[i] = o + NT(triangle[i].x()) * u + NT(triangle[i].y()) * v;
  for (double z : {low, high})
    for (const Vec<NT>& b : base) p.vertices.push_back(b - NT(z) * n);
  for (int i = 0; i < 3; ++i) p.edges.push_back(base[(i + 1) % 3] - base[i]);
  p.edges.push_back(n);
  p.normals.push_back(cross(p.edges[0], p.edges[1]));
  for (int i = 0; i < 3; ++i) p.normals.push_back(cross(p.edges[i], n));
  if (sweep == Vector_3(0, 0, 0)) return p;

  // The Minkowski sum with a segment: new facets are spanned by an edge and the sweep.
  for (int i = 0; i < 4; ++i) p.normals.push_back(cross(p.edges[i], w));
  p.edges.push_back(w);
  for (int i = 0; i < 6; ++i) p.vertices.push_back(p.vertices[i] + w);
  return p;
}

template <class NT>
Polytope<NT> make_triangle(const Point_3& a, const Point_3& b, const Point_3& c)
{
  Polytope<NT> p;
  p.vertices = {Vec<NT>::from(a), Vec<NT>::from(b), Vec<NT>::from(c)};
  for (int i = 0; i < 3; ++i) p.edges.push_back(p.vertices[(i + 1) % 3] - p.vertices[i]);
  p.normals.push_back(cross(p.edges[0], p.edges[1]));
  return p;
}

/// The box of the rounded vertices, grown by more than their rounding errors.
CGAL::Bbox_3 safe_box(const Polytope<double>& p, double magnitude)
{
  CGAL::Bbox_3 box;
  for (const Vec<double>& v : p.vertices) box += CGAL::Bbox_3(v.x, v.y, v.z, v.x, v.y, v.z);
  const double e = magnitude * 1e-14;
  return CGAL::Bbox_3(box.xmin() - e, box.ymin() - e, box.zmin() - e, box.xmax() + e, box.ymax() + e, box.zmax() + e);
}

template <class NT>
struct Range
{
  NT low, high;
};

template <class NT>
Range<NT> extent(const Polytope<NT>& p, const Vec<NT>& axis)
{
  Range<NT> r{dot(axis, p.vertices[0]), NT()};
  r.high = r.low;
  for (std::size_t i = 1; i < p.vertices.size(); ++i) {
    NT d = dot(axis, p.vertices[i]);
    if (d < r.low) r.low = d;
    if (r.high < d) r.high = d;
  }
  return r;
}

/// Calls f(axis) for every candidate of a separating direction until it returns true; says whether it did.
template <class NT, class F>
bool any_axis(const Polytope<NT>& a, const Polytope<NT>& b, F f)
{
  for (const Vec<NT>& n : a.normals)
    if (f(n)) return true;
  for (const Vec<NT>& n : b.normals)
    if (f(n)) return true;
  for (const Vec<NT>& d : a.edges)
    for (const Vec<NT>& e : b.edges)
      if (f(cross(d, e))) return true;
  return false;
}

/// How far apart the rounded bodies are along `axis`; negative if they overlap there. In units of the axis' length.
double gap(const Polytope<double>& a, const Polytope<double>& b, const Vec<double>& axis)
{
  const Range<double> r = extent(a, axis), s = extent(b, axis);
  return (std::max)(s.low - r.high, r.low - s.high);
}

bool certainly_apart(const Body& a, const Body& b)
{
  // Sums of up to 4 products of magnitude M have errors below 4e-15 M, dot products with them 1e-15 M |axis| more.
  const double error = (std::max)(a.magnitude, b.magnitude) * 1e-14;
  return any_axis(a.rounded, b.rounded, [&](const Vec<double>& axis) {
    return gap(a.rounded, b.rounded, axis) > error * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
  });
}

bool exactly_apart(const Polytope<Exact_rational>& a, const Polytope<Exact_rational>& b)
{
  return any_axis(a, b, [&](const Vec<Exact_rational>& axis) {
    if (axis.x == 0 && axis.y == 0 && axis.z == 0) return false;
    const Range<Exact_rational> r = extent(a, axis), s = extent(b, axis);
    return r.high <= s.low || s.high <= r.low;
  });
}

double largest(double x, double y, double z) { return (std::max)({std::abs(x), std::abs(y), std::abs(z)}); }

} // namespace

Body prism(const Written_frame& frame, const std::array<Point_2, 3>& triangle, double low, double high,
           const Vector_3& sweep)
{
  Body body;
  body.rounded = make_prism<double>(frame, triangle, low, high, sweep);
  const Point_3& o = frame.origin;
  double plane = (std::max)(std::abs(low), std::abs(high));
  for (const Point_2& p : triangle) plane = (std::max)({plane, std::abs(p.x()), std::abs(p.y())});
  body.magnitude = largest(o.x(), o.y(), o.z()) + 4 * plane + largest(sweep.x(), sweep.y(), sweep.z());
  body.box = safe_box(body.rounded, body.magnitude);
  body.exact = [=] { return make_prism<Exact_rational>(frame, triangle, low, high, sweep); };
  return body;
}

Body triangle(const Point_3& a, const Point_3& b, const Point_3& c)
{
  Body body;
  body.rounded = make_triangle<double>(a, b, c);
  body.magnitude = 0;
  for (const Point_3* p : {&a, &b, &c}) body.magnitude = (std::max)(body.magnitude, largest(p->x(), p->y(), p->z()));
  body.box = safe_box(body.rounded, body.magnitude);
  body.exact = [=] { return make_triangle<Exact_rational>(a, b, c); };
  return body;
}

bool interiors_meet(const Body& a, const Body& b)
{
  return CGAL::do_overlap(a.box, b.box) && !certainly_apart(a, b) && !exactly_apart(a.exact(), b.exact());
}

double penetration(const Body& a, const Body& b)
{
  double least = 1e300;
  any_axis(a.rounded, b.rounded, [&](const Vec<double>& axis) {
    const double length = std::sqrt(dot(axis, axis));
    if (length > 1e-9) least = (std::min)(least, -gap(a.rounded, b.rounded, axis) / length);
    return false;
  });
  return least;
}

Point_3 middle_of_contact(const Body& a, const Body& b)
{
  double c[3];
  for (int i = 0; i < 3; ++i)
    c[i] = ((std::max)(a.box.min(i), b.box.min(i)) + (std::min)(a.box.max(i), b.box.max(i))) / 2;
  return Point_3(c[0], c[1], c[2]);
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
