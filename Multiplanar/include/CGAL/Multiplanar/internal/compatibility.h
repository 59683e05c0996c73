// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_COMPATIBILITY_H
#define CGAL_MULTIPLANAR_INTERNAL_COMPATIBILITY_H

#include <CGAL/version.h>

#include <utility>

// What differs between CGAL 5.5 and 6.x is met here and nowhere else.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The result of `Surface_mesh::property_map<I,T>(name)` as (map, found): a pair up to CGAL 5.6, an optional since 6.0.
template <class Map>
std::pair<Map, bool> found_property_map(const std::pair<Map, bool>& result)
{
  return result;
}
#if CGAL_VERSION_NR >= 1060000900
template <class Optional>
auto found_property_map(const Optional& result) -> std::pair<std::decay_t<decltype(*result)>, bool>
{
  using Map = std::decay_t<decltype(*result)>;
  return result ? std::make_pair(*result, true) : std::make_pair(Map(), false);
}
#endif

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_COMPATIBILITY_H
