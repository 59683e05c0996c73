// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRIANGLE_TREE_H
#define CGAL_MULTIPLANAR_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Plain vectors for least squares and distances, where nothing is decided exactly.
using Vec3 = Eigen::Vector3d;

inline Vec3 as_vec(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
inline Point_3 as_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// A point of a triangle in barycentric coordinates.
struct Barycentric
{
  double w[3];
};

/// The point of triangle abc closest to q (Ericson, Real-Time Collision Detection, 5.1.5): a case for every feature.
inline Barycentric closest_on_triangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a, ac = c - a, ap = q - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {{1, 0, 0}};
  const Vec3 bp = q - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {{0, 1, 0}};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 > d3 ? d1 / (d1 - d3) : 0;
    return {{1 - v, v, 0}};
  }
  const Vec3 cp = q - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {{0, 0, 1}};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 > d6 ? d2 / (d2 - d6) : 0;
    return {{1 - w, 0, w}};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double s = (d4 - d3) + (d5 - d6), w = s > 0 ? (d4 - d3) / s : 0;
    return {{0, 1 - w, w}};
  }
  const double s = va + vb + vc;
  if (!(s > 0)) return {{1, 0, 0}}; // only rounding of a degenerate triangle leads here
  const double v = vb / s, w = vc / s;
  return {{1 - v - w, v, w}};
}

/// Squared distance from q to triangle abc.
inline double squared_distance_to_triangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Barycentric w = closest_on_triangle(q, a, b, c);
  return (w.w[0] * a + w.w[1] * b + w.w[2] * c - q).squaredNorm();
}

/// A bounding-volume tree of triangles that answers closest-point queries; doubles throughout, no allocation in a
/// query. It is built again when its triangles move: n log n, and the few triangles of panels take microseconds.
class Triangle_tree
{
public:
  struct Closest
  {
    int triangle = -1;
    Barycentric weights{{1, 0, 0}};
    Vec3 point = Vec3::Zero();
    double squared_distance = (std::numeric_limits<double>::max)();
  };

  Triangle_tree() = default;
  Triangle_tree(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles)
  {
    build(points, triangles);
  }

  void build(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles)
  {
    const int n = int(triangles.size());
    items_.resize(n);
    for (int t = 0; t < n; ++t)
      items_[t] = {{points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]}, t};
    nodes_.clear();
    leaves_.clear();
    Vec3 low, high;
    if (n > 0) root_ = build_node(0, n, low, high);
    place_.resize(n);
    for (int i = 0; i < n; ++i) place_[items_[i].id] = i;
  }

  int number_of_triangles() const { return int(items_.size()); }

  /// The corner `i` of triangle `t`.
  const Vec3& corner(int t, int i) const { return items_[place_[t]].p[i]; }

  /// The point of the triangles closest to `q`. `hint` is a triangle that is likely to be near, or -1. Among equally
  /// near triangles the answer depends on the tree and the hint alone.
  /// \param enough any triangle will do that is as near as this, the first found
  Closest closest(const Vec3& q, int hint = -1, double enough = 0) const
  {
    Closest best;
    if (items_.empty()) return best;
    if (hint >= 0) try_item(place_[hint], q, best);
    search(q, enough * enough, best);
    return best;
  }

  /// The same with triangles first .. last - 1 tried before others.
  Closest closest(const Vec3& q, int first, int last, double enough) const
  {
    Closest best;
    if (items_.empty()) return best;
    for (int t = first; t < last; ++t) try_item(place_[t], q, best);
    search(q, enough * enough, best);
    return best;
  }
  /// Calls `f(t)` for every triangle t whose box meets the box [low, high].
  template <class F>
  void for_each_overlap(const Vec3& low, const Vec3& high, F f) const
  {
    if (items_.empty()) return;
    int stack[64], top = 0;
    stack[top++] = root_;
    while (top > 0) {
      const int i = stack[--top];
      if (i >= 0) {
        for (int side = 1; side >= 0; --side)
          if (nodes_[i].meets(side, low, high)) stack[top++] = nodes_[i].child[side];
        continue;
      }
      const Leaf& leaf = leaves_[-1 - i];
      for (int j = leaf.first; j < leaf.first + leaf.count; ++j) {
        const auto& p = items_[j].p;
        if ((p[0].cwiseMin(p[1]).cwiseMin(p[2]).array() <= high.array()).all() &&
            (p[0].cwiseMax(p[1]).cwiseMax(p[2]).array() >= low.array()).all())
          f(items_[j].id);
      }
    }
  }

