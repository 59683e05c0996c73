// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PLANE_CORNER_SYSTEM_H
#define CGAL_MULTIPLANAR_INTERNAL_PLANE_CORNER_SYSTEM_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

// Planes and corners as one linearised system
// -------------------------------------------
// Panel P lies in the plane n.(x - m) = h, where m is a fixed point amid the panel (so that turning and shifting the
// plane are independent) and R its radius. Its unknowns are the three lengths y_P = (a, b, h'), with
//   dn = (a t1 + b t2) / R,   dh = h'            (t1, t2: unit tangents),
// so that all unknowns have the same unit. A corner x on P obeys n.(x - m) = h; to first order
//   n.dx = dh - (x - m).dn - rho = g.y_P - rho,   g = (-(x-m).t1 / R, -(x-m).t2 / R, 1),           (*)
// where rho = n.(x - m) - h is what the corner misses the plane by now.
//
// A *regular* corner has three panels whose normals N (rows) are independent: then dx = N^-1 (g.y - rho) follows from
// the planes, and after the planes moved the corner is put exactly on them: x = N^-1 d. All other corners (four or more
// panels, or nearly dependent normals) are *special*: they have unknowns dx of their own, and (*) are rows of a
// constraint system C y = c. A step minimises 1/2 y.Hy + f.y under C y = c; with H = L L^T,
//   (C H^-1 C^T) mu = -(C H^-1 f + c),   y = -H^-1 (f + C^T mu).
// This is the KKT system of planes and all corners with the regular corners eliminated: for k panels, 3 k unknowns
// instead of about 15 k.
//
// A *pinned* corner lies on planes that are not free and meet in one point: dx = 0, and (*) is left for its free
// panels. Where corners have many panels, as on the triangles of a mesh, most corners around a few free panels are.

/// A linear form in the unknowns, in blocks of three, plus a constant.
struct Linear_form
{
  static constexpr int capacity = 48;
  int blocks = 0;
  int block[capacity];
  Vec3 value[capacity];
  double constant = 0;

  void clear() { blocks = 0, constant = 0; }
  void add(int b, const Vec3& v)
  {
    for (int i = 0; i < blocks; ++i)
      if (block[i] == b) {
        value[i] += v;
        return;
      }
    if (blocks == capacity) return; // corners of absurd valence: the form is used as a model only
    block[blocks] = b;
    value[blocks++] = v;
  }
  double operator()(const Eigen::VectorXd& y) const
  {
    double sum = constant;
    for (int i = 0; i < blocks; ++i) sum += value[i].dot(y.segment<3>(3 * block[i]));
    return sum;
  }
};

/// Adds weight/2 (form + residual)^2 to the quadratic function 1/2 y.Hy + f.y. Only the lower triangle of H is kept.
inline void add_square(const Linear_form& form, double weight, double residual, Eigen::MatrixXd& H, Eigen::VectorXd& f)
{
  const double r = form.constant + residual;
  for (int i = 0; i < form.blocks; ++i) {
    const Vec3 w = weight * form.value[i];
    f.segment<3>(3 * form.block[i]) += r * w;
    for (int j = 0; j < form.blocks; ++j)
      if (form.block[j] <= form.block[i])
        H.block<3, 3>(3 * form.block[i], 3 * form.block[j]) += w * form.value[j].transpose();
  }
}

class Plane_corner_system
{
public:
  /// \param free which panels may move; the corners on a free panel move with it, on the planes of the others
  /// \param pin whether corners are pinned where they can be; else they have unknowns that the constraints make zero
  Plane_corner_system(const Complex_topology& topology, std::vector<char> free, bool pin = false)
      : t(topology), free_(std::move(free)), pin_(pin), panel_block_(t.number_of_panels(), -1),
        corner_block_(t.number_of_corners(), -1), moves_(t.number_of_corners(), 0), frames_(t.number_of_panels()),
        inverse_(t.number_of_corners()), miss_(t.number_of_corners(), Vec3::Zero())
  {
    for (int p = 0; p < t.number_of_panels(); ++p)
      if (free_[p]) panel_block_[p] = blocks_++, free_panels_.push_back(p);
    for (int c = 0; c < t.number_of_corners(); ++c)
      for (int p : t.corner_panels[c]) moves_[c] |= free_[p];
    for (int c = 0; c < t.number_of_corners(); ++c)
      if (moves_[c]) free_corners_.push_back(c);
    panel_blocks_ = blocks_;
  }

  /// Frames, motions of corners and constraints at the state `s`. Which corners are special may change here.
  void linearise(const Flat_state& s)
  {
    for (int p : free_panels_) frames_[p] = frame(s, p);
    blocks_ = panel_blocks_;
    special_.clear();
    for (int c : free_corners_) {
      corner_block_[c] = -1;
      if (make_regular(s, c)) continue;
      if (!is_pinned(s, c)) corner_block_[c] = blocks_++;
      special_.push_back(c);
    }
    is_special_.assign(t.number_of_corners(), 0);
    for (int c : special_) is_special_[c] = 1;
    make_constraints(s);
  }

