// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Frame_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

/// Light that falls on a face: a sky that is brighter above, a soft key light, a weak one from the other side.
double light_on(const Vector_3& normal, const Camera& camera, const Vector_3& up)
{
  const Vector_3 key = (-0.45 * camera.right + 0.75 * camera.up + 0.85 * camera.back) / 1.22;
  const Vector_3 fill = (0.8 * camera.right + 0.1 * camera.up + 0.5 * camera.back) / 0.95;
  const double half_lambert = 0.5 + 0.5 * (normal * key); // no hard border between light and shade
  return 0.24 + 0.14 * (normal * up) + 0.66 * half_lambert * half_lambert + 0.14 * std::max(0., normal * fill);
}

std::uint8_t byte_of(float light)
{
  static const std::array<std::uint8_t, 4097> table = [] {
    std::array<std::uint8_t, 4097> t{};
    for (int i = 0; i <= 4096; ++i) t[i] = internal::byte_of_linear(float(i) / 4096);
    return t;
  }();
  return table[int(std::min(1.f, std::max(0.f, light)) * 4096)];
}

/// A quantity that is linear in the picture: value at (0, 0) and growth along x and y.
struct Plane_function
{
  double at(double x, double y) const { return c + dx * x + dy * y; }
  double c = 0, dx = 0, dy = 0;
};

/// A triangle in the coordinates of the samples.
struct Flat_triangle
{
  Flat_triangle(const Camera& camera, const Scene_triangle& t, int samples)
  {
    for (int i = 0; i < 3; ++i) {
      const Camera::Projected p = camera(t.points[i]);
      x[i] = p.x * samples, y[i] = p.y * samples, inverse[i] = p.inverse_depth;
    }
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  }
  bool is_drawable() const
  {
    return inverse[0] > 0 && inverse[1] > 0 && inverse[2] > 0 && std::isfinite(area) && area != 0;
  }
  /// The linear function with these values at the corners.
  Plane_function function(double a, double b, double c) const
  {
    Plane_function f;
    f.dx = ((b - a) * (y[2] - y[0]) - (c - a) * (y[1] - y[0])) / area;
    f.dy = ((c - a) * (x[1] - x[0]) - (b - a) * (x[2] - x[0])) / area;
    f.c = a - f.dx * x[0] - f.dy * y[0];
    return f;
  }
  /// The samples of row `j` whose centres lie inside: [first, last).
  std::array<int, 2> span(int j, int width) const
  {
    const double centre = j + 0.5;
    double low = 1e300, high = -1e300;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if ((y[k] <= centre) == (y[l] <= centre)) continue;
      const double at = x[k] + (centre - y[k]) / (y[l] - y[k]) * (x[l] - x[k]);
      low = std::min(low, at), high = std::max(high, at);
    }
    if (low > high) return {0, 0};
    return {int(std::ceil(std::min(double(width), std::max(0., low - 0.5)))),
            int(std::ceil(std::min(double(width), std::max(0., high - 0.5))))};
  }

  double x[3], y[3], inverse[3], area;
};

/// Light and texture coordinates over the depth, which are linear in the picture.
struct Shader
{
  Shader(const Flat_triangle& flat, const Scene_triangle& t, const std::array<double, 3>& light) : texture(t.texture)
  {
    for (int c = 0; c < 3; ++c)
      colour[c] =
          flat.function(flat.inverse[0] * light[0] * t.colours[0][c], flat.inverse[1] * light[1] * t.colours[1][c],
                        flat.inverse[2] * light[2] * t.colours[2][c]);
    if (!texture) return;
    for (int i = 0; i < 2; ++i)
      place[i] = flat.function(flat.inverse[0] * t.texture_points[0][i], flat.inverse[1] * t.texture_points[1][i],
                               flat.inverse[2] * t.texture_points[2][i]);
    const auto& q = t.texture_points;
    const double area = (q[1][0] - q[0][0]) * (q[2][1] - q[0][1]) - (q[2][0] - q[0][0]) * (q[1][1] - q[0][1]);
    footprint = std::sqrt(std::abs(area * texture->width() * texture->height() / flat.area));
  }

  void shade(double x, double y, double inverse, std::uint8_t* rgb) const
  {
    Linear_colour light;
    for (int c = 0; c < 3; ++c) light[c] = float(colour[c].at(x, y) / inverse);
    if (texture) {
      const Linear_colour texel = (*texture)(place[0].at(x, y) / inverse, place[1].at(x, y) / inverse, footprint);
      for (int c = 0; c < 3; ++c) light[c] *= texel[c];
    }
    for (int c = 0; c < 3; ++c) rgb[c] = byte_of(light[c]);
  }

