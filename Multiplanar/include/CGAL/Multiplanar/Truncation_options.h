// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TRUNCATION_OPTIONS_H
#define CGAL_MULTIPLANAR_TRUNCATION_OPTIONS_H

#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Multiplanar/internal/Flat_polygon.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarParts
/// What panels are cut back for. Lengths are in mm.
struct Truncation_options
{
  double thickness = 3; ///< of the sheet, in mm
  double approach =
      -1; ///< way in mm over which a panel must go on along its normal unhindered; negative: thickness + 1
  /// Material narrower than this, in mm, burns away: it is taken off, and pieces of that width (twice area over
  /// perimeter) are dropped; beside a larger piece, those under twice of it too, which break.
  double thinnest = 0.5;
  /// Two panels of this list are cut free of each other over their approach whatever that costs; of any other pair, the
  /// later one is only if it keeps three quarters of its area.
  std::vector<int> freed;
  double smallest = -1; ///< pieces of less area, in mm^2, are dropped; negative: thickness squared

  double approach_length() const { return approach < 0 ? thickness + 1 : approach; } ///< `approach`, or its default
  /// `smallest`, or its default.
  double smallest_area() const { return smallest < 0 ? thickness * thickness : smallest; }
};

/// What truncation left of one panel.
struct Truncated_panel
{
  Frame frame;                      ///< of the outer surface
  std::vector<Flat_polygon> pieces; ///< largest first; none if the panel vanished
  double dropped_area = 0;          ///< of more pieces, too small to be cut, in mm^2
};

/// \ingroup PkgMultiplanarParts
/// The panels of a complex, cut back so that they fit together.
struct Truncation
{
  std::vector<Truncated_panel> panels; ///< as the panels of the complex
  /// The panels from the one that never gives way to the one that always does.
  std::vector<int> order;
  /// Pairs {first, later}: panel `later` was cut free so that it can go on along its normal with `first` in place.
  /// The other way round it would not pass.
  std::vector<std::array<int, 2>> overhangs;
  /// Pairs of which neither can go on along its normal when the other is in place, over the length asked for: cutting
  /// them free would have cost too much.
  std::vector<std::array<int, 2>> blocked;
  std::vector<std::string> warnings; ///< a sentence each: what fell apart or vanished, and what to change
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TRUNCATION_OPTIONS_H
