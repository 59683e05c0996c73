// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_HAUSDORFF_H
#define CGAL_MULTIPLANAR_HAUSDORFF_H

#include <CGAL/Multiplanar/internal/Triangle_tree.h>
#include <CGAL/Multiplanar/internal/kernel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// The largest distance of a point of one surface from another surface, known to lie in [lower, upper]. `lower` is
/// attained at `witness`.
struct Directed_hausdorff
{
  double lower = 0 /**< attained at `witness` */, upper = 0 /**< never exceeded */;
  Point_3 witness = Point_3(0, 0, 0); ///< a point of the first surface so far from the second
};

/// Both directed distances. The symmetric Hausdorff distance lies in [lower(), upper()].
struct Symmetric_hausdorff
{
  Directed_hausdorff to_second; ///< from points of the first surface to the second
  Directed_hausdorff to_first;  ///< from points of the second surface to the first

  double lower() const { return (std::max)(to_second.lower, to_first.lower); } ///< a distance that is attained
  double upper() const { return (std::max)(to_second.upper, to_first.upper); } ///< a distance that is never exceeded
};

namespace internal {

using Triangle_list = std::vector<std::array<int, 3>>;

inline std::vector<Vec3> as_vecs(const Points& points)
{
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Point_3& p : points) result.push_back(as_vec(p));
  return result;
}

/// Branch and bound for max { d(x, B) : x in A }.
///
/// For a triangle T and any triangle b of B, x -> d(x, b) is convex, so on T it is largest at a corner of T:
///   max_T d(x, B) <= max_i d(T_i, b).
/// And d(x, B) is 1-Lipschitz: max_T d(x, B) <= d(m, B) + max_i |T_i - m|, m the centroid. The smaller of both bounds
/// T; the triangle with the largest bound is divided until no bound exceeds what is attained by more than the error
/// allowed: across its longest edge, or, where T lies close to B across a side of b, along that side, so that
/// coinciding surfaces with different triangles are overlaid exactly.
class Directed_hausdorff_search
{
public:
  explicit Directed_hausdorff_search(const Triangle_tree& tree) : tree(tree) {}

  Directed_hausdorff run(const std::vector<Vec3>& points, const Triangle_list& triangles, double error)
  {
    std::vector<int> near(points.size(), -1);
    for (const auto& t : triangles)
      for (int v : t)
        if (near[v] < 0) near[v] = probe(points[v], near[t[0]]).triangle;
    for (const auto& t : triangles) {
      Piece piece{{points[t[0]], points[t[1]], points[t[2]]}, near[t[0]], (std::numeric_limits<double>::max)(), 0};
      for (int v : t) piece.bound = (std::min)(piece.bound, convex_bound(piece, near[v]));
      if (piece.bound > lower + error) bound_and_push(piece, error);
      else drop(piece);
    }
    while (!queue.empty()) {
      const Piece piece = queue.top();
      queue.pop();
      if (piece.bound > lower + error) divide(piece, error);
      else drop(piece);
    }
    Directed_hausdorff result;
    result.lower = lower;
    result.upper = (std::max)(lower, largest_dropped);
    result.witness = as_point(witness);
    CGAL_postcondition(result.upper <= result.lower + error);
    return result;
  }

private:
  struct Piece
  {
    std::array<Vec3, 3> p;
    int near;
    double bound;
    int cuts; ///< along sides since it was last halved
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };

  Triangle_tree::Closest probe(const Vec3& q, int hint)
  {
    const auto c = tree.closest(q, hint);
    const double d = std::sqrt(c.squared_distance);
    if (d > lower) lower = d, witness = q;
    return c;
  }

  double convex_bound(const Piece& piece, int b) const
  {
    double worst = 0;
    for (const Vec3& q : piece.p)
      worst =
          (std::max)(worst, squared_distance_to_triangle(q, tree.corner(b, 0), tree.corner(b, 1), tree.corner(b, 2)));
    return std::sqrt(worst);
  }

