// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SLAB_FRAME_H
#define CGAL_MULTIPLANAR_INTERNAL_SLAB_FRAME_H

#include <CGAL/Multiplanar/Part.h>
#include <CGAL/determinant.h>

#include <array>

// Coordinates in the slab of a flat part: (x, y) in its plane, z its depth, so that (x, y, z) stands for the point
// origin + x u + y v - z normal. The doubles of a frame are taken as they are: exactly over exact numbers, where the
// frame is an affine basis that is not quite orthonormal. No square root and no further rounding occurs.

namespace CGAL {
namespace Multiplanar {
namespace internal {

template <class FT>
using Triple = std::array<FT, 3>;

/// x -> matrix x + shift.
template <class FT>
struct Affine_map
{
  std::array<Triple<FT>, 3> matrix; // rows
  Triple<FT> shift;

  Triple<FT> operator()(const Triple<FT>& x) const
  {
    Triple<FT> result = shift;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) result[i] += matrix[i][j] * x[j];
    return result;
  }
};

/// From slab coordinates to the model's.
template <class FT>
Affine_map<FT> slab_to_model(const Frame& frame)
{
  Affine_map<FT> m;
  for (int i = 0; i < 3; ++i) {
    m.matrix[i] = {FT(frame.u[i]), FT(frame.v[i]), FT(-frame.normal[i])};
    m.shift[i] = FT(frame.origin[i]);
  }
  return m;
}

/// The inverse of an affine map, by cofactors.
template <class FT>
Affine_map<FT> inverse(const Affine_map<FT>& map)
{
  const auto& a = map.matrix;
  const FT determinant =
      CGAL::determinant(a[0][0], a[0][1], a[0][2], a[1][0], a[1][1], a[1][2], a[2][0], a[2][1], a[2][2]);
  Affine_map<FT> result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      result.matrix[i][j] = (a[r][c] * a[s][d] - a[r][d] * a[s][c]) / determinant;
    }
  for (int i = 0; i < 3; ++i) {
    result.shift[i] = FT(0);
    for (int j = 0; j < 3; ++j) result.shift[i] -= result.matrix[i][j] * map.shift[j];
  }
  return result;
}

/// outer(inner(x)).
template <class FT>
Affine_map<FT> composed(const Affine_map<FT>& outer, const Affine_map<FT>& inner)
{
  Affine_map<FT> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result.matrix[i][j] = FT(0);
      for (int k = 0; k < 3; ++k) result.matrix[i][j] += outer.matrix[i][k] * inner.matrix[k][j];
    }
    result.shift[i] = outer.shift[i];
    for (int k = 0; k < 3; ++k) result.shift[i] += outer.matrix[i][k] * inner.shift[k];
  }
  return result;
}

/// From the slab coordinates of one part to those of another.
template <class FT>
Affine_map<FT> slab_to_slab(const Frame& from, const Frame& to)
{
  return composed(inverse(slab_to_model<FT>(to)), slab_to_model<FT>(from));
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SLAB_FRAME_H
