// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_UNION_FIND_H
#define MULTIPLANAR_PROGRAM_UNION_FIND_H

#include <numeric>
#include <vector>

/// Disjoint sets of the numbers 0 .. n-1; the smallest member stands for each set.
class Union_find
{
public:
  explicit Union_find(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }

  int find(int i)
  {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void unite(int i, int j)
  {
    i = find(i), j = find(j);
    if (i < j) parent[j] = i;
    else parent[i] = j;
  }

private:
  std::vector<int> parent;
};

#endif // MULTIPLANAR_PROGRAM_UNION_FIND_H