private:
  static constexpr int leaf_size = 3;

  struct Item
  {
    std::array<Vec3, 3> p;
    int id;

    Vec3 sum() const { return p[0] + p[1] + p[2]; }
  };
  // An inner node knows the boxes of both its children, axis by axis, so that one pass measures both.
  struct Node
  {
    Eigen::Array2d low[3], high[3];
    int child[2]; // a node, or -1 - a leaf

    Eigen::Array2d squared_distances(const Vec3& q) const
    {
      Eigen::Array2d sum = Eigen::Array2d::Zero();
      for (int i = 0; i < 3; ++i) {
        const Eigen::Array2d d = (low[i] - q[i]).max(q[i] - high[i]).max(0.0);
        sum += d * d;
      }
      return sum;
    }
    bool meets(int side, const Vec3& a, const Vec3& b) const
    {
      for (int i = 0; i < 3; ++i)
        if (low[i][side] > b[i] || high[i][side] < a[i]) return false;
      return true;
    }
    void set(int side, const Vec3& a, const Vec3& b)
    {
      for (int i = 0; i < 3; ++i) low[i][side] = a[i], high[i][side] = b[i];
    }
  };

  struct Leaf
  {
    int first, count;
  };

  /// Builds the tree of items begin .. end - 1 and their box; returns its name, as in `Node::child`.
  int build_node(int begin, int end, Vec3& low, Vec3& high)
  {
    if (end - begin <= leaf_size) {
      low.setConstant((std::numeric_limits<double>::max)());
      high = -low;
      for (int i = begin; i < end; ++i)
        for (const Vec3& p : items_[i].p) low = low.cwiseMin(p), high = high.cwiseMax(p);
      leaves_.push_back({begin, end - begin});
      return -int(leaves_.size());
    }
    Vec3 least = items_[begin].sum(), most = least;
    for (int i = begin; i < end; ++i) {
      const Vec3 m = items_[i].sum();
      least = least.cwiseMin(m), most = most.cwiseMax(m);
    }
    int axis = 0;
    (most - least).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [axis](const Item& s, const Item& t) {
                       const double a = s.p[0][axis] + s.p[1][axis] + s.p[2][axis];
                       const double b = t.p[0][axis] + t.p[1][axis] + t.p[2][axis];
                       return a < b || (a == b && s.id < t.id);
                     });
    const int id = int(nodes_.size());
    nodes_.emplace_back();
    Vec3 other_low, other_high;
    const int left = build_node(begin, middle, low, high), right = build_node(middle, end, other_low, other_high);
    nodes_[id].set(0, low, high), nodes_[id].set(1, other_low, other_high);
    nodes_[id].child[0] = left, nodes_[id].child[1] = right;
    low = low.cwiseMin(other_low), high = high.cwiseMax(other_high);
    return id;
  }

  /// Descends to all that may be nearer than `best`, which may be nothing yet, until `best` is as near as `enough`.
  void search(const Vec3& q, double enough, Closest& best) const
  {
    int stack[64], top = 0;
    double key[64];
    stack[top] = root_, key[top++] = 0;
    while (top > 0 && best.squared_distance > enough) {
      const int i = stack[--top];
      if (key[top] >= best.squared_distance) continue;
      if (i < 0) {
        const Leaf& leaf = leaves_[-1 - i];
        for (int j = leaf.first; j < leaf.first + leaf.count; ++j) try_item(j, q, best);
        continue;
      }
      const Node& node = nodes_[i];
      const Eigen::Array2d d = node.squared_distances(q);
      const int near = d[1] < d[0] ? 1 : 0, far = 1 - near;
      if (d[far] < best.squared_distance) stack[top] = node.child[far], key[top++] = d[far];
      if (d[near] < best.squared_distance) stack[top] = node.child[near], key[top++] = d[near];
    }
  }

  void try_item(int i, const Vec3& q, Closest& best) const
  {
    const auto& p = items_[i].p;
    const Barycentric w = closest_on_triangle(q, p[0], p[1], p[2]);
    const Vec3 x = w.w[0] * p[0] + w.w[1] * p[1] + w.w[2] * p[2];
    const double d = (x - q).squaredNorm();
    if (d < best.squared_distance) best = {items_[i].id, w, x, d};
  }

  std::vector<Item> items_;
  std::vector<Node, Eigen::aligned_allocator<Node>> nodes_;
  std::vector<Leaf> leaves_;
  int root_ = 0;
  std::vector<int> place_; // of a triangle among the items
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRIANGLE_TREE_H
