// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TEXTURE_H
#define CGAL_MULTIPLANAR_TEXTURE_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/Linear_colour.h>
#include <CGAL/Multiplanar/internal/halve_image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarTextures
/// A place in a texture: (0, 0) is its lower left corner, (1, 1) its upper right one.
using Texture_point = std::array<float, 2>;

/// \ingroup PkgMultiplanarTextures
/// What a texture shows beyond 0..1.
enum class Texture_wrap
{
  repeat, ///< itself again
  clamp,  ///< the texels of its border
  mirror  ///< itself again, every other time reflected
};

/*!
\ingroup PkgMultiplanarTextures

An image to be looked up at any place and with any width of the filter: a pyramid of images, each half as wide and high
as the one before, mixed in linear light. Where the image is transparent, white shows through.

Takes 4/3 of the memory of the image.
*/
class Texture
{
public:
  /// \pre the image is not empty
  explicit Texture(Image image, Texture_wrap wrap_s = Texture_wrap::repeat, Texture_wrap wrap_t = Texture_wrap::repeat)
      : wrap_s(wrap_s), wrap_t(wrap_t)
  {
    CGAL_precondition(!image.empty());
    internal::put_on_white(image);
    levels.push_back(std::move(image));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(internal::halved(levels.back()));
  }

  int width() const { return levels[0].width; }   ///< in texels
  int height() const { return levels[0].height; } ///< in texels

  /// The mean light around (s, t), over about `footprint` texels in each direction (bilinear in the two nearest levels
  /// of the pyramid); exactly bilinear for a footprint of at most 1. Constant time.
  Linear_colour operator()(double s, double t, double footprint = 1) const
  {
    if (!(footprint > 1)) return bilinear(0, s, t);
    const double level = (std::min)(std::log2(footprint), double(levels.size() - 1));
    const int low = int(level);
    const float f = float(level - low);
    const Linear_colour a = bilinear(low, s, t);
    if (f == 0) return a;
    const Linear_colour b = bilinear(low + 1, s, t);
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
  }

private:
  /// The texel that stands at position `i` of a row or column of `n`.
  static int wrapped(long long i, int n, Texture_wrap wrap)
  {
    if (i >= 0 && i < n) return int(i);
    if (wrap == Texture_wrap::clamp) return i < 0 ? 0 : n - 1;
    const long long period = wrap == Texture_wrap::mirror ? 2 * (long long)(n) : n;
    long long j = i % period;
    if (j < 0) j += period;
    return int(j < n ? j : period - 1 - j);
  }

  /// Whole repetitions taken away, so that coordinates of any size become positions; two periods stay for mirroring.
  static double reduced(double x, Texture_wrap wrap)
  {
    if (!std::isfinite(x)) return 0;
    if (wrap == Texture_wrap::clamp) return (std::min)(2., (std::max)(-1., x));
    return x - 2 * std::floor(x / 2);
  }

  Linear_colour bilinear(int level, double s, double t) const
  {
    const Image& image = levels[level];
    const double x = reduced(s, wrap_s) * image.width - 0.5, y = (1 - reduced(t, wrap_t)) * image.height - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const float fx = float(x - x0), fy = float(y - y0);
    const int xs[2] = {wrapped((long long)(x0), image.width, wrap_s),
                       wrapped((long long)(x0) + 1, image.width, wrap_s)};
    const int ys[2] = {wrapped((long long)(y0), image.height, wrap_t),
                       wrapped((long long)(y0) + 1, image.height, wrap_t)};
    const auto& light = internal::linear_of_bytes();
    Linear_colour result{};
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const float weight = (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
        const std::uint8_t* texel = image.pixel(xs[i], ys[j]);
        for (int c = 0; c < 3; ++c) result[c] += weight * light[texel[c]];
      }
    return result;
  }

  std::vector<Image> levels;
  Texture_wrap wrap_s, wrap_t;
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TEXTURE_H
