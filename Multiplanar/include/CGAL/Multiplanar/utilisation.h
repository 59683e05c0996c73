// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_UTILISATION_H
#define CGAL_MULTIPLANAR_UTILISATION_H

#include <CGAL/Multiplanar/Sheet.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSheets
/// How much of the material becomes parts; areas in mm^2.
struct Utilisation
{
  double parts = 0;       ///< area of the parts, holes taken off
  double sheets = 0;      ///< area of all sheets
  double used = 0;        ///< the same, with the last sheet cut off straight across `border` behind its last part
  double used_length = 0; ///< of the last sheet, along its longer side, in mm

  double of_sheets() const { return sheets > 0 ? parts / sheets : 0; } ///< the share of all sheets, 0..1
  double of_used() const { return used > 0 ? parts / used : 0; }       ///< the share of what is used, 0..1
};

/// \ingroup PkgMultiplanarSheets
/// Parts fill a sheet up along its longer side (the width, if it is a square), from the origin.
inline Utilisation utilisation(const std::vector<Sheet>& sheets, const std::vector<Part>& parts, double border = 0)
{
  Utilisation result;
  for (const Sheet& sheet : sheets) {
    const bool along_x = sheet.width >= sheet.height;
    double end = 0;
    for (const Placement& placement : sheet.placements) {
      result.parts += parts[placement.part].area();
      for (const Point_2& p : parts[placement.part].outline) {
        const Point_2 q = placement(p);
        end = (std::max)(end, along_x ? q.x() : q.y());
      }
    }
    const double length = along_x ? sheet.width : sheet.height, across = along_x ? sheet.height : sheet.width;
    result.sheets += length * across;
    result.used_length = (std::min)(length, end + border);
    result.used += (&sheet == &sheets.back() ? result.used_length : length) * across;
  }
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_UTILISATION_H
