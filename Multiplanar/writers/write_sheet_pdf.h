// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_WRITE_SHEET_PDF_H
#define MULTIPLANAR_WRITERS_WRITE_SHEET_PDF_H

#include <CGAL/Multiplanar/Palette.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>

#include <iosfwd>
#include <string>

/// Writes a sheet as one page of its own size: the same lines as in SVG, in the same order and colours, 0.01 mm wide,
/// each cut a closed path. \throw std::runtime_error as Pdf_document
void write_sheet_pdf(std::ostream& out, const CGAL::Multiplanar::Sheet_drawing& sheet,
                     const CGAL::Multiplanar::Palette& palette, const std::string& title);

#endif // MULTIPLANAR_WRITERS_WRITE_SHEET_PDF_H
