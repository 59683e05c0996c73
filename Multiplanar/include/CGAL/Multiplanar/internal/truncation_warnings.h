// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_WARNINGS_H
#define CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_WARNINGS_H

#include <CGAL/Multiplanar/Truncation_options.h>
#include <CGAL/Multiplanar/Model.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// "P07", or "P07a", "P07b", ... if the panel fell apart into several pieces.
inline std::string piece_id(const Panel_complex& complex, int panel, std::size_t piece, std::size_t pieces)
{
  std::string id = panel_id(complex, panel);
  if (pieces < 2) return id;
  std::string letters; // a .. z, aa, ab, ...
  for (std::size_t i = piece + 1; i > 0; i = (i - 1) / 26) letters.insert(letters.begin(), char('a' + (i - 1) % 26));
  return id + letters;
}

namespace internal {

/// Twice the area over the length of all loops: the width of a long strip.
inline double strip_width(const Flat_polygon& polygon)
{
  double perimeter = 0;
  for_each_side(polygon,
                [&](const Point_2& a, const Point_2& b) { perimeter += std::sqrt(CGAL::squared_distance(a, b)); });
  return perimeter > 0 ? 2 * polygon.area() / perimeter : 0;
}

/// Sorts the pieces by area, largest first, and drops those too small to be cut; beside a larger piece also those so
/// narrow that they break. Crumbs are ordinary waste: wherever three panels meet at obtuse angles, the one that gives
/// way is left with one between the other two. \return the area dropped
inline double drop_small_pieces(const Truncation_options& options, std::vector<Flat_polygon>& pieces)
{
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Flat_polygon& a, const Flat_polygon& b) { return a.area() > b.area(); });
  std::vector<Flat_polygon> kept;
  double dropped = 0;
  for (Flat_polygon& piece : pieces) {
    const double narrowest = kept.empty() ? options.thinnest : 2 * options.thinnest;
    if (piece.area() >= options.smallest_area() && strip_width(piece) >= narrowest) kept.push_back(std::move(piece));
    else dropped += piece.area();
  }
  pieces = std::move(kept);
  return dropped;
}

inline std::string in_mm(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// What a user must hear about panel `p`, if anything.
inline void warn_about_panel(const Panel_complex& complex, const Truncation_options& options, int p, Truncation& result)
{
  const Truncated_panel& panel = result.panels[p];
  const std::string id = panel_id(complex, p), t = in_mm(options.thickness) + " mm";
  const std::string advice = ": use a larger size, a thinner sheet or fewer panels";
  if (panel.pieces.empty()) {
    result.warnings.push_back(id + " (" + in_mm(complex.area(p)) + " mm2) vanishes: at a thickness of " + t +
                              " its neighbours take all of its room" + advice);
    return;
  }
  if (panel.pieces.size() > 1) {
    std::string names;
    for (std::size_t i = 0; i < panel.pieces.size(); ++i)
      names += (i ? ", " : "") + piece_id(complex, p, i, panel.pieces.size());
    result.warnings.push_back(id + " falls apart into " + std::to_string(panel.pieces.size()) + " pieces (" + names +
                              ") at a thickness of " + t + advice + " to keep it whole");
  }
  if (panel.dropped_area > (std::max)(options.smallest_area(), complex.area(p) / 20))
    result.warnings.push_back(id + " loses " + in_mm(panel.dropped_area) + " of " + in_mm(complex.area(p)) +
                              " mm2 in pieces too small to be cut (under " + in_mm(options.smallest_area()) +
                              " mm2 or " + in_mm(options.thinnest) + " mm wide)" + advice + " to keep them");
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_WARNINGS_H
