// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ISOTOPIC_CHANGE_H
#define CGAL_MULTIPLANAR_INTERNAL_ISOTOPIC_CHANGE_H

#include <CGAL/Multiplanar/internal/Connectivity.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Two embedded placements of a mesh are isotopic, whatever lies between them, if they have the same side inside and
//  - the mesh is a sphere: no sphere is knotted (Alexander), or
//  - they differ only within disjoint disks D1, D2, ... of the mesh, and the rest R of it is connected. A sphere in the
//    complement of a connected set bounds a ball there, so two disks with a common border that do not meet R can be
//    moved into each other without meeting it, one pair after the other: what is cut along a disk keeps the property.
// So a mesh need not be led to where it is known to be embedded: a proof of where it is does as well.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Is the side that the faces are counter-clockwise from the outside, beyond the doubt of rounding?
inline bool encloses_its_inside(const Connectivity& c, const Points& points)
{
  double volume = 0, size = 0;
  const Point_3& o = points[0];
  for (const auto& t : c.triangles) {
    const double six = CGAL::determinant(points[t[0]] - o, points[t[1]] - o, points[t[2]] - o);
    volume += six;
    size += std::abs(six);
  }
  return volume > 1e-9 * size;
}

/// Adds to a set of faces those around vertices where it touches itself, so that its border is a set of closed curves.
/// \return false if there was nothing to add
inline bool widen_where_pinched(const Connectivity& c, std::vector<char>& in)
{
  bool widened = false;
  for (int v = 0; v < c.number_of_vertices(); ++v) {
    int runs = 0;
    const auto star = c.star(v);
    for (const int* f = star.begin(); f != star.end(); ++f)
      if (in[*f] && !in[f + 1 == star.end() ? *star.begin() : f[1]]) ++runs;
    if (runs < 2) continue;
    for (int f : star) in[f] = 1;
    widened = true;
  }
  return widened;
}

/// Numbers the pieces, connected across edges, of the faces of either kind. \return the piece of each face
inline std::vector<int> pieces_of(const Connectivity& c, const std::vector<char>& in, int& number)
{
  std::vector<int> piece(c.number_of_faces(), -1), stack;
  number = 0;
  for (int f = 0; f < c.number_of_faces(); ++f) {
    if (piece[f] >= 0) continue;
    piece[f] = number;
    stack.push_back(f);
    while (!stack.empty()) {
      const int g = stack.back();
      stack.pop_back();
      for (int h : c.neighbours[g])
        if (piece[h] < 0 && in[h] == in[g]) piece[h] = number, stack.push_back(h);
    }
    ++number;
  }
  return piece;
}

/// Adds all pieces of the rest but the largest to a set of faces. \return false if there was nothing to add
inline bool fill_but_largest(const Connectivity& c, std::vector<char>& in)
{
  int number = 0;
  const std::vector<int> piece = pieces_of(c, in, number);
  std::vector<int> rest(number, 0);
  for (int f = 0; f < c.number_of_faces(); ++f) rest[piece[f]] += !in[f];
  const int largest = int(std::max_element(rest.begin(), rest.end()) - rest.begin());
  bool filled = false;
  for (int f = 0; f < c.number_of_faces(); ++f)
    if (!in[f] && piece[f] != largest) in[f] = 1, filled = true;
  return filled;
}

/// Is each piece of a set of faces, whose border is a set of closed curves, a disk?
inline bool consists_of_disks(const Connectivity& c, const std::vector<char>& in)
{
  int number = 0;
  const std::vector<int> piece = pieces_of(c, in, number);
  // Twice V - E + F: a connected surface with a border is a disk if that is 2.
  std::vector<int> twice_euler(number, 0), border(number, 0), seen(number, -1);
  for (int f = 0; f < c.number_of_faces(); ++f) {
    twice_euler[piece[f]] += 2 - 3;
    for (int g : c.neighbours[f])
      if (in[g] != in[f]) --twice_euler[piece[f]], ++border[piece[f]];
  }
  for (int v = 0; v < c.number_of_vertices(); ++v)
    for (int f : c.star(v))
      if (seen[piece[f]] != v) seen[piece[f]] = v, twice_euler[piece[f]] += 2;
  for (int f = 0; f < c.number_of_faces(); ++f)
    if (in[f] && (twice_euler[piece[f]] != 2 || border[piece[f]] == 0)) return false;
  return true;
}

/// Do two placements of a mesh differ only within disjoint disks of it, the rest being connected?
inline bool differ_within_disks(const Connectivity& c, const Points& a, const Points& b)
{
  std::vector<char> in(c.number_of_faces(), 0);
  for (int v = 0; v < c.number_of_vertices(); ++v)
    if (a[v] != b[v])
      for (int f : c.star(v)) in[f] = 1;
  if (std::count(in.begin(), in.end(), 1) == c.number_of_faces()) return false;
  while (widen_where_pinched(c, in) || fill_but_largest(c, in)) {}
  if (std::count(in.begin(), in.end(), 1) == c.number_of_faces()) return false;
  return consists_of_disks(c, in);
}

/// Are two placements of a mesh certainly isotopic? False means: not known. Linear time but for widening.
/// \pre `c` is connected; both placements are embedded, `a` with its inside enclosed
inline bool certainly_isotopic(const Connectivity& c, const Points& a, const Points& b)
{
  CGAL_precondition(a.size() == b.size() && int(a.size()) == c.number_of_vertices());
  return encloses_its_inside(c, b) && (c.genus() == 0 || differ_within_disks(c, a, b));
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ISOTOPIC_CHANGE_H
