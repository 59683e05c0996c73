// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MULTIFRONTAL_CHOLESKY_H
#define CGAL_MULTIPLANAR_INTERNAL_MULTIFRONTAL_CHOLESKY_H

#include <CGAL/Multiplanar/internal/Cholmod.h>
#include <CGAL/Multiplanar/internal/Supernode_tree.h>
#include <CGAL/Multiplanar/internal/parallel_ranges.h>
#include <CGAL/Multiplanar/internal/serial_libraries.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <vector>

extern "C" {
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc);
}

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The numerical Cholesky factorisation over CHOLMOD's supernodes, by fronts (Duff and Reid 1983).
///
/// The front of a supernode with c columns and r rows is a dense symmetric matrix over its rows. It gathers the
/// matrix's own entries and the updates of the supernode's children; eliminating its c columns leaves an update of
/// order r - c for the parent. A front needs its children alone, so disjoint subtrees go to different threads.
/// Whichever thread computes a front adds up the same numbers in the same order: the bits do not depend on threads.
///
/// CHOLMOD's own factorisation visits all descendants of a supernode one by one and opens a parallel region for each,
/// which at the sizes of this package takes longer than the arithmetic.
class Multifrontal_cholesky
{
public:
  /// \param factor supernodal, analysed, without numbers. It receives them in `factorize`, and must outlive this.
  Multifrontal_cholesky(cholmod_factor& factor, int threads)
      : factor_(factor), tree_(factor), schedule_(tree_, threads), updates_(tree_.size(), nullptr)
  {
    std::size_t stack = stack_size(schedule_.top);
    for (int root : schedule_.subtrees) {
      stack = (std::max)(stack, stack_size(tree_.subtree(root)));
      kept_.emplace_back(std::size_t(tree_.update_size(root)) * tree_.update_size(root));
    }
    workspaces_.resize(schedule_.threads);
    for (Workspace& w : workspaces_) {
      w.stack.resize(stack);
      w.position.resize(factor.n);
      w.relative.resize(factor.n);
    }
  }

  /// Factorises the matrix, given as its lower triangle by columns. Returns false if it is not positive definite.
  bool factorize(const cholmod_sparse& matrix)
  {
    matrix_ = &matrix;
    failed_ = false;
    next_subtree_ = 0;
    parallel_ranges(schedule_.threads, schedule_.threads, [this](int part, int, int) {
      Serial_libraries serial;
      do_subtrees(workspaces_[part]);
    });
    Serial_libraries serial;
    do_fronts(schedule_.top, workspaces_[0]);
    return !failed_;
  }

private:
  struct Workspace
  {
    std::vector<double> stack; // updates that wait for their parent
    std::size_t top = 0;
    std::vector<int> position; // of each row in the present front; meaningless for other rows
    std::vector<int> relative; // positions of a child's rows in the present front
  };

  /// The most that the updates of these fronts take at a time.
  std::size_t stack_size(const std::vector<int>& fronts) const
  {
    std::size_t size = 0, largest = 0;
    for (int s : fronts) {
      const std::size_t update = std::size_t(tree_.update_size(s)) * tree_.update_size(s);
      largest = (std::max)(largest, size + update);
      for (int child : tree_.children(s))
        if (schedule_.is_together(child, s)) size -= std::size_t(tree_.update_size(child)) * tree_.update_size(child);
      size += update;
    }
    return largest;
  }

  void do_subtrees(Workspace& w)
  {
    for (int i = next_subtree_++; i < int(schedule_.subtrees.size()); i = next_subtree_++) {
      const int root = schedule_.subtrees[i];
      do_fronts(tree_.subtree(root), w);
      if (failed_) return;
      std::vector<double>& kept = kept_[i]; // the stack is needed for the next subtree
      std::copy(updates_[root], updates_[root] + kept.size(), kept.begin());
      updates_[root] = kept.data();
    }
  }

  /// \pre every child of a front in `fronts` comes before it, or has been done.
  void do_fronts(const std::vector<int>& fronts, Workspace& w)
  {
    w.top = 0;
    for (int s : fronts) {
      if (failed_) return;
      do_front(s, w);
    }
  }

