// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_NEST_SEARCH_H
#define CGAL_MULTIPLANAR_INTERNAL_NEST_SEARCH_H

#include <CGAL/Multiplanar/internal/Nest.h>
#include <CGAL/Multiplanar/internal/Split_mix.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// When a search ends.
struct Nest_budget
{
  std::int64_t insertions = 0; ///< so many parts were laid anew
  double seconds = -1;         ///< if not negative, this time is over instead
};

/*!
A nest, made part by part, that becomes denser.

First all parts are laid by falling area, each on the first sheet with room, at the place with the least
x + upright * width. Then, again and again, some parts that lie near each other are taken out, with those that decide
the length, and laid anew in another order (Shaw 1998, large neighbourhood search). What is longer than before is kept
only by chance, less and less often. All choices come from one generator, so that the same budget of insertions gives
the same nest.
*/
class Nest_search
{
public:
  Nest_search(const Nesting_problem& problem, double upright, std::uint64_t seed)
      : problem(problem), space(problem), random(seed), upright(upright)
  {
  }

  Nest run(const Nest_budget& budget)
  {
    start = std::chrono::steady_clock::now();
    Nest best = first_nest();
    insertions = 0;
    double least = value(best);
    Nest current = best;
    double now = least;
    for (double used = share(budget); used < 1; used = share(budget)) {
      Nest trial = current;
      if (!lay_some_anew(trial)) continue;
      const double v = value(trial);
      if (v > now + warmth * (1 - used) * random.uniform()) continue;
      current = std::move(trial), now = v;
      if (now < least) best = current, least = now;
    }
    return best;
  }

  /// What is minimised, in mm: the length used, sheets before the last counted as wholes, and half the mean distance of
  /// the parts from the left end, so that room is gathered at the right before the length shrinks.
  double value(const Nest& nest) const
  {
    double moment = 0, total = 0;
    for (std::size_t s = 0; s < nest.size(); ++s)
      for (const Nested_item& placed : nest[s]) {
        const double area = problem.shape(placed.item).area;
        moment += area * (double(s) * problem.width + centre(placed, 0));
        total += area;
      }
    return double(nest.size() - 1) * problem.width + used_length(problem, nest.back()) + 0.5 * moment / total;
  }

private:
  static constexpr double warmth = 1; // mm

  double share(const Nest_budget& budget)
  {
    if (budget.seconds < 0)
      return ++tries > budget.insertions ? 1 : double(insertions) / double(budget.insertions); // each try inserts
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return budget.seconds > 0 ? passed.count() / budget.seconds : 1;
  }

  double centre(const Nested_item& placed, int axis) const
  {
    const Turned_box& box = turned(problem, placed).box;
    return axis == 0 ? placed.at.x / units_per_mm + box.width / 2 : placed.at.y / units_per_mm + box.height / 2;
  }

  Nest first_nest()
  {
    std::vector<int> items;
    for (int i = 0; i < problem.number_of_items(); ++i) items.push_back(i);
    sort_by_area(items, 0);
    Nest nest(1);
    for (int item : items) insert(item, {upright, 1e9, std::nullopt}, nest);
    return nest;
  }

  /// Falling area, where each area was multiplied by a random number of at most e^(noise / 2).
  void sort_by_area(std::vector<int>& items, double noise)
  {
    std::vector<std::pair<double, int>> keys;
    for (int i : items) keys.push_back({-problem.shape(i).area * std::exp(noise * (random.uniform() - 0.5)), i});
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < items.size(); ++i) items[i] = keys[i].second;
  }

  /// Lays an item on the first sheet with room, a new one if need be. `most_end` is for the last sheet; with any, no
  /// sheet is added. \return whether the item was laid
  bool insert(int item, const Place_query& query, Nest& nest)
  {
    ++insertions;
    for (std::size_t s = 0;; ++s) {
      if (s == nest.size()) {
        if (query.most_end < 1e9) return false;
        nest.emplace_back();
      }
      Place_query here = query;
      if (s + 1 < nest.size()) here.most_end = 1e9;
      if (const auto place = space.best_place(item, nest[s], here)) {
        nest[s].push_back(*place);
        return true;
      }
    }
  }

  /// \return whether all were laid within the length used before and a little more
  bool lay_some_anew(Nest& nest)
  {
    const double most_end = used_length(problem, nest.back()) + warmth;
    const int sheet = random.below(3) == 0 ? random.below(int(nest.size())) : int(nest.size()) - 1;
    Grid_box hole;
    std::vector<int> items = take_neighbours(nest[sheet], hole);
    take_last(nest.back(), most_end - 2 * warmth, items);
    sort_by_area(items, 1);
    Place_query query;
    query.upright = 0.3 + 0.7 * random.uniform();
    query.most_end = most_end;
    for (int item : items) {
      query.at = hole;
      ++insertions;
      Place_query here = query;
      if (sheet + 1 < int(nest.size())) here.most_end = 1e9;
      if (const auto place = space.best_place(item, nest[sheet], here)) {
        nest[sheet].push_back(*place);
        continue;
      }
      query.at.reset();
      if (!insert(item, query, nest)) return false;
    }
    while (nest.size() > 1 && nest.back().empty()) nest.pop_back();
    return true;
  }

  /// Takes 4 to 15 items around a random place off a sheet. \param hole becomes the box around them
  std::vector<int> take_neighbours(Nested_sheet& sheet, Grid_box& hole)
  {
    const double length = used_length(problem, sheet);
    const double x = random.below(2) ? length * random.uniform() : length, y = problem.height * random.uniform();
    std::vector<std::pair<double, int>> keys;
    for (int i = 0; i < int(sheet.size()); ++i)
      keys.push_back({std::hypot(centre(sheet[i], 0) - x, centre(sheet[i], 1) - y), i});
    std::sort(keys.begin(), keys.end());
    keys.resize((std::min)(int(keys.size()), 4 + random.below(12)));
    std::vector<bool> gone(sheet.size(), false);
    for (const auto& key : keys) {
      gone[key.second] = true;
      const Grid_point& at = sheet[key.second].at;
      const Grid_box& box = turned(problem, sheet[key.second]).bounds;
      hole.add(Grid_point{at.x + box.min_x - room_around, at.y + box.min_y - room_around});
      hole.add(Grid_point{at.x + box.max_x, at.y + box.max_y});
    }
    return taken(sheet, gone);
  }

  /// Takes off what reaches beyond `end`.
  void take_last(Nested_sheet& sheet, double end, std::vector<int>& items)
  {
    std::vector<bool> gone;
    for (const Nested_item& placed : sheet) gone.push_back(right_end(problem, placed) > end);
    for (int item : taken(sheet, gone)) items.push_back(item);
  }

  static std::vector<int> taken(Nested_sheet& sheet, const std::vector<bool>& gone)
  {
    std::vector<int> items;
    Nested_sheet kept;
    for (std::size_t i = 0; i < sheet.size(); ++i)
      if (gone[i]) items.push_back(sheet[i].item);
      else kept.push_back(sheet[i]);
    sheet.swap(kept);
    return items;
  }

  static constexpr std::int64_t room_around = 5 * 1024; // units

  const Nesting_problem& problem;
  Nesting_space space;
  Split_mix random;
  const double upright;
  std::int64_t insertions = 0, tries = 0;
  std::chrono::steady_clock::time_point start;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_NEST_SEARCH_H
