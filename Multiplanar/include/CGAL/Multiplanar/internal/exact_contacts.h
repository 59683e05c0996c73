// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_EXACT_CONTACTS_H
#define CGAL_MULTIPLANAR_INTERNAL_EXACT_CONTACTS_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <initializer_list>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Exact "do these closed simplices meet" predicates on points whose simplices may be degenerate: a segment may be a
// point, a triangle a segment or a point, a tetrahedron flat. CGAL's own do_intersect excludes those by precondition.
//
// By Kirchberger's theorem two finite point sets have disjoint hulls if and only if all their subsets of five points in
// total do. That reduces a tetrahedron against a triangle to segments against triangles and points against tetrahedra,
// and in a plane to segments against segments and points against triangles.

/// Are all of `points` strictly on one and the same side of the plane (u, v, w)? False if (u, v, w) is degenerate.
inline bool is_strictly_on_one_side(const Point_3& u, const Point_3& v, const Point_3& w,
                                    std::initializer_list<const Point_3*> points)
{
  const CGAL::Orientation side = CGAL::orientation(u, v, w, **points.begin());
  if (side == CGAL::COPLANAR) return false;
  for (const Point_3* x : points)
    if (x != *points.begin() && CGAL::orientation(u, v, w, *x) != side) return false;
  return true;
}

/// Is x on the closed segment pq?
inline bool segment_contains(const Point_3& p, const Point_3& q, const Point_3& x)
{
  return CGAL::collinear(p, q, x) && CGAL::collinear_are_ordered_along_line(p, x, q);
}

/// Do the closed segments pq and rs meet?
/// \pre the four points are coplanar.
inline bool coplanar_segments_meet(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s)
{
  const auto pqr = CGAL::coplanar_orientation(p, q, r), pqs = CGAL::coplanar_orientation(p, q, s);
  if (pqr == pqs && pqr != CGAL::COLLINEAR) return false;
  const auto rsp = CGAL::coplanar_orientation(r, s, p), rsq = CGAL::coplanar_orientation(r, s, q);
  if (rsp == rsq && rsp != CGAL::COLLINEAR) return false;
  if (pqr != pqs && rsp != rsq) return true;
  return segment_contains(p, q, r) || segment_contains(p, q, s) || segment_contains(r, s, p) ||
         segment_contains(r, s, q);
}

/// Do the closed segments pq and rs meet?
inline bool segments_meet(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s)
{
  return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR && coplanar_segments_meet(p, q, r, s);
}

/// Is x in the closed triangle abc?
/// \pre abc has positive area and x lies in its plane.
inline bool coplanar_triangle_contains(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& x)
{
  const int abx = CGAL::coplanar_orientation(a, b, x);
  const int bcx = CGAL::coplanar_orientation(b, c, x);
  if (abx * bcx < 0) return false;
  const int cax = CGAL::coplanar_orientation(c, a, x);
  return abx * cax >= 0 && bcx * cax >= 0;
}

/// Is x in the closed triangle abc?
inline bool triangle_contains(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& x)
{
  if (CGAL::orientation(a, b, c, x) != CGAL::COPLANAR) return false;
  if (CGAL::collinear(a, b, c))
    return segment_contains(a, b, x) || segment_contains(b, c, x) || segment_contains(c, a, x);
  return coplanar_triangle_contains(a, b, c, x);
}

/// Do the closed segment pq and the closed triangle abc meet?
/// \pre the five points are coplanar and abc has positive area.
inline bool coplanar_segment_meets_triangle(const Point_3& p, const Point_3& q, const Point_3& a, const Point_3& b,
                                            const Point_3& c)
{
  return coplanar_triangle_contains(a, b, c, p) || coplanar_segments_meet(p, q, a, b) ||
         coplanar_segments_meet(p, q, b, c) || coplanar_segments_meet(p, q, c, a);
}

/// Does the line pq pass through the closed triangle abc?
/// \pre the line is not parallel to the plane of abc, which has positive area.
inline bool transversal_line_meets_triangle(const Point_3& p, const Point_3& q, const Point_3& a, const Point_3& b,
                                            const Point_3& c)
{
  const int ab = CGAL::orientation(p, q, a, b);
  const int bc = CGAL::orientation(p, q, b, c);
  if (ab * bc < 0) return false;
  const int ca = CGAL::orientation(p, q, c, a);
  return ab * ca >= 0 && bc * ca >= 0;
}

/// Do the closed segment pq and the closed triangle abc meet?
inline bool segment_meets_triangle(const Point_3& p, const Point_3& q, const Point_3& a, const Point_3& b,
                                   const Point_3& c)
{
  const auto of_p = CGAL::orientation(a, b, c, p), of_q = CGAL::orientation(a, b, c, q);
  if (of_p != CGAL::COPLANAR || of_q != CGAL::COPLANAR)
    return of_p != of_q && transversal_line_meets_triangle(p, q, a, b, c);
  if (CGAL::collinear(a, b, c))
    return segments_meet(p, q, a, b) || segments_meet(p, q, b, c) || segments_meet(p, q, c, a);
  return coplanar_segment_meets_triangle(p, q, a, b, c);
}

/// Do the closed triangles abc and uvw meet?
inline bool triangles_meet(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& u, const Point_3& v,
                           const Point_3& w)
{
  return segment_meets_triangle(a, b, u, v, w) || segment_meets_triangle(b, c, u, v, w) ||
         segment_meets_triangle(c, a, u, v, w) || segment_meets_triangle(u, v, a, b, c) ||
         segment_meets_triangle(v, w, a, b, c) || segment_meets_triangle(w, u, a, b, c);
}

/// Is x in the closed tetrahedron abcd?
/// \pre abcd is not flat.
inline bool full_tetrahedron_contains(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d,
                                      const Point_3& x)
{
  const int side = CGAL::orientation(a, b, c, d);
  return side * CGAL::orientation(a, b, c, x) >= 0 && side * CGAL::orientation(a, b, x, d) >= 0 &&
         side * CGAL::orientation(a, x, c, d) >= 0 && side * CGAL::orientation(x, b, c, d) >= 0;
}

/// Do the closed segment uv and the closed tetrahedron abcd meet? A segment that meets no face of it lies inside or
/// outside; a flat tetrahedron is the union of its faces.
inline bool segment_meets_tetrahedron(const Point_3& u, const Point_3& v, const Point_3& a, const Point_3& b,
                                      const Point_3& c, const Point_3& d)
{
  return segment_meets_triangle(u, v, a, b, c) || segment_meets_triangle(u, v, a, b, d) ||
         segment_meets_triangle(u, v, a, c, d) || segment_meets_triangle(u, v, b, c, d) ||
         (CGAL::orientation(a, b, c, d) != CGAL::COPLANAR && full_tetrahedron_contains(a, b, c, d, u));
}

/// Do the closed tetrahedron abcd and the closed triangle uvw meet?
inline bool tetrahedron_meets_triangle(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d,
                                       const Point_3& u, const Point_3& v, const Point_3& w)
{
  return segment_meets_triangle(a, b, u, v, w) || segment_meets_triangle(a, c, u, v, w) ||
         segment_meets_triangle(a, d, u, v, w) || segment_meets_triangle(b, c, u, v, w) ||
         segment_meets_triangle(b, d, u, v, w) || segment_meets_triangle(c, d, u, v, w) ||
         segment_meets_tetrahedron(u, v, a, b, c, d) || segment_meets_tetrahedron(v, w, a, b, c, d) ||
         segment_meets_tetrahedron(w, u, a, b, c, d);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_EXACT_CONTACTS_H
