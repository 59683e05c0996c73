// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_LABEL_CANDIDATES_H
#define CGAL_MULTIPLANAR_INTERNAL_LABEL_CANDIDATES_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/internal/parallel_ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Whether a data cost can fill a block of costs at once: `cost.block(label, first, last, out)`.
template <class DataCost, class = void>
struct Has_block : std::false_type
{
};
template <class DataCost>
struct Has_block<DataCost, std::void_t<decltype(std::declval<const DataCost&>().block(0, 0, 0, (double*)nullptr))>>
    : std::true_type
{
};

/// Writes the costs of `label` for nodes `first` .. `last` - 1 to `out`.
template <class DataCost>
void fill_block(const DataCost& cost, int label, int first, int last, double* out)
{
  if constexpr (Has_block<DataCost>::value) cost.block(label, first, last, out);
  else
    for (int p = first; p < last; ++p) out[p - first] = cost(p, label);
}

/// Calls `visit(label, first, last, costs)` for every label and every tile of nodes in `first` .. `last`, tile by tile.
/// Tiles are small enough that what is kept per node stays in the fastest cache.
template <class DataCost, class Visit>
void for_each_tile(const DataCost& cost, int labels, int first, int last, const Visit& visit)
{
  constexpr int tile = 256;
  std::array<double, tile> costs;
  for (; first < last; first += tile) {
    const int end = (std::min)(first + tile, last);
    for (int label = 0; label < labels; ++label) {
      fill_block(cost, label, first, end, costs.data());
      visit(label, first, end, costs.data());
    }
  }
}

/// Threads that n x labels cost evaluations are worth: starting one costs as much as some 10^5 evaluations.
inline int useful_threads(int threads, int nodes, int labels)
{
  const double evaluations = double(nodes) * labels;
  return (std::max)(1, int((std::min)(double(resolved_threads(threads)), evaluations / 2e5)));
}

/// For each label the nodes whose cost of that label lies below a bound of the node.
///
/// Of all nodes x labels costs only those below the bound can start an expansion, so only these pairs are kept. Bounds
/// may rise later; the lists then grow, and never shrink.
template <class DataCost>
class Label_candidates
{
public:
  /// Evaluates all nodes x labels costs once. The result does not depend on the number of threads.
  Label_candidates(const DataCost& cost, int labels, std::vector<double> bounds, int threads)
      : cost(cost), bounds(std::move(bounds)), lists(labels)
  {
    const int nodes = int(this->bounds.size()), parts = useful_threads(threads, nodes, labels);
    std::vector<Lists> partial(parts - 1, Lists(labels));
    parallel_ranges(nodes, parts, [&](int part, int first, int last) {
      collect(first, last, part == 0 ? lists : partial[part - 1]);
    });
    for (const Lists& more : partial)
      for (int label = 0; label < labels; ++label)
        lists[label].insert(lists[label].end(), more[label].begin(), more[label].end());
  }

  /// All nodes with a cost of `label` below their bound (and some whose bound has been higher than need be).
  const std::vector<int>& operator[](int label) const { return lists[label]; }

  /// Raises the bound of `node` to at least `bound`. O(labels) if that changes it, else O(1).
  void raise(int node, double bound)
  {
    if (!(bound > bounds[node])) return;
    for (int label = 0; label < int(lists.size()); ++label) {
      const double c = cost(node, label);
      if (bounds[node] <= c && c < bound) lists[label].push_back(node);
    }
    bounds[node] = bound;
  }

private:
  using Lists = std::vector<std::vector<int>>;

  void collect(int first, int last, Lists& to) const
  {
    for_each_tile(cost, int(to.size()), first, last, [&](int label, int begin, int end, const double* costs) {
      std::vector<int>& list = to[label];
      for (int p = begin; p < end; ++p)
        if (costs[p - begin] < bounds[p]) list.push_back(p);
    });
  }

  const DataCost& cost;
  std::vector<double> bounds;
  Lists lists;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_LABEL_CANDIDATES_H
