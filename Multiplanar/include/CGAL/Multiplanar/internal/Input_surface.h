// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_INPUT_SURFACE_H
#define CGAL_MULTIPLANAR_INTERNAL_INPUT_SURFACE_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/Flat_state.h>
#include <CGAL/Multiplanar/internal/Triangle_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A point of the model that distances are measured from, and the area that it stands for.
struct Surface_sample
{
  Vec3 point;
  double area;
  int face; ///< a face that holds it
};

/// A triangle near every place: where to begin a search for the closest.
class Nearby_triangles
{
public:
  Nearby_triangles() = default;

  /// A grid of cubes over the box of side 1.1 around the origin, each with the triangle closest to its middle.
  explicit Nearby_triangles(const Triangle_tree& tree)
  {
    cells_.reserve(std::size_t(n) * n * n);
    int hint = -1;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
          const Vec3 middle = Vec3(i + 0.5, j + 0.5, k + 0.5) * (side / n) - Vec3::Constant(side / 2);
          hint = tree.closest(middle, hint).triangle;
          cells_.push_back(hint);
        }
  }

  int operator()(const Vec3& x) const
  {
    int cell = 0;
    for (int i = 0; i < 3; ++i) cell = cell * n + (std::min)((std::max)(int((x[i] + side / 2) * (n / side)), 0), n - 1);
    return cells_[cell];
  }

private:
  static constexpr int n = 24;
  static constexpr double side = 1.1;
  std::vector<int> cells_;
};

/// The model in the frame of the numerical work: bounding-box diagonal 1, box centre at the origin.
struct Input_surface
{
  std::vector<Vec3> points;
  const Connectivity* connectivity = nullptr;
  Triangle_tree tree;
  Nearby_triangles nearby;
  std::vector<Surface_sample> samples;
  std::vector<double> importance; ///< by face: distances from there count so many times; empty: once
  double largest_importance = 1;
  double area = 0;
  Vec3 centre = Vec3::Zero();
  double scale = 1; ///< of the model: its diagonal

  void set_importance(std::vector<double> by_face)
  {
    importance = std::move(by_face);
    if (!importance.empty()) largest_importance = *std::max_element(importance.begin(), importance.end());
  }
  double importance_of(int face) const { return importance.empty() ? 1 : importance[face]; }

  Vec3 to_frame(const Point_3& p) const { return (as_vec(p) - centre) / scale; }
  Point_3 from_frame(const Vec3& v) const { return as_point(v * scale + centre); }
};

/// All vertices, and points inside faces that are large for the number of samples wanted.
inline void sample_input(Input_surface& in, int wanted)
{
  const Connectivity& c = *in.connectivity;
  const double spacing = std::sqrt(in.area / wanted);
  const int vertices = c.number_of_vertices();
  std::vector<Surface_sample> all(vertices);
  for (int v = 0; v < vertices; ++v) all[v] = {in.points[v], 0, c.star(v)[0]};
  for (int f = 0; f < c.number_of_faces(); ++f) {
    const auto& t = c.triangles[f];
    const Vec3 a = in.points[t[0]], u = in.points[t[1]] - a, v = in.points[t[2]] - a;
    const double area = u.cross(v).norm() / 2;
    const int n = (std::min)(200, int((std::max)({u.norm(), v.norm(), (u - v).norm()}) / (1.7 * spacing)) + 1);
    if (n == 1) {
      for (int x : t) all[x].area += area / 3;
      continue;
    }
    const double share = area / ((n + 1) * (n + 2) / 2);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        if (i == n || j == n || i + j == 0) all[t[i == n ? 1 : j == n ? 2 : 0]].area += share;
        else all.push_back({a + u * (double(i) / n) + v * (double(j) / n), share, f});
      }
  }
  if (int(all.size()) <= 6 * wanted) {
    in.samples = std::move(all);
    return;
  }
  // A fine mesh: one sample a cell of a finer grid, the first in vertex order, with the area of its cell.
  std::map<std::array<int, 3>, int> cells;
  for (const auto& s : all) {
    const Vec3 q = s.point / (0.6 * spacing);
    const std::array<int, 3> cell{int(std::floor(q[0])), int(std::floor(q[1])), int(std::floor(q[2]))};
    const auto found = cells.insert({cell, int(in.samples.size())});
    if (found.second) in.samples.push_back(s);
    else in.samples[found.first->second].area += s.area;
  }
}

inline Input_surface make_input_surface(const Connectivity& c, const Points& source, int samples = 5000)
{
  Input_surface in;
  in.connectivity = &c;
  Vec3 low = as_vec(source.front()), high = low;
  for (const Point_3& p : source) low = low.cwiseMin(as_vec(p)), high = high.cwiseMax(as_vec(p));
  in.centre = (low + high) / 2;
  in.scale = (high - low).norm();
  for (const Point_3& p : source) in.points.push_back(in.to_frame(p));
  in.tree.build(in.points, c.triangles);
  in.nearby = Nearby_triangles(in.tree);
  for (const auto& t : c.triangles)
    in.area += (in.points[t[1]] - in.points[t[0]]).cross(in.points[t[2]] - in.points[t[0]]).norm() / 2;
  sample_input(in, samples);
  return in;
}

/// Puts a state of the frame's units into a complex of the model's.
inline void write_state(const Flat_state& s, const Input_surface& in, Panel_complex& complex)
{
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    complex.panels[p].plane.normal = Vector_3(s.normal[p].x(), s.normal[p].y(), s.normal[p].z());
    complex.panels[p].plane.offset = s.offset[p] * in.scale + s.normal[p].dot(in.centre);
  }
  for (int c = 0; c < complex.number_of_corners(); ++c) complex.corners[c].point = in.from_frame(s.corner[c]);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_INPUT_SURFACE_H