  void bound_and_push(Piece& piece, double error)
  {
    const Vec3 m = (piece.p[0] + piece.p[1] + piece.p[2]) / 3;
    const auto c = probe(m, piece.near);
    piece.near = c.triangle;
    double radius = 0;
    for (const Vec3& q : piece.p) radius = (std::max)(radius, (q - m).squaredNorm());
    piece.bound = (std::min)(piece.bound, std::sqrt(c.squared_distance) + std::sqrt(radius));
    piece.bound = (std::min)(piece.bound, convex_bound(piece, c.triangle));
    if (piece.bound > lower + error) queue.push(piece);
    else drop(piece);
  }

  /// Looks at a piece no further: its bound is within the error of what is attained, and `lower` only grows.
  void drop(const Piece& piece) { largest_dropped = (std::max)(largest_dropped, piece.bound); }

  void divide(const Piece& piece, double error)
  {
    if (piece.cuts < 12 && cut_along_side(piece, error)) return;
    int longest = 0;
    double length = -1;
    for (int i = 0; i < 3; ++i) {
      const double l = (piece.p[(i + 1) % 3] - piece.p[i]).squaredNorm();
      if (l > length) length = l, longest = i;
    }
    const Vec3 m = (piece.p[longest] + piece.p[(longest + 1) % 3]) / 2;
    probe(m, piece.near);
    Piece left = piece, right = piece;
    left.p[(longest + 1) % 3] = m;
    right.p[longest] = m;
    left.cuts = right.cuts = 0;
    bound_and_push(left, error);
    bound_and_push(right, error);
  }

  /// Cuts a piece that is much closer to b than large, and not much larger than b, by the plane through a side of b,
  /// upright on b, that it crosses most. \return false if there is none
  bool cut_along_side(const Piece& piece, double error)
  {
    const Vec3 &a = tree.corner(piece.near, 0), &b = tree.corner(piece.near, 1), &c = tree.corner(piece.near, 2);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    double height = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
      height = (std::max)(height, std::abs(normal.dot(piece.p[i] - a)));
      size = (std::max)(size, (piece.p[(i + 1) % 3] - piece.p[i]).norm());
    }
    const double side_of_b =
        std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    if (!(height < 0.1 * size) || size > 3 * side_of_b) return false;
    double deepest = 1e-9 * size;
    std::array<double, 3> side{};
    for (int i = 0; i < 3; ++i) {
      const Vec3 &from = tree.corner(piece.near, i), &to = tree.corner(piece.near, (i + 1) % 3);
      const Vec3 inward = normal.cross(to - from).normalized();
      std::array<double, 3> d{};
      for (int j = 0; j < 3; ++j) d[j] = inward.dot(piece.p[j] - from);
      const double crossing = (std::min)(*std::max_element(d.begin(), d.end()), -*std::min_element(d.begin(), d.end()));
      if (crossing > deepest) deepest = crossing, side = d;
    }
    if (deepest <= 1e-9 * size) return false;
    for (int sign : {1, -1}) push_part(piece, side, sign, error);
    return true;
  }

  /// The part of a piece where sign * side >= 0, as one or two triangles.
  void push_part(const Piece& piece, const std::array<double, 3>& side, int sign, double error)
  {
    Vec3 polygon[4];
    int n = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const double s = sign * side[i], t = sign * side[j];
      if (s >= 0) polygon[n++] = piece.p[i];
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) polygon[n++] = piece.p[i] + (piece.p[j] - piece.p[i]) * (s / (s - t));
    }
    for (int i = 2; i < n; ++i) {
      Piece part = piece;
      part.p = {polygon[0], polygon[i - 1], polygon[i]};
      part.cuts = piece.cuts + 1;
      bound_and_push(part, error);
    }
  }

  const Triangle_tree& tree;
  std::priority_queue<Piece> queue;
  double lower = 0, largest_dropped = 0;
  Vec3 witness = Vec3::Zero();
};

