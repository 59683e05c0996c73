// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Camera.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace CGAL::Multiplanar;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// The area of the faces that look down and lie at the lower end of the model along an axis.
double base_area(const Points& points, const Triangles& triangles, int axis, const CGAL::Bbox_3& box)
{
  const double low = box.min(axis), high = low + 0.04 * (box.max(axis) - low);
  double area = 0;
  for (const auto& t : triangles) {
    if (points[t[0]][axis] > high || points[t[1]][axis] > high || points[t[2]][axis] > high) continue;
    const Vector_3 n = CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    if (n[axis] < 0 && n[axis] * n[axis] > 0.8 * n.squared_length()) area -= n[axis] / 2;
  }
  return area;
}

/// The area of the silhouette seen from far away, in cells of a coarse grid over the box's diagonal.
double silhouette(const Points& points, const Triangles& triangles, const Vector_3& right, const Vector_3& up,
                  const Point_3& centre, double diagonal)
{
  constexpr int n = 96;
  std::vector<char> covered(n * n, 0);
  for (const auto& t : triangles) {
    double x[3], y[3];
    for (int i = 0; i < 3; ++i) {
      x[i] = n * (0.5 + (points[t[i]] - centre) * right / diagonal);
      y[i] = n * (0.5 + (points[t[i]] - centre) * up / diagonal);
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (!(area > 0)) continue; // seen from behind
    const int x0 = std::max(0, int(std::min({x[0], x[1], x[2]}))),
              x1 = std::min(n - 1, int(std::max({x[0], x[1], x[2]})));
    const int y0 = std::max(0, int(std::min({y[0], y[1], y[2]}))),
              y1 = std::min(n - 1, int(std::max({y[0], y[1], y[2]})));
    for (int j = y0; j <= y1; ++j)
      for (int i = x0; i <= x1; ++i) {
        bool inside = true;
        for (int k = 0; k < 3 && inside; ++k) {
          const int l = (k + 1) % 3;
          inside = (x[l] - x[k]) * (j + 0.5 - y[k]) - (i + 0.5 - x[k]) * (y[l] - y[k]) >= -1;
        }
        if (inside) covered[j * n + i] = 1;
      }
  }
  return double(std::count(covered.begin(), covered.end(), 1));
}

} // namespace

Vector_3 upward(const Points& points, const Triangles& triangles)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const bool z = base_area(points, triangles, 2, box) > 1.5 * base_area(points, triangles, 1, box);
  return z ? Vector_3(0, 0, 1) : Vector_3(0, 1, 0);
}

Vector_3 best_view(const Points& points, const Triangles& triangles, const Vector_3& up)
{
  const Vector_3 front = up.z() != 0 ? Vector_3(0, -1, 0) : Vector_3(0, 0, 1);
  const Vector_3 side = CGAL::cross_product(up, front);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const Point_3 centre((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  const double degree = 3.14159265358979323846 / 180, elevation = 22 * degree;
  Vector_3 best = front;
  double best_score = -1;
  for (double azimuth : {32., -32., 55., -55., 125., -125., 148., -148.}) {
    const Vector_3 level = std::cos(azimuth * degree) * front + std::sin(azimuth * degree) * side;
    const Vector_3 view = std::cos(elevation) * level + std::sin(elevation) * up;
    const Vector_3 right = unit(CGAL::cross_product(up, view));
    double score = silhouette(points, triangles, right, CGAL::cross_product(view, right), centre, diagonal);
    if (std::abs(azimuth) > 90) score /= 1.25;
    if (score > best_score * 1.02) best_score = score, best = view;
  }
  return unit(best);
}

Camera fit_camera(const Points& points, const Vector_3& view, const Vector_3& up, int width, int height)
{
  CGAL_precondition(!points.empty());
  const double margin = 0.05;                                         // of the picture, on each side
  const double tangent = std::tan(13 * 3.14159265358979323846 / 180); // of half the angle over the smaller side
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.back = unit(view);
  camera.right = unit(CGAL::cross_product(up, camera.back));
  camera.up = CGAL::cross_product(camera.back, camera.right);
  camera.focal = std::min(width, height) / 2. / tangent;
  const double tan_x = (0.5 - margin) * width / camera.focal, tan_y = (0.5 - margin) * height / camera.focal;
  // The planes through the eye at the sides of the picture touch the points: the eye follows in both directions.
  const double infinity = std::numeric_limits<double>::infinity();
  double low_x = infinity, high_x = -infinity, low_y = infinity, high_y = -infinity, nearest = -infinity;
  const Point_3 origin = points[0];
  for (const Point_3& p : points) {
    const double x = (p - origin) * camera.right, y = (p - origin) * camera.up, z = (p - origin) * camera.back;
    low_x = std::min(low_x, x - tan_x * z), high_x = std::max(high_x, x + tan_x * z);
    low_y = std::min(low_y, y - tan_y * z), high_y = std::max(high_y, y + tan_y * z);
    nearest = std::max(nearest, z);
  }
  // |x - ex| <= tan_x (ez - z) for all points: ex - tan_x ez <= low_x and ex + tan_x ez >= high_x.
  const double depth = std::max({(high_x - low_x) / (2 * tan_x), (high_y - low_y) / (2 * tan_y),
                                 nearest + 1e-6 * (std::abs(nearest) + (high_x - low_x))});
  camera.eye = origin + (low_x + high_x) / 2 * camera.right + (low_y + high_y) / 2 * camera.up + depth * camera.back;
  camera.centre_x = width / 2.;
  camera.centre_y = height / 2.;
  return camera;
}
