// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_NO_FLAT_PANELS_H
#define CGAL_MULTIPLANAR_NO_FLAT_PANELS_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarRef

Thrown where no flat panels were found that a mesh fits into, with no more panels than asked for and in a bounded amount
of work. With more panels, another seed or fewer triangles they may be; `what()` says so in a line for the user.
*/
class No_flat_panels : public std::runtime_error
{
public:
  /// For so many panels asked for, and a surface of that genus and number of triangles; `fewest` panels were found to fit
  /// (0: not known), which is told where it is not many times what was asked for.
  No_flat_panels(int panels, int genus, int faces, int fewest = 0)
      : std::runtime_error(
            "no " + std::to_string(panels) + " flat panels were found that this surface of genus " +
            std::to_string(genus) + " and " + std::to_string(faces) + " faces fits into" +
            (fewest > panels && fewest <= 4 * panels ? "; the fewest found are " + std::to_string(fewest) : std::string()) +
            ": give more panels (-k), another seed, or a mesh with fewer faces")
  {
  }
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_NO_FLAT_PANELS_H
