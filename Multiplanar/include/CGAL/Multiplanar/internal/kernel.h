// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_KERNEL_H
#define CGAL_MULTIPLANAR_INTERNAL_KERNEL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The kernel of every 3D computation of the package: predicates exact, coordinates doubles.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

/// Positions of the vertices of a mesh, by vertex index.
using Points = std::vector<Point_3>;

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_KERNEL_H
