// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guard_brute_force.h"

#include <CGAL/Multiplanar/internal/swept_tetrahedron.h>

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using namespace Multiplanar_test;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using P = Point_3;

// The reference tetrahedron: p = (0,0,1) moves to q, over the edge from a = (0,0,0) to b = (2,0,0).
const P p(0, 0, 2), a(0, 0, 0), b(2, 0, 0);
const P q(0, 2, 0); // a quarter turn about ab: tau = conv(p, q, a, b) is a corner of a cube
Swept_tetrahedron tau() { return {p, q, a, b}; }

// ---- no shared vertex

TEST(Disjoint_triangle, ClearWhenASideOfTheTrianglesPlane)
{
  EXPECT_TRUE(is_clear_of_disjoint_triangle(tau(), P(-1, 0, 0), P(-1, 1, 0), P(-1, 0, 1)));
}
TEST(Disjoint_triangle, ClearBeyondAFaceThoughThePlaneCuts)
{
  EXPECT_TRUE(is_clear_of_disjoint_triangle(tau(), P(-1, -1, -1), P(-1, 3, 3), P(-1, -1, 5)));
  EXPECT_TRUE(is_clear_of_disjoint_triangle(tau(), P(-1, -5, -5), P(5, -5, -5), P(0, -0.5, -0.5)));
  EXPECT_TRUE(is_clear_of_disjoint_triangle(tau(), P(1.5, 1.5, 1.5), P(1, 5, 1), P(-1, 5, 7))); // plane cuts tau
}
TEST(Disjoint_triangle, ContactOnTheWayOnly)
{
  // Misses (p,a,b) and (q,a,b), meets the inside of tau and its face (p,q,a).
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(0.2, 0.5, 0.5), P(-2, 0.5, 0.5), P(-2, 0.6, 0.5)));
}
TEST(Disjoint_triangle, WhollyInside)
{
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(0.2, 0.2, 0.2), P(0.3, 0.2, 0.2), P(0.2, 0.3, 0.2)));
}
TEST(Disjoint_triangle, TauPiercesIt)
{
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(1, -9, -9), P(1, 9, -9), P(1, 0, 9)));
}
TEST(Disjoint_triangle, TouchingCounts)
{
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(0, 1, 1), P(-1, 1, 1), P(-1, 0, 5)));       // a corner on a face
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(-1, 1, 1), P(1, 1, 1), P(0, 5, 5)));        // an edge on pq
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(-1, -1, 2), P(1, -1, 2), P(0, 3, 2)));      // p in its inside
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), q, P(0, 5, 0), P(0, 5, 1)));                  // a common point
  EXPECT_FALSE(is_clear_of_disjoint_triangle(tau(), P(0, 0.5, 0.5), P(0, 1, 0.5), P(0, 0.5, 1))); // inside a face
}
TEST(Disjoint_triangle, FlatSweep)
{
  const P flat(1, 0, 1); // in the plane of (p, a, b)
  const Swept_tetrahedron t{p, flat, a, b};
  EXPECT_FALSE(is_clear_of_disjoint_triangle(t, P(0.5, -1, 0.5), P(0.5, 1, 0.5), P(0.5, 0, 5)));
  EXPECT_TRUE(is_clear_of_disjoint_triangle(t, P(5, -1, 0.5), P(5, 1, 0.5), P(5, 0, 5)));
  EXPECT_TRUE(is_clear_of_disjoint_triangle(t, P(5, 0, 0), P(6, 0, 0), P(5, 0, 1)));        // coplanar, apart
  EXPECT_FALSE(is_clear_of_disjoint_triangle(t, P(1, 0, 0.1), P(6, 0, 0), P(5, 0, 1)));     // coplanar, overlapping
  EXPECT_FALSE(is_clear_of_disjoint_triangle(t, P(-9, 0, -9), P(9, 0, -9), P(0, 0, 20)));   // coplanar, around it
  EXPECT_FALSE(is_clear_of_disjoint_triangle(t, P(.5, 0, .5), P(.6, 0, .5), P(.5, 0, .6))); // coplanar, inside it
}
TEST(Disjoint_triangle, SweepAlongItsOwnEdge)
{
  const P further(0, 0, 5); // p, q, a collinear: the face (p, q, a) is a segment
  const Swept_tetrahedron t{p, further, a, b};
  EXPECT_FALSE(is_clear_of_disjoint_triangle(t, P(-1, -1, 4), P(1, -1, 4), P(0, 1, 4)));
  EXPECT_TRUE(is_clear_of_disjoint_triangle(t, P(-1, -1, 6), P(1, -1, 6), P(0, 1, 6)));
}

