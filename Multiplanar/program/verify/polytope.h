// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_POLYTOPE_H
#define MULTIPLANAR_VERIFY_POLYTOPE_H

#include "written_model.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <functional>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// A vector over any number type.
template <class NT>
struct Vec
{
  NT x, y, z;

  template <class V>
  static Vec from(const V& v)
  {
    return {NT(v.x()), NT(v.y()), NT(v.z())};
  }
};

template <class NT>
Vec<NT> operator+(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class NT>
Vec<NT> operator-(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class NT>
Vec<NT> operator*(const NT& s, const Vec<NT>& a)
{
  return {s * a.x, s * a.y, s * a.z};
}
template <class NT>
NT dot(const Vec<NT>& a, const Vec<NT>& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class NT>
Vec<NT> cross(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The convex hull of `vertices`, with a direction of every edge and a normal of every facet up to sign (and maybe more
/// of either). A flat polygon has its own normal only.
template <class NT>
struct Polytope
{
  std::vector<Vec<NT>> vertices, edges, normals;
};

/// A polytope that stands in the files as doubles: rounded for a first look, and exactly for the last word.
struct Body
{
  Polytope<double> rounded;
  double magnitude; ///< bounds the terms that the rounded vertices were added up from
  CGAL::Bbox_3 box; ///< holds the exact body
  std::function<Polytope<CGAL::Exact_rational>()> exact;
};

/// The prism { origin + x u + y v - z normal : (x, y) in the triangle, low <= z <= high }, moved along 0..`sweep`.
Body prism(const Written_frame& frame, const std::array<Point_2, 3>& triangle, double low, double high,
           const Vector_3& sweep = Vector_3(0, 0, 0));

/// A flat body.
Body triangle(const Point_3& a, const Point_3& b, const Point_3& c);

/*!
Does the interior of `a` meet the interior of `b` (or, if `b` is flat, meet `b`)? Exact.

Two convex bodies, one of them with interior, have disjoint interiors iff a plane separates them whose normal is a facet
normal of one or the cross product of an edge of either. Any double vector that separates the rounded bodies by more
than their rounding errors proves it too, so the exact test decides close cases only.

\pre `a` has an interior
*/
bool interiors_meet(const Body& a, const Body& b);

/// How far one would have to be moved to get free of the other, in mm: in doubles, for messages.
double penetration(const Body& a, const Body& b);

/// The middle of what the boxes of two bodies share: for messages.
Point_3 middle_of_contact(const Body& a, const Body& b);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_POLYTOPE_H
