// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_DEFORMATION_TERMS_H
#define CGAL_MULTIPLANAR_INTERNAL_DEFORMATION_TERMS_H

#include <CGAL/Multiplanar/Deformation_weights.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// The mathematics of the deformation (paper 3.1.2), shared by all solvers.
///
/// Notation. v1 v2 v3 are the sought corners of a triangle, primes mark the positions of the previous pass, v0 the
/// original ones. E = [v2 - v1, v3 - v1] (3 x 2), A' is the triangle's area, u = v - v' a displacement, n the unit
/// normal of the triangle's label.
///
/// Elimination of v4 (equations 7 and 8). The paper adds to each triangle a fourth vertex, v4' = v1' + m' with
/// m' = n' / |n'|^(1/2) orthogonal to the triangle, and an unknown v4 = v1 + m. The map T with T [E' m'] = [E m] is
///
///     T = [E m] [E' m']^-1 = E E'^+ + m m'^T / |m'|^2,            because m' is orthogonal to the columns of E',
///     I =                    E' E'^+ + m' m'^T / |m'|^2,
///     |T - I|^2 = |(E - E') E'^+|^2 + |m - m'|^2 / |m'|^2         (Frobenius norms),
///
/// without a mixed term, since E'^+ m' = 0. No other objective holds m, and m = m' makes the second term vanish, so
/// the minimiser has m = m' and the vertices minimise the first term alone. With E' = Q R, Q^T Q = I, R a 2 x 2
/// triangle, E'^+ = R^-1 Q^T and the first term is |(E - E') R^-1|^2: six residuals in the positions alone.
///
/// Put v1 v2 on the triangle's longest edge, of length l, and let t l be the foot and h the height of v3 over it
/// (0 <= t <= 1). Then R = [l, t l; 0, h] and the two columns of (E - E') R^-1 are
///
///     (u2 - u1) / l      and      (u3 - (1 - t) u1 - t u2) / h.
///
/// In other words: A' |T - I|^2 is the Dirichlet energy over the triangle of the piecewise linear displacement.
///
/// Slivers. Only h can be small against l. Taking max(h, 1e-3 l) for h regularises E'^T E' = R^T R where the triangle
/// is a sliver and nowhere else; for any triangle both coefficients times sqrt(A') are then below 23.
namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The residuals of equation 8 for one triangle, times sqrt(weight): for i = 0, 1, the vectors sum_j rows[i][j] u_j.
using Transformation_rows = std::array<std::array<double, 3>, 2>;

/// \param weight the squared residuals are multiplied with this and with the triangle's present area.
/// The rows of each pair sum to zero: a translation is free. A triangle with no extent gets zeros.
inline Transformation_rows transformation_rows(const Point_3& p0, const Point_3& p1, const Point_3& p2, double weight)
{
  constexpr double smallest_height = 1e-3; // of the longest edge
  const std::array<const Point_3*, 3> p = {&p0, &p1, &p2};
  const std::array<double, 3> squared_edge = {CGAL::squared_distance(p0, p1), CGAL::squared_distance(p1, p2),
                                              CGAL::squared_distance(p2, p0)};
  const int i1 = int(std::max_element(squared_edge.begin(), squared_edge.end()) - squared_edge.begin());
  const int i2 = (i1 + 1) % 3, i3 = (i1 + 2) % 3;
  Transformation_rows rows = {};
  const double squared_l = squared_edge[i1];
  if (!(squared_l > 0)) return rows;

  const Vector_3 base = *p[i2] - *p[i1], side = *p[i3] - *p[i1];
  const double l = std::sqrt(squared_l), t = (base * side) / squared_l;
  const double twice_area = std::sqrt(CGAL::cross_product(base, side).squared_length());
  const double scale = std::sqrt(weight * twice_area / 2);
  const double along = scale / l, across = scale / (std::max)(twice_area / l, smallest_height * l);
  rows[0][i1] = -along;
  rows[0][i2] = along;
  rows[1][i1] = -across * (1 - t);
  rows[1][i2] = -across * t;
  rows[1][i3] = across;
  return rows;
}

/// Sum of the areas of all triangles.
inline double surface_area(const Connectivity& c, const Points& points)
{
  double twice_area = 0;
  for (int f = 0; f < c.number_of_faces(); ++f) twice_area += std::sqrt(area_vector(c, points, f).squared_length());
  return twice_area / 2;
}