// ---- one shared vertex a

TEST(Triangle_at_vertex, Clear)
{
  EXPECT_TRUE(is_clear_of_triangle_at_vertex(tau(), P(-1, 0, 0), P(-1, 1, 0)));
  EXPECT_TRUE(is_clear_of_triangle_at_vertex(tau(), P(-1, 3, 3), P(-1, -3, -3))); // its plane cuts tau's plane x = 0
  EXPECT_TRUE(is_clear_of_triangle_at_vertex(tau(), P(3, -1, -1), P(3, 1, -5)));  // beside b, below
}
TEST(Triangle_at_vertex, OppositeEdgeInside)
{
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(.2, .2, .2), P(.3, .2, .2)));
}
TEST(Triangle_at_vertex, OppositeFacePierced)
{
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(3, 3, 3), P(4, 3, 3)));
}
TEST(Triangle_at_vertex, OppositeEdgeCutsTau)
{
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(-1, .5, .5), P(1, .3, .3)));
}
TEST(Triangle_at_vertex, TouchingBeyondTheVertexCounts)
{
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(0, 1, 1), P(-1, 0, 0)));  // a ray in the face (p, q, a)
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(1, 0, 0), P(1, -1, 0)));  // along the edge ab
  EXPECT_FALSE(is_clear_of_triangle_at_vertex(tau(), P(0, 5, 0), P(-1, 5, -1))); // along aq, longer
}
TEST(Triangle_at_vertex, MovingOntoOrThroughTheVertex)
{
  EXPECT_FALSE(is_clear_of_triangle_at_vertex({p, a, a, b}, P(-1, 0, 0), P(-1, 1, 0)));
  EXPECT_FALSE(is_clear_of_triangle_at_vertex({p, P(0, 0, -1), a, b}, P(-1, 0, 0), P(-1, 1, 0)));
}
TEST(Triangle_at_vertex, FlatSweep)
{
  const P flat(1, 0, 1);
  EXPECT_TRUE(is_clear_of_triangle_at_vertex({p, flat, a, b}, P(-1, 0, 0), P(-1, 0, -1)));   // coplanar, apart
  EXPECT_FALSE(is_clear_of_triangle_at_vertex({p, flat, a, b}, P(5, 0, 1), P(5, 0, -1)));    // coplanar, overlapping
  EXPECT_FALSE(is_clear_of_triangle_at_vertex({p, flat, a, b}, P(1, -1, 1), P(1, 1, 1)));    // through the plane
  EXPECT_TRUE(is_clear_of_triangle_at_vertex({p, flat, a, b}, P(-1, -1, -1), P(-1, 1, -1))); // through, outside
}

// ---- two shared vertices a, b: the wedge rule