/// Integrates d(x, tree) over the triangles by the centroid rule on pieces with edges of at most `size`.
inline double mean_distance_to_tree(const std::vector<Vec3>& points, const Triangle_list& triangles,
                                    const Triangle_tree& tree, double size)
{
  double integral = 0, area = 0;
  int hint = -1;
  for (const auto& t : triangles) {
    const Vec3 a = points[t[0]], u = points[t[1]] - a, v = points[t[2]] - a;
    const double longest = (std::max)({u.norm(), v.norm(), (u - v).norm()});
    const int n = (std::max)(1, int(std::ceil(longest / size)));
    const double piece = u.cross(v).norm() / 2 / (double(n) * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (int up = 0; up < 2; ++up) {
          if (up == 1 && i + j + 1 >= n) continue;
          const double shift = up == 0 ? 1.0 / 3 : 2.0 / 3;
          const auto c = tree.closest(a + u * ((i + shift) / n) + v * ((j + shift) / n), hint);
          hint = c.triangle;
          integral += piece * std::sqrt(c.squared_distance);
          area += piece;
        }
  }
  return area > 0 ? integral / area : 0;
}

inline double bounding_box_diagonal(const std::vector<Vec3>& points)
{
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

} // namespace internal

/*!
\ingroup PkgMultiplanarDistance

The largest distance of a point of the surface A from the surface B, with certified bounds (up to the rounding of
doubles, about 1e-15 of the coordinates).

\param points_a, triangles_a the surface A: points, and triples of their indices
\param points_b, triangles_b the surface B
\param error how far apart the bounds may be, in the units of the points; > 0

The surfaces are triangles over points; they need not be closed, but must not be empty.
*/
inline Directed_hausdorff directed_hausdorff(const Points& points_a, const std::vector<std::array<int, 3>>& triangles_a,
                                             const Points& points_b, const std::vector<std::array<int, 3>>& triangles_b,
                                             double error)
{
  if (triangles_a.empty() || triangles_b.empty()) throw std::invalid_argument("the distance of an empty surface");
  if (!(error > 0)) throw std::invalid_argument("the error of a Hausdorff distance must be positive");
  const internal::Triangle_tree tree(internal::as_vecs(points_b), triangles_b);
  return internal::Directed_hausdorff_search(tree).run(internal::as_vecs(points_a), triangles_a, error);
}

/// \ingroup PkgMultiplanarDistance
/// The symmetric Hausdorff distance of two surfaces, each direction within `error`.
inline Symmetric_hausdorff symmetric_hausdorff(const Points& points_a,
                                               const std::vector<std::array<int, 3>>& triangles_a,
                                               const Points& points_b,
                                               const std::vector<std::array<int, 3>>& triangles_b, double error)
{
  Symmetric_hausdorff result;
  result.to_second = directed_hausdorff(points_a, triangles_a, points_b, triangles_b, error);
  result.to_first = directed_hausdorff(points_b, triangles_b, points_a, triangles_a, error);
  return result;
}

/// \ingroup PkgMultiplanarDistance
/// The mean distance of the points of A from B: the integral over A by the centroid rule on pieces of at most 1/100
/// of A's bounding-box diagonal, over the area.
inline double mean_distance(const Points& points_a, const std::vector<std::array<int, 3>>& triangles_a,
                            const Points& points_b, const std::vector<std::array<int, 3>>& triangles_b)
{
  if (triangles_a.empty() || triangles_b.empty()) throw std::invalid_argument("the distance of an empty surface");
  const auto a = internal::as_vecs(points_a);
  const internal::Triangle_tree tree(internal::as_vecs(points_b), triangles_b);
  return internal::mean_distance_to_tree(a, triangles_a, tree, internal::bounding_box_diagonal(a) / 100);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_HAUSDORFF_H
