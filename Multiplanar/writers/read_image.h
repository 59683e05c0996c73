// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_READ_IMAGE_H
#define MULTIPLANAR_WRITERS_READ_IMAGE_H

#include <CGAL/Multiplanar/Image.h>

#include <string_view>

/// The picture in a PNG or JPEG file of any depth and kind of colour. One of more than `most_pixels` is reduced on the
/// way by a whole factor in both directions, each pixel the mean light of those that it stands for, so that little more
/// memory is needed than for the result.
/// \throw std::runtime_error that says what is wrong: another format, damaged, or more than 2^30 pixels
CGAL::Multiplanar::Image read_image(std::string_view bytes, std::size_t most_pixels = std::size_t(1) << 26);

#endif // MULTIPLANAR_WRITERS_READ_IMAGE_H
