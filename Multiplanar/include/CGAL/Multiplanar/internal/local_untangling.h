// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_LOCAL_UNTANGLING_H
#define CGAL_MULTIPLANAR_INTERNAL_LOCAL_UNTANGLING_H

#include <CGAL/Multiplanar/internal/lifted_content.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

// The last few inverted triangles of a planar map, removed vertex by vertex. The signed area of each triangle around a
// vertex is linear in its place, so the place where the smallest of them is largest is a linear program in two unknowns
// (one for a vertex that slides along a line) and the area. It is bounded, because the areas around a vertex add up to
// the same whatever its place. Going round and round, the vertices near an inverted triangle make room for it.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The doubled area of a triangle as constant + slope.d for a motion d of one vertex.
struct Linear_area
{
  Point_2d slope;
  double constant;
};

/// That of the triangle (p, a, b), whose vertex p moves.
inline Linear_area linear_area(const Point_2d& p, const Point_2d& a, const Point_2d& b)
{
  return {{(a - b).y(), (b - a).x()}, doubled_area(p, a, b)};
}

/// The smallest area after a motion d.
inline double least_area(const std::vector<Linear_area>& areas, const Point_2d& d)
{
  double worst = (std::numeric_limits<double>::max)();
  for (const Linear_area& a : areas) worst = (std::min)(worst, a.constant + a.slope.dot(d));
  return worst;
}

/// The motion after which the smallest area is largest: three are equal and smallest there. Zero if that gains nothing.
inline Point_2d best_motion(const std::vector<Linear_area>& areas)
{
  const int n = int(areas.size());
  const double now = least_area(areas, Point_2d::Zero());
  double best = now + 1e-3 * std::abs(now);
  Point_2d motion = Point_2d::Zero();
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        Eigen::Matrix2d m;
        m.row(0) = areas[i].slope - areas[j].slope, m.row(1) = areas[i].slope - areas[k].slope;
        if (m.determinant() == 0) continue;
        const Point_2d d =
            m.inverse() * Point_2d(areas[j].constant - areas[i].constant, areas[k].constant - areas[i].constant);
        const double value = d.allFinite() ? least_area(areas, d) : best;
        if (value > best) best = value, motion = d;
      }
  return motion;
}

class Local_untangling
{
public:
  Local_untangling(const Planar_complex& complex, std::vector<double>& x)
      : c(complex), x(x), around(complex.unknowns), kind(complex.unknowns, Planar_node::Kind::fixed)
  {
    for (int t = 0; t < int(c.triangles.size()); ++t)
      for (int i = 0; i < 3; ++i) {
        const Planar_node& node = c.nodes[c.triangles[t][i]];
        if (node.kind == Planar_node::Kind::fixed) continue;
        around[node.unknown].emplace_back(t, i);
        kind[node.unknown] = node.kind;
      }
  }

  /// \return whether every triangle is positive; if not, the smallest areas are no smaller than before
  bool run(int sweeps)
  {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      const std::vector<int> region = unknowns_near_inverted(1 + sweep / 4);
      if (region.empty()) return c.count_inverted(x.data()) == 0;
      bool moved = false;
      for (int u : region) moved = (kind[u] == Planar_node::Kind::free ? place(u) : slide(u)) || moved;
      if (!moved && sweep > 12) break;
    }
    return c.count_inverted(x.data()) == 0;
  }

