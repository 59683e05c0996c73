// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PLANES_H
#define CGAL_MULTIPLANAR_PLANES_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Plane.h>
#include <CGAL/Multiplanar/label_costs.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The labels whose planes `estimate_planes()` could not take from the mean of their faces, in increasing order.
struct Plane_estimation
{
  std::vector<int> emptied;   ///< labels without a face of positive area
  std::vector<int> cancelled; ///< labels whose normals cancel
};

namespace internal {

/// Area-weighted sums over the faces of one label.
struct Plane_sums
{
  double area = 0;
  Vector_3 normal = Vector_3(0, 0, 0), centroid = Vector_3(0, 0, 0);
  int largest_face = -1; // the first of the largest

  void add(const Label_costs& costs, int face)
  {
    const double a = costs.area(face);
    area += a;
    normal = normal + a * costs.normal(face);
    centroid = centroid + a * (costs.centroid(face) - CGAL::ORIGIN);
    if (largest_face == -1 || a > costs.area(largest_face)) largest_face = face;
  }
};

/// The plane with this unit normal through the mean centroid.
inline Plane plane_through_centroid(const Vector_3& normal, const Plane_sums& sums)
{
  return {normal, normal * sums.centroid / sums.area};
}

} // namespace internal

/// Estimates the plane of each label from its faces (section 3.1.1, "updating plane equations"): the area-weighted mean
/// of their normals, made unit, through the area-weighted mean of their centroids.
///
/// What has no mean:
/// - a label without faces (or with faces of area 0 only) keeps the plane it had, and is listed as emptied: it may win
///   faces back in the next labelling, or be given another plane by the caller;
/// - a label whose mean normal is shorter than `cancelling` (its faces point all ways: both sides of a thin sheet, a
///   whole sphere) takes the normal of its largest face, the one of least index among equals, still through the mean
///   centroid, and is listed as cancelled.
/// Labels that come to lie on the same plane both keep it; see `first_coinciding()`.
///
/// The mean normal does not minimise eq. 2, which sums absolute values, so the energy may rise a little here.
/// \param costs areas, normals and centroids of the faces
/// \param labelling the label of each face
/// \param planes the planes of all labels, replaced by the estimates
/// \param cancelling mean normals shorter than this are none
/// \pre `labelling` has a label in 0 .. planes.size() - 1 for each face. Linear time.
inline Plane_estimation estimate_planes(const Label_costs& costs, const std::vector<int>& labelling,
                                        std::vector<Plane>& planes, double cancelling = 1e-6)
{
  CGAL_precondition(labelling.size() == std::size_t(costs.faces()));
  std::vector<internal::Plane_sums> sums(planes.size());
  for (int face = 0; face < costs.faces(); ++face) {
    CGAL_precondition(0 <= labelling[face] && labelling[face] < int(planes.size()));
    sums[labelling[face]].add(costs, face);
  }
  Plane_estimation result;
  for (int label = 0; label < int(planes.size()); ++label) {
    const internal::Plane_sums& s = sums[label];
    if (!(s.area > 0)) {
      result.emptied.push_back(label);
      continue;
    }
    const double length = std::sqrt(s.normal.squared_length());
    if (length > cancelling * s.area) {
      planes[label] = internal::plane_through_centroid(s.normal / length, s);
    } else {
      result.cancelled.push_back(label);
      planes[label] = internal::plane_through_centroid(costs.normal(s.largest_face), s);
    }
  }
  return result;
}

/// For each label the least label with the same plane, normals and offsets equal up to `tolerance`; itself if none.
///
/// Two labels on one plane are allowed. Their data costs are equal, so where their faces meet the boundary between them
/// costs and gains nothing: the next alpha-expansion gives the one's faces to the other wherever that is all there is
/// to it, and the label so emptied is reported by `estimate_planes()`. Labels with equal planes whose faces do not meet
/// stay two. Faces never decide by chance: on a tie they keep their label. O(k^2) time for k labels.
inline std::vector<int> first_coinciding(const std::vector<Plane>& planes, double tolerance = 1e-9)
{
  const auto same = [tolerance](const Plane& a, const Plane& b) {
    return (a.normal - b.normal).squared_length() <= tolerance * tolerance &&
           std::abs(a.offset - b.offset) <= tolerance;
  };
  std::vector<int> first(planes.size());
  for (int i = 0; i < int(planes.size()); ++i) {
    first[i] = 0;
    while (!same(planes[first[i]], planes[i])) ++first[i];
  }
  return first;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PLANES_H
