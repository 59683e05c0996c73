// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TURNED_BOXES_H
#define CGAL_MULTIPLANAR_INTERNAL_TURNED_BOXES_H

#include <CGAL/Multiplanar/Sheet.h>

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The rectangle around a part that was turned by `rotation` degrees; (x, y) is its lower left corner.
struct Turned_box
{
  double rotation = 0, x = 0, y = 0, width = 0, height = 0;
};

/// Smaller in area; of boxes whose areas differ by rounding alone, the flatter one.
inline bool smaller_box(const Turned_box& a, const Turned_box& b)
{
  const double area_a = a.width * a.height, area_b = b.width * b.height;
  if (std::abs(area_a - area_b) > 1e-9 * (std::max)(area_a, area_b)) return area_a < area_b;
  return a.height < b.height;
}

/// The boxes of a part at the angles worth a try.
struct Turned_boxes
{
  std::vector<Turned_box> along_sides; ///< a side of the convex hull along the x or the y axis: the smallest is here
  std::vector<Turned_box> at_degrees;  ///< at every full degree: a long part may fit along the sheet's diagonal only
};

inline Turned_box turned_box(const Outline& hull, const Placement& placement)
{
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
  for (const Point_2& p : hull) {
    const Point_2 q = placement(p);
    low_x = (std::min)(low_x, q.x()), high_x = (std::max)(high_x, q.x());
    low_y = (std::min)(low_y, q.y()), high_y = (std::max)(high_y, q.y());
  }
  Turned_box box;
  box.rotation = placement.rotation;
  box.x = low_x, box.y = low_y;
  box.width = high_x - low_x, box.height = high_y - low_y;
  return box;
}

/// The boxes of `part`, mirrored first if so. O(h^2) for h vertices on the convex hull.
inline Turned_boxes turned_boxes(const Part& part, bool mirrored)
{
  Outline hull;
  CGAL::convex_hull_2(part.outline.begin(), part.outline.end(), std::back_inserter(hull));
  Placement placement;
  placement.mirrored = mirrored;
  const auto box_at = [&](double rotation) {
    placement.rotation = rotation;
    return turned_box(hull, placement);
  };
  Turned_boxes boxes;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point_2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double dx = mirrored ? a.x() - b.x() : b.x() - a.x();
    const double angle = -std::atan2(b.y() - a.y(), dx) * 180 / 3.14159265358979323846;
    boxes.along_sides.push_back(box_at(angle));
    boxes.along_sides.push_back(box_at(angle + 90));
  }
  for (int degree = 0; degree < 180; ++degree) boxes.at_degrees.push_back(box_at(degree));
  return boxes;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TURNED_BOXES_H
