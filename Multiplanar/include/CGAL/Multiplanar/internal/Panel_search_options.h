// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_OPTIONS_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_OPTIONS_H

#include <CGAL/Multiplanar/Approximation_options.h>

#include <cstdint>

namespace CGAL {
namespace Multiplanar {
namespace internal {

struct Panel_search_options
{
  int max_panels = 50;
  Effort effort = Effort::normal;
  double time_limit = 0;
  int threads = 0;
  std::uint64_t seed = 0;
  double work = 1; ///< multiplies the work of the search
  double min_edge = 0.002, min_width = 0.002;
  double thickness = 0; ///< of the sheets; 0: room for joints does not count
};

/// How much work an effort stands for. Counted in distances measured, not in seconds, so that results can be repeated.
struct Search_budget
{
  int partitions; ///< to start from, besides those given
  int chains;     ///< kept after the start, each searched on its own
  int rounds;     ///< after each, the worst chains end; fewer if five in a row gain nothing
  double work;    ///< of a chain in a round, in distances measured
  double merged;  ///< of the search that starts at panels merged from triangles
};

inline Search_budget search_budget(Effort effort)
{
  switch (effort) {
  case Effort::fast:
    return {2, 0, 0, 0., 3e6};
  case Effort::normal:
    return {8, 4, 6, 1.5e6, 1.5e7};
  case Effort::best:
    return {24, 8, 1 << 20, 6e6, 6e7};
  }
  return {};
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_SEARCH_OPTIONS_H
