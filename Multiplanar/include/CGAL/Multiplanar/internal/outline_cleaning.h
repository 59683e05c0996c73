// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_OUTLINE_CLEANING_H
#define CGAL_MULTIPLANAR_INTERNAL_OUTLINE_CLEANING_H

#include <CGAL/Multiplanar/exact_polygons.h>
#include <CGAL/Multiplanar/internal/Flat_polygon.h>
#include <CGAL/Multiplanar/internal/thin_webs.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Exact polygons are rounded to doubles once, here, and rid of what no machine can cut: slivers thinner than a
// micrometre, which nearly coincident cuts leave, steps, spikes and notches with sides under 20 micrometres, and thin
// webs (thin_webs.h). That only takes material away, or adds slivers of at most a nanometre (rounding alone adds 1e-14
// mm): parts that were disjoint stay so, up to that much.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// All in mm.
struct Cleaning_tolerance
{
  double removed = 1e-3;    ///< the thickness of slivers that may be taken off
  double added = 1e-6;      ///< and of those that may be added
  double short_side = 0.02; ///< at sides shorter than this, slivers up to this thickness may be taken off
  double slit = 1e-4;       ///< notches shorter than this may be filled however they look
};

/// The least altitude of a triangle: how thick it is.
inline double thickness_of_triangle(const Point_2& a, const Point_2& b, const Point_2& c)
{
  const double doubled_area = std::abs((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
  const double longest =
      std::sqrt((std::max)({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)}));
  return longest > 0 ? doubled_area / longest : 0;
}

/// Is the point on the right of the loop, where there is no material?
inline bool is_void(const Point_2& p, const Outline& loop)
{
  const CGAL::Bounded_side right = twice_signed_area(loop) > 0 ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDED_SIDE;
  return CGAL::bounded_side_2(loop.begin(), loop.end(), p) == right;
}

/// Is b the end of a notch of `uncleaned` that is longer than `length`, between sides that turn back at b? Cleaning
/// itself can make what looks like one where a sliver of material was.
inline bool
ends_a_slit(const Point_2& a, const Point_2& b, const Point_2& c, double length, const Outline& uncleaned)
{
  return (a - b) * (c - b) > 0 && CGAL::squared_distance(a, b) > length * length &&
         CGAL::squared_distance(b, c) > length * length && is_void(CGAL::centroid(a, b, c), uncleaned);
}

/// May vertex b, between a and c, be taken out? Where the loop turns left (material lies on its left), that removes the
/// triangle abc; elsewhere it adds it. A slit stays, however narrow: walls of the model stand on both sides of it.
inline bool is_dispensable(const Point_2& a, const Point_2& b, const Point_2& c, const Cleaning_tolerance& tolerance,
                           const Outline& uncleaned)
{
  const double thickness = thickness_of_triangle(a, b, c);
  if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN)
    return thickness <= tolerance.added && !ends_a_slit(a, b, c, tolerance.slit, uncleaned);
  const double shorter = std::sqrt((std::min)(CGAL::squared_distance(a, b), CGAL::squared_distance(b, c)));
  return thickness <= (shorter < tolerance.short_side ? tolerance.short_side : tolerance.removed);
}

/// Takes out vertices as long as one is dispensable.
inline void clean_loop(Outline& loop, const Cleaning_tolerance& tolerance)
{
  const Outline uncleaned = loop;
  std::size_t unchanged = 0; // consecutive vertices that had to stay
  for (std::size_t i = 0; loop.size() >= 3 && unchanged < loop.size();) {
    const std::size_t n = loop.size();
    i %= n;
    if (is_dispensable(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], tolerance, uncleaned)) {
      loop.erase(loop.begin() + std::ptrdiff_t(i));
      i = (i + n - 2) % n; // the predecessor has new neighbours
      unchanged = 0;
    } else {
      ++i;
      ++unchanged;
    }
  }
  if (loop.size() < 3) loop.clear();
}

