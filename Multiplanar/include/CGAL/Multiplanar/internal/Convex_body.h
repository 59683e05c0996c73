// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONVEX_BODY_H
#define CGAL_MULTIPLANAR_INTERNAL_CONVEX_BODY_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Multiplanar/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Convex bodies and the proof that two of them are apart: a plane with one on either side. The plane may come from
// rounded arithmetic; whether it separates is then decided beyond the errors of rounding. So "apart" is always true.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The convex hull of `vertices`, with a direction of every edge and a normal of every facet, up to sign and rounding.
struct Convex_body
{
  Points vertices;
  std::vector<Vector_3> edges, normals;
  CGAL::Bbox_3 box;

  void update_box()
  {
    box = CGAL::Bbox_3();
    for (const Point_3& p : vertices) box += p.bbox();
  }
};

/// { frame(p) - z normal : p in `base`, low <= z <= high }. \pre `base` is convex, low < high
inline Convex_body prism_over(const Outline& base, const Frame& frame, double low, double high)
{
  Convex_body body;
  for (const double z : {low, high})
    for (const Point_2& p : base) body.vertices.push_back(frame(p) - z * frame.normal);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const auto side = base[(i + 1) % base.size()] - base[i];
    body.edges.push_back(side.x() * frame.u + side.y() * frame.v);
    body.normals.push_back(side.y() * frame.u - side.x() * frame.v);
  }
  body.edges.push_back(frame.normal);
  body.normals.push_back(frame.normal);
  body.update_box();
  return body;
}

/// All points that the body passes when it moves by `way`: its Minkowski sum with a segment.
inline Convex_body swept_body(Convex_body body, const Vector_3& way)
{
  const std::size_t n = body.vertices.size();
  for (std::size_t i = 0; i < n; ++i) body.vertices.push_back(body.vertices[i] + way);
  for (const Vector_3& e : body.edges) body.normals.push_back(CGAL::cross_product(e, way));
  body.edges.push_back(way);
  body.update_box();
  return body;
}

inline Convex_body shifted_body(Convex_body body, const Vector_3& by)
{
  for (Point_3& p : body.vertices) p = p + by;
  body.update_box();
  return body;
}

/// The range of a body along an axis.
inline std::array<double, 2> extent_along(const Vector_3& axis, const Convex_body& body)
{
  std::array<double, 2> range{{1e300, -1e300}};
  for (const Point_3& p : body.vertices) {
    const double x = axis.x() * p.x() + axis.y() * p.y() + axis.z() * p.z();
    range[0] = (std::min)(range[0], x);
    range[1] = (std::max)(range[1], x);
  }
  return range;
}

/// Does a plane orthogonal to `axis` separate the two? Never yes by rounding: three products and two sums of numbers up
/// to `magnitude` |axis| err by less than 3 * 2^-53 times their sum.
inline bool separates(const Vector_3& axis, const Convex_body& a, const Convex_body& b, double magnitude)
{
  const double error = 1e-15 * magnitude * (std::abs(axis.x()) + std::abs(axis.y()) + std::abs(axis.z()));
  const auto r = extent_along(axis, a), s = extent_along(axis, b);
  return r[1] + 2 * error < s[0] || s[1] + 2 * error < r[0];
}

inline double magnitude_of(const CGAL::Bbox_3& box)
{
  double most = 0;
  for (int i = 0; i < 3; ++i) most = (std::max)({most, std::abs((box.min)(i)), std::abs((box.max)(i))});
  return most;
}

/// Are the two apart? "Yes" is proved by a separating plane. "No" is true but for bodies that rounding cannot tell from
/// touching ones: two convex bodies are apart iff a plane along a facet of one, or along an edge of each, separates
/// them.
inline bool proved_apart(const Convex_body& a, const Convex_body& b)
{
  if (!CGAL::do_overlap(a.box, b.box)) return true;
  const double magnitude = (std::max)(magnitude_of(a.box), magnitude_of(b.box));
  for (const Vector_3& n : a.normals)
    if (separates(n, a, b, magnitude)) return true;
  for (const Vector_3& n : b.normals)
    if (separates(n, a, b, magnitude)) return true;
  for (const Vector_3& d : a.edges)
    for (const Vector_3& e : b.edges)
      if (separates(CGAL::cross_product(d, e), a, b, magnitude)) return true;
  return false;
}

/// A union of convex bodies.
struct Bodies
{
  std::vector<Convex_body> list;
  CGAL::Bbox_3 box;

  void add(Convex_body body)
  {
    box += body.box;
    list.push_back(std::move(body));
  }
};

inline Bodies swept_bodies(const Bodies& bodies, const Vector_3& way)
{
  Bodies result;
  for (const Convex_body& body : bodies.list) result.add(swept_body(body, way));
  return result;
}

inline Bodies shifted_bodies(const Bodies& bodies, const Vector_3& by)
{
  Bodies result;
  for (const Convex_body& body : bodies.list) result.add(shifted_body(body, by));
  return result;
}

inline bool proved_apart(const Bodies& a, const Bodies& b)
{
  if (!CGAL::do_overlap(a.box, b.box)) return true;
  for (const Convex_body& p : a.list) {
    if (!CGAL::do_overlap(p.box, b.box)) continue;
    for (const Convex_body& q : b.list)
      if (!proved_apart(p, q)) return false;
  }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONVEX_BODY_H
