// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_TEXTURE_SHEET_PDF_H
#define MULTIPLANAR_WRITERS_TEXTURE_SHEET_PDF_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/texture_baking.h>

#include <iosfwd>
#include <vector>

/// The image of a placed part, and where on its sheet it is shown.
struct Printed_part
{
  const CGAL::Multiplanar::Image* image = nullptr; ///< null: nothing is printed
  CGAL::Multiplanar::Texture_grid grid;
  std::vector<CGAL::Multiplanar::Outline> with_bleed; ///< on the sheet: the panel and what is printed around it
  std::vector<CGAL::Multiplanar::Outline> own;        ///< on the sheet: what no other part's bleed may cover
};

/// What is printed for one sheet.
struct Texture_sheet
{
  const CGAL::Multiplanar::Sheet& sheet;
  const CGAL::Multiplanar::Sheet_drawing& drawing; ///< of the sheet as it is cut
  const std::vector<CGAL::Multiplanar::Part>& parts;
  std::vector<Printed_part> printed; ///< by placement
  int number = 1;
};

/*!
Writes two pages of the size of the sheet: the textures with their bleed, and on the same place the cuts and ids; both
with crosses 4 mm from the corners of the sheet.

As it is printed, the pictures read as on the model. Parts lie on a sheet with their inner faces up, so the page shows
the sheet from behind: its cuts are those of the sheet turned over. \p mirrored, the page is that of the sheet as it is
cut, and the pictures are reversed: for transfer, face down on the outer faces. Where parts lie outer face up it is the
other way round.

\throw std::runtime_error when Cairo fails
*/
void write_texture_sheet(std::ostream& out, const Texture_sheet& sheet, bool mirrored);

#endif // MULTIPLANAR_WRITERS_TEXTURE_SHEET_PDF_H
