// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FREE_POSITIONS_H
#define CGAL_MULTIPLANAR_INTERNAL_FREE_POSITIONS_H

#include <CGAL/Multiplanar/internal/no_fit_polygon.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The whole numbers from `low` to `high`.
struct Grid_interval
{
  std::int64_t low, high;
  bool is_empty() const { return low > high; }
};

/// The x of the points with whole coordinates on the line `y` in the interior of a convex polygon.
/// \pre the line is strictly between the lowest and the highest vertex
inline Grid_interval row_of(const Convex_grid_polygon& polygon, std::int64_t y)
{
  Grid_interval row{1, 0};
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Grid_point &a = polygon[i], &b = polygon[i + 1 < n ? i + 1 : 0];
    if ((a.y <= y) == (b.y <= y)) continue;
    if (b.y > a.y) row.high = ceil_quotient((y - a.y) * (b.x - a.x), b.y - a.y) + a.x - 1; // the right side goes up
    else row.low = floor_quotient((y - b.y) * (a.x - b.x), a.y - b.y) + b.x + 1;
  }
  return row;
}

/// row_of() with x and y exchanged.
inline Grid_interval column_of(const Convex_grid_polygon& polygon, std::int64_t x)
{
  Grid_interval column{1, 0};
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Grid_point &a = polygon[i], &b = polygon[i + 1 < n ? i + 1 : 0];
    if ((a.x <= x) == (b.x <= x)) continue;
    if (b.x > a.x) column.low = floor_quotient((x - a.x) * (b.y - a.y), b.x - a.x) + a.y + 1; // the lower side
    else column.high = ceil_quotient((x - b.x) * (a.y - b.y), a.x - b.x) + b.y - 1;
  }
  return column;
}

/*!
Where one part can lie: the points of a rectangle (the inner-fit rectangle, or a window of it) in the interior of none
of the convex members of no-fit polygons. All on the grid; what is returned is free exactly.

Rows and columns are searched: on a line, every member forbids one interval. A place found on a row is pushed down and
to the left as far as it goes, so that it ends in a corner between obstacles, wherever the rows lie.
*/
class Free_positions
{
public:
  /// Forgets all members. \param window_ of positions, not empty
  void start(const Grid_box& window_)
  {
    window = window_;
    count = 0;
  }

  /// Adds A + (-B), A lying at `shift`, if it can matter.
  void forbid(const Convex_piece& a, const Convex_piece& negated_b, const Grid_point& shift)
  {
    const Grid_box box{a.box.min_x + negated_b.box.min_x + shift.x, a.box.min_y + negated_b.box.min_y + shift.y,
                       a.box.max_x + negated_b.box.max_x + shift.x, a.box.max_y + negated_b.box.max_y + shift.y};
    if (box.max_x <= window.min_x || box.min_x >= window.max_x || box.max_y <= window.min_y ||
        box.min_y >= window.max_y)
      return;
    if (count == members.size()) members.emplace_back();
    members[count].box = box;
    convex_sum(a.polygon, negated_b.polygon, shift, members[count].polygon);
    ++count;
  }

  bool is_free(const Grid_point& p) const
  {
    if (p.x < window.min_x || p.y < window.min_y || p.x > window.max_x || p.y > window.max_y) return false;
    for (std::size_t i = 0; i < count; ++i)
      if (is_in_open_box(members[i].box, p) && is_inside(members[i].polygon, p)) return false;
    return true;
  }

  /// The leftmost place, of these the lowest, among the rows `step` apart; pushed down and to the left.
  std::optional<Grid_point> leftmost(std::int64_t step)
  {
    fill_rows(step);
    std::optional<Grid_point> best;
    std::int64_t limit = window.max_x;
    for (std::size_t r = 0; r < number_of_rows && limit >= window.min_x; ++r) {
      const std::int64_t x = first_free(rows[r], limit);
      if (x > limit) continue;
      best = Grid_point{x, y_of_row(r, step)};
      limit = x - 1;
    }
    if (best) *best = settled(*best);
    return best;
  }

  /// A free place pushed down and to the left until it moves no more, or a few times.
  Grid_point settled(Grid_point p)
  {
    CGAL_precondition(is_free(p));
    for (int i = 0; i < 20; ++i) {
      const Grid_point before = p;
      p.y = pushed_down(p);
      p.x = pushed_left(p);
      if (p == before) break;
    }
    CGAL_postcondition(is_free(p));
    return p;
  }

private:
  struct Member
  {
    Convex_grid_polygon polygon;
    Grid_box box;
  };

  /// A Grid_interval in half the memory, maybe empty.
  struct Row_interval
  {
    std::int32_t low, high;
  };

  static bool is_in_open_box(const Grid_box& box, const Grid_point& p)
  {
    return p.x > box.min_x && p.x < box.max_x && p.y > box.min_y && p.y < box.max_y;
  }

