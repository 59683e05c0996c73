// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H
#define CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <boost/pending/disjoint_sets.hpp>

#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The free panels in pieces that do not depend on each other: free panels around one corner are in one piece.
inline std::vector<std::vector<int>> free_pieces(const Complex_topology& t, const std::vector<char>& free)
{
  boost::disjoint_sets_with_storage<> sets(t.number_of_panels());
  for (const auto& around : t.corner_panels) {
    int first = -1;
    for (int p : around) {
      if (!free[p]) continue;
      if (first < 0) first = p;
      else sets.union_set(first, p);
    }
  }
  std::vector<std::vector<int>> pieces;
  std::vector<int> piece_of(t.number_of_panels(), -1);
  for (int p = 0; p < t.number_of_panels(); ++p) {
    if (!free[p]) continue;
    const int l = int(sets.find_set(p));
    if (piece_of[l] < 0) piece_of[l] = int(pieces.size()), pieces.emplace_back();
    pieces[piece_of[l]].push_back(p);
  }
  return pieces;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H
