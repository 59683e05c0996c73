// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_WRITE_PNG_H
#define MULTIPLANAR_WRITERS_WRITE_PNG_H

#include <CGAL/Multiplanar/Image.h>

#include <iosfwd>

/// Writes an image as PNG, without alpha if every pixel is opaque. The same image gives the same bytes. The caller
/// checks the state of `out` afterwards.
/// \param pixels_per_mm noted in the file, so that programs print it at true size; 0: unknown
/// \throw std::runtime_error when libpng fails for another reason than the stream
void write_png(std::ostream& out, const CGAL::Multiplanar::Image& image, double pixels_per_mm = 0);

#endif // MULTIPLANAR_WRITERS_WRITE_PNG_H
