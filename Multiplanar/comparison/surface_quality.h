// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_COMPARISON_SURFACE_QUALITY_H
#define MULTIPLANAR_COMPARISON_SURFACE_QUALITY_H

#include "Compared_surface.h"

#include <CGAL/Multiplanar/hausdorff.h>
#include <CGAL/Multiplanar/internal/embedding.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// The same measures for whatever a method returns, a mesh or a soup of triangles. Nothing is mended before it is
// measured.

namespace CGAL {
namespace Multiplanar {
namespace comparison {

using namespace internal;

/// What a surface is worth as an approximation by panels. Lengths are in the units of the model.
struct Surface_quality
{
  double to_surface = 0, to_input = 0; ///< one-sided Hausdorff distances, upper bounds within 1e-4 of the diagonal
  double mean = 0;                     ///< the mean of both mean distances
  double bend = 0;                     ///< largest distance of a corner from the plane fitted to its panel's corners
  bool closed = false;                 ///< a closed oriented 2-manifold
  int open_edges = 0;                  ///< edges with one triangle
  int crowded_edges = 0;               ///< edges with more than two triangles, or two that are not oriented alike
  int flat_triangles = 0;              ///< triangles without area, which are not looked at for intersections
  int intersections = 0;               ///< pairs of triangles that meet in more than what they share. Exact

  double hausdorff() const { return (std::max)(to_surface, to_input); }
};

/// Faults of the edges, seen as those of a closed oriented surface. \return edges with one, and with wrong triangles
inline std::pair<int, int> edge_faults(const std::vector<std::array<int, 3>>& triangles)
{
  std::map<std::pair<int, int>, std::array<int, 2>> edges; // how often each is passed upward, and downward
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      ++edges[{(std::min)(a, b), (std::max)(a, b)}][a < b];
    }
  std::pair<int, int> faults(0, 0);
  for (const auto& edge : edges)
    if (edge.second[0] + edge.second[1] == 1) ++faults.first;
    else if (edge.second[0] != 1 || edge.second[1] != 1) ++faults.second;
  return faults;
}

/// Are the triangles a closed oriented 2-manifold? Points without a triangle do not count.
inline bool is_closed_manifold(std::vector<std::array<int, 3>> triangles)
{
  std::map<int, int> number;
  for (auto& t : triangles)
    for (int& v : t) v = number.emplace(v, int(number.size())).first->second;
  try {
    make_connectivity(std::move(triangles), int(number.size()));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// Pairs of triangles that meet in more than the simplex they share; two over the same three points do. Exact, and
/// quadratic in their number: for surfaces of few panels.
inline int number_of_intersections(const Points& points, const std::vector<std::array<int, 3>>& triangles)
{
  std::vector<std::array<int, 3>> solid;
  std::vector<CGAL::Bbox_3> boxes;
  for (const auto& t : triangles)
    if (!CGAL::collinear(points[t[0]], points[t[1]], points[t[2]])) {
      solid.push_back(t);
      boxes.push_back(points[t[0]].bbox() + points[t[1]].bbox() + points[t[2]].bbox());
    }
  int count = 0;
  for (std::size_t i = 0; i < solid.size(); ++i)
    for (std::size_t j = i + 1; j < solid.size(); ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j])) count += !meet_in_shared_simplex(points, solid[i], solid[j]);
  return count;
}

/// The largest distance of the points from the plane that fits them best in the sense of least squares.
inline double deviation_from_plane(const Points& points, const std::vector<int>& corners)
{
  if (corners.size() < 4) return 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (int c : corners) centre += as_vec(points[c]) / double(corners.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (int c : corners) scatter += (as_vec(points[c]) - centre) * (as_vec(points[c]) - centre).transpose();
  const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  double worst = 0;
  for (int c : corners) worst = (std::max)(worst, std::abs(normal.dot(as_vec(points[c]) - centre)));
  return worst;
}

/// \param source, triangles the model
/// \throws std::invalid_argument if `surface` has no triangles
inline Surface_quality surface_quality(const Points& source, const std::vector<std::array<int, 3>>& triangles,
                                       const Compared_surface& surface)
{
  const double error = 1e-4 * bounding_box_diagonal(as_vecs(source));
  const auto distance = symmetric_hausdorff(source, triangles, surface.points, surface.triangles, error);
  Surface_quality q;
  q.to_surface = distance.to_second.upper;
  q.to_input = distance.to_first.upper;
  q.mean = (mean_distance(source, triangles, surface.points, surface.triangles) +
            mean_distance(surface.points, surface.triangles, source, triangles)) /
           2;
  for (const auto& corners : surface.flat_together)
    q.bend = (std::max)(q.bend, deviation_from_plane(surface.points, corners));
  std::tie(q.open_edges, q.crowded_edges) = edge_faults(surface.triangles);
  q.closed = is_closed_manifold(surface.triangles);
  for (const auto& t : surface.triangles)
    q.flat_triangles += CGAL::collinear(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  q.intersections = number_of_intersections(surface.points, surface.triangles);
  return q;
}

} // namespace comparison
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_COMPARISON_SURFACE_QUALITY_H