  const Texture* texture;
  Plane_function colour[3], place[2];
  double footprint = 1;
};

} // namespace

void draw_triangle(Frame_buffer& buffer, const Band& band, const Camera& camera, const Scene_triangle& t,
                   const Vector_3& up)
{
  const Flat_triangle flat(camera, t, buffer.samples);
  if (!flat.is_drawable()) return;
  const double top = std::min({flat.y[0], flat.y[1], flat.y[2]}), bottom = std::max({flat.y[0], flat.y[1], flat.y[2]});
  if (bottom < band.first || top > band.last) return;
  const bool backside = flat.area > 0; // rows run downward
  std::array<double, 3> light;
  for (int i = 0; i < 3; ++i) light[i] = light_on(backside ? -t.normals[i] : t.normals[i], camera, up);
  const Plane_function depth = flat.function(flat.inverse[0], flat.inverse[1], flat.inverse[2]);
  const Shader shader(flat, t, light);
  const int begin = std::max(band.first, int(std::floor(top))), end = std::min(band.last, int(std::ceil(bottom)) + 1);
  for (int j = begin; j < end; ++j) {
    const std::array<int, 2> span = flat.span(j, buffer.width);
    for (int i = span[0]; i < span[1]; ++i) {
      const double inverse = depth.at(i + 0.5, j + 0.5);
      const std::size_t sample = std::size_t(j) * buffer.width + i;
      if (!(inverse > double(buffer.inverse_depth[sample]))) continue;
      buffer.inverse_depth[sample] = float(inverse);
      shader.shade(i + 0.5, j + 0.5, inverse, buffer.rgb.data() + 3 * sample);
    }
  }
}

void draw_line(Frame_buffer& buffer, const Band& band, const Camera& camera, const Scene_line& line, double bias)
{
  const Camera::Projected p = camera(line.a), q = camera(line.b);
  if (!(p.inverse_depth > 0 && q.inverse_depth > 0)) return;
  const double n = buffer.samples, half = line.width * n / 2;
  const double ax = p.x * n, ay = p.y * n, dx = (q.x - p.x) * n, dy = (q.y - p.y) * n, length = dx * dx + dy * dy;
  const int first = std::max(band.first, int(std::min(ay, ay + dy) - half)),
            last = std::min(band.last, int(std::max(ay, ay + dy) + half) + 2);
  std::uint8_t rgb[3];
  for (int c = 0; c < 3; ++c) rgb[c] = byte_of(line.colour[c]);
  for (int j = first; j < last; ++j) {
    // The part of the line that can reach this row, then all samples near it.
    double t0 = 0, t1 = 1;
    if (std::abs(dy) > 1e-9) {
      t0 = (j + 0.5 - half - ay) / dy, t1 = (j + 0.5 + half - ay) / dy;
      if (t0 > t1) std::swap(t0, t1);
      t0 = std::max(0., t0), t1 = std::min(1., t1);
      if (t0 > t1) continue;
    }
    // A steep line is `half` wide along the row, a flat one reaches further.
    const double low = std::min(ax + t0 * dx, ax + t1 * dx) - half, high = std::max(ax + t0 * dx, ax + t1 * dx) + half;
    const int begin = std::max(0, int(low)), end = std::min(buffer.width, int(std::max(0., high)) + 2);
    for (int i = begin; i < end; ++i) {
      const double px = i + 0.5 - ax, py = j + 0.5 - ay;
      const double t = length > 0 ? std::min(1., std::max(0., (px * dx + py * dy) / length)) : 0;
      const double ex = px - t * dx, ey = py - t * dy;
      if (ex * ex + ey * ey > half * half) continue;
      double inverse = p.inverse_depth + t * (q.inverse_depth - p.inverse_depth);
      inverse = inverse / std::max(0.5, 1 - bias * inverse);
      const std::size_t sample = std::size_t(j) * buffer.width + i;
      if (!(inverse > double(buffer.inverse_depth[sample]))) continue;
      buffer.inverse_depth[sample] = float(inverse);
      std::copy(rgb, rgb + 3, buffer.rgb.begin() + 3 * std::ptrdiff_t(sample));
    }
  }
}
