// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_GUARD_FIXTURES_H
#define MULTIPLANAR_TEST_GUARD_FIXTURES_H

#include "guard_brute_force.h"
#include "meshes.h"

#include <CGAL/Surface_mesh.h>

#include <cstring>

/// What the tests of guarded motion share.
namespace Multiplanar_test {

using Surface = CGAL::Surface_mesh<Point_3>;

inline Connectivity connect(const Mesh& mesh)
{
  return CGAL::Multiplanar::internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
}

inline bool are_same_bits(const Point_3& p, const Point_3& q)
{
  for (int i = 0; i < 3; ++i) {
    const double a = p[i], b = q[i];
    if (std::memcmp(&a, &b, sizeof a) != 0) return false;
  }
  return true;
}

inline Surface surface_mesh(const Connectivity& c, const Points& points)
{
  Surface mesh;
  for (const Point_3& p : points) mesh.add_vertex(p);
  for (const auto& t : c.triangles)
    mesh.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]), Surface::Vertex_index(t[2]));
  return mesh;
}

/// Every point displaced by up to `size` per coordinate.
inline Points displaced(const Points& points, double size, std::uint64_t seed)
{
  Random_numbers random(seed);
  Points targets;
  for (const Point_3& p : points)
    targets.push_back(p + size * Vector_3(random.signed_unit(), random.signed_unit(), random.signed_unit()));
  return targets;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_GUARD_FIXTURES_H
