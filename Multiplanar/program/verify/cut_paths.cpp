// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cut_paths.h"

#include "Report.h"
#include "joint_geometry.h"
#include "loops.h"
#include "placing.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

void add_sides(const Loop& loop, const std::vector<bool>& grows, std::vector<Placed_part::Side>& sides)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
    sides.push_back({loop[i], loop[(i + 1) % loop.size()], !grows.empty() && grows[i]});
}

/// The least distance between the boxes of two segments: a lower bound of theirs.
double box_distance(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d)
{
  const auto part = [](double p, double q, double r, double s) {
    return (std::max)({0.0, (std::min)(r, s) - (std::max)(p, q), (std::min)(p, q) - (std::max)(r, s)});
  };
  return (std::max)(part(a.x(), b.x(), c.x(), d.x()), part(a.y(), b.y(), c.y(), d.y()));
}

/// The cut of one part, measured against it.
class Measured_cut
{
public:
  Measured_cut(const Placed_part& part, const Loop& path, double kerf, double fit)
      : part(part), path(path), half_kerf(kerf / 2), growth(fit > 0 ? fit : 0)
  {
  }

  /// Empty if the cut runs where it should.
  std::string problem()
  {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Point_2 &a = path[i], &b = path[(i + 1) % path.size()];
      std::string said = too_near(a, b);
      if (said.empty() && !is_covered(a, b))
        said = "is " + shown(part.distance_to_boundary(farthest) - half_kerf) + " mm too far from the part at " +
               shown(farthest);
      if (!said.empty()) return said;
    }
    return "";
  }

private:
  std::string too_near(const Point_2& a, const Point_2& b) const
  {
    if (part.has_material(a) && part.distance_to_boundary(a) > drawing_tolerance)
      return "runs through the part at " + shown(a);
    for (const auto& side : part.sides) {
      if (box_distance(a, b, side.a, side.b) > half_kerf) continue;
      const double d = distance(a, b, side.a, side.b);
      if (d < half_kerf - drawing_tolerance)
        return "is " + shown(half_kerf - d) + " mm too near to the part at " + shown(a);
    }
    return "";
  }

  /// Is all of ab near enough to one side or another? What is near to one side is convex: if its ends are, all of a
  /// stretch is; otherwise it is halved.
  bool is_covered(const Point_2& a, const Point_2& b)
  {
    for (const auto& side : part.sides) {
      const double reach = half_kerf + drawing_tolerance + (side.grows ? growth : 0);
      if (box_distance(a, a, side.a, side.b) > reach || box_distance(b, b, side.a, side.b) > reach) continue;
      if (distance(a, side.a, side.b) <= reach && distance(b, side.a, side.b) <= reach) return true;
    }
    if (std::hypot(b.x() - a.x(), b.y() - a.y()) < drawing_tolerance / 4) {
      farthest = a;
      return false;
    }
    const Point_2 m = CGAL::midpoint(a, b);
    return is_covered(a, m) && is_covered(m, b);
  }

  const Placed_part& part;
  const Loop& path;
  const double half_kerf, growth;
  Point_2 farthest;
};

/// The middle of a side, moved off the material by `by`.
Point_2 beside(const Placed_part& part, const Placed_part::Side& side, double by)
{
  const double dx = side.b.x() - side.a.x(), dy = side.b.y() - side.a.y(), length = std::hypot(dx, dy);
  const Point_2 m = CGAL::midpoint(side.a, side.b);
  const double x = dy / length, y = -dx / length, probe = 1e-4;
  const double s = part.has_material(Point_2(m.x() + probe * x, m.y() + probe * y)) ? -by : by;
  return Point_2(m.x() + s * x, m.y() + s * y);
}

