// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_KERF_COMPENSATION_H
#define CGAL_MULTIPLANAR_KERF_COMPENSATION_H

#include <CGAL/Multiplanar/exact_polygons.h>

#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The paths of a cutting beam: closed, simple and disjoint.
struct Cut_paths
{
  Outline outer;              ///< counter-clockwise
  std::vector<Outline> inner; ///< clockwise
};

/// Whether a polygon has at least three vertices and its sides meet at their ends only. Exact.
inline bool is_simple_outline(const Outline& outline)
{
  if (outline.size() < 3) return false;
  return CGAL::Polygon_2<Kernel>(outline.begin(), outline.end()).is_simple();
}

namespace internal {

inline Exact_loop oriented_loop(const Outline& outline, CGAL::Orientation orientation)
{
  Exact_loop loop = exact_loop(outline);
  if (loop.orientation() != orientation) loop.reverse_orientation();
  return loop;
}

/// A regular polygon inscribed in the circle of the given radius, with sides shorter than `chord`.
inline Exact_loop inscribed_polygon(double radius, double chord)
{
  const double turn = 2 * 3.14159265358979323846;
  const int n = (std::max)(16, int(std::ceil(turn * radius / chord)) + 1);
  Exact_loop disc;
  for (int i = 0; i < n; ++i)
    disc.push_back(Exact_point_2(radius * std::cos(turn * i / n), radius * std::sin(turn * i / n)));
  return disc;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

The paths that the middle of a cut of width `kerf` has to follow so that the nominal part remains: the outline goes
outward by `kerf` / 2, holes go inward, and convex corners become arcs of chords shorter than 0.01 mm. It is the exact
Minkowski sum with a polygon inscribed in the circle of that radius (at most 0.01^2 / (4 `kerf`) short of it), rounded
to doubles at the end.

A hole narrower than the kerf has no path; an inlet narrower than the kerf turns into an inner path or vanishes.

\param outline counter-clockwise or clockwise
\param holes of any orientation, inside the outline and disjoint
\param kerf full width of the cut in mm, not negative
\pre `outline` and `holes` are simple, 0 <= `kerf`
*/
inline Cut_paths compensate_kerf(const Outline& outline, const std::vector<Outline>& holes, double kerf)
{
  using namespace internal;
  CGAL_precondition(kerf >= 0 && is_simple_outline(outline));
  Exact_polygon region(oriented_loop(outline, CGAL::COUNTERCLOCKWISE));
  for (const Outline& hole : holes) {
    CGAL_precondition(is_simple_outline(hole));
    region.add_hole(oriented_loop(hole, CGAL::CLOCKWISE));
  }
  const Exact_polygon sum = kerf > 0 ? CGAL::minkowski_sum_2(region, inscribed_polygon(kerf / 2, 0.01)) : region;
  Cut_paths paths;
  paths.outer = rounded(sum.outer_boundary());
  for (auto hole = sum.holes_begin(); hole != sum.holes_end(); ++hole) paths.inner.push_back(rounded(*hole));
  return paths;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_KERF_COMPENSATION_H
