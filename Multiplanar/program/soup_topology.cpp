// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup_topology.h"
#include "Soup_edges.h"
#include "Union_find.h"
#include "failure.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace {

std::string number(long long n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void refuse_repeated_vertices(const Polygon_soup& soup, const std::string& name)
{
  std::vector<int> sorted;
  for (int f = 0; f < soup.number_of_faces(); ++f) {
    sorted.assign(soup.face(f), soup.face(f) + soup.face_size(f));
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      throw input_error(name + ": face " + std::to_string(f) + " is degenerate: it uses vertex " +
                        std::to_string(*twice) + " twice: --repair removes such faces");
  }
}

void refuse_crowded_edges(const Soup_edges& edges, const std::string& name)
{
  edges.for_each([&](const Half_edge* begin, const Half_edge* end) {
    if (end - begin > 2)
      throw input_error(name + ": not manifold: the edge between the vertices " + std::to_string(begin->low) + " and " +
                        std::to_string(begin->high) + " has " + std::to_string(end - begin) +
                        " faces: at most two may meet in an edge: --repair cuts them apart");
  });
}

/// Can faces be turned so that neighbours agree? Faces are nodes; an edge says "same" or "other way round".
bool is_orientable(const Polygon_soup& soup, const Soup_edges& edges)
{
  const int n = soup.number_of_faces();
  Union_find sets(2 * std::size_t(n)); // face f as it is: f, turned: f + n
  edges.for_each([&](const Half_edge* begin, const Half_edge* end) {
    if (end - begin != 2) return;
    const int f = begin[0].face, g = begin[1].face;
    const int shift = begin[0].forward == begin[1].forward ? n : 0;
    sets.unite(f, g + shift);
    sets.unite(f + n, g + n - shift);
  });
  for (int f = 0; f < n; ++f)
    if (sets.find(f) == sets.find(f + n)) return false;
  return true;
}

void refuse_wrong_orientation(const Polygon_soup& soup, const Soup_edges& edges, const std::string& name)
{
  edges.for_each([&](const Half_edge* begin, const Half_edge* end) {
    if (end - begin != 2 || begin[0].forward != begin[1].forward) return;
    const std::string faces = std::to_string(begin[0].face) + " and " + std::to_string(begin[1].face);
    if (!is_orientable(soup, edges))
      throw input_error(name + ": not orientable: inside and outside cannot be told apart (seen at faces " + faces +
                        "): --repair wraps it");
    throw input_error(name + ": not consistently oriented: the faces " + faces +
                      " run the same way along their common edge: --repair turns faces to agree");
  });
}

void refuse_boundary(const Polygon_soup& soup, const Soup_edges& edges, const std::string& name)
{
  Union_find loops(soup.points.size());
  std::set<int> on_boundary;
  edges.for_each([&](const Half_edge* begin, const Half_edge* end) {
    if (end - begin != 1) return;
    loops.unite(begin->low, begin->high);
    on_boundary.insert({begin->low, begin->high});
  });
  if (on_boundary.empty()) return;
  const auto count = std::count_if(on_boundary.begin(), on_boundary.end(), [&](int v) { return loops.find(v) == v; });
  throw input_error(name + ": " + number(count, "boundary loop", "boundary loops") + " (first at vertex " +
                    std::to_string(*on_boundary.begin()) + "): the mesh must be closed; --repair fills holes");
}

/// The corners of faces around a vertex hang together through shared edges, or the vertex joins several sheets.
void refuse_pinched_vertices(const Polygon_soup& soup, const Soup_edges& edges, const std::string& name)
{
  Union_find corners(soup.indices.size());
  edges.for_each([&](const Half_edge* begin, const Half_edge* end) {
    if (end - begin != 2) return;
    corners.unite(begin[0].low_corner, begin[1].low_corner);
    corners.unite(begin[0].high_corner, begin[1].high_corner);
  });
  std::vector<int> fan(soup.points.size(), -1);
  for (int i = 0; i < int(soup.indices.size()); ++i) {
    int& first = fan[soup.indices[i]];
    if (first < 0) first = corners.find(i);
    if (corners.find(i) != first)
      throw input_error(name + ": not manifold: several parts of the surface meet in vertex " +
                        std::to_string(soup.indices[i]) + ": --repair splits it");
  }
}

void refuse_components(const Polygon_soup& soup, const std::string& name)
{
  Union_find sets(soup.points.size());
  for (int f = 0; f < soup.number_of_faces(); ++f)
    for (int i = 1; i < soup.face_size(f); ++i) sets.unite(soup.face(f)[0], soup.face(f)[i]);
  std::set<int> roots;
  int second = -1;
  for (int f = 0; f < soup.number_of_faces(); ++f)
    if (roots.insert(sets.find(soup.face(f)[0])).second && roots.size() == 2) second = f;
  if (roots.size() > 1)
    throw input_error(name + ": " + std::to_string(roots.size()) + " components (the second has face " +
                      std::to_string(second) + "): give one connected surface; --repair keeps the largest");
}

} // namespace

bool has_boundary(const Polygon_soup& soup)
{
  bool found = false;
  Soup_edges(soup).for_each([&](const Half_edge* begin, const Half_edge* end) { found = found || end - begin == 1; });
  return found;
}

int weld_equal_points(Polygon_soup& soup)
{
  const auto& points = soup.points;
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return points[a] < points[b]; });
  std::vector<int> target(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) // the stable order puts the first of equal points first
    target[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? target[order[i - 1]] : order[i];
  int welded = 0;
  std::vector<int> place(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (target[v] == int(v)) {
      place[v] = int(v) - welded;
      soup.points[v - welded] = points[v];
    } else ++welded;
  soup.points.resize(soup.points.size() - welded);
  for (int& v : soup.indices) v = place[target[v]];
  return welded;
}

int remove_unused_points(Polygon_soup& soup)
{
  std::vector<bool> used(soup.points.size(), false);
  for (int v : soup.indices) used[v] = true;
  std::vector<int> place(soup.points.size());
  int removed = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    place[v] = int(v) - removed;
    if (used[v]) soup.points[v - removed] = soup.points[v];
    else ++removed;
  }
  soup.points.resize(soup.points.size() - removed);
  for (int& v : soup.indices) v = place[v];
  return removed;
}

void check_topology(const Polygon_soup& soup, const std::string& name)
{
  refuse_repeated_vertices(soup, name);
  const Soup_edges edges(soup);
  refuse_crowded_edges(edges, name);
  refuse_wrong_orientation(soup, edges, name);
  refuse_boundary(soup, edges, name);
  refuse_pinched_vertices(soup, edges, name);
  refuse_components(soup, name);
}
