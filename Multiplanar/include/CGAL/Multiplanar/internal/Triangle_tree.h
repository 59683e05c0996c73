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
    nodes_.reserve(2 * std::size_t(n) / leaf_size + 8);
    if (n > 0) build_node(0, n);
    place_.resize(n);
    for (int i = 0; i < n; ++i) place_[items_[i].id] = i;
  }

  int number_of_triangles() const { return int(items_.size()); }

  /// The corner `i` of triangle `t`.
  const Vec3& corner(int t, int i) const { return items_[place_[t]].p[i]; }

  /// The point of the triangles closest to `q`. `hint` is a triangle that is likely to be near, or -1. Among equally
  /// near triangles the answer depends on the tree and the hint alone.
  Closest closest(const Vec3& q, int hint = -1) const
  {
    Closest best;
    if (nodes_.empty()) return best;
    if (hint >= 0) try_item(place_[hint], q, best);
    int stack[64], top = 0;
    double key[64];
    stack[top] = 0, key[top++] = squared_distance_to_box(nodes_[0], q);
    while (top > 0) {
      const int i = stack[--top];
      if (key[top] >= best.squared_distance) continue;
      const Node& node = nodes_[i];
      if (node.count > 0) {
        for (int j = node.first; j < node.first + node.count; ++j) try_item(j, q, best);
        continue;
      }
      int near = i + 1, far = node.first;
      double d_near = squared_distance_to_box(nodes_[near], q), d_far = squared_distance_to_box(nodes_[far], q);
      if (d_far < d_near) std::swap(near, far), std::swap(d_near, d_far);
      if (d_far < best.squared_distance) stack[top] = far, key[top++] = d_far;
      if (d_near < best.squared_distance) stack[top] = near, key[top++] = d_near;
    }
    return best;
  }

  /// Calls `f(t)` for every triangle t whose box meets the box [low, high].
  template <class F>
  void for_each_overlap(const Vec3& low, const Vec3& high, F f) const
  {
    if (nodes_.empty()) return;
    int stack[64], top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const int i = stack[--top];
      const Node& node = nodes_[i];
      if ((node.low.array() > high.array()).any() || (node.high.array() < low.array()).any()) continue;
      if (node.count == 0) {
        stack[top++] = node.first;
        stack[top++] = i + 1;
        continue;
      }
      for (int j = node.first; j < node.first + node.count; ++j) {
        const auto& p = items_[j].p;
        if ((p[0].cwiseMin(p[1]).cwiseMin(p[2]).array() <= high.array()).all() &&
            (p[0].cwiseMax(p[1]).cwiseMax(p[2]).array() >= low.array()).all())
          f(items_[j].id);
      }
    }
  }

private:
  static constexpr int leaf_size = 4;

  struct Item
  {
    std::array<Vec3, 3> p;
    int id;
  };
  // The left child of an inner node follows it; `first` is the right child. In a leaf, `first` is an item.
  struct Node
  {
    Vec3 low, high;
    int first = 0, count = 0;
  };

  int build_node(int begin, int end)
  {
    const int id = int(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.low.setConstant((std::numeric_limits<double>::max)());
    node.high = -node.low;
    Vec3 low = node.low, high = node.high;
    for (int i = begin; i < end; ++i) {
      for (const Vec3& p : items_[i].p) node.low = node.low.cwiseMin(p), node.high = node.high.cwiseMax(p);
      const Vec3 m = items_[i].p[0] + items_[i].p[1] + items_[i].p[2];
      low = low.cwiseMin(m), high = high.cwiseMax(m);
    }
    if (end - begin <= leaf_size) {
      node.first = begin, node.count = end - begin;
    } else {
      int axis = 0;
      (high - low).maxCoeff(&axis);
      const int middle = (begin + end) / 2;
      std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                       [axis](const Item& s, const Item& t) {
                         const double a = s.p[0][axis] + s.p[1][axis] + s.p[2][axis];
                         const double b = t.p[0][axis] + t.p[1][axis] + t.p[2][axis];
                         return a < b || (a == b && s.id < t.id);
                       });
      build_node(begin, middle);
      node.first = build_node(middle, end);
    }
    nodes_[id] = node;
    return id;
  }

  static double squared_distance_to_box(const Node& node, const Vec3& q)
  {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = (std::max)((std::max)(node.low[i] - q[i], q[i] - node.high[i]), 0.0);
      sum += d * d;
    }
    return sum;
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
  std::vector<Node> nodes_;
  std::vector<int> place_; // of a triangle among the items
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRIANGLE_TREE_H
