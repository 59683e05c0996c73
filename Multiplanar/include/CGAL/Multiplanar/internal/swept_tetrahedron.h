// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SWEPT_TETRAHEDRON_H
#define CGAL_MULTIPLANAR_INTERNAL_SWEPT_TETRAHEDRON_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/exact_contacts.h>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Notation. The vertex p of an embedded closed mesh moves along the segment to q while every other vertex stands
// still: p(t) = p + t (q - p). The incident triangle (p, a, b) sweeps the tetrahedron tau = conv(p, q, a, b), which may
// be flat. A triangle s that does not contain p is static.
//
// Claim. If for every triangle (p, a, b) of p's star and every static triangle s
//     tau meets s exactly in their shared simplex, and no (p(t), a, b) has zero area,            (*)
// then the mesh is embedded at every time t.
// Proof. A star triangle and a static one at time t: (p(t), a, b) lies in tau, so (*) says it. Two star triangles
// T = (p, a, b) and T' = (p, c, d) at time t: both are cones with apex p(t) and have area. Suppose that they meet in
// more than their shared simplex. Then some ray from p(t) meets ab in a point x and cd in a point y, and if T and T'
// share an edge of the star, say b = c, there is such a ray that does not pass through b. The edges ab and cd are
// static, so they meet in a shared vertex at most, and x differs from y. Let x be the nearer to p(t) (else swap T and
// T'). Then x lies between p(t) and y, hence in T'(t), hence in the tetrahedron tau' that T' sweeps. The surface is
// closed, so x also lies in the triangle s across ab, which is static. By (*) x lies in the hull of those vertices that
// s and tau' share, all of them among c and d. So x lies on ab and on cd: it is the shared vertex b, which the ray does
// not pass. Contradiction: contact within the star, folds about its edges included, cannot occur unless (*) fails for a
// triangle across the link of p. []
//
// Each predicate below decides one case of (*), by the number of vertices that tau and s share. They are exact for any
// coordinates, construct nothing, and take a bounded number of orientation tests.

/// The tetrahedron that the triangle (p, a, b) sweeps while its vertex p moves to q.
struct Swept_tetrahedron
{
  const Point_3 &p, &q, &a, &b;
};

/// No shared vertex: is `tau` disjoint from the triangle (u, v, w)?
/// \pre (u, v, w) has positive area.
inline bool is_clear_of_disjoint_triangle(const Swept_tetrahedron& tau, const Point_3& u, const Point_3& v,
                                          const Point_3& w)
{
  if (is_strictly_on_one_side(u, v, w, {&tau.p, &tau.q, &tau.a, &tau.b})) return true;
  return !tetrahedron_meets_triangle(tau.p, tau.q, tau.a, tau.b, u, v, w);
}

/// One shared vertex `tau.a`: do `tau` and the triangle (tau.a, u, v) meet in that vertex only?
///
/// Both are cones over the apex a: tau over its face (p, q, b), s over its edge uv. A common point other than a lies on
/// a ray from a that leaves tau in a point of (p, q, b) and s in a point of uv; the nearer of the two is in both sets.
/// So they meet in a only if uv misses tau and (p, q, b) misses s, and only if they do, unless a itself is in (p, q,
/// b); but then (p(t), a, b) loses its area, and "not clear" is the right answer as well. \pre (tau.a, u, v) has
/// positive area.
inline bool is_clear_of_triangle_at_vertex(const Swept_tetrahedron& tau, const Point_3& u, const Point_3& v)
{
  if (is_strictly_on_one_side(tau.a, u, v, {&tau.p, &tau.q, &tau.b})) return true;
  return !segment_meets_tetrahedron(u, v, tau.p, tau.q, tau.a, tau.b) &&
         !triangles_meet(tau.a, u, v, tau.p, tau.q, tau.b);
}

