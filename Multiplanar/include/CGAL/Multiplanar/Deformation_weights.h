// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_DEFORMATION_WEIGHTS_H
#define CGAL_MULTIPLANAR_DEFORMATION_WEIGHTS_H

#include <CGAL/assertions.h>

#include <cmath>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarRef
///
/// The relative importance of the four objectives of the deformation (paper 3.1.2, equations 5 to 9).
///
/// The deformation minimises, over the vertex positions v of a mesh of unit bounding-box diagonal,
///
///     similarity     * sum over vertices  a_v s_v |v - v0|^2                                     (5)
///   + w_p^2          * sum over triangles ((v2 - v1) . n)^2 + ((v3 - v1) . n)^2                  (6)
///   + transformation * sum over triangles a_f |T - I|^2                                          (8)
///   + smoothness     * N * sum over vertices |v - mean of v's neighbours|^2                      (9)
///
/// where N is the number of vertices, a_v and a_f are areas of vertices and triangles as shares of the whole (each
/// set sums to 1 on the original mesh), and s_v is an optional multiplier of the caller's. Each sum tends to a value
/// of the surface, not of its tessellation, when the mesh is refined: (5) and (8) are integrals; in (6) and in
/// N times (9) the powers of the edge length cancel. That is why (6) has no area and (9) has the factor N.
///
/// `similarity`, `transformation` and `smoothness` multiply squared residuals. The flattening weight w_p follows
/// the paper: it multiplies the equation, so its square enters here; it grows from pass to pass.
struct Deformation_weights
{
  /// Pull towards the original positions. It is the ratio to `transformation` that matters: similarity is a squared
  /// length, transformation has no dimension. Must be positive.
  double similarity = 100;

  /// Resistance to any change of shape against the previous pass. Not negative.
  double transformation = 1;

  /// Pull of each vertex towards the mean of its neighbours; 0 leaves the objective out. Not negative.
  double smoothness = 0;

  /// Flattening weight w_p of the first and of the last pass. Positive.
  double flattening_first = 1;
  double flattening_last = 2000; ///< of the last pass

  /// The flattening weight of pass `pass` of 0 .. `number_of_passes` - 1: in geometric progression from
  /// `flattening_first` to `flattening_last`, so that every pass adds the same share. A single pass gets the last.
  double flattening(int pass, int number_of_passes) const
  {
    CGAL_precondition(0 <= pass && pass < number_of_passes);
    if (pass + 1 == number_of_passes) return flattening_last;
    return flattening_first * std::pow(flattening_last / flattening_first, double(pass) / (number_of_passes - 1));
  }
  /// Are all weights finite and in their ranges?
  bool is_valid() const
  {
    return similarity > 0 && transformation >= 0 && smoothness >= 0 && flattening_first > 0 && flattening_last > 0 &&
           std::isfinite(similarity + transformation + smoothness + flattening_first + flattening_last);
  }
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_DEFORMATION_WEIGHTS_H
