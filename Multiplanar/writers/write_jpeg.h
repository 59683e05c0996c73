// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_WRITE_JPEG_H
#define MULTIPLANAR_WRITERS_WRITE_JPEG_H

#include <CGAL/Multiplanar/Image.h>

#include <string>

/// The bytes of a JPEG file that shows an image, alpha left out. \throw std::runtime_error when libjpeg fails
std::string jpeg_of(const CGAL::Multiplanar::Image& image, int quality = 85);

#endif // MULTIPLANAR_WRITERS_WRITE_JPEG_H
