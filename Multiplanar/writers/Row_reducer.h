// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_ROW_REDUCER_H
#define MULTIPLANAR_WRITERS_ROW_REDUCER_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/Linear_colour.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

/// Takes the rows of a picture one after the other and keeps them, reduced by a whole factor if they would be too many.
class Row_reducer
{
public:
  /// \throw std::runtime_error for sizes that make no sense
  Row_reducer(std::size_t width, std::size_t height, std::size_t most_pixels) : source_width(width)
  {
    if (width == 0 || height == 0) throw std::runtime_error("the picture is empty");
    if (height > (std::size_t(1) << 30) / width)
      throw std::runtime_error("the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                               " pixels: more than 2^30");
    while ((width / factor) * (height / factor) > most_pixels) ++factor;
    image = CGAL::Multiplanar::Image(int(std::max<std::size_t>(1, width / factor)),
                                     int(std::max<std::size_t>(1, height / factor)));
    if (factor > 1) sums.assign(4 * std::size_t(image.width), 0);
  }

  /// A row of `width` pixels of red, green, blue, alpha.
  void add(const std::uint8_t* rgba)
  {
    if (row / factor >= std::size_t(image.height)) return; // what is left over at the lower border
    std::uint8_t* out = image.pixel(0, int(row / factor));
    if (factor == 1) std::copy(rgba, rgba + 4 * source_width, out);
    else {
      accumulate(rgba);
      if (row % factor == factor - 1 || image.height == 1) store(out);
    }
    ++row;
  }

  CGAL::Multiplanar::Image take() { return std::move(image); }

private:
  void accumulate(const std::uint8_t* rgba)
  {
    const auto& light = CGAL::Multiplanar::internal::linear_of_bytes();
    for (std::size_t x = 0; x < std::size_t(image.width) * factor && x < source_width; ++x) {
      float* sum = sums.data() + 4 * (x / factor);
      const float alpha = float(rgba[4 * x + 3]);
      for (int c = 0; c < 3; ++c) sum[c] += alpha * light[rgba[4 * x + c]];
      sum[3] += alpha;
    }
  }
  void store(std::uint8_t* out)
  {
    for (std::size_t x = 0; x < std::size_t(image.width); ++x) {
      float* sum = sums.data() + 4 * x;
      for (int c = 0; c < 3; ++c)
        out[4 * x + c] = sum[3] > 0 ? CGAL::Multiplanar::internal::byte_of_linear(sum[c] / sum[3]) : 0;
      out[4 * x + 3] = std::uint8_t(std::min(255.f, sum[3] / float(factor * factor) + 0.5f));
      std::fill(sum, sum + 4, 0.f);
    }
  }

  std::size_t source_width, factor = 1, row = 0;
  CGAL::Multiplanar::Image image;
  std::vector<float> sums;
};

#endif // MULTIPLANAR_WRITERS_ROW_REDUCER_H
