// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_DEFORMATION_FIXTURES_H
#define MULTIPLANAR_TEST_DEFORMATION_FIXTURES_H

#include "meshes.h"

#include <CGAL/Multiplanar/Deformation_weights.h>
#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <Eigen/Dense>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Multiplanar_test {

using CGAL::Multiplanar::Deformation_weights;
using CGAL::Multiplanar::internal::Connectivity;

/// The arguments of one deformation.
struct Deformation_problem
{
  std::string name;
  Connectivity connectivity;
  Points rest;
  Points current;
  std::vector<int> labels;
  std::vector<Vector_3> normals;
  Deformation_weights weights;
  double w_p = 1;
  std::vector<double> similarity_scale;
};

inline Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// The directions of `count` points that spiral around the unit sphere.
inline std::vector<Vector_3> spiral_directions(int count)
{
  std::vector<Vector_3> result;
  const double golden = std::acos(-1.) * (3 - std::sqrt(5.));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.) / count, r = std::sqrt(1 - z * z);
    result.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return result;
}

inline int nearest_direction(const std::vector<Vector_3>& directions, const Vector_3& v)
{
  int best = 0;
  for (int i = 1; i < int(directions.size()); ++i)
    if (directions[i] * v > directions[best] * v) best = i;
  return best;
}

/// Unit area-weighted mean normal of each label; zero for a label without faces.
inline std::vector<Vector_3> mean_normals(const Connectivity& c, const Points& points, const std::vector<int>& labels,
                                          int number_of_labels)
{
  std::vector<Vector_3> normals(number_of_labels, CGAL::NULL_VECTOR);
  for (int f = 0; f < c.number_of_faces(); ++f)
    normals[labels[f]] = normals[labels[f]] + CGAL::Multiplanar::internal::area_vector(c, points, f);
  for (Vector_3& n : normals)
    if (n.squared_length() > 0) n = unit(n);
  return normals;
}

/// `mesh` in the unit frame, faces labelled by the nearest of k directions, at rest.
inline Deformation_problem problem_at_rest(const std::string& name, const Mesh& mesh, int k)
{
  Deformation_problem p;
  p.name = name;
  p.rest = p.current = normalised(mesh).points;
  p.connectivity = CGAL::Multiplanar::internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
  const std::vector<Vector_3> directions = spiral_directions(k);
  for (int f = 0; f < p.connectivity.number_of_faces(); ++f)
    p.labels.push_back(
        nearest_direction(directions, CGAL::Multiplanar::internal::area_vector(p.connectivity, p.rest, f)));
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, k);
  return p;
}

/// A number in [-1, 1] from the upper bits of the generator: the same on every platform.
inline double random_unit(std::mt19937_64& random) { return double(random() >> 11) / double(1ull << 52) - 1; }

/// Moves each current position by up to `amount` in each coordinate.
inline Deformation_problem shaken(Deformation_problem p, double amount, std::mt19937_64& random)
{
  for (Point_3& q : p.current) q = q + amount * Vector_3(random_unit(random), random_unit(random), random_unit(random));
  return p;
}

inline double largest_distance(const Points& a, const Points& b)
{
  double squared = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squared = (std::max)(squared, CGAL::squared_distance(a[i], b[i]));
  return std::sqrt(squared);
}

/// Largest distance between the vertices of a face and the plane through one of them with the face's label normal.
inline double largest_unevenness(const Deformation_problem& p, const Points& points)
{
  double largest = 0;
  for (int f = 0; f < p.connectivity.number_of_faces(); ++f) {
    const auto& t = p.connectivity.triangles[f];
    const Vector_3& n = p.normals[p.labels[f]];
    for (int i = 1; i < 3; ++i) largest = (std::max)(largest, std::abs(n * (points[t[i]] - points[t[0]])));
  }
  return largest;
}

/// The slow twin of a solver: the paper's system, row by row, with an unknown v4 for every triangle, dense.
class Full_deformation_system
{
public:
  explicit Full_deformation_system(const Deformation_problem& p) : p_(p), n_(int(p.rest.size()))
  {
    const Connectivity& c = p.connectivity;
    columns_ = 3 * (n_ + c.number_of_faces());
    for (int f = 0; f < c.number_of_faces(); ++f)
      area_ += std::sqrt(
          CGAL::squared_area(p.rest[c.triangles[f][0]], p.rest[c.triangles[f][1]], p.rest[c.triangles[f][2]]));
    for (int v = 0; v < n_; ++v) add_similarity(v);
    for (int f = 0; f < c.number_of_faces(); ++f) {
      add_flattening(f);
      add_transformation(f);
    }
    for (int v = 0; v < n_; ++v) add_smoothness(v);
  }

