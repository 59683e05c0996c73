// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_CAMERA_H
#define MULTIPLANAR_WRITERS_CAMERA_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <array>
#include <vector>

/// A pinhole camera: looks along -`back`; pixels are counted from the upper left corner of the picture.
struct Camera
{
  using Point = CGAL::Multiplanar::Point_3;
  using Vector = CGAL::Multiplanar::Vector_3;

  /// A place in the picture, and one over the distance from the plane of the pinhole: linear in the picture on planes.
  struct Projected
  {
    double x, y, inverse_depth;
  };

  Projected operator()(const Point& p) const
  {
    const Vector d = p - eye;
    const double inverse = -1 / (d * back);
    return {centre_x + focal * inverse * (d * right), centre_y - focal * inverse * (d * up), inverse};
  }
  /// From the eye through a place in the picture; not of unit length.
  Vector ray(double x, double y) const { return (x - centre_x) / focal * right - (y - centre_y) / focal * up - back; }

  Point eye = Point(0, 0, 0);
  Vector right = Vector(1, 0, 0), up = Vector(0, 1, 0), back = Vector(0, 0, 1); ///< orthonormal
  double focal = 1;                                                             ///< pixels at distance 1
  double centre_x = 0, centre_y = 0;
  int width = 0, height = 0;
};

/// The direction that is up for a model: y, or z where the model stands on a flat base along z.
CGAL::Multiplanar::Vector_3 upward(const CGAL::Multiplanar::Points& points,
                                   const std::vector<std::array<int, 3>>& triangles);

/// Whence to look at a model: of views at three quarters from above, the one that shows its silhouette largest; views
/// of the front (+z where y is up, -y where z is) are preferred. \return a unit vector towards the viewer
CGAL::Multiplanar::Vector_3 best_view(const CGAL::Multiplanar::Points& points,
                                      const std::vector<std::array<int, 3>>& triangles,
                                      const CGAL::Multiplanar::Vector_3& up);

/// A camera in the direction `view` that shows all points as large as a picture with a margin allows. \pre any points
Camera fit_camera(const CGAL::Multiplanar::Points& points, const CGAL::Multiplanar::Vector_3& view,
                  const CGAL::Multiplanar::Vector_3& up, int width, int height);

#endif // MULTIPLANAR_WRITERS_CAMERA_H
