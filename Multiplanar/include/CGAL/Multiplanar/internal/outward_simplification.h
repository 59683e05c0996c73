// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_OUTWARD_SIMPLIFICATION_H
#define CGAL_MULTIPLANAR_INTERNAL_OUTWARD_SIMPLIFICATION_H

#include <CGAL/Multiplanar/Part.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Fewer vertices around a little more area. Two steps, each adding a triangle to the polygon:
///  - a reflex vertex b between a and c goes: the triangle a b c is filled;
///  - a side b c between two convex corners goes: its neighbours are prolonged to where they meet, in q: the triangle
///    b q c is filled.
/// The step that adds least comes first. The polygon stays simple: nothing else of it may be in the triangle.
class Outward_simplification
{
public:
  /// \pre simple and counter-clockwise
  explicit Outward_simplification(Outline outline) : p(std::move(outline)) {}

  /// Takes steps that add less than `each` mm^2, and `all` of them together at most `total`.
  const Outline& run(double each, double total)
  {
    double added = 0;
    for (Step s = cheapest(each); s.vertex >= 0 && added + s.area <= total; s = cheapest(each)) {
      added += s.area;
      take(s);
    }
    return p;
  }

private:
  struct Step
  {
    double area;
    int vertex = -1;      ///< the reflex one, or the first of the side
    bool is_side = false; ///< a side goes
    Point_2 q = Point_2(0, 0);
  };

  int size() const { return int(p.size()); }
  int wrapped(int i) const { return (i + size()) % size(); }
  const Point_2& at(int i) const { return p[wrapped(i)]; }

  /// No other vertex in the closed triangle, which is given counter-clockwise.
  bool is_free(const Point_2& a, const Point_2& b, const Point_2& c) const
  {
    for (const Point_2& v : p)
      if (v != a && v != b && v != c && CGAL::orientation(a, b, v) != CGAL::RIGHT_TURN &&
          CGAL::orientation(b, c, v) != CGAL::RIGHT_TURN && CGAL::orientation(c, a, v) != CGAL::RIGHT_TURN)
        return false;
    return true;
  }

  /// No side of the polygon that does not end in b or c meets the sides b q and q c.
  bool is_uncrossed(int i, const Point_2& q) const
  {
    using Segment = Kernel::Segment_2;
    const Segment bq(at(i), q), qc(q, at(i + 1));
    for (int k = 2; k + 2 <= size() - 1; ++k) {
      const Segment side(at(i + k), at(i + k + 1));
      if (CGAL::do_intersect(side, bq) || CGAL::do_intersect(side, qc)) return false;
    }
    return true;
  }

  /// Becomes `best` if it can be taken and adds less.
  void consider_vertex(int i, Step& best) const
  {
    const Point_2 &a = at(i - 1), &b = at(i), &c = at(i + 1);
    const CGAL::Orientation turn = CGAL::orientation(a, b, c);
    if (turn == CGAL::LEFT_TURN) return;
    const double area = turn == CGAL::COLLINEAR ? 0 : CGAL::area(a, c, b);
    if (!(area < best.area)) return;
    if (turn == CGAL::COLLINEAR ? CGAL::collinear_are_ordered_along_line(a, b, c) : is_free(a, c, b))
      best = {area, i, false, b};
  }

  void consider_side(int i, Step& best) const
  {
    const Point_2 &a = at(i - 1), &b = at(i), &c = at(i + 1), &d = at(i + 2);
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN || CGAL::orientation(b, c, d) != CGAL::LEFT_TURN) return;
    const Kernel::Vector_2 u = b - a, v = d - c, w = c - b;
    const double det = u.x() * v.y() - u.y() * v.x();
    if (det <= 1e-3 * std::sqrt(u.squared_length() * v.squared_length())) return; // they meet far away or nowhere
    const Point_2 q = b + (w.x() * v.y() - w.y() * v.x()) / det * u;
    if (CGAL::orientation(b, q, c) != CGAL::LEFT_TURN) return;
    const double area = CGAL::area(b, q, c);
    if (area < best.area && is_free(b, q, c) && is_uncrossed(i, q)) best = {area, i, true, q};
  }

  Step cheapest(double most) const
  {
    Step best{most};
    if (size() <= 3) return best;
    for (int i = 0; i < size(); ++i) {
      consider_vertex(i, best);
      if (size() > 4) consider_side(i, best);
    }
    return best;
  }

  void take(const Step& s)
  {
    if (s.is_side) p[wrapped(s.vertex + 1)] = s.q;
    p.erase(p.begin() + s.vertex);
  }

  Outline p;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_OUTWARD_SIMPLIFICATION_H
