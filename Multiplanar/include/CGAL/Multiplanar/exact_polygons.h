// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_EXACT_POLYGONS_H
#define CGAL_MULTIPLANAR_EXACT_POLYGONS_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Polygon_set_2.h>

#include <CGAL/Multiplanar/Part.h>

#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The kernel of the outlines of parts: constructions are exact.
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_point_2 = Exact_kernel::Point_2;      ///< in the plane of a panel, in mm
using Exact_loop = CGAL::Polygon_2<Exact_kernel>; ///< one boundary of a polygon
/// The outer boundary counter-clockwise, holes clockwise.
using Exact_polygon = CGAL::Polygon_with_holes_2<Exact_kernel>;
using Exact_polygon_set = CGAL::Polygon_set_2<Exact_kernel>; ///< any number of polygons, with Boolean operations

namespace internal {

/// The double nearest to an exact number. (`to_double` alone may be off by 1e-5 of it: it stops at the interval.)
inline double rounded(const Exact_kernel::FT& x) { return CGAL::to_double(CGAL::exact(x)); }
inline Point_2 rounded(const Exact_point_2& p) { return Point_2(rounded(p.x()), rounded(p.y())); }

inline Exact_loop exact_loop(const Outline& outline)
{
  Exact_loop result;
  for (const Point_2& p : outline) result.push_back(Exact_point_2(p.x(), p.y()));
  return result;
}

inline Outline rounded(const Exact_loop& loop)
{
  Outline result;
  result.reserve(loop.size());
  for (const Exact_point_2& p : loop) result.push_back(rounded(p));
  return result;
}

inline Exact_polygon exact_polygon(const Outline& outline, const std::vector<Outline>& holes)
{
  Exact_polygon result(exact_loop(outline));
  for (const Outline& hole : holes) result.add_hole(exact_loop(hole));
  return result;
}

inline std::vector<Exact_polygon> polygons_of(const Exact_polygon_set& set)
{
  std::vector<Exact_polygon> result;
  set.polygons_with_holes(std::back_inserter(result));
  return result;
}

/// In mm^2, holes taken off; rounded.
inline double area(const Exact_polygon& polygon)
{
  Exact_kernel::FT sum = polygon.outer_boundary().area(); // a hole runs clockwise: its area is negative
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) sum += hole->area();
  return rounded(sum);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_EXACT_POLYGONS_H
