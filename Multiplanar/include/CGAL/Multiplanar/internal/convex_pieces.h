// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_H
#define CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_H

#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// No corner turns right; straight corners are allowed.
inline bool is_convex(const Outline& polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (CGAL::orientation(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) == CGAL::RIGHT_TURN) return false;
  return true;
}

/// The polygon that two pieces form when the side (a, b) of `left`, which is the side (b, a) of `right`, is taken out.
inline Outline merged_across(const Outline& left, const Outline& right, const Point_2& a, const Point_2& b)
{
  Outline result;
  const auto append_from = [&result](const Outline& piece, const Point_2& first) {
    const std::size_t start = std::find(piece.begin(), piece.end(), first) - piece.begin();
    for (std::size_t i = 0; i + 1 < piece.size(); ++i) result.push_back(piece[(start + i) % piece.size()]);
  };
  append_from(left, b);
  append_from(right, a);
  return result;
}

/// Takes out diagonals between pieces as long as what results is convex (Hertel and Mehlhorn, 1983: at most four times
/// the least number of pieces).
inline void merge_convex(std::vector<Outline>& pieces)
{
  std::map<std::pair<Point_2, Point_2>, int> piece_left_of;
  const auto enter = [&](int i) {
    for (std::size_t k = 0; k < pieces[i].size(); ++k)
      piece_left_of[{pieces[i][k], pieces[i][(k + 1) % pieces[i].size()]}] = i;
  };
  for (int i = 0; i < int(pieces.size()); ++i) enter(i);
  const auto sides = piece_left_of; // a copy: the map changes below
  for (const auto& side : sides) {
    const auto opposite = std::make_pair(side.first.second, side.first.first);
    if (!(side.first < opposite)) continue;
    const auto left = piece_left_of.find(side.first), right = piece_left_of.find(opposite);
    if (left == piece_left_of.end() || right == piece_left_of.end() || left->second == right->second) continue;
    const int i = left->second, j = right->second;
    Outline merged = merged_across(pieces[i], pieces[j], side.first.first, side.first.second);
    if (!is_convex(merged)) continue;
    pieces[i] = std::move(merged);
    pieces[j].clear();
    piece_left_of.erase(side.first);
    piece_left_of.erase(opposite);
    enter(i);
  }
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [](const Outline& p) { return p.empty(); }), pieces.end());
}

/// A polygon with holes cut into convex polygons at diagonals between its vertices.
inline std::vector<Outline> convex_pieces(const Outline& outline, const std::vector<Outline>& holes)
{
  if (holes.empty() && is_convex(outline)) return {outline};
  using Loop = CGAL::Polygon_2<Kernel>;
  CGAL::Polygon_with_holes_2<Kernel> polygon(Loop(outline.begin(), outline.end()));
  for (const Outline& hole : holes) polygon.add_hole(Loop(hole.begin(), hole.end()));
  std::vector<Loop> triangles;
  CGAL::Polygon_triangulation_decomposition_2<Kernel>()(polygon, std::back_inserter(triangles));
  std::vector<Outline> pieces;
  for (const Loop& t : triangles) {
    pieces.emplace_back(t.vertices_begin(), t.vertices_end());
    if (t.orientation() == CGAL::CLOCKWISE) std::reverse(pieces.back().begin(), pieces.back().end());
  }
  merge_convex(pieces);
  return pieces;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONVEX_PIECES_H