TEST(Triangle_at_edge, OnOneSideOfItsPlane)
{
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(0, -1, 1)));
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(5, -1, 1)));
}
TEST(Triangle_at_edge, InsideTheWedge)
{
  EXPECT_FALSE(is_clear_of_triangle_at_edge(tau(), P(0, 1, 1)));
  EXPECT_FALSE(is_clear_of_triangle_at_edge(tau(), P(-50, 9, 1))); // far along the edge: only the half-plane counts
}
TEST(Triangle_at_edge, CrossingItsPlaneOnTheFarSide)
{
  // The edge becomes concave from convex and is flat on the way: allowed.
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(0, -1, -1)));
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(0, -1, -0.25)));
}
TEST(Triangle_at_edge, LandingInItsPlane)
{
  EXPECT_FALSE(is_clear_of_triangle_at_edge(tau(), P(0, 3, 0))); // folded onto it
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(0, -3, 0))); // flat across the edge
}
TEST(Triangle_at_edge, LeavingItsPlane)
{
  EXPECT_TRUE(is_clear_of_triangle_at_edge(tau(), P(0, 0, -1))); // flat at the start
}
TEST(Triangle_at_edge, MoreThanAHalfTurnIsSweptTheOtherWay)
{
  const P beyond(0, 1, -3); // p(t) passes y > 0
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, beyond, a, b}, P(0, 1, 0)));
  EXPECT_TRUE(is_clear_of_triangle_at_edge({p, beyond, a, b}, P(0, -1, 0)));
}
TEST(Triangle_at_edge, FlatSweepOnOneSide)
{
  EXPECT_TRUE(is_clear_of_triangle_at_edge({p, P(1, 0, 5), a, b}, P(0, 1, 0)));
  EXPECT_TRUE(is_clear_of_triangle_at_edge({p, P(1, 0, 5), a, b}, P(0, 0, -1)));
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, P(1, 0, 5), a, b}, P(0, 0, 1)));
  EXPECT_TRUE(is_clear_of_triangle_at_edge({p, P(-7, 0, 1e-300), a, b}, P(0, 1, 0)));
}
TEST(Triangle_at_edge, ZeroAreaAtTheEnd)
{
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, P(1, 0, 0), a, b}, P(0, 1, 0))); // within the edge
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, P(9, 0, 0), a, b}, P(0, 1, 0))); // on its line
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, b, a, b}, P(0, 1, 0)));          // in a vertex
}
TEST(Triangle_at_edge, ZeroAreaOnTheWay)
{
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, P(1, 0, -1), a, b}, P(0, 1, 0)));
  EXPECT_FALSE(is_clear_of_triangle_at_edge({p, P(90, 0, -1), a, b}, P(0, 1, 0)));
}
TEST(Triangle_at_edge, DegenerateCasesOfTheRule)
{
  EXPECT_TRUE(flat_sweep_keeps_area({p, P(1, 0, 5), a, b}));
  EXPECT_FALSE(flat_sweep_keeps_area({p, P(1, 0, 0), a, b}));
  EXPECT_FALSE(flat_sweep_keeps_area({p, P(1, 0, -5), a, b}));
  EXPECT_TRUE(is_clear_of_triangle_at_edge_when_flat({p, P(1, 0, 5), a, b}, P(0, 1, 0)));
  EXPECT_FALSE(is_clear_of_triangle_at_edge_when_flat({p, P(1, 0, 5), a, b}, P(7, 0, 1)));
}

// ---- all cases through the vertex numbers

TEST(Is_sweep_clear, FindsTheCase)
{
  using Triangle = std::array<int, 3>;
  const Points x = {p, a, b, P(0, -1, -1), P(.2, .2, .2), P(.3, .2, .2), P(0, 1, 1), P(-1, -1, -1), P(-2, -1, -1)};
  const Triangle t{0, 1, 2};
  for (int turn = 0; turn < 3; ++turn) {
    const auto turned = [&](int i, int j, int k) {
      const Triangle s{i, j, k};
      return Triangle{s[turn], s[(turn + 1) % 3], s[(turn + 2) % 3]};
    };
    EXPECT_TRUE(is_sweep_clear(x, t, q, turned(2, 1, 3)));
    EXPECT_FALSE(is_sweep_clear(x, t, q, turned(2, 1, 6)));
    EXPECT_TRUE(is_sweep_clear(x, t, q, turned(1, 7, 8)));
    EXPECT_FALSE(is_sweep_clear(x, t, q, turned(1, 5, 4)));
    EXPECT_FALSE(is_sweep_clear(x, t, q, turned(4, 5, 2)));
    EXPECT_TRUE(is_sweep_clear(x, t, q, turned(3, 7, 8)));
    EXPECT_FALSE(is_sweep_clear(x, t, q, turned(4, 5, 6)));
  }
}

// ---- twins: CGAL's constructions on random small grids

Exact::Point_3 exact(const P& x) { return {x.x(), x.y(), x.z()}; }
Exact::Triangle_3 exact(const P& u, const P& v, const P& w) { return {exact(u), exact(v), exact(w)}; }

