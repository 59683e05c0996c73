// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_PLACING_H
#define MULTIPLANAR_VERIFY_PLACING_H

#include "written_model.h"

#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// Where a point of a part comes to lie on its sheet: mirrored (x -> -x), turned, shifted; y upward.
inline Point_2 placed(const Written_placement& placement, const Point_2& p)
{
  const double angle = placement.rotation * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  const double x = placement.mirrored ? -p.x() : p.x(), y = p.y();
  return Point_2(c * x - s * y + placement.x, s * x + c * y + placement.y);
}

inline Loop placed(const Written_placement& placement, const Loop& loop)
{
  Loop result;
  for (const Point_2& p : loop) result.push_back(placed(placement, p));
  return result;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_PLACING_H
