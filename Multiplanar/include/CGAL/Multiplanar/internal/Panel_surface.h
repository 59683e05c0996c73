// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SURFACE_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SURFACE_H

#include <CGAL/Multiplanar/internal/Flat_state.h>
#include <CGAL/Multiplanar/internal/exact_contacts.h>
#include <CGAL/Multiplanar/panel_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Do two triangles over shared points meet outside their shared corners and sides? Exact.
inline bool triangles_conflict(const std::vector<Vec3>& x, const std::array<int, 3>& t, const std::array<int, 3>& s)
{
  int shared = 0, sum_i = 0, sum_j = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (t[i] == s[j]) ++shared, sum_i += i, sum_j += j;
  const auto a = [&](int i) { return as_point(x[t[i % 3]]); };
  const auto b = [&](int j) { return as_point(x[s[j % 3]]); };
  if (shared == 0) return triangles_meet(a(0), a(1), a(2), b(0), b(1), b(2));
  if (shared == 1) {
    const int i = sum_i, j = sum_j;
    return segment_meets_triangle(a(i + 1), a(i + 2), b(j), b(j + 1), b(j + 2)) ||
           segment_meets_triangle(b(j + 1), b(j + 2), a(i), a(i + 1), a(i + 2));
  }
  if (shared == 2) {
    const int i = 3 - sum_i, j = 3 - sum_j; // the corners not shared
    if (CGAL::collinear(a(i + 1), a(i + 2), a(i))) return true;
    return CGAL::orientation(a(i + 1), a(i + 2), a(i), b(j)) == CGAL::COPLANAR &&
           CGAL::coplanar_orientation(a(i + 1), a(i + 2), a(i), b(j)) != CGAL::NEGATIVE;
  }
  return true;
}

/// The panels of a state as triangles over its corners, and which panels are no simple polygons.
class Panel_surface
{
public:
  using Triangle = std::array<int, 3>;

  explicit Panel_surface(const Complex_topology& topology)
      : t(&topology), panel_triangles_(topology.number_of_panels()), simple_(topology.number_of_panels(), 0)
  {
  }

  /// Triangulates the panels in `panels` anew.
  void update(const Flat_state& s, const std::vector<int>& panels)
  {
    for (int p : panels) simple_[p] = triangulate(s, p);
  }

  /// Takes over panel `q` of another surface, which has the same corners in the same places, as panel `p`.
  /// \param corner_now the number here of every corner there, or -1
  /// \return false if the corners are not the same ones
  bool take(int p, const Panel_surface& other, int q, const std::vector<int>& corner_now)
  {
    const auto &now = t->loops[p], &before = other.t->loops[q];
    std::size_t corners = 0;
    for (const auto& loop : now) corners += loop.size();
    std::vector<int> expected;
    for (const auto& loop : before)
      for (int c : loop) {
        if (corner_now[c] < 0) return false;
        expected.push_back(corner_now[c]);
      }
    if (now.size() != before.size() || expected.size() != corners) return false;
    std::vector<int> actual;
    for (const auto& loop : now) actual.insert(actual.end(), loop.begin(), loop.end());
    std::sort(expected.begin(), expected.end());
    std::sort(actual.begin(), actual.end());
    if (expected != actual) return false;
    panel_triangles_[p] = other.panel_triangles_[q];
    for (Triangle& triangle : panel_triangles_[p])
      for (int& c : triangle) c = corner_now[c];
    simple_[p] = other.simple_[q];
    return true;
  }

  /// Builds the tree over the triangles of all simple panels (and of the fans of those that are not).
  void build_tree(const Flat_state& s)
  {
    triangles_.clear();
    panel_of_.clear();
    first_triangle_.assign(1, 0);
    for (int p = 0; p < t->number_of_panels(); ++p) {
      for (const Triangle& q : panel_triangles_[p]) triangles_.push_back(q), panel_of_.push_back(p);
      first_triangle_.push_back(int(triangles_.size()));
    }
    tree_.build(s.corner, triangles_);
  }

  const std::vector<Triangle>& triangles_of(int p) const { return panel_triangles_[p]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  int panel_of(int triangle) const { return panel_of_[triangle]; }

  /// The point of the panels closest to `q`, panel `likely` tried first (some triangles of it: the tree is faster than
  /// all those of a panel with many corners); as near as `enough` will do.
  Triangle_tree::Closest closest(const Vec3& q, int likely, double enough = 0) const
  {
    const int first = first_triangle_[likely], last = (std::min)(first + 8, first_triangle_[likely + 1]);
    return tree_.closest(q, first, last, enough);
  }
  const Triangle_tree& tree() const { return tree_; }
  bool is_simple(int p) const { return simple_[p]; }
  bool all_simple() const
  {
    for (char s : simple_)
      if (!s) return false;
    return true;
  }

  /// Pairs of panels with triangles in conflict, one of them in `changed`; stops at `limit`. Exact.
  /// \pre the tree is built
  std::vector<std::array<int, 2>> conflicts(const Flat_state& s, const std::vector<char>& changed, int limit) const
  {
    std::vector<std::array<int, 2>> result;
    for (int i = 0; i < int(triangles_.size()) && int(result.size()) < limit; ++i) {
      const int p = panel_of_[i];
      if (!changed[p]) continue;
      const Triangle& q = triangles_[i];
      const Vec3 &a = s.corner[q[0]], &b = s.corner[q[1]], &c = s.corner[q[2]];
      tree_.for_each_overlap(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), [&](int j) {
        const int o = panel_of_[j];
        if (o == p || (changed[o] && o < p) || int(result.size()) >= limit) return;
        if (triangles_conflict(s.corner, q, triangles_[j])) result.push_back({p, o});
      });
    }
    return result;
  }

private:
  bool triangulate(const Flat_state& s, int p)
  {
    auto& triangles = panel_triangles_[p];
    triangles.clear();
    const Axis_projection project(s.normal[p]);
    std::vector<Polygon_loop> loops;
    std::vector<int> corners;
    for (const auto& loop : t->loops[p]) {
      loops.emplace_back();
      for (int c : loop) loops.back().push_back(project(s.corner[c])), corners.push_back(c);
    }
    std::vector<Triangle> local;
    bool simple = is_polygon_with_holes(loops);
    if (simple && loops.size() == 1) simple = cut_ears(loops[0], local);
    else if (simple) local = triangulate_polygon(loops);
    if (!simple) { // a fan: something to measure by
      local.clear();
      for (int i = 1; i + 1 < int(loops[0].size()); ++i) local.push_back({0, i, i + 1});
    }
    for (const Triangle& q : local) triangles.push_back({corners[q[0]], corners[q[1]], corners[q[2]]});
    return simple;
  }

  const Complex_topology* t;
  std::vector<std::vector<Triangle>> panel_triangles_;
  std::vector<char> simple_;
  std::vector<Triangle> triangles_;
  std::vector<int> panel_of_;
  std::vector<int> first_triangle_; ///< of each panel, in the order of `triangles_`; and the end
  Triangle_tree tree_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SURFACE_H
