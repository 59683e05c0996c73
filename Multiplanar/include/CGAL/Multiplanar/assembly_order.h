// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ASSEMBLY_ORDER_H
#define CGAL_MULTIPLANAR_ASSEMBLY_ORDER_H

#include <CGAL/Multiplanar/internal/approach.h>
#include <CGAL/Multiplanar/internal/pleasant_order.h>
#include <CGAL/Multiplanar/parts_from_joints.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarAssembly
/// The order in which parts go together, or what stands in its way.
struct Assembly_order
{
  std::vector<Assembly_step> steps; ///< empty if there is no order
  /// If there is no order: edges of the complex whose joints are in the way. Without their joints, there is one, unless
  /// `stuck_parts` says otherwise.
  std::vector<int> blocking_edges;
  /// If there is no order whatever the joints: parts of panels that get in each other's way.
  std::vector<int> stuck_parts;
  std::vector<int> without_approach; ///< steps to whose place no straight way was found
};

namespace internal {

/// The units of every edge that a joint holds together. Teeth of a panel in pieces count for all pieces.
inline std::vector<Unit_joint> unit_joints(const Panel_complex& complex, const Joined_parts& joined)
{
  std::vector<Unit_joint> result;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    if (joined.joints[e].kind != Edge_joint::Kind::teeth) continue;
    for (int u = 0; u < int(joined.parts.size()); ++u)
      for (int v = 0; v < int(joined.parts.size()); ++v)
        if (joined.panel_of_part[u] == complex.edges[e].panels[0] &&
            joined.panel_of_part[v] == complex.edges[e].panels[1])
          result.push_back({{{u, v}}, false});
  }
  for (int c = 0; c < int(joined.parts.size()); ++c)
    if (joined.edge_of_part[c] >= 0) result.push_back({joined.hosts[c], true});
  return result;
}

class Assembly_planner
{
public:
  Assembly_planner(const Panel_complex& complex, const Joined_parts& joined, double thickness, double last)
      : complex(complex), joined(joined), problem{joined.parts, joined.hosts, thickness, last}, motions(problem),
        search(problem, motions), pleasant(problem, motions, unit_joints(complex, joined))
  {
  }

  Assembly_order plan()
  {
    Assembly_order result;
    std::vector<int> units;
    while (!find_order(units))
      if (!leave_out_what_blocks(result)) break;
    if (result.blocking_edges.empty() && result.stuck_parts.empty()) add_steps(units, result);
    return result;
  }

private:
  /// The best base from which there is an order.
  bool find_order(std::vector<int>& units)
  {
    for (const int base : pleasant.bases()) {
      const auto order = search.order(pleasant.preference(base));
      if (!order) continue;
      units = *order;
      return true;
    }
    return false;
  }

  /// Of the units left in a dead end, the one that the fewest edges hold is freed of their connectors.
  bool leave_out_what_blocks(Assembly_order& result)
  {
    const std::vector<bool>& there = search.where_it_ended();
    std::vector<int> fewest;
    std::vector<int> held;
    for (int u = 0; u < int(there.size()); ++u) {
      if (!there[u]) continue;
      const auto blockers = search.blockers(u, there);
      if (blockers.empty()) continue; // the base, which is kept till last
      const auto edges = edges_of_blockers(u, blockers);
      if (edges.empty()) held.push_back(u);
      else if (fewest.empty() || edges.size() < fewest.size()) fewest = edges;
    }
    if (fewest.empty()) {
      result.stuck_parts = held;
      return false;
    }
    bool any = false;
    for (const int e : fewest) {
      any = any ||
            std::find(result.blocking_edges.begin(), result.blocking_edges.end(), e) == result.blocking_edges.end();
      result.blocking_edges.push_back(e);
      for (int c = 0; c < int(joined.parts.size()); ++c)
        if (joined.edge_of_part[c] == e) search.ignore(c);
    }
    std::sort(result.blocking_edges.begin(), result.blocking_edges.end());
    result.blocking_edges.erase(std::unique(result.blocking_edges.begin(), result.blocking_edges.end()),
                                result.blocking_edges.end());
    // Teeth cannot be left out of the search: they are changed first.
    return any && joined.joints[fewest[0]].kind == Edge_joint::Kind::connector;
  }

