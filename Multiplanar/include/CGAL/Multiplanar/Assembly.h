// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ASSEMBLY_H
#define CGAL_MULTIPLANAR_ASSEMBLY_H

#include <CGAL/Multiplanar/Part.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarAssembly
/// Parts that are put in place together, in one straight motion.
struct Assembly_step
{
  std::vector<int> parts;                 ///< positions in the list of parts: a panel first, then what is mounted on it
  Vector_3 direction = Vector_3(0, 0, 0); ///< in which they move, of length 1
  double travel = 0;                      ///< mm before their place from where on their way is proved free
  /// The direction of a straight way, proved free, from outside of all that is placed to where `travel` begins; none if
  /// no such way was found. `direction` itself where the whole column is free.
  std::optional<Vector_3> approach;
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ASSEMBLY_H
