// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_SALIENCY_IMAGE_H
#define CGAL_MULTIPLANAR_SALIENCY_IMAGE_H

#include <CGAL/Multiplanar/Texture.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The grey value of the texel at (s, t), 0..1 as painted (not as light); transparent is 0; the image repeats.
inline double painted_value(const Image& image, double s, double t)
{
  const double x = s - std::floor(s), y = t - std::floor(t);
  const std::uint8_t* pixel = image.pixel((std::min)(image.width - 1, int(x * image.width)),
                                          image.height - 1 - (std::min)(image.height - 1, int(y * image.height)));
  return (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) / 255 * pixel[3] / 255;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarTextures

The saliency of faces from an image painted in the space of the texture: white means 1, black 0. The value of a face is
the mean of the image over its triangle: of n^2 places evenly spread over it, with n the extent of the triangle in
texels, between 2 and 32. A face without texture points (not finite) has saliency 0.

\param image in the space of the texture, its first row at the top (t = 1)
\param texture_points of the corners of every face
\return by face, in 0..1
\pre the image is not empty
*/
inline std::vector<double> saliency_of_image(const Image& image,
                                             const std::vector<std::array<Texture_point, 3>>& texture_points)
{
  CGAL_precondition(!image.empty());
  std::vector<double> result;
  result.reserve(texture_points.size());
  for (const auto& p : texture_points) {
    double extent = 0;
    for (int i = 0; i < 3; ++i)
      extent = (std::max)({extent, std::abs(double(p[i][0]) - p[(i + 1) % 3][0]) * image.width,
                           std::abs(double(p[i][1]) - p[(i + 1) % 3][1]) * image.height});
    double sum = 0;
    const int n = !(extent > 2) ? 2 : extent > 32 ? 32 : int(std::ceil(extent));
    // The n^2 triangles that parallels to the sides cut it into, each by its middle.
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {
        const double third = j % 2 ? 2. / 3 : 1. / 3, a = (i + third) / n, b = (j / 2 + third) / n, c = 1 - a - b;
        const double s = c * p[0][0] + a * p[1][0] + b * p[2][0], t = c * p[0][1] + a * p[1][1] + b * p[2][1];
        if (std::isfinite(s) && std::isfinite(t)) sum += internal::painted_value(image, s, t);
      }
    result.push_back((std::min)(1., sum / (double(n) * n)));
  }
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_SALIENCY_IMAGE_H
