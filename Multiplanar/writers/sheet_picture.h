// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_SHEET_PICTURE_H
#define MULTIPLANAR_WRITERS_SHEET_PICTURE_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/Linear_colour.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>

#include <functional>
#include <string>

/// A sheet as it is cut, parts in their colours, ids legible; about `width` pixels wide.
/// \param colour_of the colour of the part with this id
CGAL::Multiplanar::Image
sheet_picture(const CGAL::Multiplanar::Sheet_drawing& drawing, int width,
              const std::function<CGAL::Multiplanar::Linear_colour(const std::string&)>& colour_of);

#endif // MULTIPLANAR_WRITERS_SHEET_PICTURE_H