/// p(t) leaves the line ab or crosses it: the degenerate cases of the wedge rule, where tau is flat.
/// True if (p(t), a, b) keeps a positive area on the whole way.
/// \pre p, q, a, b are coplanar and (p, a, b) has positive area.
inline bool flat_sweep_keeps_area(const Swept_tetrahedron& tau)
{
  return !CGAL::collinear(tau.a, tau.b, tau.q) &&
         CGAL::coplanar_orientation(tau.a, tau.b, tau.p, tau.q) == CGAL::POSITIVE;
}

/// Two shared vertices, flat sweep: with p and q on the same side of ab, the wedge is the half-plane abp.
/// Is the half-plane abc another one?
/// \pre p, q, a, b are coplanar; neither (p, a, b) nor (a, b, c) has zero area.
inline bool is_clear_of_triangle_at_edge_when_flat(const Swept_tetrahedron& tau, const Point_3& c)
{
  if (!flat_sweep_keeps_area(tau)) return false;
  return CGAL::orientation(tau.a, tau.b, tau.p, c) != CGAL::COPLANAR ||
         CGAL::coplanar_orientation(tau.a, tau.b, tau.p, c) == CGAL::NEGATIVE;
}

/// Two shared vertices: do `tau` and the triangle (tau.a, tau.b, c) meet in the edge ab only, and does (p(t), a, b)
/// keep a positive area?
///
/// Near the inner points of ab, tau equals the closed wedge between the half-planes abp and abq, of less than 180
/// degrees. So they meet in ab only if and only if the half-plane abc is outside the wedge, that is, unless c lies on
/// q's side of the plane abp (or on it) and on p's side of the plane abq (or on it).
/// \pre neither (tau.p, tau.a, tau.b) nor (tau.a, tau.b, c) has zero area.
inline bool is_clear_of_triangle_at_edge(const Swept_tetrahedron& tau, const Point_3& c)
{
  const int of_p = CGAL::orientation(tau.a, tau.b, c, tau.p);
  const int of_q = CGAL::orientation(tau.a, tau.b, c, tau.q);
  if (of_p * of_q > 0) return true; // p and q on one side of the plane abc: so is the wedge
  const int of_wedge = CGAL::orientation(tau.a, tau.b, tau.p, tau.q);
  if (of_wedge == 0) return is_clear_of_triangle_at_edge_when_flat(tau, c);
  // orientation(a,b,p,c) = -of_p and orientation(a,b,q,c) = -of_q; those of q and p are of_wedge and -of_wedge.
  return !(of_p * of_wedge <= 0 && of_q * of_wedge >= 0);
}

/// Condition (*) for the triangle `t`, whose vertex t[0] moves from `points[t[0]]` to `q`, and the static triangle `s`.
/// \pre s does not contain t[0] and shares at most an edge with t.
template <class Triangle>
bool is_sweep_clear(const Points& points, const Triangle& t, const Point_3& q, const Triangle& s)
{
  CGAL_precondition(s[0] != t[0] && s[1] != t[0] && s[2] != t[0]);
  int at_a = -1, at_b = -1; // where s holds a and b
  for (int i = 0; i < 3; ++i) {
    if (s[i] == t[1]) at_a = i;
    if (s[i] == t[2]) at_b = i;
  }
  const Point_3 &p = points[t[0]], &a = points[t[1]], &b = points[t[2]];
  if (at_a >= 0 && at_b >= 0) return is_clear_of_triangle_at_edge({p, q, a, b}, points[s[3 - at_a - at_b]]);
  if (at_a >= 0)
    return is_clear_of_triangle_at_vertex({p, q, a, b}, points[s[(at_a + 1) % 3]], points[s[(at_a + 2) % 3]]);
  if (at_b >= 0)
    return is_clear_of_triangle_at_vertex({p, q, b, a}, points[s[(at_b + 1) % 3]], points[s[(at_b + 2) % 3]]);
  return is_clear_of_disjoint_triangle({p, q, a, b}, points[s[0]], points[s[1]], points[s[2]]);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SWEPT_TETRAHEDRON_H
