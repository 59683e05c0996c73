// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_ORDER_H
#define CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_ORDER_H

#include <CGAL/Multiplanar/Panel_complex.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/*!
Which of two panels gives way: the wider one, where the *width* of a panel is its area over its perimeter; at equal
widths (to six digits, so that rounding does not decide) the one numbered later.

An edge costs either panel about the same strip, t sin(theta) or t cot(theta / 2) wide. Taken off the wider panel it
costs the smaller part of a panel, and narrow panels, which truncation could destroy or leave without room for slots,
are cut only where they must be. Being a total order, the rule never cuts in circles: a panel is cut to the final
shapes of all that come before it, and by nothing else.

\return the panels from the first, which never gives way, to the last, which always does
*/
inline std::vector<int> truncation_order(const Panel_complex& complex)
{
  const int n = complex.number_of_panels();
  std::vector<double> width(n);
  for (int p = 0; p < n; ++p) {
    double perimeter = 0;
    for (const auto& loop : complex.panels[p].loops)
      for (const auto& side : loop) perimeter += complex.edge_length(side.edge);
    const double w = perimeter > 0 ? complex.area(p) / perimeter : 0;
    const double unit = w > 0 ? std::pow(10.0, std::floor(std::log10(w)) - 5) : 1;
    width[p] = std::round(w / unit) * unit;
  }
  std::vector<int> order(n);
  for (int p = 0; p < n; ++p) order[p] = p;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return width[a] < width[b]; });
  return order;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_TRUNCATION_ORDER_H
