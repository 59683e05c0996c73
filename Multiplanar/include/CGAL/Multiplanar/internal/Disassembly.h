// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_DISASSEMBLY_H
#define CGAL_MULTIPLANAR_INTERNAL_DISASSEMBLY_H

#include <CGAL/Multiplanar/internal/Assembly_motions.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// How a unit is put on: with these connectors mounted on it, after which those are put in from inside.
struct Unit_motion
{
  std::vector<int> carried, inserted;
};

/*!
Looks for an order backward: from the whole model, units are taken off one by one, each along its normal, together with
the connectors that only it still holds. Which parts are there depends on the *set* of units that are left, so a set
from which no way leads on is remembered and never tried again: the search is complete. Taking off frees: what is in a
unit's own way only becomes less, which is why the search hardly ever turns back. If it ends at units each of which is
blocked by others of them, no order whatever takes them apart (whichever would be the first of them could not go), and
it ends for good.
*/
class Disassembly
{
public:
  /// In which order the units of a set are tried, `last` being the one taken off before (-1: none); the first are taken
  /// off first. May leave some out for good.
  using Preference = std::function<std::vector<int>(const std::vector<bool>& there, int last)>;

  Disassembly(const Assembly_problem& problem, const Assembly_motions& motions)
      : problem(problem), motions(motions), ignored(problem.parts.size(), false), connectors_of(problem.parts.size())
  {
    for (int c = 0; c < int(problem.parts.size()); ++c)
      if (!problem.is_unit(c))
        for (const int host : problem.hosts[c]) connectors_of[host].push_back(c);
  }

  /// Connectors that are left out of the model.
  void ignore(int connector) { ignored[connector] = true; }

  /// The units in the order in which they are placed; none if there is no order, or none was found within `most` sets.
  std::optional<std::vector<int>> order(const Preference& preference, int most = 20000)
  {
    dead.clear();
    budget = most;
    hopeless = false;
    smallest_dead.clear();
    std::vector<bool> there(problem.parts.size());
    for (int p = 0; p < int(there.size()); ++p) there[p] = problem.is_unit(p);
    std::vector<int> taken_off;
    if (!take_off_all(there, preference, taken_off)) return std::nullopt;
    return std::vector<int>(taken_off.rbegin(), taken_off.rend());
  }

  /// After a failure: the smallest set of units from which none could be taken off.
  const std::vector<bool>& where_it_ended() const { return smallest_dead; }

  /// How `unit` comes to a set of units, `there` being the set with it; none if it cannot.
  std::optional<Unit_motion> motion(int unit, const std::vector<bool>& there) const
  {
    if (is_in_the_way_of(unit, there)) return std::nullopt;
    Unit_motion result;
    for (const int c : connectors_of[unit]) {
      const int side = problem.hosts[c][0] == unit ? 0 : 1;
      if (ignored[c] || there[problem.hosts[c][1 - side]]) continue;
      if (is_free(motions.obstacles_of_carried(c, side), unit, there, false)) result.carried.push_back(c);
      else if (is_free(motions.obstacles_of_inserted(c, side), unit, there, true)) result.inserted.push_back(c);
      else return std::nullopt;
    }
    return result;
  }

  /// The parts that keep `unit` from being taken off a set: units, and connectors, its own that run into something too.
  std::vector<int> blockers(int unit, const std::vector<bool>& there) const
  {
    std::set<int> result;
    for (const int p : motions.obstacles_of_unit(unit))
      if (is_there_without(p, unit, there)) result.insert(p);
    for (const int c : connectors_of[unit]) {
      const int side = problem.hosts[c][0] == unit ? 0 : 1;
      if (!ignored[c] && !there[problem.hosts[c][1 - side]] &&
          !is_free(motions.obstacles_of_carried(c, side), unit, there, false) &&
          !is_free(motions.obstacles_of_inserted(c, side), unit, there, true))
        result.insert(c);
    }
    return {result.begin(), result.end()};
  }

  const std::vector<int>& connectors(int unit) const { return connectors_of[unit]; }
  bool is_ignored(int connector) const { return ignored[connector]; }

private:
  /// Is something in the way of the sheet of `unit` itself?
  bool is_in_the_way_of(int unit, const std::vector<bool>& there) const
  {
    const auto& obstacles = motions.obstacles_of_unit(unit);
    return std::any_of(obstacles.begin(), obstacles.end(), [&](int p) { return is_there_without(p, unit, there); });
  }

  /// Is part p there when `unit` is not?
  bool is_there_without(int p, int unit, const std::vector<bool>& there) const
  {
    if (problem.is_unit(p)) return p != unit && there[p];
    const auto& hosts = problem.hosts[p];
    return !ignored[p] && ((hosts[0] != unit && there[hosts[0]]) || (hosts[1] != unit && there[hosts[1]]));
  }

  bool is_free(const std::vector<int>& obstacles, int unit, const std::vector<bool>& there, bool unit_is_there) const
  {
    for (const int p : obstacles) {
      if (is_there_without(p, unit, there)) return false;
      const bool comes_with_unit = p == unit || problem.hosts[p][0] == unit || problem.hosts[p][1] == unit;
      if (unit_is_there && comes_with_unit && !ignored[p]) return false;
    }
    return true;
  }

  bool take_off_all(std::vector<bool>& there, const Preference& preference, std::vector<int>& taken_off)
  {
    int left = 0;
    for (const bool b : there) left += b;
    if (left == 0) return true;
    if (dead.count(there) || --budget < 0) return false;
    bool any = false;
    const std::vector<int> choice = preference(there, taken_off.empty() ? -1 : taken_off.back());
    for (const int unit : choice) {
      if (!motion(unit, there)) continue;
      any = true;
      there[unit] = false;
      taken_off.push_back(unit);
      if (take_off_all(there, preference, taken_off)) return true;
      taken_off.pop_back();
      there[unit] = true;
      if (budget < 0 || hopeless) return false;
    }
    if (!any) {
      if (smallest_dead.empty() || left < count(smallest_dead)) smallest_dead = there;
      hopeless = std::all_of(choice.begin(), choice.end(), [&](int unit) { return is_in_the_way_of(unit, there); });
    }
    dead.insert(there);
    return false;
  }

  static int count(const std::vector<bool>& set)
  {
    int n = 0;
    for (const bool b : set) n += b;
    return n;
  }

  const Assembly_problem& problem;
  const Assembly_motions& motions;
  std::vector<bool> ignored;
  std::vector<std::vector<int>> connectors_of; ///< by unit
  std::set<std::vector<bool>> dead;
  std::vector<bool> smallest_dead;
  int budget = 0;
  bool hopeless = false;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_DISASSEMBLY_H
