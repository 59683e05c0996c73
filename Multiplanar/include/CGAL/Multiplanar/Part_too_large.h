// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PART_TOO_LARGE_H
#define CGAL_MULTIPLANAR_PART_TOO_LARGE_H

#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSheets
/// Thrown when a part fits no sheet at any angle that was tried.
struct Part_too_large : std::runtime_error
{
  /// \param part, w, h, f the members `id`, `width`, `height`, `factor`
  Part_too_large(std::string part, double w, double h, double f)
      : std::runtime_error("part " + part + " is larger than the sheet"), id(std::move(part)), width(w), height(h),
        factor(f)
  {
  }
  std::string id;       ///< the part that exceeds the sheet most
  double width;         ///< of the smallest rectangle around it, in mm
  double height;        ///< of that rectangle, not more than its width
  double factor;        ///< every part fits once everything is scaled by this number (< 1)
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PART_TOO_LARGE_H
