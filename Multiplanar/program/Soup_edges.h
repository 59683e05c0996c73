// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SOUP_EDGES_H
#define MULTIPLANAR_PROGRAM_SOUP_EDGES_H

#include "Polygon_soup.h"

#include <algorithm>
#include <tuple>
#include <vector>

/// An edge as one face walks along it.
struct Half_edge
{
  int low, high;               ///< its vertices
  int low_corner, high_corner; ///< where the face names them: positions in Polygon_soup::indices
  int face;
  bool forward; ///< from `low` to `high`

  bool operator<(const Half_edge& other) const
  {
    return std::tie(low, high, face, low_corner) < std::tie(other.low, other.high, other.face, other.low_corner);
  }
};

/// The half-edges of a soup, those of one edge side by side.
class Soup_edges
{
public:
  explicit Soup_edges(const Polygon_soup& soup)
  {
    half_edges.reserve(soup.indices.size());
    for (int f = 0; f < soup.number_of_faces(); ++f)
      for (int i = 0, n = soup.face_size(f), first = int(soup.face_begin[f]); i < n; ++i) {
        const int from = first + i, to = first + (i + 1) % n;
        const int a = soup.indices[from], b = soup.indices[to];
        half_edges.push_back(a < b ? Half_edge{a, b, from, to, f, true} : Half_edge{b, a, to, from, f, false});
      }
    std::sort(half_edges.begin(), half_edges.end());
  }

  /// Calls `visit(begin, end)` with the range of half-edges of every edge.
  template <class Visitor>
  void for_each(Visitor visit) const
  {
    const Half_edge* const last = half_edges.data() + half_edges.size();
    for (const Half_edge *begin = half_edges.data(), *end = begin; begin != last; begin = end) {
      while (end != last && end->low == begin->low && end->high == begin->high) ++end;
      visit(begin, end);
    }
  }

private:
  std::vector<Half_edge> half_edges;
};

#endif // MULTIPLANAR_PROGRAM_SOUP_EDGES_H