/// Looks for cuts of holes that are missing: a point of a hole that the waste of the kerf does not reach must be inside
/// one.
std::string problem_of_holes(const Placed_part& part, const std::vector<const Loop*>& inner, double kerf)
{
  std::size_t side = part.outline.size();
  for (std::size_t h = 0; h < part.holes.size(); ++h)
    for (std::size_t i = 0; i < part.holes[h].size(); ++i, ++side) {
      const Point_2 p = beside(part, part.sides[side], kerf / 2 + 2 * drawing_tolerance);
      if (part.distance_to_boundary(p) < kerf / 2 + 1.5 * drawing_tolerance || side_of(part.holes[h], p) != 1) continue;
      const auto around = std::count_if(inner.begin(), inner.end(), [&](const Loop* l) { return side_of(*l, p) > 0; });
      if (around != 1)
        return "hole " + std::to_string(h + 1) + " at " + shown(p) + (around == 0 ? " is not cut" : " is cut twice");
    }
  return "";
}

std::string problem_of_fit(const Placed_part& part, const Loop& outer, double kerf, double fit)
{
  if (fit / 2 <= 2 * drawing_tolerance) return "";
  for (std::size_t t = 0; t < part.tabs.size(); ++t) {
    const std::vector<int>& tab = part.tabs[t];
    int widened = 0;
    for (std::size_t i = 0; i + 1 < tab.size(); ++i)
      if (distance_to_boundary(beside(part, part.sides[tab[i]], kerf / 2 + fit / 2), outer) <= drawing_tolerance)
        ++widened;
    if (widened < (tab.size() >= 4 ? 2 : 1))
      return "its tab " + std::to_string(t + 1) + " is not drawn wider by the fit of " + shown(fit) + " mm";
  }
  return "";
}

} // namespace

bool Placed_part::has_material(const Point_2& p) const
{
  return side_of(outline, p) > 0 &&
         std::none_of(holes.begin(), holes.end(), [&](const Loop& hole) { return side_of(hole, p) >= 0; });
}

double Placed_part::distance_to_boundary(const Point_2& p) const
{
  double least = 1e300;
  for (const Side& side : sides) least = (std::min)(least, distance(p, side.a, side.b));
  return least;
}

Placed_part place(const Written_part& part, const Written_placement& placement)
{
  Placed_part result;
  result.id = part.id;
  result.outline = placed(placement, part.outline);
  std::vector<bool> grows(part.outline.size(), false);
  for (std::size_t t = 0; t < part.tabs.size(); ++t) {
    result.tabs.push_back(tab_vertices(part, t));
    for (std::size_t i = 0; i + 1 < result.tabs.back().size(); ++i) grows[result.tabs.back()[i]] = true;
  }
  add_sides(result.outline, grows, result.sides);
  for (const Loop& hole : part.holes) {
    result.holes.push_back(placed(placement, hole));
    add_sides(result.holes.back(), {}, result.sides);
  }
  return result;
}

std::vector<std::string> problems_of_cuts(const Placed_part& part, const std::vector<const Loop*>& outer,
                                          const std::vector<const Loop*>& inner, double kerf, double fit)
{
  std::vector<std::string> problems;
  bool simple = true;
  for (const auto* paths : {&outer, &inner})
    for (const Loop* path : *paths) {
      const std::string name = paths == &outer ? "its outer cut " : "an inner cut ";
      if (!is_simple(*path)) {
        problems.push_back(name + "at " + shown(path->front()) + " is not a simple polygon");
        simple = false;
        continue;
      }
      const std::string said = Measured_cut(part, *path, kerf, fit).problem();
      if (!said.empty()) problems.push_back(name + said);
      if (paths == &inner && side_of(*path, part.outline[0]) >= 0) problems.push_back(name + "goes around the part");
    }
  if (outer.size() != 1) problems.push_back("it has " + counted(outer.size(), "outer cut") + " instead of one");
  if (!problems.empty() || !simple) return problems;

  for (const Point_2& p : part.outline)
    if (side_of(*outer[0], p) < 0 && distance_to_boundary(p, *outer[0]) > drawing_tolerance) {
      problems.push_back("its outer cut leaves out " + shown(p));
      break;
    }
  for (const std::string& said : {problem_of_holes(part, inner, kerf), problem_of_fit(part, *outer[0], kerf, fit)})
    if (!said.empty()) problems.push_back(said);
  return problems;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
