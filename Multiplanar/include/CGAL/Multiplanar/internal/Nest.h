// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_NEST_H
#define CGAL_MULTIPLANAR_INTERNAL_NEST_H

#include <CGAL/Multiplanar/internal/Free_positions.h>
#include <CGAL/Multiplanar/internal/Nesting_shape.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What is to be nested: shapes at the angles they are tried at, and the usable rectangle of every sheet.
struct Nesting_problem
{
  double width = 0, height = 0; ///< mm that nominal parts may cover; sheets fill up along the width
  std::vector<Nesting_shape> shapes;
  std::vector<int> shape_of_item;

  int number_of_items() const { return int(shape_of_item.size()); }
  const Nesting_shape& shape(int item) const { return shapes[shape_of_item[item]]; }
};

/// An item on a sheet; `at` is where the origin of its turned shape lies.
struct Nested_item
{
  int item = -1, turn = 0;
  Grid_point at;
};

using Nested_sheet = std::vector<Nested_item>;
using Nest = std::vector<Nested_sheet>;

inline const Turned_shape& turned(const Nesting_problem& problem, const Nested_item& placed)
{
  return problem.shape(placed.item).turned[placed.turn];
}

/// The right end of the box around a nominal part, in mm from the left end of the usable rectangle.
inline double right_end(const Nesting_problem& problem, const Nested_item& placed)
{
  return placed.at.x / units_per_mm + turned(problem, placed).box.width;
}

/// How far to the right a sheet is used, in mm.
inline double used_length(const Nesting_problem& problem, const Nested_sheet& sheet)
{
  double length = 0;
  for (const Nested_item& placed : sheet) length = (std::max)(length, right_end(problem, placed));
  return length;
}

/// What is asked of a place on a sheet.
struct Place_query
{
  double upright = 1;         ///< the cost of a place is x + upright * width of the box around the part, in mm
  double most_end = 1e9;      ///< no part may reach farther to the right, in mm
  std::optional<Grid_box> at; ///< where the lower left corner of the box may lie
};

/// Finds where an item can be laid on a sheet; keeps its memory from one search to the next.
class Nesting_space
{
public:
  explicit Nesting_space(const Nesting_problem& problem) : problem(problem) {}

  /// The cheapest place at any angle of the item; the first angle of equally cheap ones.
  std::optional<Nested_item> best_place(int item, const Nested_sheet& sheet, const Place_query& query)
  {
    std::optional<Nested_item> best;
    double least = 1e300;
    const Nesting_shape& shape = problem.shape(item);
    for (int t = 0; t < int(shape.turned.size()); ++t) {
      const Turned_box& box = shape.turned[t].box;
      const double offset = query.upright * box.width;
      const double most_x = (std::min)(least - offset, query.most_end - box.width);
      const auto place = leftmost(shape.turned[t], sheet, most_x, query);
      if (!place) continue;
      const double cost = place->x / units_per_mm + offset;
      if (cost >= least) continue;
      least = cost;
      best = Nested_item{item, t, *place};
    }
    return best;
  }

private:
  static std::int64_t units(double mm) { return std::int64_t(std::floor((mm + 1e-9) * units_per_mm)); }

  std::optional<Grid_point> leftmost(const Turned_shape& b, const Nested_sheet& sheet, double most_x,
                                     const Place_query& query)
  {
    Grid_box window{0, 0, units(problem.width - b.box.width), units(problem.height - b.box.height)};
    if (query.at) {
      window.min_x = (std::max)(window.min_x, query.at->min_x),
      window.max_x = (std::min)(window.max_x, query.at->max_x);
      window.min_y = (std::max)(window.min_y, query.at->min_y),
      window.max_y = (std::min)(window.max_y, query.at->max_y);
    }
    window.max_x = (std::min)(window.max_x, units((std::min)(most_x, 1e6)));
    if (window.min_x > window.max_x || window.min_y > window.max_y) return std::nullopt;
    free.start(window);
    for (const Nested_item& placed : sheet)
      for (const Convex_piece& a : turned(problem, placed).pieces)
        for (const Convex_piece& negated : b.negated) free.forbid(a, negated, placed.at);
    return free.leftmost(units(row_step));
  }

  static constexpr double row_step = 3; // mm

  const Nesting_problem& problem;
  Free_positions free;
};

/// Do no two grown parts overlap, and do all nominal ones keep to the usable rectangle? Exact on the grid; quadratic.
inline bool is_nest_valid(const Nesting_problem& problem, const Nest& nest)
{
  for (const Nested_sheet& sheet : nest)
    for (std::size_t i = 0; i < sheet.size(); ++i) {
      const Turned_shape& b = turned(problem, sheet[i]);
      const Grid_point& at = sheet[i].at;
      if (at.x < 0 || at.y < 0 || at.x / units_per_mm + b.box.width > problem.width + 1e-9 ||
          at.y / units_per_mm + b.box.height > problem.height + 1e-9)
        return false;
      for (std::size_t j = 0; j < i; ++j)
        for (const Convex_grid_polygon& member :
             no_fit_polygon(turned(problem, sheet[j]).pieces, b.negated, sheet[j].at))
          if (is_inside(member, at)) return false;
    }
  return true;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_NEST_H
