// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FIRST_FIT_H
#define CGAL_MULTIPLANAR_INTERNAL_FIRST_FIT_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/plane_corner_system.h>

#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Area, and first and second moments of points: enough for the squared distance of them all from any plane.
struct Moments
{
  double area = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vec3 normal = Vec3::Zero(); ///< sum of vector areas

  Moments& operator+=(const Moments& o)
  {
    area += o.area, first += o.first, second += o.second, normal += o.normal;
    return *this;
  }
};

/// Moments of a triangle as a surface: its exact integrals.
inline Moments triangle_moments(const Vec3& a, const Vec3& b, const Vec3& c)
{
  Moments m;
  m.normal = (b - a).cross(c - a) / 2;
  m.area = m.normal.norm();
  const Vec3 sum = a + b + c;
  m.first = m.area / 3 * sum;
  m.second = m.area / 12 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  return m;
}

/// Moments of all faces of a mesh.
inline std::vector<Moments> face_moments(const Connectivity& c, const std::vector<Vec3>& points)
{
  std::vector<Moments> result;
  result.reserve(c.number_of_faces());
  for (const auto& t : c.triangles) result.push_back(triangle_moments(points[t[0]], points[t[1]], points[t[2]]));
  return result;
}

/// The plane with the least mean squared distance from the points of `m`, its normal on the side of the mean normal.
/// Where the points have no clear plane (two small variances), the mean normal decides.
inline void fit_plane(const Moments& m, Vec3& normal, double& offset)
{
  const Vec3 mean = m.first / (m.area > 0 ? m.area : 1);
  const Eigen::Matrix3d variance = m.second / (m.area > 0 ? m.area : 1) - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(variance);
  normal = eigen.eigenvectors().col(0);
  const Vec3 average = m.normal.normalized();
  if (normal.dot(average) < 0) normal = -normal;
  if (normal.dot(average) < 0.7 && m.normal.norm() > 0) normal = average;
  offset = normal.dot(mean);
}

/// Planes and corners of the free panels fitted together: minimises
///   sum over free panels of  integral (n.x - d)^2 over its faces / total area  +  pull * sum over corners |x - x0|^2
/// (for a free panel not in `refit`, the motion of its plane takes the integral's place) under flatness, by
/// Gauss-Newton steps that start at x0 (corners anywhere, planes as in `s`) and end flat. The pull keeps
/// ill-conditioned corners in place. \return false if no flat state was reached
inline bool first_fit(const std::vector<Moments>& moments, Plane_corner_system& system, const std::vector<char>& refit,
                      Flat_state& s, double pull, int steps = 8)
{
  const std::vector<Vec3> old = s.corner;
  double area = 0;
  for (int p : system.free_panels()) area += moments[p].area;
  Linear_form form;
  for (int step = 0; step < steps; ++step) {
    system.linearise(s);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(system.unknowns(), system.unknowns());
    Eigen::VectorXd f = Eigen::VectorXd::Zero(system.unknowns());
    H.diagonal().array() += 1e-9;
    for (int p : system.free_panels()) {
      if (!refit[p]) {
        H.diagonal().segment<3>(3 * system.block_of(p)).array() += moments[p].area / area;
        continue;
      }
      // The three principal points q_i = mean +- sqrt(3) sigma_i e_i reproduce the second moments exactly.
      const Moments& m = moments[p];
      const Vec3 mean = m.first / m.area;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m.second / m.area - mean * mean.transpose());
      for (int i = 0; i < 6; ++i) {
        const double sigma = std::sqrt((std::max)(0.0, 3 * eigen.eigenvalues()[i / 2]));
        const Vec3 q = mean + (i % 2 == 0 ? sigma : -sigma) * eigen.eigenvectors().col(i / 2);
        const double r = s.offset[p] - s.normal[p].dot(q);
        form.clear();
        system.add_panel_motion(p, q + r * s.normal[p], 1, form);
        add_square(form, m.area / area / 6, r, H, f);
      }
    }
    for (int c : system.free_corners())
      for (int i = 0; i < 3; ++i) {
        form.clear();
        system.add_corner_motion(c, Vec3::Unit(i), form);
        add_square(form, pull, s.corner[c][i] - old[c][i], H, f);
      }
    const Eigen::VectorXd y = system.solve(H, f);
    if (!y.allFinite()) return false;
    system.move_linearly(y, s);
    if (y.norm() < 1e-10) break;
  }
  system.linearise(s);
  return system.settle(s);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FIRST_FIT_H
