// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MAKE_NESTING_PROBLEM_H
#define CGAL_MULTIPLANAR_INTERNAL_MAKE_NESTING_PROBLEM_H

#include <CGAL/Multiplanar/internal/Nest.h>
#include <CGAL/Multiplanar/internal/fitting_boxes.h>
#include <CGAL/Multiplanar/press_fit.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A sheet higher than wide is nested lying on its side.
inline bool is_filled_upward(const Sheet_options& options) { return options.height > options.width; }

/// The boxes of a part at the angles at which it is tried and fits: equal steps from the one that makes its box
/// smallest, or any others if it fits at none of these.
inline std::vector<Turned_box> boxes_to_try(const Part& part, const Sheet_options& options)
{
  const Usable_area area(options);
  const Turned_boxes all = turned_boxes(part, options.mirrored);
  Placement turn;
  turn.mirrored = options.mirrored;
  const double base = std::min_element(all.along_sides.begin(), all.along_sides.end(), smaller_box)->rotation;
  std::vector<Turned_box> boxes;
  for (int r = 0; r < options.rotations; ++r) {
    turn.rotation = base + 360.0 * r / options.rotations;
    const Turned_box box = turned_box(part.outline, turn);
    if (area.fits(box)) boxes.push_back(box);
  }
  if (boxes.empty())
    for (const auto* list : {&all.along_sides, &all.at_degrees})
      for (const Turned_box& box : *list)
        if (area.fits(box)) boxes.push_back(box);
  return boxes;
}

/// A part as it is cut, with the fit on its tabs; one that crosses itself as the hull around it.
inline Part part_to_nest(const Part& part, double fit)
{
  Part result = part;
  if (is_simple_outline(part.outline)) result.outline = press_fit_outline(part, fit);
  else {
    result.outline.clear();
    CGAL::convex_hull_2(part.outline.begin(), part.outline.end(), std::back_inserter(result.outline));
  }
  result.holes.clear();
  for (const Outline& hole : part.holes)
    if (is_simple_outline(hole)) result.holes.push_back(hole);
  return result;
}

/// The position of the first part with the same outline and holes.
inline std::size_t first_alike(const std::vector<Part>& parts, std::size_t i)
{
  std::size_t k = 0;
  while (parts[k].outline != parts[i].outline || parts[k].holes != parts[i].holes) ++k;
  return k;
}

/// \throws Part_too_large
inline Nesting_problem make_nesting_problem(const std::vector<Part>& given, Sheet_options options)
{
  std::vector<Part> parts;
  for (const Part& part : given) parts.push_back(part_to_nest(part, options.fit));
  if (is_filled_upward(options)) std::swap(options.width, options.height);
  fitting_boxes(parts, options);
  Nesting_problem problem;
  const Usable_area area(options);
  problem.width = area.width, problem.height = area.height;
  double smallest = parts[0].area();
  for (const Part& part : parts) smallest = (std::min)(smallest, part.area());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t alike = first_alike(parts, i);
    if (alike < i) {
      problem.shape_of_item.push_back(problem.shape_of_item[alike]);
      continue;
    }
    Nesting_shape shape;
    const std::vector<Outline> pieces =
        nesting_pieces(parts[i], (options.gap + options.kerf) / 2, smallest, shape.area);
    for (const Turned_box& box : boxes_to_try(parts[i], options))
      shape.turned.push_back(turned_shape(pieces, box, options.mirrored));
    problem.shape_of_item.push_back(int(problem.shapes.size()));
    problem.shapes.push_back(std::move(shape));
  }
  return problem;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MAKE_NESTING_PROBLEM_H
