// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ASSEMBLED_PARTS_H
#define CGAL_MULTIPLANAR_ASSEMBLED_PARTS_H

#include <CGAL/Multiplanar/assembly_order.h>

#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarAssembly
/// Parts, what joins them, and the order in which they go together.
struct Assembled_parts
{
  Joined_parts joined;               ///< the parts and what joins them
  std::vector<Assembly_step> steps;  ///< empty if there is no order; then a warning says why
  std::vector<std::string> warnings; ///< of the parts and of the assembly
};

namespace internal {

inline std::string listed(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// The panels that parts belong to, ascending.
inline std::vector<int> panels_of(const Joined_parts& joined, const std::vector<int>& parts)
{
  std::vector<int> result;
  for (const int part : parts) result.push_back(joined.panel_of_part[part]);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// What is tried next at an edge whose joint is in the way: teeth instead of connectors, glue instead of teeth.
inline Joint_mode next_joint(Edge_joint::Kind present, Joint_mode mode)
{
  const bool may_have_teeth = mode == Joint_mode::automatic;
  return present == Edge_joint::Kind::connector && may_have_teeth ? Joint_mode::teeth : Joint_mode::none;
}

inline std::string joint_change_warning(const Panel_complex& complex, const Joined_parts& joined,
                                        const std::map<int, Joint_mode>& changed)
{
  std::vector<std::string> list;
  for (const auto& entry : changed) {
    const int e = entry.first;
    list.push_back(edge_id(complex, e) + " (" + panel_id(complex, complex.edges[e].panels[0]) + "-" +
                   panel_id(complex, complex.edges[e].panels[1]) + ": " +
                   (joined.joints[e].kind == Edge_joint::Kind::teeth ? "teeth" : "glue") + ")");
  }
  return "so that the parts can be put together one after another, " +
         std::string(list.size() == 1 ? "this edge has" : "these edges have") + " another joint: " + listed(list);
}

inline std::string no_order_warning(const Joined_parts& joined, const std::vector<int>& stuck)
{
  std::vector<std::string> list;
  for (const int part : stuck) list.push_back(joined.parts[part].id);
  return "no order of assembly: these parts of panels are in each other's way, whatever the joints: " + listed(list) +
         ": use a larger size, a thinner sheet or other panels";
}

inline std::string approach_warning(const Joined_parts& joined, const Assembly_order& order)
{
  std::vector<std::string> list;
  for (const int s : order.without_approach) {
    char text[64];
    std::snprintf(text, sizeof text, " (%g mm)", order.steps[s].travel);
    list.push_back(joined.parts[order.steps[s].parts[0]].id + text);
  }
  return "no straight way leads to the place of these parts; tilt them in; the end of their way is free: " +
         listed(list);
}

/// Has the panels that are in each other's way cut free of each other. \return whether that is something new
inline bool free_stuck_panels(const Joined_parts& joined, const Assembly_order& order, Joint_options& options)
{
  bool any = false;
  for (const int p : panels_of(joined, order.stuck_parts)) {
    if (std::find(options.freed.begin(), options.freed.end(), p) != options.freed.end()) continue;
    options.freed.push_back(p);
    any = true;
  }
  return any;
}

inline std::string freed_warning(const Panel_complex& complex, const std::vector<int>& freed)
{
  std::vector<std::string> list;
  for (const int p : freed) list.push_back(panel_id(complex, p));
  return "these panels overhang each other; one of them is cut back so that it can be put on, which leaves a gap: " +
         listed(list);
}

} // namespace internal

/*!
\ingroup PkgMultiplanarAssembly

Parts that can be put together: `make_joined_parts()` and `assembly_order()`. Where joints allow no order, the edges in
the way get another joint (teeth, and glue where teeth do not help), and everything is done again; a warning names them.

\param complex flat panels, in mm, outward oriented
\param options as for `make_joints()`
\throws std::invalid_argument as `make_joints()`
*/
inline Assembled_parts make_assembled_parts(const Panel_complex& complex, Joint_options options)
{
  Assembled_parts result;
  std::map<int, Joint_mode> changed;
  Assembly_order order;
  for (;;) {
    result.joined = make_joined_parts(complex, options);
    for (const auto& entry : changed)
      if (result.joined.joints[entry.first].kind == Edge_joint::Kind::none)
        result.joined.joints[entry.first].reason = "glue: a joint would keep a panel from being put on";
    order = assembly_order(complex, result.joined, options.thickness);
    if (order.blocking_edges.empty() && !internal::free_stuck_panels(result.joined, order, options)) break;
    if (options.mode_of_edge.empty()) options.mode_of_edge.assign(complex.number_of_edges(), options.mode);
    for (const int e : order.blocking_edges)
      changed[e] = options.mode_of_edge[e] =
          internal::next_joint(result.joined.joints[e].kind, options.mode_of_edge[e]);
  }
  result.warnings = result.joined.warnings;
  if (!changed.empty()) result.warnings.push_back(internal::joint_change_warning(complex, result.joined, changed));
  if (!options.freed.empty()) result.warnings.push_back(internal::freed_warning(complex, options.freed));
  if (!order.stuck_parts.empty())
    result.warnings.push_back(internal::no_order_warning(result.joined, order.stuck_parts));
  if (!order.without_approach.empty()) result.warnings.push_back(internal::approach_warning(result.joined, order));
  result.steps = std::move(order.steps);
  return result;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ASSEMBLED_PARTS_H