  std::int64_t y_of_row(std::size_t r, std::int64_t step) const
  {
    return (std::min)(window.min_y + std::int64_t(r) * step, window.max_y);
  }

  /// For every row the intervals that are forbidden.
  void fill_rows(std::int64_t step)
  {
    number_of_rows = std::size_t((window.max_y - window.min_y + step - 1) / step) + 1;
    if (rows.size() < number_of_rows) rows.resize(number_of_rows);
    for (std::size_t r = 0; r < number_of_rows; ++r) rows[r].clear();
    from_the_left.clear();
    for (std::size_t i = 0; i < count; ++i) from_the_left.push_back({members[i].box.min_x, i});
    std::sort(from_the_left.begin(), from_the_left.end());
    for (const auto& member : from_the_left) fill_rows_of(members[member.second], step);
  }

  /// The two chains of a member are followed from its lowest vertex upward, row by row. In doubles, and a thousandth of
  /// a unit too wide: a row must not offer what is forbidden, and may lose a place that only just is free.
  void fill_rows_of(const Member& m, std::int64_t step)
  {
    const Convex_grid_polygon& v = m.polygon;
    const std::size_t n = v.size();
    std::size_t right = 0, left = 0; // the sides right -> right + 1 and left -> left - 1, which go up
    const auto next_left = [&] { return left == 0 ? n - 1 : left - 1; };
    const auto slope = [&](std::size_t from, std::size_t to) {
      return double(v[to].x - v[from].x) / double(v[to].y - v[from].y);
    };
    double right_slope = 0, left_slope = 0;
    bool fresh = true;
    const std::int64_t first = (std::max)(std::int64_t(0), floor_quotient(m.box.min_y - window.min_y, step) + 1);
    for (std::size_t r = std::size_t(first); r < number_of_rows; ++r) {
      const std::int64_t y = y_of_row(r, step);
      if (y >= m.box.max_y) break;
      if (y <= m.box.min_y) continue; // the last row is nearer than a step
      if (fresh || v[right + 1].y <= y) {
        while (v[right + 1].y <= y) ++right;
        right_slope = slope(right, right + 1);
      }
      if (fresh || v[next_left()].y <= y) {
        while (v[next_left()].y <= y) left = next_left();
        left_slope = slope(left, next_left());
      }
      fresh = false;
      const double low = double(v[left].x) + double(y - v[left].y) * left_slope;
      const double high = double(v[right].x) + double(y - v[right].y) * right_slope;
      if (high >= double(window.min_x) && low <= double(window.max_x) + 1)
        rows[r].push_back({std::int32_t(std::ceil(low - 1e-3)), std::int32_t(std::floor(high + 1e-3))});
    }
  }

  /// The least free x of a row, or one above `limit`.
  std::int64_t first_free(std::vector<Row_interval>& row, std::int64_t limit) const
  {
    // Insertion: the rows are short, and nearly in order as the members are.
    for (std::size_t i = 1; i < row.size(); ++i) {
      const Row_interval interval = row[i];
      std::size_t k = i;
      for (; k > 0 && row[k - 1].low > interval.low; --k) row[k] = row[k - 1];
      row[k] = interval;
    }
    std::int64_t x = window.min_x;
    for (const Row_interval& i : row) {
      if (i.low > x || x > limit) break;
      x = (std::max)(x, std::int64_t(i.high) + 1);
    }
    return x;
  }

  /// The least y reached from the free place p by going straight down.
  std::int64_t pushed_down(const Grid_point& p) const
  {
    std::int64_t stop = window.min_y;
    for (std::size_t i = 0; i < count; ++i) {
      const Member& m = members[i];
      if (p.x <= m.box.min_x || p.x >= m.box.max_x || m.box.min_y >= p.y) continue;
      const Grid_interval column = column_of(m.polygon, p.x);
      if (!column.is_empty() && column.high < p.y) stop = (std::max)(stop, column.high + 1);
    }
    return stop;
  }

  std::int64_t pushed_left(const Grid_point& p) const
  {
    std::int64_t stop = window.min_x;
    for (std::size_t i = 0; i < count; ++i) {
      const Member& m = members[i];
      if (p.y <= m.box.min_y || p.y >= m.box.max_y || m.box.min_x >= p.x) continue;
      const Grid_interval row = row_of(m.polygon, p.y);
      if (!row.is_empty() && row.high < p.x) stop = (std::max)(stop, row.high + 1);
    }
    return stop;
  }

  Grid_box window;
  std::vector<Member> members; ///< the first `count` are in use; the rest keep their memory
  std::size_t count = 0, number_of_rows = 0;
  std::vector<std::pair<std::int64_t, std::size_t>> from_the_left; ///< members by the left end of their boxes
  std::vector<std::vector<Row_interval>> rows;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FREE_POSITIONS_H