/// Hands those faces of tau to `use` that have an area.
template <class Use>
void for_each_face(const Swept_tetrahedron& t, Use use)
{
  const std::array<const P*, 4> x{&t.p, &t.q, &t.a, &t.b};
  for (int i = 0; i < 4; ++i) {
    const P &u = *x[(i + 1) % 4], &v = *x[(i + 2) % 4], &w = *x[(i + 3) % 4];
    if (!CGAL::collinear(u, v, w)) use(exact(u, v, w));
  }
}

/// tau as a solid if it is one, else as the union of its faces: does it meet the triangle s? (p, a, b) has area, so a
/// face that degenerates lies in the others.
bool twin_meets(const Swept_tetrahedron& t, const Exact::Triangle_3& s)
{
  if (!CGAL::coplanar(t.p, t.q, t.a, t.b))
    return CGAL::do_intersect(Exact::Tetrahedron_3(exact(t.p), exact(t.q), exact(t.a), exact(t.b)), s);
  bool meets = false;
  for_each_face(t, [&](const Exact::Triangle_3& face) { meets |= CGAL::do_intersect(face, s); });
  return meets;
}

/// Does tau meet s in points other than `apex`? By the intersection of s with each face, and by s within tau.
bool twin_meets_beyond(const Swept_tetrahedron& t, const Exact::Triangle_3& s, const P& apex)
{
  bool meets = false;
  for_each_face(t, [&](const Exact::Triangle_3& face) {
    const auto common = CGAL::intersection(face, s);
    if (!common) return;
    const auto* point = boost::get<Exact::Point_3>(&*common);
    meets |= point == nullptr || *point != exact(apex);
  });
  if (CGAL::coplanar(t.p, t.q, t.a, t.b)) return meets;
  const Exact::Tetrahedron_3 solid(exact(t.p), exact(t.q), exact(t.a), exact(t.b));
  return meets || solid.has_on_bounded_side(CGAL::centroid(s));
}

struct Random_case
{
  P p, q, a, b, c, d, e;
  bool is_usable() const { return p != q && !CGAL::collinear(p, a, b); }
};

/// Is p(t) on the line ab at some time? By the exact time.
bool loses_area(const Random_case& r)
{
  const auto ab = exact(r.b) - exact(r.a), p = exact(r.p) - exact(r.a), q = exact(r.q) - exact(r.a);
  const auto of_p = CGAL::cross_product(ab, p), of_q = CGAL::cross_product(ab, q);
  // The cross product with ab is affine in time: it vanishes in all components at one time of 0..1, or nowhere.
  for (int i = 0; i < 3; ++i)
    if (of_p[i] != of_q[i]) {
      const Exact::FT time = of_p[i] / (of_p[i] - of_q[i]);
      return time >= 0 && time <= 1 && of_p + time * (of_q - of_p) == CGAL::NULL_VECTOR;
    }
  return of_p == CGAL::NULL_VECTOR;
}

Random_case random_case(Random_numbers& random, int size)
{
  const auto point = [&] { return P(random.below(size), random.below(size), random.below(size)); };
  return {point(), point(), point(), point(), point(), point(), point()};
}

TEST(Twin, DisjointTriangle)
{
  Random_numbers random(1);
  int clear = 0, contact = 0, flat = 0;
  for (int n = 0; n < 30000; ++n) {
    const Random_case r = random_case(random, 3 + n % 5);
    if (!r.is_usable() || CGAL::collinear(r.c, r.d, r.e)) continue;
    const Swept_tetrahedron t{r.p, r.q, r.a, r.b};
    const bool ours = is_clear_of_disjoint_triangle(t, r.c, r.d, r.e);
    ASSERT_EQ(ours, !twin_meets(t, exact(r.c, r.d, r.e))) << n;
    ++(ours ? clear : contact);
    flat += CGAL::coplanar(r.p, r.q, r.a, r.b);
  }
  EXPECT_GT(clear, 2000);
  EXPECT_GT(contact, 2000);
  EXPECT_GT(flat, 1000);
}

