// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONNECTIVITY_H
#define CGAL_MULTIPLANAR_INTERNAL_CONNECTIVITY_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The combinatorics of a closed, oriented, connected triangle mesh in flat arrays. It never changes while the
/// mesh moves, so the rooms that only move points or relabel faces share one.
///
/// Edge i of face f runs from `triangles[f][i]` to `triangles[f][(i + 1) % 3]`, counter-clockwise seen from outside;
/// `neighbours[f][i]` is the face on its other side.
struct Connectivity
{
  using Triangle = std::array<int, 3>;

  std::vector<Triangle> triangles;
  std::vector<Triangle> neighbours;

  int number_of_faces() const { return int(triangles.size()); }
  int number_of_vertices() const { return int(star_begin.size()) - 1; }
  int number_of_edges() const { return number_of_faces() * 3 / 2; }

  /// The faces around vertex `v`, counter-clockwise seen from outside.
  boost::iterator_range<const int*> star(int v) const
  {
    return {star_faces.data() + star_begin[v], star_faces.data() + star_begin[v + 1]};
  }

  /// The position (0, 1, 2) of vertex `v` in face `f`.
  int corner_of(int f, int v) const
  {
    const Triangle& t = triangles[f];
    CGAL_precondition(t[0] == v || t[1] == v || t[2] == v);
    return t[0] == v ? 0 : t[1] == v ? 1 : 2;
  }

  /// The position in `neighbours[f]` of face `g`, or -1 if they share no edge.
  int edge_towards(int f, int g) const
  {
    for (int i = 0; i < 3; ++i)
      if (neighbours[f][i] == g) return i;
    return -1;
  }

  /// Genus of the closed surface (Euler: V - E + F = 2 - 2g).
  int genus() const { return (2 - (number_of_vertices() - number_of_edges() + number_of_faces())) / 2; }

  std::vector<int> star_begin; // size: vertices + 1
  std::vector<int> star_faces;
};

/// Builds the connectivity of `triangles` over vertices 0 .. `number_of_vertices` - 1.
/// \throws std::invalid_argument if the triangles are not a closed oriented 2-manifold. Linear time.
inline Connectivity make_connectivity(std::vector<std::array<int, 3>> triangles, int number_of_vertices)
{
  Connectivity c;
  c.triangles = std::move(triangles);
  const int faces = c.number_of_faces();
  std::vector<int> degree(number_of_vertices + 1, 0);
  for (const auto& t : c.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) throw std::invalid_argument("a face names a vertex twice");
    for (int v : t) {
      if (v < 0 || v >= number_of_vertices) throw std::invalid_argument("a face names a vertex that does not exist");
      ++degree[v];
    }
  }
  c.star_begin.assign(number_of_vertices + 1, 0);
  for (int v = 0; v < number_of_vertices; ++v) c.star_begin[v + 1] = c.star_begin[v] + degree[v];

  // Half-edges leaving v, found through the faces that hold v.
  std::vector<int> fill(c.star_begin.begin(), c.star_begin.end() - 1);
  c.star_faces.resize(3 * std::size_t(faces));
  for (int f = 0; f < faces; ++f)
    for (int v : c.triangles[f]) c.star_faces[fill[v]++] = f;

  c.neighbours.assign(faces, {-1, -1, -1});
  for (int f = 0; f < faces; ++f)
    for (int i = 0; i < 3; ++i) {
      const int a = c.triangles[f][i], b = c.triangles[f][(i + 1) % 3];
      for (int g : c.star(b)) {
        const auto& t = c.triangles[g];
        for (int j = 0; j < 3; ++j)
          if (t[j] == b && t[(j + 1) % 3] == a) {
            if (c.neighbours[f][i] != -1) throw std::invalid_argument("an edge has more than two faces");
            c.neighbours[f][i] = g;
          }
      }
      if (c.neighbours[f][i] == -1) throw std::invalid_argument("the surface is not closed or not oriented");
    }
  // Each star put in cyclic order; a star that is not one cycle is not a manifold vertex.
  for (int v = 0; v < number_of_vertices; ++v) {
    const int begin = c.star_begin[v], size = c.star_begin[v + 1] - begin;
    if (size == 0) throw std::invalid_argument("a vertex has no face");
    int f = c.star_faces[begin];
    for (int n = 0; n < size; ++n) {
      if (n > 0 && f == c.star_faces[begin]) throw std::invalid_argument("a vertex is not manifold");
      // Entries from n on are overwritten in cyclic order; the set of faces is the same when the star is one cycle.
      c.star_faces[begin + n] = f;
      f = c.neighbours[f][(c.corner_of(f, v) + 2) % 3]; // across the edge that enters v: counter-clockwise
    }
    if (f != c.star_faces[begin]) throw std::invalid_argument("a vertex is not manifold");
  }
  return c;
}

/// Connectivity of a CGAL triangle mesh, with faces and vertices numbered in the order of its ranges.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
template <class TriangleMesh>
Connectivity make_connectivity(const TriangleMesh& mesh)
{
  using vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  std::unordered_map<vertex, int> index;
  int n = 0;
  for (vertex v : vertices(mesh)) index[v] = n++;
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(num_faces(mesh));
  for (auto f : faces(mesh)) {
    std::array<int, 3> t{};
    int i = 0;
    for (vertex v : vertices_around_face(halfedge(f, mesh), mesh)) {
      if (i == 3) throw std::invalid_argument("a face is not a triangle");
      t[i++] = index[v];
    }
    if (i != 3) throw std::invalid_argument("a face is not a triangle");
    triangles.push_back(t);
  }
  return make_connectivity(std::move(triangles), n);
}

/// Twice the vector area of face `f`: its direction is the outer normal, its length twice the area.
inline Vector_3 area_vector(const Connectivity& c, const Points& points, int f)
{
  const auto& t = c.triangles[f];
  return CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONNECTIVITY_H