private:
  Linear_area area(const std::pair<int, int>& corner) const
  {
    const auto& t = c.triangles[corner.first];
    const auto at = [&](int i) { return c.nodes[t[(corner.second + i) % 3]].at(x.data()); };
    return linear_area(at(0), at(1), at(2));
  }

  bool is_inverted(int t) const
  {
    const auto& v = c.triangles[t];
    return !(doubled_area(c.nodes[v[0]].at(x.data()), c.nodes[v[1]].at(x.data()), c.nodes[v[2]].at(x.data())) >
             c.tolerance[t]);
  }

  /// Unknowns of the vertices within `rings` triangles of an inverted one, in increasing order.
  std::vector<int> unknowns_near_inverted(int rings) const
  {
    std::vector<char> reached(c.unknowns, 0), seen(c.triangles.size(), 0);
    std::vector<int> front, result;
    for (int t = 0; t < int(c.triangles.size()); ++t)
      if (is_inverted(t)) front.push_back(t), seen[t] = 1;
    for (int ring = 0; ring < rings; ++ring) {
      std::vector<int> next;
      for (int t : front)
        for (int v : c.triangles[t]) {
          const Planar_node& node = c.nodes[v];
          if (node.kind == Planar_node::Kind::fixed || reached[node.unknown]) continue;
          reached[node.unknown] = 1;
          result.push_back(node.unknown);
          for (const auto& corner : around[node.unknown])
            if (!seen[corner.first]) seen[corner.first] = 1, next.push_back(corner.first);
        }
      front = std::move(next);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<Linear_area> areas_around(int u) const
  {
    std::vector<Linear_area> areas;
    for (const auto& corner : around[u]) areas.push_back(area(corner));
    return areas;
  }

  /// Moves a free vertex to the best place.
  bool place(int u)
  {
    const Point_2d motion = best_motion(areas_around(u));
    if (motion == Point_2d::Zero()) return false;
    x[u] += motion.x(), x[u + 1] += motion.y();
    return true;
  }

  /// The same for a vertex on a line, in all the planes that the line lies in: two areas are equal.
  bool slide(int u)
  {
    std::vector<Linear_area> areas = areas_around(u);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const auto& corner = around[u][i];
      areas[i].slope = {areas[i].slope.dot(c.nodes[c.triangles[corner.first][corner.second]].along), 0};
    }
    const double now = least_area(areas, Point_2d::Zero());
    double best = now + 1e-3 * std::abs(now), motion = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
      for (std::size_t j = i + 1; j < areas.size(); ++j) {
        const double slope = areas[i].slope.x() - areas[j].slope.x();
        if (slope == 0) continue;
        const double d = (areas[j].constant - areas[i].constant) / slope, value = least_area(areas, {d, 0});
        if (value > best) best = value, motion = d;
      }
    x[u] += motion;
    return motion != 0;
  }

  const Planar_complex& c;
  std::vector<double>& x;
  std::vector<std::vector<std::pair<int, int>>> around; // triangles and corners, by unknown
  std::vector<Planar_node::Kind> kind;
};

/// The total lifted content untangles maps of one polygon; minimised over more unknowns it costs much and was never
/// seen to (0 of 583 such maps of panels with all their neighbours, 242 of 688 smaller ones).
constexpr int most_unknowns_lifted = 800;

/// Makes every triangle positive from the map `x`: vertex by vertex, and by the total lifted content where that does
/// not do. \param mean_area of a triangle \return whether every triangle came out positive; if not, `x` is the best
/// found
inline bool untangle(const Planar_complex& complex, double mean_area, std::vector<double>& x)
{
  if (complex.unknowns == 0) return complex.count_inverted(x.data()) == 0;
  std::vector<double> best = x;
  int fewest = complex.count_inverted(x.data());
  const int for_good = complex.count_inverted_for_good();
  const auto locally = [&] {
    Local_untangling(complex, x).run(24);
    const int inverted = complex.count_inverted(x.data());
    if (inverted < fewest) fewest = inverted, best = x;
    return fewest == for_good;
  };
  bool done = fewest == for_good || locally() || complex.unknowns > most_unknowns_lifted;
  for (double alpha = 1e-2; alpha >= 1e-6 && !done; alpha *= 1e-2) {
    minimise_lifted_content(complex, alpha * mean_area, x);
    done = locally();
  }
  x = best;
  return fewest == 0;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_LOCAL_UNTANGLING_H
