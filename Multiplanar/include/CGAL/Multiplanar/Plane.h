// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PLANE_H
#define CGAL_MULTIPLANAR_PLANE_H

#include <CGAL/Multiplanar/internal/kernel.h>

namespace CGAL {
namespace Multiplanar {

/// The oriented plane { x : normal . x = offset } of a label or a panel, in the paper's notation (n_f, d_f).
/// `normal` has unit length up to rounding and points out of the solid.
struct Plane
{
  Vector_3 normal = Vector_3(0, 0, 1); ///< of unit length, up to rounding
  double offset = 0;                   ///< d
};

/// Signed distance of `p` from `plane`, positive outside.
inline double signed_distance(const Plane& plane, const Point_3& p)
{
  return plane.normal * (p - CGAL::ORIGIN) - plane.offset;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PLANE_H
