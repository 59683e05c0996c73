// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CHOLMOD_H
#define CGAL_MULTIPLANAR_INTERNAL_CHOLMOD_H

#if __has_include(<suitesparse/cholmod.h>)
#include <suitesparse/cholmod.h>
#else
#include <cholmod.h>
#endif

#include <memory>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// CHOLMOD's workspace and settings. Its address is handed to every call, so it neither moves nor copies.
class Cholmod
{
public:
  Cholmod()
  {
    cholmod_start(&common_);
    common_.print = 0; // no messages: failures are return values
    common_.quick_return_if_not_posdef = 1;
  }
  ~Cholmod() { cholmod_finish(&common_); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

private:
  cholmod_common common_;
};

struct Free_cholmod_factor
{
  Cholmod* cholmod;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, cholmod->get()); }
};

/// A factor is freed through the workspace it was made with, which must outlive it.
using Cholmod_factor = std::unique_ptr<cholmod_factor, Free_cholmod_factor>;

/// A dense matrix that CHOLMOD allocates, grows and reuses by itself (`cholmod_solve2`).
class Cholmod_dense
{
public:
  explicit Cholmod_dense(Cholmod& cholmod) : cholmod_(&cholmod) {}
  ~Cholmod_dense() { cholmod_free_dense(&matrix_, cholmod_->get()); }
  Cholmod_dense(const Cholmod_dense&) = delete;
  Cholmod_dense& operator=(const Cholmod_dense&) = delete;

  cholmod_dense** handle() { return &matrix_; }
  const double* values() const { return static_cast<const double*>(matrix_->x); }

private:
  Cholmod* cholmod_;
  cholmod_dense* matrix_ = nullptr;
};

/// A square symmetric matrix whose lower triangle is in the caller's arrays, columns sorted. `values` may be null:
/// then it is a pattern only.
inline cholmod_sparse lower_triangle_view(int size, int* column_begin, int* rows, double* values)
{
  cholmod_sparse matrix = {};
  matrix.nrow = matrix.ncol = std::size_t(size);
  matrix.nzmax = std::size_t(column_begin[size]);
  matrix.p = column_begin;
  matrix.i = rows;
  matrix.x = values;
  matrix.stype = -1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  return matrix;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CHOLMOD_H
