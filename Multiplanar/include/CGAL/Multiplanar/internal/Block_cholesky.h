// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_BLOCK_CHOLESKY_H
#define CGAL_MULTIPLANAR_INTERNAL_BLOCK_CHOLESKY_H

#include <CGAL/Multiplanar/internal/Cholmod.h>
#include <CGAL/Multiplanar/internal/Multifrontal_cholesky.h>
#include <CGAL/Multiplanar/internal/elimination_order.h>
#include <CGAL/Multiplanar/internal/serial_libraries.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A symmetric 3 x 3 block: xx, yx, zx, yy, zy, zz (its lower triangle, column by column).
using Symmetric_block = std::array<double, 6>;

/// A symmetric positive definite system with three unknowns a vertex and a fixed pattern: factorised anew for each set
/// of values, ordered and analysed once.
///
/// The matrix lies in memory in its elimination order, lower triangle by columns, so that no permuted copy is made for
/// each factorisation. CHOLMOD orders, analyses and substitutes; `Multifrontal_cholesky` factorises. Every block added
/// must be symmetric itself.
class Block_cholesky
{
public:
  /// Where a block lies: the entry in row a, column s is value `begin + a + {0, step - 1, 2 step - 3}[s]`.
  struct Slot
  {
    int begin;
    int step; // entries in the first column of the block's column
  };

  /// Orders and analyses. Time: that of nested dissection, O(n log n). See `is_valid()`.
  Block_cholesky(const Vertex_graph& graph, int threads)
      : x_(cholmod_), y_(cholmod_), e_(cholmod_), factor_(nullptr, Free_cholmod_factor{&cholmod_})
  {
    const std::vector<int> order = elimination_order(graph);
    if (order.empty()) return;
    rank_.resize(order.size());
    for (int i = 0; i < int(order.size()); ++i) rank_[order[i]] = i;
    fill_pattern(graph, order);
    analyze(threads);
  }

  /// False if there was not enough memory for the analysis. Then nothing else may be called.
  bool is_valid() const { return factor_ != nullptr; }

  int number_of_vertices() const { return int(rank_.size()); }

  /// The place of vertex `v` in the elimination order: its unknowns are 3 rank(v) + 0, 1, 2.
  int rank(int v) const { return rank_[v]; }

  /// The slot of the block of `u` and `v`, which must be equal or joined in the graph. Logarithmic time.
  Slot slot(int u, int v) const
  {
    const int column = (std::min)(rank_[u], rank_[v]), row = (std::max)(rank_[u], rank_[v]);
    const int begin = column_begin_[3 * column], end = column_begin_[3 * column + 1];
    const auto found = std::lower_bound(rows_.begin() + begin, rows_.begin() + end, 3 * row);
    CGAL_assertion(found != rows_.begin() + end && *found == 3 * row);
    return {int(found - rows_.begin()), end - begin};
  }

  void set_zero() { values_.assign(values_.size(), 0.); }

  void add_diagonal(Slot slot, const Symmetric_block& b)
  {
    double* const value = values_.data() + slot.begin;
    value[0] += b[0];
    value[1] += b[1];
    value[2] += b[2];
    value[slot.step] += b[3];
    value[slot.step + 1] += b[4];
    value[2 * slot.step - 1] += b[5];
  }

  void add_off_diagonal(Slot slot, const Symmetric_block& b)
  {
    double* value = values_.data() + slot.begin;
    value[0] += b[0];
    value[1] += b[1];
    value[2] += b[2];
    value += slot.step - 1;
    value[0] += b[1];
    value[1] += b[3];
    value[2] += b[4];
    value += slot.step - 2;
    value[0] += b[2];
    value[1] += b[4];
    value[2] += b[5];
  }

  /// Adds `weight` times the unit matrix to any block.
  void add_isotropic(Slot slot, double weight)
  {
    double* const value = values_.data() + slot.begin;
    value[0] += weight;
    value[slot.step] += weight;
    value[2 * slot.step - 1] += weight;
  }

  /// Returns false if the matrix is not positive definite.
  bool factorize()
  {
    CGAL_precondition(is_valid());
    Serial_libraries serial;
    cholmod_sparse matrix = view();
    return fronts_->factorize(matrix);
  }

  /// Solves with the last successful factorisation; `b` and `x` by rank. Returns false if the result is not finite.
  bool solve(std::vector<double>& b, std::vector<double>& x)
  {
    CGAL_precondition(is_valid() && b.size() == 3 * rank_.size());
    Serial_libraries serial;
    cholmod_dense right = {};
    right.nrow = right.nzmax = right.d = b.size();
    right.ncol = 1;
    right.x = b.data();
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, factor_.get(), &right, nullptr, x_.handle(), nullptr, y_.handle(), e_.handle(),
                        cholmod_.get()))
      return false;
    x.assign(x_.values(), x_.values() + b.size());
    return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
  }

  /// Bytes held by the factor, for reports.
  std::size_t factor_bytes() const { return factor_ == nullptr ? 0 : factor_->xsize * sizeof(double); }

private:
  void fill_pattern(const Vertex_graph& graph, const std::vector<int>& order)
  {
    column_begin_ = {0};
    std::vector<int> below;
    for (int i = 0; i < int(order.size()); ++i) {
      below.clear();
      for (int u : graph.adjacent(order[i]))
        if (rank_[u] > i) below.push_back(rank_[u]);
      std::sort(below.begin(), below.end());
      for (int s = 0; s < 3; ++s) {
        for (int a = s; a < 3; ++a) rows_.push_back(3 * i + a);
        for (int r : below)
          for (int a = 0; a < 3; ++a) rows_.push_back(3 * r + a);
        column_begin_.push_back(int(rows_.size()));
      }
    }
    values_.assign(rows_.size(), 0.);
  }

  void analyze(int threads)
  {
    Serial_libraries serial;
    cholmod_->nmethods = 1;
    cholmod_->method[0].ordering = CHOLMOD_NATURAL;
    cholmod_->postorder = 0;
    cholmod_->supernodal = CHOLMOD_SUPERNODAL;
    cholmod_sparse matrix = view();
    factor_.reset(cholmod_analyze(&matrix, cholmod_.get()));
    if (factor_ != nullptr && !cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, factor_.get(), cholmod_.get()))
      factor_.reset();
    if (factor_ != nullptr) fronts_.reset(new Multifrontal_cholesky(*factor_, threads));
  }

  cholmod_sparse view()
  {
    return lower_triangle_view(3 * number_of_vertices(), column_begin_.data(), rows_.data(), values_.data());
  }

  std::vector<int> rank_;
  std::vector<int> column_begin_;
  std::vector<int> rows_;
  std::vector<double> values_;
  Cholmod cholmod_; // outlives what is below
  Cholmod_dense x_, y_, e_;
  Cholmod_factor factor_;
  std::unique_ptr<Multifrontal_cholesky> fronts_;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_BLOCK_CHOLESKY_H
