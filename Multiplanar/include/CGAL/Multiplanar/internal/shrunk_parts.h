// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SHRUNK_PARTS_H
#define CGAL_MULTIPLANAR_INTERNAL_SHRUNK_PARTS_H

#include <CGAL/Multiplanar/internal/Convex_body.h>
#include <CGAL/Multiplanar/internal/convex_pieces.h>

#include <algorithm>
#include <set>
#include <utility>

// Parts that fit touch each other, and rounded coordinates cannot touch without overlapping a little. So a part is
// compared as a solid that is shrunk by `skin` (5 nanometres, less at slender pieces) where it ends, and stays whole
// where it was only cut into convex pieces. Promise: the solid contains every point of the part farther than `erosion`
// (1 micrometre) from its boundary. What is free for the one is free for the other, which is what `multiplanar verify`
// asks for.

namespace CGAL {
namespace Multiplanar {
namespace internal {

constexpr double skin = 5e-6, erosion = 1e-3; // mm

/// The sides of a part: material lies on the left.
inline std::set<std::pair<Point_2, Point_2>> sides_of(const Part& part)
{
  std::set<std::pair<Point_2, Point_2>> sides;
  const auto add = [&sides](const Outline& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) sides.insert({loop[i], loop[(i + 1) % loop.size()]});
  };
  add(part.outline);
  for (const Outline& hole : part.holes) add(hole);
  return sides;
}

/// The half-plane to the left of the line from a to b, moved to the left by `distance`, cut out of a convex polygon.
inline Outline cut_to_left(const Outline& polygon, const Point_2& a, const Point_2& b, double distance)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::hypot(dx, dy);
  const auto depth = [&](const Point_2& p) {
    return (dx * (p.y() - a.y()) - dy * (p.x() - a.x())) / length - distance;
  };
  Outline result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point_2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double d = depth(p), e = depth(q);
    if (d >= 0) result.push_back(p);
    if ((d > 0 && e < 0) || (d < 0 && e > 0)) result.push_back(p + (d / (d - e)) * (q - p));
  }
  return result.size() < 3 ? Outline() : result;
}

/// Sides of a convex piece of a part, of which some are the part's own (`is_own`) and some are cuts through it.
/// By how much, up to `skin`, may side `i` be moved without taking off more than the erosion of the part does? Where
/// the boundary turns into a cut by a small angle, a strip along the side reaches far along the cut.
inline double skin_of_side(const Outline& piece, const std::vector<bool>& is_own, std::size_t i)
{
  double result = skin;
  const std::size_t n = piece.size();
  const auto direction = [&](std::size_t k) {
    const auto d = piece[(k + 1) % n] - piece[k % n];
    return d / std::sqrt(d.squared_length());
  };
  const auto along = direction(i);
  for (const std::size_t step : {std::size_t(1), n - 1})
    for (std::size_t k = (i + step) % n; k != i; k = (k + step) % n) {
      const auto d = direction(k);
      const double sine = std::abs(along.x() * d.y() - along.y() * d.x());
      if (sine * erosion > 2 * skin || along * d < 0) break;
      if (is_own[k]) continue;
      result = (std::min)(result, sine * erosion / 2);
      break;
    }
  return result;
}

inline Outline shrunk_piece(const Outline& piece, const std::set<std::pair<Point_2, Point_2>>& sides)
{
  std::vector<bool> is_own;
  for (std::size_t i = 0; i < piece.size(); ++i)
    is_own.push_back(sides.count({piece[i], piece[(i + 1) % piece.size()]}) > 0);
  Outline result = piece;
  for (std::size_t i = 0; i < piece.size() && !result.empty(); ++i)
    if (is_own[i])
      result = cut_to_left(result, piece[i], piece[(i + 1) % piece.size()], skin_of_side(piece, is_own, i));
  return result;
}

/// A part as a union of convex bodies, shrunk as said above.
inline Bodies shrunk_part(const Part& part, double thickness)
{
  Bodies result;
  const auto sides = sides_of(part);
  for (const Outline& piece : convex_pieces(part.outline, part.holes)) {
    const Outline shrunk = shrunk_piece(piece, sides);
    if (!shrunk.empty()) result.add(prism_over(shrunk, part.frame, skin, thickness - skin));
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SHRUNK_PARTS_H
