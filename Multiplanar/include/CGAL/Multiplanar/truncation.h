// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TRUNCATION_H
#define CGAL_MULTIPLANAR_TRUNCATION_H

#include <CGAL/Multiplanar/Truncation_options.h>
#include <CGAL/Multiplanar/internal/Truncator.h>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarParts

Cuts every panel of a closed polygon mesh back so that all of them can be sheets of the same thickness, which extend
inward from the outer surface with sides perpendicular to the sheet, and fit together (section 3.2.2 of the paper, in
the general form):

 1. from each panel the *columns* are removed (the points of the panel, extended inward by the thickness) that leave the
    model;
 2. then, pair by pair, the panel that gives way loses the projection onto its plane of the overlap of both sheets.

At a convex edge with interior angle theta >= 90 degrees, one of the two panels so loses a strip t sin(theta) wide;
below 90 degrees, one loses t cot(theta), the other t cot(theta / 2); at a reflex edge none does. Panels that share only
a corner, and panels that come close without touching, are covered by the same construction. Of two panels the wider
(area over perimeter) gives way.

\param complex flat panels, in mm, outward oriented
\param options the thickness, and what is too small to be cut
\return a polygon in the plane of each panel, or several, or none; warnings say what fell apart or vanished.
        Coordinates are exact up to one rounding to doubles (and a nanometre where slivers were cleaned away); within
        each panel, the polygons are valid (checked exactly) and disjoint.
\throws std::invalid_argument if the thickness is not positive or a panel is not a flat, simple polygon

Linear in the number of pairs of sheets whose boxes meet; a few milliseconds a panel.
*/
inline Truncation truncate_panels(const Panel_complex& complex, const Truncation_options& options)
{
  return internal::Truncator(complex, options).truncation();
}

/// \ingroup PkgMultiplanarParts
/// The same with a thickness in mm and defaults for the rest.
inline Truncation truncate_panels(const Panel_complex& complex, double thickness)
{
  Truncation_options options;
  options.thickness = thickness;
  return truncate_panels(complex, options);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TRUNCATION_H
