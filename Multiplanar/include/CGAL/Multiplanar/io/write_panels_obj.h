// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_PANELS_OBJ_H
#define CGAL_MULTIPLANAR_IO_WRITE_PANELS_OBJ_H

#include <CGAL/Multiplanar/internal/bridge_holes.h>
#include <CGAL/Multiplanar/io/number_format.h>
#include <CGAL/Multiplanar/parts_from_panels.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline Bridge_loop bridge_loop(const Panel_complex& complex, const Panel_complex::Loop& loop, const Frame& frame)
{
  Bridge_loop result;
  for (int corner : complex.loop_corners(loop))
    result.push_back({frame.project(complex.corners[corner].point), corner});
  return result;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes the panels as OBJ: the corners once each, and one polygon a panel, in a group with the panel's id,
counter-clockwise seen from outside. Holes are joined to the outline by bridges. Panels without an area are left out.
The caller checks the state of `out` afterwards.

\param out the stream
\param complex in mm
*/
inline void write_panels_obj(std::ostream& out, const Panel_complex& complex)
{
  out << "# panels in mm\n";
  for (const auto& corner : complex.corners)
    out << "v " << internal::exact_number(corner.point.x()) << " " << internal::exact_number(corner.point.y()) << " "
        << internal::exact_number(corner.point.z()) << "\n";
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    if (!internal::has_outline(complex, p)) continue;
    const auto& loops = complex.panels[p].loops;
    const Frame frame = internal::panel_frame(complex, p);
    std::vector<internal::Bridge_loop> holes;
    for (std::size_t i = 1; i < loops.size(); ++i) holes.push_back(internal::bridge_loop(complex, loops[i], frame));
    out << "g " << panel_id(complex, p) << "\nf";
    for (int corner : internal::bridge_holes(internal::bridge_loop(complex, loops[0], frame), std::move(holes)))
      out << " " << corner + 1;
    out << "\n";
  }
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_PANELS_OBJ_H
