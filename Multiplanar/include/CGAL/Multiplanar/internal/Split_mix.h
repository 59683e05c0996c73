// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SPLIT_MIX_H
#define CGAL_MULTIPLANAR_INTERNAL_SPLIT_MIX_H

#include <cstdint>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A small generator whose numbers are the same everywhere (Steele, Lea, Flood: Fast splittable pseudorandom number
/// generators, 2014).
class Split_mix
{
public:
  explicit Split_mix(std::uint64_t seed) : state(seed) {}

  std::uint64_t operator()()
  {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }

  double uniform() { return double((*this)() >> 11) / 9007199254740992.0; } ///< in [0, 1)
  int below(int n) { return int((*this)() % std::uint64_t(n)); }            ///< \pre n > 0

private:
  std::uint64_t state;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SPLIT_MIX_H