TEST(Twin, TriangleAtVertex)
{
  Random_numbers random(2);
  int clear = 0, contact = 0, flat = 0;
  for (int n = 0; n < 20000; ++n) {
    const Random_case r = random_case(random, 3 + n % 5);
    if (!r.is_usable() || CGAL::collinear(r.a, r.d, r.e)) continue;
    const Swept_tetrahedron t{r.p, r.q, r.a, r.b};
    const bool ours = is_clear_of_triangle_at_vertex(t, r.d, r.e);
    const bool meets = twin_meets_beyond(t, exact(r.a, r.d, r.e), r.a);
    // Where (p(t), a, b) loses its area the move is refused anyhow, and "not clear" is never wrong.
    if (loses_area(r)) ASSERT_FALSE(ours && meets) << n;
    else ASSERT_EQ(ours, !meets) << n;
    ++(ours ? clear : contact);
    flat += CGAL::coplanar(r.p, r.q, r.a, r.b);
  }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(contact, 1000);
  EXPECT_GT(flat, 500);
}

/// Twin of the wedge rule: times sampled densely in exact arithmetic, and area by collinearity.
TEST(Twin, TriangleAtEdge)
{
  Random_numbers random(3);
  int clear = 0, contact = 0, flat = 0;
  for (int n = 0; n < 20000; ++n) {
    const Random_case r = random_case(random, 3 + n % 5);
    if (!r.is_usable() || CGAL::collinear(r.a, r.b, r.c)) continue;
    if (CGAL::coplanar(r.a, r.b, r.c, r.p) && CGAL::coplanar_orientation(r.a, r.b, r.c, r.p) == CGAL::POSITIVE)
      continue; // not embedded at the start
    const Swept_tetrahedron t{r.p, r.q, r.a, r.b};
    const bool ours = is_clear_of_triangle_at_edge(t, r.c);
    // Contact if and only if at some time p(t) lies in the closed half-plane abc. That time is a rational function of
    // small integers: p(t) crosses the plane once, at f(p) / (f(p) - f(q)) with f its signed volume.
    const auto f = [&](const Exact::Point_3& x) {
      return CGAL::determinant(exact(r.b) - exact(r.a), exact(r.c) - exact(r.a), x - exact(r.a));
    };
    const auto at = [&](const Exact::FT& s) { return exact(r.p) + s * (exact(r.q) - exact(r.p)); };
    const auto in_half_plane = [&](const Exact::Point_3& x) {
      return CGAL::collinear(exact(r.a), exact(r.b), x) ||
             CGAL::coplanar_orientation(exact(r.a), exact(r.b), exact(r.c), x) == CGAL::POSITIVE;
    };
    const Exact::FT fp = f(exact(r.p)), fq = f(exact(r.q));
    bool meets = false;
    if (fp == 0 && fq == 0) meets = in_half_plane(exact(r.q)); // p is not in it, and the way is straight
    else if (CGAL::sign(fp) * CGAL::sign(fq) <= 0) meets = in_half_plane(at(fp / (fp - fq)));
    ASSERT_EQ(ours, !meets && !loses_area(r)) << n;
    ++(ours ? clear : contact);
    flat += CGAL::coplanar(r.p, r.q, r.a, r.b);
  }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(contact, 1000);
  EXPECT_GT(flat, 500);
}

TEST(Twin, SegmentAndTriangleMayDegenerate)
{
  Random_numbers random(4);
  int meet = 0, degenerate = 0;
  for (int n = 0; n < 30000; ++n) {
    const Random_case r = random_case(random, 2 + n % 3);
    const bool ours = segment_meets_triangle(r.p, r.q, r.a, r.b, r.c);
    const bool flat = CGAL::collinear(r.a, r.b, r.c);
    // A degenerate triangle is the union of its edges, a degenerate segment is a point.
    const auto twin = [&](const auto& object) {
      const auto edge = [&](const P& u, const P& v) {
        return u == v ? CGAL::do_intersect(object, exact(u))
                      : CGAL::do_intersect(object, Exact::Segment_3(exact(u), exact(v)));
      };
      if (!flat) return CGAL::do_intersect(object, exact(r.a, r.b, r.c));
      return edge(r.a, r.b) || edge(r.b, r.c) || edge(r.c, r.a);
    };
    const bool theirs = r.p == r.q ? twin(exact(r.p)) : twin(Exact::Segment_3(exact(r.p), exact(r.q)));
    ASSERT_EQ(ours, theirs) << n;
    meet += ours;
    degenerate += flat;
  }
  EXPECT_GT(meet, 3000);
  EXPECT_GT(degenerate, 1000);
}

} // namespace