  Points minimiser() const
  {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(Eigen::Index(rows_.size()), columns_);
    Eigen::VectorXd b(Eigen::Index(rows_.size()));
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      for (const auto& entry : rows_[i].first) a(i, entry.first) += entry.second;
      b(i) = rows_[i].second;
    }
    const Eigen::VectorXd x = a.householderQr().solve(b);
    Points points;
    for (int v = 0; v < n_; ++v) points.emplace_back(x(3 * v), x(3 * v + 1), x(3 * v + 2));
    return points;
  }

private:
  using Row = std::vector<std::pair<int, double>>; // column, coefficient

  void add_row(Row row, double right_side, double squared_weight)
  {
    for (auto& entry : row) entry.second *= std::sqrt(squared_weight);
    rows_.emplace_back(std::move(row), std::sqrt(squared_weight) * right_side);
  }

  /// Equation 5.
  void add_similarity(int v)
  {
    double star = 0;
    for (int f : p_.connectivity.star(v)) {
      const auto& t = p_.connectivity.triangles[f];
      star += std::sqrt(CGAL::squared_area(p_.rest[t[0]], p_.rest[t[1]], p_.rest[t[2]]));
    }
    const double scale = p_.similarity_scale.empty() ? 1 : p_.similarity_scale[v];
    for (int d = 0; d < 3; ++d)
      add_row({{3 * v + d, 1}}, p_.rest[v][d], p_.weights.similarity * scale * star / 3 / area_);
  }

  /// Equation 6.
  void add_flattening(int f)
  {
    const auto& t = p_.connectivity.triangles[f];
    const Vector_3& n = p_.normals[p_.labels[f]];
    for (int i = 1; i < 3; ++i) {
      Row row;
      for (int d = 0; d < 3; ++d) {
        row.emplace_back(3 * t[i] + d, n[d]);
        row.emplace_back(3 * t[0] + d, -n[d]);
      }
      add_row(row, 0, p_.w_p * p_.w_p);
    }
  }

  /// Equations 7 and 8: T = V V'^-1 with the edges as columns; nine rows T = I.
  void add_transformation(int f)
  {
    const auto& t = p_.connectivity.triangles[f];
    const Vector_3 e1 = p_.current[t[1]] - p_.current[t[0]], e2 = p_.current[t[2]] - p_.current[t[0]];
    const Vector_3 normal = CGAL::cross_product(e1, e2);
    const Vector_3 e3 = normal / std::sqrt(std::sqrt(normal.squared_length()));
    Eigen::Matrix3d before;
    for (int d = 0; d < 3; ++d) before.row(d) << e1[d], e2[d], e3[d];
    const Eigen::Matrix3d inverse = before.inverse();
    const double weight = p_.weights.transformation * std::sqrt(normal.squared_length()) / 2 / area_;
    const int moved[3] = {t[1], t[2], n_ + f};
    for (int d = 0; d < 3; ++d)
      for (int j = 0; j < 3; ++j) { // T(d, j) = sum over i of (v_i - v_1)_d inverse(i, j)
        Row row;
        for (int i = 0; i < 3; ++i) {
          row.emplace_back(3 * moved[i] + d, inverse(i, j));
          row.emplace_back(3 * t[0] + d, -inverse(i, j));
        }
        add_row(row, d == j ? 1 : 0, weight);
      }
  }

  /// Equation 9.
  void add_smoothness(int v)
  {
    const Connectivity& c = p_.connectivity;
    const double valence = double(c.star(v).size());
    for (int d = 0; d < 3; ++d) {
      Row row = {{3 * v + d, 1}};
      for (int f : c.star(v)) // each neighbour lies in two faces of the star
        for (int u : c.triangles[f])
          if (u != v) row.emplace_back(3 * u + d, -0.5 / valence);
      add_row(row, 0, p_.weights.smoothness * n_);
    }
  }

  const Deformation_problem& p_;
  int n_;
  int columns_ = 0;
  double area_ = 0;
  std::vector<std::pair<Row, double>> rows_;
};

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_DEFORMATION_FIXTURES_H