/// A third of the area of the star of each vertex, as a share of the whole area. Vertices among slivers alone get a
/// thousandth of the mean, so that nothing in the system is without a hold.
inline std::vector<double> vertex_area_shares(const Connectivity& c, const Points& points, double area)
{
  std::vector<double> share(c.number_of_vertices(), 0.);
  for (int f = 0; f < c.number_of_faces(); ++f) {
    const double third = std::sqrt(area_vector(c, points, f).squared_length()) / (6 * area);
    for (int v : c.triangles[f]) share[v] += third;
  }
  const double least = 1e-3 / c.number_of_vertices();
  for (double& s : share) s = (std::max)(s, least);
  return share;
}

/// The vertices joined to `v` by an edge, counter-clockwise seen from outside, appended to `out`.
inline void append_neighbours(const Connectivity& c, int v, std::vector<int>& out)
{
  for (int f : c.star(v)) out.push_back(c.triangles[f][(c.corner_of(f, v) + 1) % 3]);
}

/// All coefficients of one deformation problem: set up once from the original mesh, updated before each pass.
class Deformation_terms
{
public:
  /// \pre `weights.is_valid()`, one point a vertex, the surface has an area. Keeps a pointer to `connectivity`.
  Deformation_terms(const Connectivity& connectivity, const Points& rest, const Deformation_weights& weights)
      : connectivity_(&connectivity), rest_(rest), weights_(weights), area_(surface_area(connectivity, rest)),
        area_share_(vertex_area_shares(connectivity, rest, area_)), similarity_(area_share_.size()),
        transformation_(connectivity.triangles.size()), normals_(connectivity.triangles.size())
  {
    CGAL_precondition(weights.is_valid());
    CGAL_precondition(int(rest.size()) == connectivity.number_of_vertices());
    CGAL_precondition(area_ > 0);
  }

  /// Computes the coefficients of the pass that starts at `current`. The arguments are those of a solver's `solve`.
  /// Returns false if one of them is not finite.
  bool update(const Points& current, const std::vector<int>& labels, const std::vector<Vector_3>& normals, double w_p,
              const std::vector<double>& similarity_scale)
  {
    const Connectivity& c = *connectivity_;
    CGAL_precondition(int(current.size()) == c.number_of_vertices());
    CGAL_precondition(int(labels.size()) == c.number_of_faces());
    CGAL_precondition(similarity_scale.empty() || similarity_scale.size() == current.size());
    CGAL_precondition(!(w_p < 0));
    double sum = w_p; // finite if and only if every number is, but for overflow, which is no better
    for (int v = 0; v < c.number_of_vertices(); ++v) {
      const double scale = similarity_scale.empty() ? 1 : similarity_scale[v];
      CGAL_precondition(!(scale <= 0));
      similarity_[v] = weights_.similarity * area_share_[v] * scale;
      sum += similarity_[v] + (current[v] - CGAL::ORIGIN).squared_length();
    }
    for (int f = 0; f < c.number_of_faces(); ++f) {
      const auto& t = c.triangles[f];
      CGAL_precondition(0 <= labels[f] && labels[f] < int(normals.size()));
      normals_[f] = w_p * normals[labels[f]];
      transformation_[f] =
          transformation_rows(current[t[0]], current[t[1]], current[t[2]], weights_.transformation / area_);
      sum += normals_[f].squared_length();
    }
    return std::isfinite(sum);
  }

  const Connectivity& connectivity() const { return *connectivity_; }
  const Points& rest() const { return rest_; }
  bool has_smoothness() const { return weights_.smoothness > 0; }

  /// Weight of |v - v0|^2.
  double similarity(int v) const { return similarity_[v]; }
  /// Residual rows of equation 8, weighted.
  const Transformation_rows& transformation(int f) const { return transformation_[f]; }
  /// w_p times the normal of the face's label: the residuals of equation 6 are its products with two edges.
  const Vector_3& weighted_normal(int f) const { return normals_[f]; }
  /// Weight of |v - mean of neighbours|^2.
  double smoothness() const { return weights_.smoothness * connectivity_->number_of_vertices(); }

private:
  const Connectivity* connectivity_;
  Points rest_;
  Deformation_weights weights_;
  double area_;
  std::vector<double> area_share_;
  std::vector<double> similarity_;
  std::vector<Transformation_rows> transformation_;
  std::vector<Vector_3> normals_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_DEFORMATION_TERMS_H
