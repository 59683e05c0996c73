// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H
#define CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The free panels in pieces that do not depend on each other: free panels around one corner are in one piece.
inline std::vector<std::vector<int>> free_pieces(const Complex_topology& t, const std::vector<char>& free)
{
  std::vector<int> leader(t.number_of_panels());
  for (int p = 0; p < int(leader.size()); ++p) leader[p] = p;
  const auto find = [&](int p) {
    while (leader[p] != p) p = leader[p] = leader[leader[p]];
    return p;
  };
  for (const auto& around : t.corner_panels) {
    int first = -1;
    for (int p : around) {
      if (!free[p]) continue;
      if (first < 0) first = find(p);
      else leader[find(p)] = first;
    }
  }
  std::vector<std::vector<int>> pieces;
  std::vector<int> piece_of(leader.size(), -1);
  for (int p = 0; p < int(leader.size()); ++p) {
    if (!free[p]) continue;
    const int l = find(p);
    if (piece_of[l] < 0) piece_of[l] = int(pieces.size()), pieces.emplace_back();
    pieces[piece_of[l]].push_back(p);
  }
  return pieces;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FREE_PIECES_H
