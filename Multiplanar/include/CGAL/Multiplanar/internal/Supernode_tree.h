// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SUPERNODE_TREE_H
#define CGAL_MULTIPLANAR_INTERNAL_SUPERNODE_TREE_H

#include <CGAL/Multiplanar/internal/Cholmod.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The supernodes of a factor that CHOLMOD has analysed: runs of consecutive columns of nearly equal structure, kept
/// as one dense matrix each. The parent of a supernode is that of the first row below its own columns. In postorder,
/// each subtree is a run of supernodes that ends with its root.
class Supernode_tree
{
public:
  /// Keeps pointers into `factor`. \pre the columns are in postorder.
  explicit Supernode_tree(const cholmod_factor& factor)
      : column_begin_(static_cast<const int*>(factor.super)), row_begin_(static_cast<const int*>(factor.pi)),
        value_begin_(static_cast<const int*>(factor.px)), rows_(static_cast<const int*>(factor.s)),
        parent_(factor.nsuper, -1), first_(factor.nsuper), children_(factor.nsuper)
  {
    std::vector<int> supernode_of(factor.n);
    for (int s = 0; s < size(); ++s)
      std::fill(supernode_of.begin() + column_begin_[s], supernode_of.begin() + column_begin_[s + 1], s);
    std::iota(first_.begin(), first_.end(), 0);
    for (int s = 0; s < size(); ++s) {
      if (update_size(s) == 0) continue; // a root
      parent_[s] = supernode_of[rows(s)[number_of_columns(s)]];
      CGAL_assertion(parent_[s] > s);
      children_[parent_[s]].push_back(s);
      first_[parent_[s]] = (std::min)(first_[parent_[s]], first_[s]);
    }
    CGAL_assertion(is_in_postorder());
  }

  int size() const { return int(parent_.size()); }
  int parent(int s) const { return parent_[s]; } ///< -1 for a root
  const std::vector<int>& children(int s) const { return children_[s]; }
  int first_column(int s) const { return column_begin_[s]; }
  int number_of_columns(int s) const { return column_begin_[s + 1] - column_begin_[s]; }
  int number_of_rows(int s) const { return row_begin_[s + 1] - row_begin_[s]; }
  int update_size(int s) const { return number_of_rows(s) - number_of_columns(s); }
  const int* rows(int s) const { return rows_ + row_begin_[s]; } ///< its own columns first
  int values_begin(int s) const { return value_begin_[s]; }

  /// The supernodes below and including `root`, children before parents.
  std::vector<int> subtree(int root) const
  {
    std::vector<int> result(root - first_[root] + 1);
    std::iota(result.begin(), result.end(), first_[root]);
    return result;
  }

  /// Time to eliminate a supernode, in multiplications; the last term stands for moving the front's numbers about.
  double work(int s) const
  {
    const double c = number_of_columns(s), r = update_size(s);
    return c * c * c / 6 + c * c * r / 2 + c * r * r / 2 + 4 * (c + r) * (c + r);
  }

private:
  /// Does each supernode follow directly upon the subtrees of its children, which follow upon each other?
  bool is_in_postorder() const
  {
    for (int s = 0; s < size(); ++s) {
      int next = first_[s];
      for (int child : children_[s]) {
        if (first_[child] != next) return false;
        next = child + 1;
      }
      if (next != s) return false;
    }
    return true;
  }

  const int* column_begin_;
  const int* row_begin_;
  const int* value_begin_;
  const int* rows_;
  std::vector<int> parent_;
  std::vector<int> first_; // of each supernode's subtree
  std::vector<std::vector<int>> children_;
};

/// Which subtrees are eliminated side by side, and which supernodes above them one after the other.
struct Supernode_schedule
{
  int threads = 1;
  std::vector<int> subtrees; // roots, the longest work first
  std::vector<int> top;      // children before parents
  std::vector<int> group;    // of each supernode: its subtree's index, -1 for the top

  /// Whether the two are done in the same sequence, by the same thread.
  bool is_together(int s, int t) const { return group[s] == group[t]; }

  Supernode_schedule(const Supernode_tree& tree, int wanted_threads) : group(tree.size(), -1)
  {
    std::vector<double> below(tree.size(), 0.); // work of the subtree
    std::vector<int> roots;
    for (int s = 0; s < tree.size(); ++s) {
      below[s] += tree.work(s);
      if (tree.parent(s) >= 0) below[tree.parent(s)] += below[s];
      else roots.push_back(s);
    }
    const double all =
        std::accumulate(roots.begin(), roots.end(), 0., [&](double sum, int r) { return sum + below[r]; });
    constexpr double worth_a_thread = 5e6; // a few milliseconds; starting a thread takes a few hundredths of one
    threads = (std::max)(1, (std::min)(wanted_threads, int(all / worth_a_thread)));
    if (threads > 1) choose_subtrees(tree, below, roots);
    for (int i = 0; i < int(subtrees.size()); ++i)
      for (int s : tree.subtree(subtrees[i])) group[s] = i;
    for (int s = 0; s < tree.size(); ++s)
      if (group[s] == -1) top.push_back(s);
  }

private:
  /// Opens the longest subtree again and again and keeps the state whose predicted time is least.
  void choose_subtrees(const Supernode_tree& tree, const std::vector<double>& below, std::vector<int> roots)
  {
    const auto longer = [&](int a, int b) { return below[a] != below[b] ? below[a] > below[b] : a < b; };
    double top_work = 0, best = (std::numeric_limits<double>::max)();
    for (int opened = 0; opened < 16 * threads && !roots.empty(); ++opened) {
      std::sort(roots.begin(), roots.end(), longer);
      const double time = top_work + longest_share(below, roots);
      if (time < best) {
        best = time;
        subtrees = roots;
      }
      const int longest = roots.front();
      roots.erase(roots.begin());
      roots.insert(roots.end(), tree.children(longest).begin(), tree.children(longest).end());
      top_work += tree.work(longest);
    }
  }

  /// Each subtree in turn goes to the thread that is free first.
  double longest_share(const std::vector<double>& below, const std::vector<int>& roots) const
  {
    std::vector<double> busy(threads, 0.);
    for (int r : roots) *std::min_element(busy.begin(), busy.end()) += below[r];
    return *std::max_element(busy.begin(), busy.end());
  }
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SUPERNODE_TREE_H
