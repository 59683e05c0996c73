// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ENGRAVE_IDS_H
#define CGAL_MULTIPLANAR_ENGRAVE_IDS_H

#include <CGAL/Multiplanar/Sheet.h>
#include <CGAL/Multiplanar/label_placement.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarSheets

Engraves every part's id where the part has most room, upright on its sheet if possible.

\param parts the parts of the model, which get the engravings
\param sheets where the parts lie
\param smallest, largest height of capital letters in mm
\return the ids of the parts too small for letters of `smallest` mm: they stay blank
*/
inline std::vector<std::string> engrave_ids(std::vector<Part>& parts, const std::vector<Sheet>& sheets, double smallest,
                                            double largest)
{
  std::vector<std::string> blank;
  for (const Sheet& sheet : sheets)
    for (const Placement& placement : sheet.placements) {
      Part& part = parts[placement.part];
      const double upright = placement.mirrored ? placement.rotation : -placement.rotation;
      const Engraving label = place_label(part.id, part.outline, part.holes, largest, upright);
      if (label.height >= smallest) part.engraving.push_back(label);
      else blank.push_back(part.id);
    }
  return blank;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ENGRAVE_IDS_H
