// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_BOXES_H
#define MULTIPLANAR_TEST_BOXES_H

#include "meshes.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace Multiplanar_test {

/// A mesh and, for each face, the flat panel that it belongs to.
struct Panelled_mesh
{
  Mesh mesh;
  std::vector<int> panels;
};

/// The surface of a union of unit cubes at integer places, each square side divided into n x n squares of two
/// triangles. A panel is a connected set of coplanar sides.
/// \pre the union is a manifold: no two cubes meet in an edge or a vertex alone
inline Panelled_mesh boxes(const std::vector<std::array<int, 3>>& cells, int n)
{
  const std::set<std::array<int, 3>> filled(cells.begin(), cells.end());
  Panelled_mesh result;
  std::map<std::array<int, 3>, int> vertex_at; // coordinates times n
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = vertex_at.insert({p, int(result.mesh.points.size())});
    if (found.second) result.mesh.points.push_back(Point_3(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n));
    return found.first->second;
  };
  using Side = std::array<int, 5>; // axis, direction, position along the axis, the two others
  std::map<Side, int> panel_of;
  for (const auto& cell : filled)
    for (int axis = 0; axis < 3; ++axis)
      for (int direction = 0; direction < 2; ++direction) {
        std::array<int, 3> beyond = cell;
        beyond[axis] += direction == 1 ? 1 : -1;
        if (!filled.count(beyond))
          panel_of[{{axis, direction, cell[axis], cell[(axis + 1) % 3], cell[(axis + 2) % 3]}}] = -1;
      }
  int panels = 0;
  for (auto& start : panel_of) {
    if (start.second >= 0) continue;
    std::vector<Side> stack{start.first};
    start.second = panels;
    while (!stack.empty()) {
      const Side s = stack.back();
      stack.pop_back();
      for (int i = 3; i < 5; ++i)
        for (int step : {-1, 1}) {
          Side t = s;
          t[i] += step;
          const auto found = panel_of.find(t);
          if (found != panel_of.end() && found->second < 0) found->second = panels, stack.push_back(t);
        }
    }
    ++panels;
  }
  for (const auto& side : panel_of) {
    const int axis = side.first[0], u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [&](int du, int dv) {
          std::array<int, 3> p{};
          p[axis] = n * (side.first[2] + side.first[1]);
          p[u] = n * side.first[3] + i + du;
          p[v] = n * side.first[4] + j + dv;
          return vertex(p);
        };
        const int a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
        if (side.first[1] == 1) {
          result.mesh.triangles.push_back({a, b, c});
          result.mesh.triangles.push_back({a, c, d});
        } else {
          result.mesh.triangles.push_back({a, c, b});
          result.mesh.triangles.push_back({a, d, c});
        }
        result.panels.push_back(side.second);
        result.panels.push_back(side.second);
      }
  }
  return result;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_BOXES_H
