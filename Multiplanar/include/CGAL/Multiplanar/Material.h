// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_MATERIAL_H
#define CGAL_MULTIPLANAR_MATERIAL_H

#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSheets
/// A sheet material and how it is cut; all in mm.
struct Material
{
  const char* name; ///< as `--material` takes it
  double thickness; ///< of the sheet, in mm
  double kerf; ///< full width of the cut
  double fit;  ///< by how much a tab is wider than its slot
};

/*!
\ingroup PkgMultiplanarSheets

Presets to start from. Machines differ and stock varies by a tenth in thickness: a cut of the fit test says more.

Kerfs are the middles of the ranges that users of laser cutters report for stock of this thickness: acrylic 0.15-0.23
(3 mm) and 0.18-0.25 (6 mm), MDF 0.15-0.18 and 0.20-0.22, birch and poplar plywood 0.20 and 0.25, cardboard 0.12-0.19
(one range for both).

Fits: wood gives and is pressed, 0.025-0.05 mm a side; thin wood gives more easily than thick, so 3 mm takes the upper
end, 6 mm the lower one (in 6 mm plywood a slot 0.05 mm narrower than another already needs a hammer). Acrylic breaks
where it is pressed: none, the parts are glued. Cardboard is crushed rather than bent; it takes the upper end of wood.
*/
inline const std::vector<Material>& materials()
{
  static const std::vector<Material> table = {
      {"plywood-3", 3, 0.20, 0.10},    {"plywood-6", 6, 0.25, 0.05},    {"mdf-3", 3, 0.165, 0.10},
      {"mdf-6", 6, 0.21, 0.05},        {"acrylic-3", 3, 0.19, 0},       {"acrylic-6", 6, 0.215, 0},
      {"cardboard-3", 3, 0.155, 0.10}, {"cardboard-6", 6, 0.155, 0.10},
  };
  return table;
}

/// \ingroup PkgMultiplanarSheets
/// The preset of that name, in any case of letters, or null; "plywood" alone is its 3 mm stock.
inline const Material* find_material(std::string name)
{
  for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const Material& material : materials())
    if (name == material.name || name + "-3" == material.name) return &material;
  return nullptr;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_MATERIAL_H
