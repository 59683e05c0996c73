// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_ASSEMBLY_MOTIONS_H
#define CGAL_MULTIPLANAR_INTERNAL_ASSEMBLY_MOTIONS_H

#include <CGAL/Multiplanar/Assembly.h>
#include <CGAL/Multiplanar/internal/shrunk_parts.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// Notation: a *unit* is a part of a panel. A *connector* has two hosts, the units that its tabs go through. The host
// that is placed first carries it: it comes with that unit, or is put in from inside right after it. A part is *there*
// once it is placed. Blocked and free are meant over the last `last` mm of a motion.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// What an order is sought for.
struct Assembly_problem
{
  std::vector<Part> parts;
  std::vector<std::array<int, 2>> hosts; ///< by part: the hosts of a connector, {-1, -1} for units
  double thickness = 0;
  double last = 0; ///< mm

  bool is_unit(int part) const { return hosts[part][0] < 0; }
};

/// Which motion runs into which part, every question answered once.
class Assembly_motions
{
public:
  explicit Assembly_motions(const Assembly_problem& problem)
      : problem(problem), by_unit(problem.parts.size()), carried(problem.parts.size()), inserted(problem.parts.size()),
        insertion_known(problem.parts.size(), {{false, false}})
  {
    for (const Part& part : problem.parts) bodies.push_back(shrunk_part(part, problem.thickness));
    for (int p = 0; p < int(bodies.size()); ++p) {
      if (problem.is_unit(p)) by_unit[p] = obstacles_of(p, way_out(p), p, p);
      else
        for (int side = 0; side < 2; ++side)
          carried[p][side] = obstacles_of(p, way_out(problem.hosts[p][side]), problem.hosts[p][0], problem.hosts[p][1]);
    }
  }

  /// The parts that a unit runs into when it is put on alone.
  const std::vector<int>& obstacles_of_unit(int unit) const { return by_unit[unit]; }
  /// The parts that a connector runs into when it comes with host `side`, its hosts aside.
  const std::vector<int>& obstacles_of_carried(int connector, int side) const { return carried[connector][side]; }
  /// The parts that a connector runs into when it is put into host `side` from inside, the other host aside.
  const std::vector<int>& obstacles_of_inserted(int connector, int side) const
  {
    if (!insertion_known[connector][side]) {
      const int host = problem.hosts[connector][side], other = problem.hosts[connector][1 - side];
      inserted[connector][side] = obstacles_of(connector, -way_out(host), other, other);
      insertion_known[connector][side] = true;
    }
    return inserted[connector][side];
  }

  const Bodies& bodies_of(int part) const { return bodies[part]; }
  /// From its place along its normal.
  Vector_3 way_out(int unit) const { return problem.last * problem.parts[unit].frame.normal; }

private:
  /// All parts but `a` and `b` that a part runs into on its way.
  std::vector<int> obstacles_of(int part, const Vector_3& way, int a, int b) const
  {
    const Bodies swept = swept_bodies(bodies[part], way);
    std::vector<int> result;
    for (int q = 0; q < int(bodies.size()); ++q)
      if (q != part && q != a && q != b && !proved_apart(swept, bodies[q])) result.push_back(q);
    return result;
  }

  const Assembly_problem& problem;
  std::vector<Bodies> bodies;
  std::vector<std::vector<int>> by_unit;
  std::vector<std::array<std::vector<int>, 2>> carried;
  mutable std::vector<std::array<std::vector<int>, 2>> inserted;
  mutable std::vector<std::array<bool, 2>> insertion_known;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_ASSEMBLY_MOTIONS_H