  int unknowns() const { return 3 * blocks_; }
  const std::vector<int>& free_panels() const { return free_panels_; }
  const std::vector<int>& free_corners() const { return free_corners_; }
  bool moves(int c) const { return moves_[c]; }
  bool is_free(int p) const { return free_[p]; }
  int block_of(int p) const { return panel_block_[p]; }

  /// Adds u.dx of corner `c` to `form`.
  void add_corner_motion(int c, const Vec3& u, Linear_form& form) const
  {
    if (!moves_[c]) return;
    if (is_special_[c]) {
      if (corner_block_[c] >= 0) form.add(corner_block_[c], u);
      return;
    }
    const Vec3 v = inverse_[c].transpose() * u;
    const auto& panels = t.corner_panels[c];
    for (int i = 0; i < 3; ++i)
      if (free_[panels[i]]) form.add(panel_block_[panels[i]], v[i] * incidence_[c][i]);
    form.constant -= v.dot(miss_[c]);
  }

  /// Adds factor * (motion of panel `p` along its normal at the point `q`).
  void add_panel_motion(int p, const Vec3& q, double factor, Linear_form& form) const
  {
    if (free_[p]) form.add(panel_block_[p], factor * incidence(p, q));
  }

  /// Adds u.dn of panel `p` to `form`.
  void add_turn(int p, const Vec3& u, Linear_form& form) const
  {
    if (!free_[p]) return;
    const Frame& f = frames_[p];
    form.add(panel_block_[p], Vec3(u.dot(f.tangent[0]), u.dot(f.tangent[1]), 0) / f.radius);
  }

  /// Minimises 1/2 y.Hy + f.y under the constraints; H positive definite, lower triangle.
  Eigen::VectorXd solve(const Eigen::MatrixXd& H, const Eigen::VectorXd& f) const
  {
    const Eigen::LLT<Eigen::MatrixXd> llt(H);
    if (constraints_.rows() == 0) return -llt.solve(f);
    const Eigen::MatrixXd X = llt.solve(constraints_.transpose());
    Eigen::MatrixXd S = constraints_ * X;
    S.diagonal().array() += 1e-12 * S.trace() / double(S.rows());
    const Eigen::VectorXd mu = S.ldlt().solve(-(X.transpose() * f + right_side_));
    return -llt.solve(f) - X * mu;
  }

  /// Moves planes and corners by `y`: every corner by its linear motion.
  void move_linearly(const Eigen::VectorXd& y, Flat_state& s) const
  {
    for (int c : free_corners_) {
      if (is_special_[c]) {
        move_special(y, c, s);
        continue;
      }
      Vec3 e = -miss_[c];
      for (int i = 0; i < 3; ++i) {
        const int p = t.corner_panels[c][i];
        if (free_[p]) e[i] += incidence_[c][i].dot(y.segment<3>(3 * panel_block_[p]));
      }
      s.corner[c] += inverse_[c] * e;
    }
    move_planes(y, s);
  }

  /// Moves planes by `y`, then puts every corner on them: special corners together with their planes by minimum-norm
  /// Newton steps, regular ones by intersection. \return false if that fails
  bool move(const Eigen::VectorXd& y, Flat_state& s)
  {
    for (int c : special_) move_special(y, c, s);
    move_planes(y, s);
    return settle(s);
  }

  /// Makes `s` flat: see `move`. Regular corners go where their planes meet.
  bool settle(Flat_state& s)
  {
    for (int round = 0; !special_.empty(); ++round) {
      const double worst = special_miss(s);
      if (worst < 2e-15) break;
      if (round == 12) {
        if (worst > 1e-12) return false;
        break;
      }
      for (int p : free_panels_) frames_[p] = frame(s, p);
      make_constraints(s);
      Eigen::MatrixXd S = constraints_ * constraints_.transpose();
      S.diagonal().array() += 1e-13;
      const Eigen::VectorXd y = constraints_.transpose() * S.ldlt().solve(right_side_);
      if (!y.allFinite()) return false;
      for (int c : special_) move_special(y, c, s);
      move_planes(y, s);
    }
    for (int c : free_corners_)
      if (!is_special_[c] && !intersect(s, c)) return false;
    return true;
  }

private:
  struct Frame
  {
    Vec3 middle = Vec3::Zero();
    double radius = 1;
    std::array<Vec3, 2> tangent;
  };

  Frame frame(const Flat_state& s, int p) const
  {
    Frame f;
    int n = 0;
    for (int c : t.loops[p][0]) f.middle += s.corner[c], ++n;
    f.middle /= n;
    double r = 0;
    for (int c : t.loops[p][0]) r = (std::max)(r, (s.corner[c] - f.middle).norm());
    f.radius = (std::max)(r, 1e-3);
    f.tangent = tangents(s.normal[p]);
    return f;
  }

