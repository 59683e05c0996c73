// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PLEASANT_ORDER_H
#define CGAL_MULTIPLANAR_INTERNAL_PLEASANT_ORDER_H

#include <CGAL/Multiplanar/internal/Disassembly.h>
#include <CGAL/Multiplanar/internal/cut_vertices.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Two units that a joint holds together.
struct Unit_joint
{
  std::array<int, 2> units;
  bool by_connectors; ///< else by teeth
};

/*!
What makes an order pleasant. A large panel lies on the table as the base; every panel is held by a joint of one that is
placed already; the model grows upward from the table, and from one panel to the next beside it; and the last panel is
one that comes from afar unhindered and has few tabs to thread in.
*/
class Pleasant_order
{
public:
  Pleasant_order(const Assembly_problem& problem, const Assembly_motions& motions,
                 const std::vector<Unit_joint>& joints)
      : problem(problem), motions(motions), neighbours(problem.parts.size()), tabs(problem.parts.size(), 0),
        teeth(problem.parts.size(), 0)
  {
    for (const Unit_joint& joint : joints)
      for (int side = 0; side < 2; ++side) {
        neighbours[joint.units[side]].push_back(joint.units[1 - side]);
        if (!joint.by_connectors) ++teeth[joint.units[side]];
      }
    for (auto& list : neighbours) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    for (int c = 0; c < int(problem.parts.size()); ++c)
      if (!problem.is_unit(c))
        for (const int host : problem.hosts[c]) ++tabs[host];
    for (int u = 0; u < int(problem.parts.size()); ++u)
      if (problem.is_unit(u)) units.push_back(u);
  }

  /// Units that may be the base, the best first.
  std::vector<int> bases() const
  {
    std::vector<int> result = units;
    std::vector<double> area(problem.parts.size(), 0);
    for (const int u : units) area[u] = neighbours[u].empty() ? 0 : problem.parts[u].area();
    std::stable_sort(result.begin(), result.end(), [&](int u, int v) { return area[u] > area[v]; });
    return result;
  }

  /// \param base placed first
  Disassembly::Preference preference(int base) const
  {
    const std::vector<double> height = heights(base);
    const auto range = std::minmax_element(height.begin(), height.end());
    const double near = 0.2 * (*range.second - *range.first);
    return [this, base, height, near](const std::vector<bool>& there, int last) {
      const Cut_vertices cuts(neighbours, there);
      std::vector<std::tuple<bool, bool, bool, double, int>> keys; // the smallest is taken off first
      for (const int u : units) {
        if (!there[u] || (u == base && count(there) > 1)) continue;
        const bool is_near = last >= 0 && std::binary_search(neighbours[u].begin(), neighbours[u].end(), last);
        if (last < 0) keys.emplace_back(cuts.is_cut(u), !is_easy(u), !comes_from_afar(u), effort(u), u);
        else keys.emplace_back(cuts.is_cut(u), !neighbours[u].empty(), false, -height[u] - (is_near ? near : 0), u);
      }
      std::sort(keys.begin(), keys.end());
      std::vector<int> result;
      for (const auto& key : keys) result.push_back(std::get<4>(key));
      return result;
    };
  }

private:
  static int count(const std::vector<bool>& set) { return int(std::count(set.begin(), set.end(), true)); }

  /// Above the table, on which the base lies; but at least as high as every unit that must be there
  /// before it, so that these need not be placed early only because it is.
  std::vector<double> heights(int base) const
  {
    const Frame& table = problem.parts[base].frame;
    std::vector<double> result(problem.parts.size(), 0);
    for (const int u : units) {
      const Bbox_3& box = motions.bodies_of(u).box;
      const Point_3 middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
      result[u] = (table.origin - middle) * table.normal;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const int u : units) // must come before v
        for (const int v : motions.obstacles_of_unit(u))
          if (problem.is_unit(v) && result[v] < result[u]) {
            result[v] = result[u];
            changed = true;
          }
    }
    return result;
  }

  /// As the last panel: it has tabs that hold it, and no teeth to fit in.
  bool is_easy(int u) const { return tabs[u] > 0 && teeth[u] == 0; }
  double effort(int u) const { return tabs[u] + 2 * teeth[u]; }

  /// With all other parts there, is the whole column before the unit free?
  bool comes_from_afar(int u) const
  {
    double far = 0;
    for (const int v : units)
      for (int i = 0; i < 3; ++i)
        far = (std::max)(far, (motions.bodies_of(v).box.max)(i) - (motions.bodies_of(v).box.min)(i));
    const Bodies swept = swept_bodies(motions.bodies_of(u), 10 * far * problem.parts[u].frame.normal);
    for (int p = 0; p < int(problem.parts.size()); ++p)
      if (p != u && !proved_apart(swept, motions.bodies_of(p))) return false;
    return true;
  }

  const Assembly_problem& problem;
  const Assembly_motions& motions;
  std::vector<std::vector<int>> neighbours; ///< by part
  std::vector<int> tabs, teeth;             ///< by part
  std::vector<int> units;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PLEASANT_ORDER_H
