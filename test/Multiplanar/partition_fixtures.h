// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_PARTITION_FIXTURES_H
#define MULTIPLANAR_TEST_PARTITION_FIXTURES_H

#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/panel_partition_problems.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Meshes with labels to make panels of, and the check that panels keep their promises.
namespace Multiplanar_test {

using namespace CGAL::Multiplanar;
using internal::Connectivity;
using Labels = std::vector<int>;

/// A mesh with what the partition needs.
struct Model
{
  Model(std::string name, Mesh m)
      : name(std::move(name)), mesh(normalised(std::move(m))),
        c(internal::make_connectivity(mesh.triangles, int(mesh.points.size()))), costs(c, mesh.points)
  {
  }
  Model(const Model&) = delete; // the costs refer to the connectivity

  Point_3 centroid(int f) const { return costs.centroid(f); }
  int faces() const { return c.number_of_faces(); }
  int fewest_panels() const { return 4 + 3 * c.genus(); }

  std::string name;
  Mesh mesh;
  Connectivity c;
  Label_costs costs;
};

inline Labels labels_by_point(const Model& m, const std::function<int(const Point_3&)>& label)
{
  Labels result;
  for (int f = 0; f < m.faces(); ++f) result.push_back(label(m.centroid(f)));
  return result;
}

/// Cells around random vertices, by distance in space.
inline Labels random_cells(const Model& m, int cells, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point_3> sites;
  for (int i = 0; i < cells; ++i) sites.push_back(m.mesh.points[random() % m.mesh.points.size()]);
  return labels_by_point(m, [&](const Point_3& p) {
    int best = 0;
    for (int i = 1; i < cells; ++i)
      if (CGAL::squared_distance(p, sites[i]) < CGAL::squared_distance(p, sites[best])) best = i;
    return best;
  });
}

/// Labels of the nearest of `k` planes, some rounds of refitting: ragged, in many pieces.
inline Labels plane_cells(const Model& m, int k, std::uint64_t seed)
{
  std::vector<Plane> planes = seed_planes(m.costs, k, seed);
  Labels labels(m.faces());
  for (int round = 0; round < 3; ++round) {
    for (int f = 0; f < m.faces(); ++f) {
      labels[f] = 0;
      for (int p = 1; p < k; ++p)
        if (m.costs.data_cost(f, planes[p]) < m.costs.data_cost(f, planes[labels[f]])) labels[f] = p;
    }
    estimate_planes(m.costs, labels, planes);
  }
  return labels;
}

/// The surface of a flat bar of unit cubes with holes through it, each cube's side an n x n grid: genus = holes.
inline Mesh plate_with_holes(int holes, int n)
{
  const int width = 2 * holes + 1;
  const auto solid = [&](int x, int y, int z) {
    return 0 <= x && x < width && 0 <= y && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
  };
  Mesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = index.emplace(p, int(mesh.points.size()));
    if (found.second) mesh.points.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
    return found.first->second;
  };
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < 3; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          std::array<int, 3> next{x, y, 0};
          next[axis] += side == 1 ? 1 : -1;
          if (!solid(x, y, 0) || solid(next[0], next[1], next[2])) continue;
          int u = (axis + 1) % 3, v = (axis + 2) % 3;
          if (side == 0) std::swap(u, v);
          for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
              const auto corner = [&](int di, int dj) {
                std::array<int, 3> p{n * x, n * y, 0};
                p[axis] += side * n;
                p[u] += i + di;
                p[v] += j + dj;
                return vertex(p);
              };
              const int a = corner(0, 0), b = corner(1, 0), d = corner(1, 1), e = corner(0, 1);
              mesh.triangles.push_back({a, b, d});
              mesh.triangles.push_back({a, d, e});
            }
        }
  return mesh;
}

inline Panel_partition_options options_for(int k, bool realisable = true)
{
  Panel_partition_options options;
  options.max_panels = k;
  options.realisable = realisable;
  return options;
}

inline std::string text_of(const std::vector<Partition_problem>& problems)
{
  std::string text;
  for (const auto& p : problems) text += "panel " + std::to_string(p.panel) + ": " + p.text + "; ";
  return text;
}

/// Runs `make_panels()` in both modes and checks all that it promises. \return the report of the full mode
inline Panel_partition_report expect_good_panels(const Model& m, const Labels& start, int k, const std::string& what)
{
  const std::string where = m.name + ", " + what + ", k = " + std::to_string(k);
  Labels labels = start;
  const auto light = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k, false));
  EXPECT_TRUE(light.ok) << where;
  EXPECT_LE(light.panels, k) << where;
  for (const auto& p : partition_problems(m.c, m.mesh.points, labels, light.panels))
    EXPECT_GT(p.kind, Partition_problem::self_touch) << where << ": " << p.text;

  labels = start;
  const auto report = make_panels(m.c, m.mesh.points, m.costs, labels, options_for(k));
  EXPECT_TRUE(report.ok) << where;
  EXPECT_LE(report.panels, k) << where;
  const auto problems = partition_problems(m.c, m.mesh.points, labels, report.panels);
  EXPECT_TRUE(problems.empty()) << where << ": " << text_of(problems);
  return report;
}

/// Labellings that a segmentation would hardly make.
inline std::vector<std::pair<std::string, Labels>> adversarial_labels(const Model& m)
{
  const double turn = 2 * std::acos(-1.);
  const auto angle = [](const Point_3& p) { return std::atan2(p.y(), p.x()); };
  const auto floor = [](double x) { return int(std::floor(x)) + 1000; };
  std::vector<std::pair<std::string, Labels>> result;
  result.emplace_back("one label", Labels(m.faces(), 0));
  Labels labels(m.faces());
  for (int f = 0; f < m.faces(); ++f) labels[f] = f;
  result.emplace_back("a label a face", labels);
  for (int f = 0; f < m.faces(); ++f) labels[f] = f % 2;
  result.emplace_back("checkerboard", labels);
  result.emplace_back("stripes across z", labels_by_point(m, [&](const Point_3& p) { return floor(12 * p.z()); }));
  result.emplace_back("stripes across x", labels_by_point(m, [&](const Point_3& p) { return floor(9 * p.x()); }));
  result.emplace_back("sectors", labels_by_point(m, [&](const Point_3& p) { return floor(3 * angle(p)); }));
  result.emplace_back("two spirals",
                      labels_by_point(m, [&](const Point_3& p) { return floor(angle(p) / turn + 8 * p.z()) % 2; }));
  result.emplace_back("one inside another", labels_by_point(m, [](const Point_3& p) {
                        const double d = CGAL::squared_distance(p, Point_3(0.3, 0, 0));
                        return d < 0.01 ? 0 : d < 0.03 ? 1 : 2;
                      }));
  result.emplace_back("A, B, A, B", labels_by_point(m, [](const Point_3& p) {
                        return std::abs(p.z()) < 0.08 ? 2 : int(p.x() * p.y() > 0);
                      }));
  result.emplace_back("a label in 40 pieces", random_cells(m, 80, 5));
  for (int& p : result.back().second) p = p % 2 == 0 ? 0 : p;
  result.emplace_back("noise", labels);
  std::mt19937_64 random(7);
  for (int& p : result.back().second) p = int(random() % 5);
  result.emplace_back("salt and pepper", random_cells(m, 12, 9));
  for (int& p : result.back().second)
    if (random() % 10 == 0) p = int(random() % 12);
  return result;
}

inline Labels cube_sides(int n)
{
  Labels labels(12 * n * n);
  for (int f = 0; f < int(labels.size()); ++f) labels[f] = f / (2 * n * n);
  return labels;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_PARTITION_FIXTURES_H
