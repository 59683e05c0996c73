// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_HALVE_IMAGE_H
#define CGAL_MULTIPLANAR_INTERNAL_HALVE_IMAGE_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/Linear_colour.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Makes every pixel opaque: what is transparent lets white through, mixed in linear light.
inline void put_on_white(Image& image)
{
  const auto& light = linear_of_bytes();
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const float alpha = float(image.rgba[i + 3]) / 255;
    if (alpha < 1)
      for (int c = 0; c < 3; ++c) image.rgba[i + c] = byte_of_linear(alpha * light[image.rgba[i + c]] + 1 - alpha);
    image.rgba[i + 3] = 255;
  }
}

/// The pixels of a row or column of `n` that pixel `i` of the halved one covers, and the share of each.
struct Halved_pixel
{
  Halved_pixel(int i, int n)
  {
    if (n == 1) return;
    const int half = n / 2;
    first = 2 * i;
    if (n % 2 == 0) {
      count = 2;
      share = {0.5f, 0.5f, 0};
      return;
    }
    // n = 2 half + 1 pixels on `half`: each covers 2 + 1 / half of them, so up to three.
    count = 3;
    const float total = float(n);
    share = {float(half - i) / total, float(half) / total, float(i + 1) / total};
  }

  int first = 0, count = 1;
  std::array<float, 3> share{{1, 0, 0}};
};

/// Half as wide and high (rounded down, at least 1): every pixel is the mean light of the area that it covers.
/// \pre `image` is opaque and not empty
inline Image halved(const Image& image)
{
  Image result((std::max)(1, image.width / 2), (std::max)(1, image.height / 2));
  const auto& light = linear_of_bytes();
  for (int y = 0; y < result.height; ++y) {
    const Halved_pixel rows(y, image.height);
    for (int x = 0; x < result.width; ++x) {
      const Halved_pixel columns(x, image.width);
      Linear_colour sum{};
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i) {
          const std::uint8_t* pixel = image.pixel(columns.first + i, rows.first + j);
          for (int c = 0; c < 3; ++c) sum[c] += rows.share[j] * columns.share[i] * light[pixel[c]];
        }
      std::uint8_t* out = result.pixel(x, y);
      for (int c = 0; c < 3; ++c) out[c] = byte_of_linear(sum[c]);
      out[3] = 255;
    }
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_HALVE_IMAGE_H