  Vec3 incidence(int p, const Vec3& x) const
  {
    const Frame& f = frames_[p];
    const Vec3 v = (x - f.middle) / -f.radius;
    return {v.dot(f.tangent[0]), v.dot(f.tangent[1]), 1};
  }

  static double miss(const Flat_state& s, int c, int p) { return s.normal[p].dot(s.corner[c]) - s.offset[p]; }

  bool make_regular(const Flat_state& s, int c)
  {
    const auto& panels = t.corner_panels[c];
    if (panels.size() != 3) return false;
    Eigen::Matrix3d N;
    for (int i = 0; i < 3; ++i) N.row(i) = s.normal[panels[i]];
    if (std::abs(N.determinant()) < smallest_determinant) return false;
    inverse_[c] = N.inverse();
    incidence_.resize(t.number_of_corners());
    for (int i = 0; i < 3; ++i) {
      incidence_[c][i] = free_[panels[i]] ? incidence(panels[i], s.corner[c]) : Vec3(Vec3::Zero());
      miss_[c][i] = miss(s, c, panels[i]);
    }
    return true;
  }

  /// Do the planes around `c` that are not free hold it where it is?
  bool is_pinned(const Flat_state& s, int c) const
  {
    if (!pin_) return false;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int p : t.corner_panels[c]) {
      if (free_[p]) continue;
      if (std::abs(miss(s, c, p)) > 2e-15) return false;
      sum += s.normal[p] * s.normal[p].transpose();
    }
    return sum.determinant() > smallest_spread;
  }

  bool has_row(int c, int p) const { return corner_block_[c] >= 0 || free_[p]; }

  void move_special(const Eigen::VectorXd& y, int c, Flat_state& s) const
  {
    if (corner_block_[c] >= 0) s.corner[c] += y.segment<3>(3 * corner_block_[c]);
  }

  void make_constraints(const Flat_state& s)
  {
    int rows = 0;
    for (int c : special_)
      for (int p : t.corner_panels[c]) rows += has_row(c, p);
    constraints_.setZero(rows, unknowns());
    right_side_.setZero(rows);
    int row = 0;
    for (int c : special_)
      for (int p : t.corner_panels[c]) {
        if (!has_row(c, p)) continue;
        if (corner_block_[c] >= 0) constraints_.block<1, 3>(row, 3 * corner_block_[c]) = s.normal[p].transpose();
        if (free_[p]) constraints_.block<1, 3>(row, 3 * panel_block_[p]) = -incidence(p, s.corner[c]).transpose();
        right_side_[row++] = -miss(s, c, p);
      }
  }

  double special_miss(const Flat_state& s) const
  {
    double worst = 0;
    for (int c : special_)
      for (int p : t.corner_panels[c]) worst = (std::max)(worst, std::abs(miss(s, c, p)));
    return worst;
  }

  void move_planes(const Eigen::VectorXd& y, Flat_state& s) const
  {
    for (int p : free_panels_) {
      const Frame& f = frames_[p];
      const Vec3 d = y.segment<3>(3 * panel_block_[p]);
      const double h = s.offset[p] - s.normal[p].dot(f.middle) + d[2];
      const Vec3 n = s.normal[p] + (d[0] * f.tangent[0] + d[1] * f.tangent[1]) / f.radius;
      const double length = n.norm();
      s.normal[p] = n / length;
      s.offset[p] = s.normal[p].dot(f.middle) + h / length;
    }
  }

  bool intersect(Flat_state& s, int c) const
  {
    Eigen::Matrix3d N;
    Vec3 d;
    for (int i = 0; i < 3; ++i) {
      const int p = t.corner_panels[c][i];
      N.row(i) = s.normal[p];
      d[i] = s.offset[p];
    }
    if (std::abs(N.determinant()) < smallest_determinant / 4) return false;
    const Eigen::Matrix3d inverse = N.inverse();
    Vec3 x = inverse * d;
    x += inverse * (d - N * x); // one refinement: the residual to rounding
    s.corner[c] = x;
    return true;
  }

  static constexpr double smallest_determinant = 1e-3;
  static constexpr double smallest_spread = 1e-6; ///< of normals that pin a corner: the determinant of sum n n^T

  const Complex_topology& t;
  std::vector<char> free_;
  bool pin_;
  std::vector<int> panel_block_, corner_block_;
  std::vector<char> moves_, is_special_;
  std::vector<Frame> frames_;
  std::vector<Eigen::Matrix3d> inverse_;
  std::vector<Vec3> miss_;
  std::vector<std::array<Vec3, 3>> incidence_;
  std::vector<int> free_panels_, free_corners_, special_;
  int blocks_ = 0, panel_blocks_ = 0;
  Eigen::MatrixXd constraints_;
  Eigen::VectorXd right_side_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PLANE_CORNER_SYSTEM_H
