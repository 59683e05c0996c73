// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PALETTE_H
#define CGAL_MULTIPLANAR_PALETTE_H

#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSheets
/// The stroke colours by which laser software tells operations apart: all different.
struct Palette
{
  std::string name = "default";    ///< as `--palette` takes it
  std::string engrave = "#000000"; ///< texts and marks
  std::string inner = "#0000ff";   ///< cuts inside of parts: slots and holes
  std::string outer = "#ff0000";   ///< outlines
};

/*!
\ingroup PkgMultiplanarSheets

The palettes to choose from.

 - default: what frees a part is red, inner cuts are blue, engraving is black.
 - lightburn: the colours of LightBurn's layers 00, 01 and 02, which it works through in this order without being told:
   black, blue, red. The same three colours as default, named for those who look for it.
 - score: red cuts, as with many machines, where blue lines are scored and black ones rastered: engraving is blue, inner
   cuts are magenta, outer cuts red.
 - blue-cut: for machines that cut blue lines and engrave red ones: outer cuts are blue, inner cuts cyan, engraving red.
*/
inline const std::vector<Palette>& palettes()
{
  static const std::vector<Palette> table = {{"default", "#000000", "#0000ff", "#ff0000"},
                                             {"lightburn", "#000000", "#0000ff", "#ff0000"},
                                             {"score", "#0000ff", "#ff00ff", "#ff0000"},
                                             {"blue-cut", "#ff0000", "#00ffff", "#0000ff"}};
  return table;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PALETTE_H
