// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "render.h"
#include "Frame_buffer.h"
#include "Ground_shadow.h"
#include "ambient_occlusion.h"

#include <CGAL/Multiplanar/internal/parallel_ranges.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <optional>

using namespace CGAL::Multiplanar;

namespace {

double diagonal_of(const Scene& scene)
{
  CGAL::Bbox_3 box;
  for (const Scene_triangle& t : scene.triangles)
    for (const Point_3& p : t.points) box += p.bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// A light grey, brighter in the middle.
float background(double x, double y, const Camera& camera)
{
  const double dx = x / camera.width - 0.5, dy = y / camera.height - 0.45;
  return float(0.93 - 0.22 * (dx * dx + dy * dy));
}

/// The means of the samples of row `y` of the picture.
void resolve_row(const Frame_buffer& buffer, const Camera& camera, const std::vector<float>& open_sky,
                 const std::optional<Ground_shadow>& shadow, int y, Image& image)
{
  const int n = buffer.samples;
  const auto& light = internal::linear_of_bytes();
  for (int x = 0; x < image.width; ++x) {
    float sum[3] = {0, 0, 0};
    int empty = 0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::size_t sample = std::size_t(y * n + j) * buffer.width + x * n + i;
        if (buffer.inverse_depth[sample] == 0) ++empty;
        else
          for (int c = 0; c < 3; ++c) sum[c] += light[buffer.rgb[3 * sample + c]];
      }
    const float sky = open_sky[std::size_t(y) * image.width + x];
    for (float& c : sum) c *= sky;
    if (empty > 0) {
      const float shade = shadow ? float((*shadow)(camera, x + 0.5, y + 0.5)) : 1;
      const float back = background(x + 0.5, y + 0.5, camera) * shade * float(empty);
      sum[0] += back * 0.985f, sum[1] += back * 0.99f, sum[2] += back;
    }
    std::uint8_t* pixel = image.pixel(x, y);
    for (int c = 0; c < 3; ++c) pixel[c] = internal::byte_of_linear(sum[c] / float(n * n));
    pixel[3] = 255;
  }
}

} // namespace

Image render(const Scene& scene, const Camera& camera, int samples, int threads)
{
  CGAL_precondition(camera.width > 0 && camera.height > 0 && samples > 0);
  Frame_buffer buffer(camera.width, camera.height, samples);
  const double bias = 0.0015 * diagonal_of(scene);
  const int parts = internal::resolved_threads(threads);
  internal::parallel_ranges(buffer.height, parts, [&](int, int first, int last) {
    for (const Scene_triangle& t : scene.triangles) draw_triangle(buffer, {first, last}, camera, t, scene.up);
    for (const Scene_line& line : scene.lines) draw_line(buffer, {first, last}, camera, line, bias);
  });
  const std::vector<float> open_sky = ambient_occlusion(buffer, camera, 0.05 * diagonal_of(scene), parts);
  std::optional<Ground_shadow> shadow;
  if (scene.has_ground) shadow.emplace(scene);
  Image image(camera.width, camera.height);
  internal::parallel_ranges(image.height, parts, [&](int, int first, int last) {
    for (int y = first; y < last; ++y) resolve_row(buffer, camera, open_sky, shadow, y, image);
  });
  return image;
}