  /// The edges whose joints block a unit; none if a sheet itself does, at an edge without teeth.
  std::vector<int> edges_of_blockers(int unit, const std::vector<int>& blockers) const
  {
    std::vector<int> edges;
    for (const int p : blockers) {
      const int e = problem.is_unit(p) ? edge_with_teeth(unit, p) : joined.edge_of_part[p];
      if (e < 0) return {};
      edges.push_back(e);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  int edge_with_teeth(int u, int v) const
  {
    const int p = joined.panel_of_part[u], q = joined.panel_of_part[v];
    for (int e = 0; e < complex.number_of_edges(); ++e) {
      const auto& panels = complex.edges[e].panels;
      const bool between = (panels[0] == p && panels[1] == q) || (panels[0] == q && panels[1] == p);
      if (between && joined.joints[e].kind == Edge_joint::Kind::teeth) return e;
    }
    return -1;
  }

  void add_steps(const std::vector<int>& units, Assembly_order& result)
  {
    std::vector<bool> there(problem.parts.size(), false);
    for (const int unit : units) {
      there[unit] = true;
      const auto motion = search.motion(unit, there);
      CGAL_assertion(bool(motion));
      std::vector<int> parts{unit};
      parts.insert(parts.end(), motion->carried.begin(), motion->carried.end());
      add_step(parts, problem.parts[unit].frame.normal, result);
      for (const int c : motion->inserted) add_step({c}, -problem.parts[unit].frame.normal, result);
    }
  }

  void add_step(const std::vector<int>& parts, const Vector_3& out, Assembly_order& result)
  {
    std::vector<const Bodies*> moving;
    for (const int p : parts) moving.push_back(&motions.bodies_of(p));
    const double outside = (std::max)(way_outside(moving, placed), problem.last);
    Assembly_step step;
    step.parts = parts;
    step.direction = -out;
    step.travel = free_travel(moving, placed, out, problem.last, outside);
    step.approach = straight_approach(moving, placed, out, step.travel, outside);
    if (!step.approach) result.without_approach.push_back(int(result.steps.size()));
    result.steps.push_back(step);
    placed.insert(placed.end(), moving.begin(), moving.end());
  }

  const Panel_complex& complex;
  const Joined_parts& joined;
  const Assembly_problem problem;
  const Assembly_motions motions;
  Disassembly search;
  Pleasant_order pleasant;
  std::vector<const Bodies*> placed;
};

} // namespace internal

/*!
\ingroup PkgMultiplanarAssembly

An order in which all parts can be put together.

Every panel goes on along its own normal, because all tabs that it takes, and all it has, are perpendicular to it. The
connectors of an edge are mounted, from inside, on the panel placed first: before it goes on where they get past what is
placed, else right after it, in steps of their own. The last t + 1 mm of every step are proved free of all that is
placed by then, for everything that moves: convex pieces of the parts, swept along the motion, are separated from the
others by planes, beyond the errors of rounding. Parts may touch: they are compared less a skin of 5 nanometres.

The order is found by taking the model apart, panel by panel; the search is complete (up to 20,000 sets of panels for
each base). Among the orders it finds a pleasant one: a large panel lies on the table, every panel is held by one that
is placed, the model grows upward, and the last panel has few tabs and comes from afar.

\param complex what the parts were made from
\param joined by `make_joined_parts()`
\param thickness of the sheet, in mm
\return the steps with, for each, how far its straight way is free and from where it can be reached in a straight line
        (26 directions are tried); or, if there is no order, the edges whose joints are in the way

For n parts that have a bounded number of others near them: n box tests a part, n^2 steps of the search, and for each
panel up to 40 sweeps against all that is placed; 5 to 20 milliseconds a panel.
*/
inline Assembly_order assembly_order(const Panel_complex& complex, const Joined_parts& joined, double thickness)
{
  CGAL_precondition(thickness > 0);
  CGAL_precondition(joined.hosts.size() == joined.parts.size());
  return internal::Assembly_planner(complex, joined, thickness, thickness + 1).plan();
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ASSEMBLY_ORDER_H
