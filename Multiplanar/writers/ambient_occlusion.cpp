// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ambient_occlusion.h"

#include <CGAL/Multiplanar/internal/parallel_ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

/// Distances from the eye's plane by pixel; 0 where nothing is seen.
std::vector<float> depths(const Frame_buffer& buffer, int width, int height)
{
  std::vector<float> result(std::size_t(width) * height, 0);
  const int n = buffer.samples, middle = n / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float inverse = buffer.inverse_depth[std::size_t(y * n + middle) * buffer.width + x * n + middle];
      if (inverse > 0) result[std::size_t(y) * width + x] = 1 / inverse;
    }
  return result;
}

/// Pairs of opposite directions at growing distances, as parts of the radius: together they look all around.
struct Probe
{
  float x, y;
};

std::array<Probe, 16> probes()
{
  std::array<Probe, 16> result{};
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.399963 * i, distance = std::sqrt((i + 0.5) / 16);
    result[i] = {float(distance * std::cos(angle)), float(distance * std::sin(angle))};
  }
  return result;
}

} // namespace

std::vector<float> ambient_occlusion(const Frame_buffer& buffer, const Camera& camera, double radius, int threads)
{
  const int width = camera.width, height = camera.height;
  const std::vector<float> depth = depths(buffer, width, height);
  const auto at = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height ? depth[std::size_t(y) * width + x] : 0;
  };
  const std::array<Probe, 16> all = probes();
  std::vector<float> raw(depth.size(), 1), result(depth.size(), 1);
  internal::parallel_ranges(height, threads, [&](int, int first, int last) {
    for (int y = first; y < last; ++y)
      for (int x = 0; x < width; ++x) {
        const float z = at(x, y);
        if (z == 0) continue;
        const double reach = std::min(camera.focal * radius / z, 120.);
        double hidden = 0;
        for (const Probe& probe : all) {
          const int dx = int(std::lround(probe.x * reach)), dy = int(std::lround(probe.y * reach));
          const float a = at(x + dx, y + dy), b = at(x - dx, y - dy);
          // On a plane the mean of two opposite depths is the depth in the middle: what is nearer rises above it.
          const double near_a = a == 0 ? -radius : double(z) - a, near_b = b == 0 ? -radius : double(z) - b;
          const double rise = (std::max(-radius, near_a) + std::max(-radius, near_b)) / 2;
          if (near_a > 2 * radius || near_b > 2 * radius) continue; // another thing, far in front
          hidden += std::min(1., std::max(0., (rise - 0.02 * radius) / (0.6 * radius)));
        }
        raw[std::size_t(y) * width + x] = float(1 - 0.75 * hidden / double(all.size()));
      }
  });
  // The mean over a neighbourhood of the same surface takes the grain away.
  internal::parallel_ranges(height, threads, [&](int, int first, int last) {
    for (int y = first; y < last; ++y)
      for (int x = 0; x < width; ++x) {
        const float z = at(x, y);
        if (z == 0) continue;
        float sum = 0;
        int count = 0;
        for (int j = std::max(0, y - 3); j <= std::min(height - 1, y + 3); ++j)
          for (int i = std::max(0, x - 3); i <= std::min(width - 1, x + 3); ++i)
            if (std::abs(at(i, j) - z) < 0.3 * radius) sum += raw[std::size_t(j) * width + i], ++count;
        result[std::size_t(y) * width + x] = count > 0 ? sum / float(count) : 1;
      }
  });
  return result;
}
