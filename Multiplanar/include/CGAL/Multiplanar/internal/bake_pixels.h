// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_BAKE_PIXELS_H
#define CGAL_MULTIPLANAR_INTERNAL_BAKE_PIXELS_H

#include <CGAL/Multiplanar/Image.h>
#include <CGAL/Multiplanar/internal/Flat_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Some rows of an image while they are painted: sums of light, and the nearest border of the panel.
struct Bake_strip
{
  Bake_strip(int width, int first, int last)
      : width(width), first(first), last(last), light(std::size_t(width) * (last - first), {{0, 0, 0, 0}}),
        distance(light.size(), std::numeric_limits<float>::infinity()), border(light.size(), -1)
  {
  }
  std::size_t at(int i, int j) const { return std::size_t(j - first) * width + i; }

  int width, first, last;                  ///< rows first .. last - 1
  std::vector<std::array<float, 4>> light; ///< sums of red, green, blue and of the weights
  std::vector<float> distance;             ///< squared, in pixels, of the nearest border
  std::vector<int> border;
};

/// The pixels from `low` to `high`, bounded by 0 .. n - 1.
inline std::array<int, 2> pixel_range(double low, double high, int first, int last)
{
  return {int((std::max)(double(first), (std::min)(double(last), std::floor(low)))),
          int((std::max)(double(first), (std::min)(double(last), std::floor(high) + 1)))};
}

/// Adds what a triangle shows to the pixels under it: at samples x samples places a pixel, as many as texels lie along
/// it (at most 8), or two where only colours vary.
inline void paint_triangle(const Flat_triangle& t, const Surface_appearance& looks, Bake_strip& strip)
{
  if (!t.has_area()) return;
  const double texels = t.texels_per_pixel(looks);
  const int samples = !looks.texture(t.face) ? 2 : int((std::min)(8., (std::max)(1., std::ceil(texels - 1e-9))));
  const double footprint = texels / samples;
  const float weight = 1.f / float(samples * samples);
  const auto rows =
      pixel_range((std::min)({t.y[0], t.y[1], t.y[2]}), (std::max)({t.y[0], t.y[1], t.y[2]}), strip.first, strip.last);
  const auto columns =
      pixel_range((std::min)({t.x[0], t.x[1], t.x[2]}), (std::max)({t.x[0], t.x[1], t.x[2]}), 0, strip.width);
  const double inside = -1e-9; // places on a side count for both triangles
  for (int j = rows[0]; j < rows[1]; ++j)
    for (int i = columns[0]; i < columns[1]; ++i)
      for (int b = 0; b < samples; ++b)
        for (int a = 0; a < samples; ++a) {
          const std::array<double, 3> c = t.coordinates(i + (a + 0.5) / samples, j + (b + 0.5) / samples);
          if (c[0] < inside || c[1] < inside || c[2] < inside) continue;
          const Linear_colour colour = looks(t.face, c, footprint);
          std::array<float, 4>& sum = strip.light[strip.at(i, j)];
          for (int k = 0; k < 3; ++k) sum[k] += weight * colour[k];
          sum[3] += weight;
        }
}

/// The point of a border nearest to (px, py): its place along the side, 0..1, and its squared distance.
inline std::array<double, 2> nearest_on_border(const Flat_triangle& t, int side, double px, double py)
{
  const int next = (side + 1) % 3;
  const double ax = t.x[side], ay = t.y[side], dx = t.x[next] - ax, dy = t.y[next] - ay, length = dx * dx + dy * dy;
  const double s = length > 0 ? (std::min)(1., (std::max)(0., ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
  const double ex = ax + s * dx - px, ey = ay + s * dy - py;
  return {s, ex * ex + ey * ey};
}

/// Notes for the pixels around a border that it is near.
inline void reach_from_border(const Flat_triangles& flat, int number, double bleed, Bake_strip& strip)
{
  const Border& border = flat.borders[number];
  const Flat_triangle& t = flat.triangles[border.triangle];
  const int next = (border.side + 1) % 3;
  const double reach = bleed + 2;
  const auto rows = pixel_range((std::min)(t.y[border.side], t.y[next]) - reach,
                                (std::max)(t.y[border.side], t.y[next]) + reach, strip.first, strip.last);
  const auto columns = pixel_range((std::min)(t.x[border.side], t.x[next]) - reach,
                                   (std::max)(t.x[border.side], t.x[next]) + reach, 0, strip.width);
  for (int j = rows[0]; j < rows[1]; ++j)
    for (int i = columns[0]; i < columns[1]; ++i) {
      const float d = float(nearest_on_border(t, border.side, i + 0.5, j + 0.5)[1]);
      const std::size_t at = strip.at(i, j);
      if (d < strip.distance[at]) strip.distance[at] = d, strip.border[at] = number;
    }
}

/// What the panel shows at the point of a border nearest to the centre of a pixel.
inline Linear_colour colour_beyond(const Flat_triangles& flat, const Surface_appearance& looks, int number, int i,
                                   int j)
{
  const Border& border = flat.borders[number];
  const Flat_triangle& t = flat.triangles[border.triangle];
  const double s = nearest_on_border(t, border.side, i + 0.5, j + 0.5)[0];
  std::array<double, 3> c{{0, 0, 0}};
  c[border.side] = 1 - s;
  c[(border.side + 1) % 3] = s;
  return looks(t.face, c, t.has_area() ? t.texels_per_pixel(looks) : 1);
}

inline void write_strip(const Flat_triangles& flat, const Surface_appearance& looks, double bleed,
                        const Bake_strip& strip, Image& image)
{
  for (int j = strip.first; j < strip.last; ++j)
    for (int i = 0; i < strip.width; ++i) {
      const std::size_t at = strip.at(i, j);
      const std::array<float, 4>& sum = strip.light[at];
      Linear_colour colour;
      if (sum[3] > 0) colour = {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
      else if (strip.border[at] >= 0 && strip.distance[at] <= float((bleed + 1) * (bleed + 1)))
        colour = colour_beyond(flat, looks, strip.border[at], i, j);
      else continue;
      std::uint8_t* pixel = image.pixel(i, j);
      for (int c = 0; c < 3; ++c) pixel[c] = byte_of_linear(colour[c]);
      pixel[3] = 255;
    }
}

/// Paints an image, strip by strip so that little memory is needed. \param bleed in pixels
inline Image bake_pixels(const Flat_triangles& flat, const Surface_appearance& looks, int width, int height,
                         double bleed)
{
  Image image(width, height);
  const int rows = (std::max)(1, int(4000000 / (std::max)(1, width)));
  for (int first = 0; first < height; first += rows) {
    Bake_strip strip(width, first, (std::min)(height, first + rows));
    for (const Flat_triangle& t : flat.triangles) paint_triangle(t, looks, strip);
    for (int b = 0; b < int(flat.borders.size()); ++b) reach_from_border(flat, b, bleed, strip);
    write_strip(flat, looks, bleed, strip, image);
  }
  return image;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_BAKE_PIXELS_H