/// The short bottom bc of a notch between the sides ab and cd, both turned into the material: replaced by the point
/// where the sides meet, if that is near. Removes material.
inline void close_notches(Outline& loop, const Cleaning_tolerance& tolerance)
{
  for (std::size_t i = 0; loop.size() >= 4 && i < loop.size(); ++i) {
    const std::size_t n = loop.size();
    const Point_2 &a = loop[i], &b = loop[(i + 1) % n], &c = loop[(i + 2) % n], &d = loop[(i + 3) % n];
    const double limit = 5 * tolerance.short_side;
    if (CGAL::squared_distance(b, c) > tolerance.short_side * tolerance.short_side ||
        CGAL::orientation(a, b, c) != CGAL::RIGHT_TURN || CGAL::orientation(b, c, d) != CGAL::RIGHT_TURN)
      continue;
    const auto s = b - a, r = c - d; // both towards the bottom
    const double cross = s.x() * r.y() - s.y() * r.x();
    if (cross == 0) continue;
    const auto w = c - b;
    const double beyond_b = (w.x() * r.y() - w.y() * r.x()) / cross, beyond_c = (w.x() * s.y() - w.y() * s.x()) / cross;
    if (!(beyond_b > 0 && beyond_c > 0) || beyond_b * beyond_b * s.squared_length() > limit * limit) continue;
    loop[(i + 1) % n] = b + beyond_b * s;
    loop.erase(loop.begin() + std::ptrdiff_t((i + 2) % n));
  }
}

/// The rounded and cleaned polygon; valid, or with an empty outline if nothing of it is thick enough.
inline Flat_polygon cleaned(const Exact_polygon& polygon, const Cleaning_tolerance& tolerance)
{
  Flat_polygon result;
  result.outline = rounded(polygon.outer_boundary());
  clean_loop(result.outline, tolerance);
  close_notches(result.outline, tolerance);
  if (twice_signed_area(result.outline) <= 0) result.outline.clear();
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
    Outline loop = rounded(*hole);
    clean_loop(loop, tolerance);
    close_notches(loop, tolerance);
    if (!loop.empty() && twice_signed_area(loop) < 0) result.holes.push_back(std::move(loop));
  }
  return result;
}

/// Points where the boundary of `polygon` touches itself, taken out with a square of 20 micrometres.
inline Exact_polygon_set without_pinches(const Exact_polygon& polygon)
{
  std::vector<Point_2> vertices, repeated;
  const auto collect = [&vertices](const Exact_loop& loop) {
    for (const Exact_point_2& p : loop) vertices.push_back(rounded(p));
  };
  collect(polygon.outer_boundary());
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) collect(*hole);
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    if (vertices[i] == vertices[i + 1]) repeated.push_back(vertices[i]);
  Exact_polygon_set set(polygon);
  const double r = 0.01;
  for (const Point_2& p : repeated)
    set.difference(exact_loop({Point_2(p.x() - r, p.y() - r), Point_2(p.x() + r, p.y() - r),
                               Point_2(p.x() + r, p.y() + r), Point_2(p.x() - r, p.y() + r)}));
  return set;
}

/// The pieces of `set`, rounded and cleaned; all valid. What is thinner than a micrometre everywhere disappears.
/// \param lost receives the area of pieces that no cleaning makes valid (none are known)
inline std::vector<Flat_polygon> cleaned_pieces(const Exact_polygon_set& set, double& lost)
{
  std::vector<Flat_polygon> result;
  const auto accept = [&result](const Exact_polygon& polygon) {
    for (const Cleaning_tolerance& tolerance : {Cleaning_tolerance(), Cleaning_tolerance{1e-5, 1e-8, 1e-5, 1e-5}}) {
      Flat_polygon piece = cleaned(polygon, tolerance);
      if (piece.outline.empty()) return true;
      if (!is_valid(piece)) continue;
      result.push_back(std::move(piece));
      return true;
    }
    return false;
  };
  for (const Exact_polygon& polygon : polygons_of(set)) {
    if (accept(polygon)) continue;
    for (const Exact_polygon& part : polygons_of(without_pinches(polygon)))
      if (!accept(part)) lost += area(part);
  }
  return result;
}

/// The same without webs and pinholes narrower than `width`: cutting one may leave others, so it is done until there
/// are none, a few times at most.
inline std::vector<Flat_polygon> cleaned_pieces(const Exact_polygon_set& set, double width, double& lost)
{
  std::vector<Flat_polygon> pieces = cleaned_pieces(set, lost);
  for (int round = 0; round < 4; ++round) {
    std::vector<Flat_polygon> result;
    bool changed = false;
    for (const Flat_polygon& piece : pieces) {
      const std::vector<Exact_loop> cuts = cuts_of_webs(piece, width);
      if (cuts.empty()) {
        result.push_back(piece);
        continue;
      }
      changed = true;
      Exact_polygon_set all, rest(exact_polygon(piece.outline, piece.holes));
      all.join(cuts.begin(), cuts.end());
      rest.difference(all);
      for (Flat_polygon& p : cleaned_pieces(rest, lost)) result.push_back(std::move(p));
    }
    pieces = std::move(result);
    if (!changed) break;
  }
  return pieces;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_OUTLINE_CLEANING_H