  void do_front(int s, Workspace& w)
  {
    const int columns = tree_.number_of_columns(s), rows = tree_.number_of_rows(s), rest = rows - columns;
    double* const panel = static_cast<double*>(factor_.x) + tree_.values_begin(s);
    double* const update = w.stack.data() + w.top;
    std::fill(panel, panel + std::size_t(rows) * columns, 0.);
    for (int j = 0; j < rest; ++j)
      std::fill(update + std::size_t(j) * rest + j, update + std::size_t(j + 1) * rest, 0.);
    for (int i = 0; i < rows; ++i) w.position[tree_.rows(s)[i]] = i;
    add_matrix(s, panel, w);
    for (int child : tree_.children(s)) add_update(child, s, panel, update, w);
    if (!eliminate(columns, rest, panel, update)) {
      failed_ = true;
      return;
    }
    pop_children_and_push(s, update, w);
  }

  void add_matrix(int s, double* panel, const Workspace& w) const
  {
    const int* const begin = static_cast<const int*>(matrix_->p);
    const int* const row = static_cast<const int*>(matrix_->i);
    const double* const value = static_cast<const double*>(matrix_->x);
    for (int j = 0; j < tree_.number_of_columns(s); ++j) {
      double* const column = panel + std::size_t(j) * tree_.number_of_rows(s);
      const int c = tree_.first_column(s) + j;
      for (int k = begin[c]; k < begin[c + 1]; ++k) column[w.position[row[k]]] = value[k];
    }
  }

  /// Adds a child's update, whose rows are rows of the front too.
  void add_update(int child, int s, double* panel, double* update, Workspace& w) const
  {
    const int n = tree_.update_size(child), columns = tree_.number_of_columns(s), rows = tree_.number_of_rows(s);
    const int* const child_rows = tree_.rows(child) + tree_.number_of_columns(child);
    for (int i = 0; i < n; ++i) w.relative[i] = w.position[child_rows[i]];
    const int* const r = w.relative.data();
    for (int j = 0; j < n; ++j) {
      const double* const from = updates_[child] + std::size_t(j) * n;
      double* const to = r[j] < columns ? panel + std::size_t(r[j]) * rows
                                        : update + std::size_t(r[j] - columns) * (rows - columns) - columns;
      for (int i = j; i < n; ++i) to[r[i]] += from[i];
    }
  }

  /// panel = [A; B] becomes [L; B L^-T] with A = L L^T, and update becomes update - B A^-1 B^T. Lower triangles.
  static bool eliminate(int columns, int rest, double* panel, double* update)
  {
    const int rows = columns + rest;
    const double one = 1, minus_one = -1;
    int info = 0;
    dpotrf_("L", &columns, panel, &rows, &info);
    if (info != 0) return false;
    if (rest == 0) return true;
    dtrsm_("R", "L", "T", "N", &rest, &columns, &one, panel, &rows, panel + columns, &rows);
    dsyrk_("L", "N", &rest, &columns, &minus_one, panel + columns, &rows, &one, update, &rest);
    return true;
  }

  /// The children's updates, on top of the stack below the new one, have been used up.
  void pop_children_and_push(int s, double* update, Workspace& w)
  {
    double* place = update;
    for (int child : tree_.children(s))
      if (schedule_.is_together(child, s)) place = (std::min)(place, updates_[child]);
    const std::size_t size = std::size_t(tree_.update_size(s)) * tree_.update_size(s);
    if (place != update) std::memmove(place, update, size * sizeof(double));
    updates_[s] = place;
    w.top = std::size_t(place - w.stack.data()) + size;
  }

  cholmod_factor& factor_;
  Supernode_tree tree_;
  Supernode_schedule schedule_;
  std::vector<double*> updates_; // of each supernode: where it is
  std::vector<std::vector<double>> kept_;
  std::vector<Workspace> workspaces_;
  const cholmod_sparse* matrix_ = nullptr;
  std::atomic<int> next_subtree_{0};
  std::atomic<bool> failed_{false};
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MULTIFRONTAL_CHOLESKY_H
