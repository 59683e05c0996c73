// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TEXTURE_DISTORTION_H
#define CGAL_MULTIPLANAR_TEXTURE_DISTORTION_H

#include <CGAL/Multiplanar/internal/Flat_triangles.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarTextures
/// A value that half of the area stays below, and one that 95 % of it do.
struct Quantiles
{
  double median = 1; ///< half of the area is below
  double p95 = 1;    ///< 95 % of the area are below
};

/// \ingroup PkgMultiplanarTextures
/// How the panels stretch what the source shows, by the singular values s1 >= s2 of each triangle's linear map from the
/// source to the panel; 1 is no change of length.
struct Texture_distortion
{
  Quantiles largest;    ///< of s1
  Quantiles smallest;   ///< of 1 / s2
  Quantiles distortion; ///< of max(s1, 1 / s2)
};

namespace internal {

/// The coordinates of the edges of a triangle in its plane: (a, 0) and (b, c), c >= 0.
inline std::array<double, 3> flat_edges(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const Vector_3 e = q - p, f = r - p;
  const double a = std::sqrt(e.squared_length());
  return {a, a > 0 ? e * f / a : 0, a > 0 ? std::sqrt(CGAL::cross_product(e, f).squared_length()) / a : 0};
}

/// The singular values of the linear map between two triangles, the larger first; infinite where the source is flat.
inline std::array<double, 2> stretch(const std::array<Point_3, 3>& source, const std::array<Point_3, 3>& target)
{
  const auto s = flat_edges(source[0], source[1], source[2]), t = flat_edges(target[0], target[1], target[2]);
  if (!(s[0] > 0 && s[2] > 0)) return {std::numeric_limits<double>::infinity(), 0};
  // J ((s0, s1), (0, s2)) = ((t0, t1), (0, t2)), upper triangular as both are.
  const double a = t[0] / s[0], d = t[2] / s[2], b = (t[1] - a * s[1]) / s[2];
  return {largest_singular_value(a, b, 0, d), smallest_singular_value(a, b, 0, d)};
}

/// The values below which half and 95 % of the weight lie. Reorders `values`.
inline Quantiles weighted_quantiles(std::vector<std::pair<double, double>>& values)
{
  Quantiles result;
  std::sort(values.begin(), values.end());
  double total = 0, sum = 0;
  for (const auto& v : values) total += v.second;
  bool has_median = false;
  for (const auto& v : values) {
    sum += v.second;
    if (!has_median && sum >= 0.5 * total) result.median = v.first, has_median = true;
    result.p95 = v.first;
    if (sum >= 0.95 * total) break;
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarTextures

Distortion over the area of the source.

\param triangles triples of vertices, the same before and after
\param source, target positions of the vertices before and after
\param scale by which the target is larger as a whole: that is no distortion
\pre `scale` > 0; as many source as target points
*/
inline Texture_distortion texture_distortion(const std::vector<std::array<int, 3>>& triangles, const Points& source,
                                             const Points& target, double scale = 1)
{
  CGAL_precondition(scale > 0 && source.size() == target.size());
  std::vector<std::pair<double, double>> largest, smallest, both;
  for (const auto& t : triangles) {
    const std::array<Point_3, 3> from = {source[t[0]], source[t[1]], source[t[2]]},
                                 to = {target[t[0]], target[t[1]], target[t[2]]};
    const std::array<double, 2> s = internal::stretch(from, to);
    const double area = std::sqrt(CGAL::cross_product(from[1] - from[0], from[2] - from[0]).squared_length()) / 2;
    const double longer = s[0] / scale, shorter = scale / s[1];
    largest.emplace_back(longer, area);
    smallest.emplace_back(shorter, area);
    both.emplace_back((std::max)(longer, shorter), area);
  }
  return {internal::weighted_quantiles(largest), internal::weighted_quantiles(smallest),
          internal::weighted_quantiles(both)};
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TEXTURE_DISTORTION_H
