// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IMAGE_H
#define CGAL_MULTIPLANAR_IMAGE_H

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarTextures
/// A picture of eight bits a channel: red, green, blue (sRGB) and alpha (0: transparent), not premultiplied, rows from
/// the top, each from the left.
struct Image
{
  Image() = default;
  /// All pixels transparent black.
  Image(int width, int height) : width(width), height(height), rgba(4 * std::size_t(width) * height, 0) {}

  bool empty() const { return rgba.empty(); } ///< no pixels?
  /// The four bytes of the pixel in column x and row y, both counted from the upper left corner.
  std::uint8_t* pixel(int x, int y)
  {
    CGAL_precondition(x >= 0 && x < width && y >= 0 && y < height);
    return rgba.data() + 4 * (std::size_t(y) * width + x);
  }
  /// The same, to read.
  const std::uint8_t* pixel(int x, int y) const
  {
    CGAL_precondition(x >= 0 && x < width && y >= 0 && y < height);
    return rgba.data() + 4 * (std::size_t(y) * width + x);
  }

  int width = 0;                  ///< in pixels
  int height = 0;                 ///< in pixels
  std::vector<std::uint8_t> rgba; ///< row by row from the top, 4 bytes a pixel: sRGB and opacity
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IMAGE_H
