// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Union_find.h"
#include "repair_steps.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace {

using Triangle = Repair_mesh::Triangle;
using Edge = std::pair<int, int>;

constexpr double weld_distance = 1e-5; ///< of the diagonal

std::string counted(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

Edge edge_of(const Triangle& t, std::size_t i) { return std::minmax(t[i], t[(i + 1) % 3]); }

std::map<Edge, int> faces_of_edges(const std::vector<Triangle>& triangles)
{
  std::map<Edge, int> result;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++result[edge_of(t, i)];
  return result;
}

std::set<int> open_vertices(const Repair_mesh& mesh)
{
  std::set<int> result;
  for (const auto& edge : faces_of_edges(mesh.triangles))
    if (edge.second == 1) result.insert({edge.first.first, edge.first.second});
  return result;
}

/// The vertices of every set become the first of them. \return how many went
std::size_t join(Repair_mesh& mesh, Union_find& sets)
{
  std::vector<int> place(mesh.points.size());
  std::size_t kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    const int first = sets.find(int(v)); // the smallest: its place is known already
    place[v] = first == int(v) ? int(kept) : place[std::size_t(first)];
    if (first == int(v)) mesh.points[kept++] = mesh.points[v];
  }
  for (Triangle& t : mesh.triangles)
    for (int& v : t) v = place[std::size_t(v)];
  const std::size_t gone = mesh.points.size() - kept;
  mesh.points.resize(kept);
  return gone;
}

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Joins some vertices that are at most `reach` apart, but never the ends of an edge.
std::size_t join_close(Repair_mesh& mesh, std::vector<int> vertices, double reach)
{
  const auto& points = mesh.points;
  std::sort(vertices.begin(), vertices.end(),
            [&](int a, int b) { return std::tie(points[std::size_t(a)], a) < std::tie(points[std::size_t(b)], b); });
  const std::map<Edge, int> edges = reach > 0 ? faces_of_edges(mesh.triangles) : std::map<Edge, int>();
  Union_find sets(points.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      const auto &p = points[std::size_t(vertices[i])], &q = points[std::size_t(vertices[j])];
      if (q[0] - p[0] > reach || (reach == 0 && p != q)) break;
      if (distance(p, q) <= reach && !edges.count(std::minmax(vertices[i], vertices[j])))
        sets.unite(vertices[i], vertices[j]);
    }
  return join(mesh, sets);
}

/// Keeps the triangles that `is_kept` says. \return how many went
template <class Is_kept>
std::size_t keep(Repair_mesh& mesh, Is_kept is_kept)
{
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    if (is_kept(mesh.triangles[f])) {
      mesh.triangles[kept] = mesh.triangles[f];
      mesh.corners[kept++] = mesh.corners[f];
    }
  const std::size_t gone = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  mesh.corners.resize(kept);
  return gone;
}

std::size_t remove_repeated_vertices(Repair_mesh& mesh)
{
  return keep(mesh, [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
}

std::size_t remove_copies(Repair_mesh& mesh)
{
  std::set<Triangle> known;
  return keep(mesh, [&](Triangle t) {
    std::sort(t.begin(), t.end());
    return known.insert(t).second;
  });
}

/// A triangle with an open edge and an edge of three or more is no part of a closed surface.
std::size_t remove_fins(Repair_mesh& mesh)
{
  std::size_t removed = 0;
  for (std::size_t now = 1; now > 0; removed += now) {
    const std::map<Edge, int> edges = faces_of_edges(mesh.triangles);
    now = keep(mesh, [&](const Triangle& t) {
      int open = 0, crowded = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const int count = edges.at(edge_of(t, i));
        open += count == 1;
        crowded += count > 2;
      }
      return open == 0 || crowded == 0;
    });
  }
  return removed;
}

/// CGAL copies it: what it changes lies elsewhere.
struct Turned : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  Turned(std::vector<Triangle>& corners, std::size_t& count) : corners(corners), count(count) {}
  void polygon_orientation_reversed(std::size_t f)
  {
    std::reverse(corners[f].begin(), corners[f].end());
    ++count;
  }
  std::vector<Triangle>& corners;
  std::size_t& count;
};

} // namespace

double Repair_mesh::diagonal() const
{
  std::array<double, 3> low = points.at(0), high = low;
  for (const auto& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return distance(low, high);
}

void weld(Repair_mesh& mesh)
{
  if (open_vertices(mesh).empty()) return;
  std::vector<int> all(mesh.points.size());
  std::iota(all.begin(), all.end(), 0);
  const std::size_t equal = join_close(mesh, std::move(all), 0);
  if (equal > 0) mesh.say("welded " + counted(equal, "vertex", "vertices") + " to others at the same place");
  const std::set<int> open = open_vertices(mesh);
  const std::size_t close = join_close(mesh, {open.begin(), open.end()}, weld_distance * mesh.diagonal());
  if (close > 0)
    mesh.say("welded " + counted(close, "vertex", "vertices") +
             " along open edges to others closer than 1e-5 of the diagonal");
}

void remove_useless_triangles(Repair_mesh& mesh)
{
  const std::size_t repeated = remove_repeated_vertices(mesh);
  if (repeated > 0) mesh.say("removed " + counted(repeated, "face", "faces") + " that used a vertex twice");
  const std::size_t copies = remove_copies(mesh);
  if (copies > 0) mesh.say("removed " + counted(copies, "copy", "copies") + " of faces");
  const std::size_t fins = remove_fins(mesh);
  if (fins > 0) mesh.say("removed " + counted(fins, "face", "faces") + " that hung on an edge of others");
}

void orient(Repair_mesh& mesh)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const Triangle& t : mesh.triangles) polygons.emplace_back(t.begin(), t.end());
  std::size_t turned = 0;
  const Turned visitor(mesh.corners, turned);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(visitor));
  if (turned > 0) mesh.say("turned " + counted(turned, "face", "faces") + " to agree with others");
  if (points.size() > mesh.points.size())
    mesh.say("cut the surface apart in " + counted(points.size() - mesh.points.size(), "vertex", "vertices") +
             " where it was no manifold");
  for (std::size_t v = mesh.points.size(); v < points.size(); ++v)
    mesh.points.push_back({points[v].x(), points[v].y(), points[v].z()});
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) mesh.triangles[f][i] = int(polygons[f][i]);
}
