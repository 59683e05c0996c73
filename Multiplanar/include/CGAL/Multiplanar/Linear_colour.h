// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_LINEAR_COLOUR_H
#define CGAL_MULTIPLANAR_LINEAR_COLOUR_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarTextures
/// Red, green and blue proportional to light, 0..1: the only form in which colours may be mixed. Images hold sRGB.
using Linear_colour = std::array<float, 3>;

/// The light that an sRGB value of 0..1 stands for (IEC 61966-2-1).
inline float linear_of_srgb(float value)
{
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// The inverse of `linear_of_srgb()`.
inline float srgb_of_linear(float value)
{
  return value <= 0.0031308f ? value * 12.92f : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

namespace internal {

/// `linear_of_srgb()` of the 256 values of a byte.
inline const std::array<float, 256>& linear_of_bytes()
{
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (int i = 0; i < 256; ++i) t[i] = linear_of_srgb(float(i) / 255);
    return t;
  }();
  return table;
}

/// The sRGB byte nearest to a light of 0..1. A table of the square root's steps finds it within one, a comparison with
/// the lights half-way between bytes settles it: the nearest byte exactly, so that bytes survive the way there and
/// back.
inline std::uint8_t byte_of_linear(float light)
{
  struct Tables
  {
    std::array<float, 257> above{}; // above[i]: the light from which on byte i + 1 is nearer than i
    std::array<std::uint8_t, 4097> guess{};
  };
  static const Tables tables = [] {
    Tables t;
    for (int i = 0; i < 256; ++i) t.above[i] = linear_of_srgb((float(i) + 0.5f) / 255);
    for (int i = 0; i <= 4096; ++i) {
      const float root = float(i) / 4096;
      t.guess[i] = std::uint8_t(std::min(255.f, std::max(0.f, 255 * srgb_of_linear(root * root))));
    }
    return t;
  }();
  const float x = std::min(1.f, std::max(0.f, light));
  int byte = tables.guess[int(std::sqrt(x) * 4096)];
  while (byte < 255 && x >= tables.above[byte]) ++byte;
  while (byte > 0 && x < tables.above[byte - 1]) --byte;
  return std::uint8_t(byte);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_LINEAR_COLOUR_H
