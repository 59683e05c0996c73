// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
#define CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/convex_pieces_map.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Maps of a triangulated planar domain into a polygon whose boundary positions are given, all triangles positive:
// 1. the discrete map with Floater's mean value weights, taken from the triangles' shapes on the model. It is injective
//    whenever the polygon is convex, and usually when it is not;
// 2. where it is not, it is untangled from there;
// 3. where that fails, the polygon is cut into convex pieces.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The triangles as a complex whose parameters are the places of the free vertices, and those.
inline Planar_complex planar_complex(const Triangles& triangles, const std::vector<char>& fixed, double tolerance,
                                     const std::vector<Point_2d>& points, std::vector<double>& x)
{
  Planar_complex complex;
  complex.triangles = triangles;
  complex.tolerance.assign(triangles.size(), tolerance);
  x.clear();
  for (std::size_t v = 0; v < points.size(); ++v) {
    Planar_node node;
    node.base = points[v];
    if (!fixed[v]) {
      node.kind = Planar_node::Kind::free;
      node.unknown = int(x.size());
      x.push_back(points[v].x());
      x.push_back(points[v].y());
    }
    complex.nodes.push_back(node);
  }
  complex.unknowns = int(x.size());
  return complex;
}

/// Makes every triangle positive from where the vertices are. \return how many triangles are not
inline int untangle(const Triangles& triangles, const std::vector<char>& fixed, double polygon_area, double tolerance,
                    std::vector<Point_2d>& points)
{
  std::vector<double> x;
  const Planar_complex complex = planar_complex(triangles, fixed, tolerance, points, x);
  if (complex.count_inverted(x.data()) == 0) return 0;
  untangle(complex, std::abs(polygon_area) / double(triangles.size()), x);
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = complex.nodes[v].at(x.data());
  return complex.count_inverted(x.data());
}

/// Positions of the free vertices such that every triangle is positive.
/// \param shape the vertices on the model, whose triangles the weights come from
/// \param fixed whether a vertex keeps its place in `points`; every boundary vertex does
/// \param polygon_area in the plane
/// \param tolerance the doubled area that counts as positive
/// \param points in: the fixed places; out: all of them
/// \return false if some triangle could not be made positive; the best found is in `points`
inline bool injective_map(const Triangles& triangles, const std::vector<Eigen::Vector3d>& shape,
                          const std::vector<char>& fixed, double polygon_area, double tolerance,
                          std::vector<Point_2d>& points)
{
  CGAL_precondition(shape.size() == points.size() && fixed.size() == points.size());
  mean_value_map(triangles, shape, fixed, points);
  const int inverted = untangle(triangles, fixed, polygon_area, tolerance, points);
  if (inverted == 0) return true;
  Convex_pieces_map pieces(shape, points);
  if (!pieces.run(triangles)) return false;
  std::vector<Point_2d> other(pieces.places().begin(), pieces.places().begin() + std::ptrdiff_t(points.size()));
  const int left = untangle(triangles, fixed, polygon_area, tolerance, other);
  if (left < inverted) points = std::move(other);
  return left == 0;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_INJECTIVE_MAP_H
