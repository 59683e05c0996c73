// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ground_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace CGAL::Multiplanar;

Ground_shadow::Ground_shadow(const Scene& scene) : up(scene.up), shade(cells * cells, 0)
{
  if (scene.triangles.empty()) return;
  u = std::abs(up.x()) > 0.5 ? Vector_3(0, 1, 0) : Vector_3(1, 0, 0);
  v = CGAL::cross_product(up, u);
  const Point_3 start = scene.triangles[0].points[0];
  const double infinity = std::numeric_limits<double>::infinity();
  double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};
  for (const Scene_triangle& t : scene.triangles)
    for (const Point_3& p : t.points) {
      const double c[3] = {(p - start) * u, (p - start) * v, (p - start) * up};
      for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], c[i]), high[i] = std::max(high[i], c[i]);
    }
  origin = start + (low[0] + high[0]) / 2 * u + (low[1] + high[1]) / 2 * v + low[2] * up;
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  size = 2 * std::max(extent, 1e-300);
  std::vector<float> lowest(cells * cells, std::numeric_limits<float>::infinity());
  for (const Scene_triangle& t : scene.triangles) cast(t, lowest);
  // Two shadows: what nearly touches the ground, little blurred, and everything, much blurred.
  std::vector<float> contact(cells * cells, 0);
  for (int i = 0; i < cells * cells; ++i) {
    const float h = lowest[i] / float(extent);
    contact[i] = std::exp(-30 * h);
    shade[i] = std::exp(-3 * h);
  }
  for (int pass = 0; pass < 3; ++pass) blur(contact, 2), blur(shade, 9);
  for (int i = 0; i < cells * cells; ++i) shade[i] = 1 - (1 - 0.38f * contact[i]) * (1 - 0.30f * shade[i]);
}

void Ground_shadow::cast(const Scene_triangle& t, std::vector<float>& lowest) const
{
  double x[3], y[3], h[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = cells * (0.5 + (t.points[i] - origin) * u / size);
    y[i] = cells * (0.5 + (t.points[i] - origin) * v / size);
    h[i] = (t.points[i] - origin) * up;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  const auto bound = [](double value) { return std::max(0, std::min(cells - 1, int(value))); };
  const int x0 = bound(std::min({x[0], x[1], x[2]})), x1 = bound(std::max({x[0], x[1], x[2]}));
  const int y0 = bound(std::min({y[0], y[1], y[2]})), y1 = bound(std::max({y[0], y[1], y[2]}));
  for (int j = y0; j <= y1; ++j)
    for (int i = x0; i <= x1; ++i) {
      double weight[3], height = std::min({h[0], h[1], h[2]});
      bool inside = std::abs(area) < 1;
      if (!inside) {
        inside = true;
        height = 0;
        for (int k = 0; k < 3; ++k) {
          const int a = (k + 1) % 3, b = (k + 2) % 3;
          weight[k] = ((x[a] - i - 0.5) * (y[b] - j - 0.5) - (x[b] - i - 0.5) * (y[a] - j - 0.5)) / area;
          inside = inside && weight[k] >= -1e-9;
          height += weight[k] * h[k];
        }
      }
      float& cell = lowest[j * cells + i];
      if (inside) cell = std::min(cell, float(std::max(0., height)));
    }
}

/// Mean over a square, rows and columns one after the other.
void Ground_shadow::blur(std::vector<float>& grid, int radius) const
{
  std::vector<float> line(cells);
  for (int direction = 0; direction < 2; ++direction) {
    const int step = direction == 0 ? 1 : cells, next = direction == 0 ? cells : 1;
    for (int k = 0; k < cells; ++k) {
      float* start = grid.data() + k * next;
      for (int i = 0; i < cells; ++i) line[i] = start[i * step];
      double sum = 0;
      for (int i = -radius; i < cells; ++i) {
        if (i + radius < cells) sum += line[i + radius];
        if (i - radius - 1 >= 0) sum -= line[i - radius - 1];
        if (i >= 0) start[i * step] = float(sum / (2 * radius + 1));
      }
    }
  }
}

double Ground_shadow::operator()(const Camera& camera, double x, double y) const
{
  const Vector_3 ray = camera.ray(x, y);
  const double along = ray * up, height = (camera.eye - origin) * up;
  if (!(along < 0) || !(height > 0)) return 1;
  const Vector_3 hit = camera.eye + height / -along * ray - origin;
  const double gx = cells * (0.5 + hit * u / size) - 0.5, gy = cells * (0.5 + hit * v / size) - 0.5;
  if (!(gx > 0 && gy > 0 && gx < cells - 1 && gy < cells - 1)) return 1;
  const int i = int(gx), j = int(gy);
  const double fx = gx - i, fy = gy - j;
  const float* cell = shade.data() + j * cells + i;
  return 1 - ((1 - fy) * ((1 - fx) * cell[0] + fx * cell[1]) + fy * ((1 - fx) * cell[cells] + fx * cell[cells + 1]));
}
