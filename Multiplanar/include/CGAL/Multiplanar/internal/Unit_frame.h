// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_UNIT_FRAME_H
#define CGAL_MULTIPLANAR_INTERNAL_UNIT_FRAME_H

#include <CGAL/assertions.h>
#include <CGAL/bounding_box.h>
#include <CGAL/Multiplanar/Plane.h>

#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The coordinates in which the numerical rooms work: box centre at the origin, box diagonal 1. The mesh itself stays in
/// the input's coordinates, so that what is proved about it holds for the numbers that the user gave and gets.
class Unit_frame
{
public:
  explicit Unit_frame(const Points& points)
  {
    CGAL_precondition(!points.empty());
    const auto box = CGAL::bounding_box(points.begin(), points.end());
    centre = CGAL::midpoint((box.min)(), (box.max)());
    length = std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
    CGAL_precondition(length > 0);
  }

  /// The diagonal of the bounding box, in input units.
  double diagonal() const { return length; }

  Point_3 to_unit(const Point_3& p) const { return CGAL::ORIGIN + (p - centre) / length; }
  Point_3 from_unit(const Point_3& p) const { return centre + (p - CGAL::ORIGIN) * length; }

  Points to_unit(const Points& points) const
  {
    Points result;
    result.reserve(points.size());
    for (const Point_3& p : points) result.push_back(to_unit(p));
    return result;
  }

  Plane from_unit(const Plane& plane) const
  {
    return {plane.normal, plane.offset * length + plane.normal * (centre - CGAL::ORIGIN)};
  }
  Plane to_unit(const Plane& plane) const
  {
    return {plane.normal, (plane.offset - plane.normal * (centre - CGAL::ORIGIN)) / length};
  }

private:
  Point_3 centre;
  double length;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_UNIT_FRAME_H
