// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_SHEET_H
#define CGAL_MULTIPLANAR_SHEET_H

#include <CGAL/Multiplanar/Part.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// Where a part lies on a sheet: mirrored (x -> -x) if so, then rotated by `rotation` degrees, then shifted to (x, y).
struct Placement
{
  int part = -1; ///< position in the list of parts
  double x = 0;  ///< of the part's origin on the sheet, in mm
  double y = 0;  ///< upward
  double rotation = 0;   ///< in degrees, counter-clockwise
  bool mirrored = false; ///< x -> -x first

  /// From the part to the sheet: mirrored, then turned, then moved.
  Point_2 operator()(const Point_2& p) const
  {
    const double a = rotation * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
    const double px = mirrored ? -p.x() : p.x();
    return Point_2(c * px - s * p.y() + x, s * px + c * p.y() + y);
  }
};

/// A rectangle of material with its parts; the lower left corner is the origin, y points upward, lengths are in mm.
struct Sheet
{
  double width = 0;                  ///< in mm
  double height = 0;                 ///< in mm
  std::vector<Placement> placements; ///< each part at most once
};

/// How parts are laid on sheets.
struct Sheet_options
{
  double width = 600;   ///< of a sheet, in mm
  double height = 400;  ///< of a sheet, in mm
  double border = 5;    ///< free margin along the edge of a sheet
  double gap = 1;       ///< material left between two parts, in mm
  double kerf = 0;      ///< full width of the cut
  double fit = 0;       ///< how much wider than its slot a tab is cut, in mm
  bool mirrored = true; ///< parts lie inner face up

  int rotations = 16;   ///< a part is tried at so many angles, equal steps apart, the first with its flattest box
  int insertions = 300; ///< the search for a denser nest lays so many parts anew; 0: no search
  double seconds = -1;  ///< if not negative, the search ends after this time instead
  int threads = 0;      ///< of the search; 0: all that the machine has
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_SHEET_H
