// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Part_mesh.h"

#include <CGAL/Multiplanar/panel_triangulation.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

Outline oriented(Outline loop, bool counter_clockwise)
{
  if ((twice_signed_area(loop) > 0) != counter_clockwise) std::reverse(loop.begin(), loop.end());
  return loop;
}

class Builder
{
public:
  Builder(const Part& part, double thickness, const Point_3& origin)
      : frame(part.frame), thickness(thickness), shift(CGAL::ORIGIN - origin)
  {
    loops.push_back(oriented(part.outline, true));
    for (const Outline& hole : part.holes) loops.push_back(oriented(hole, false));
  }

  Part_mesh build()
  {
    if (internal::is_polygon_with_holes(loops)) add_faces();
    for (const Outline& loop : loops) add_walls(loop);
    return std::move(mesh);
  }

private:
  Point_3 at(const Point_2& p, double depth) const { return frame(p) - depth * frame.normal + shift; }

  static int add_point(Mesh_faces& faces, const Point_3& p, const Vector_3& normal, const Point_2& place)
  {
    faces.points.push_back(p);
    faces.normals.push_back(normal);
    faces.places.push_back(place);
    return int(faces.points.size()) - 1;
  }

  void add_faces()
  {
    std::vector<Point_2> all;
    for (const Outline& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
    for (const Point_2& p : all) {
      add_point(mesh.outer, at(p, 0), frame.normal, p);
      add_point(mesh.rest, at(p, thickness), -frame.normal, p);
    }
    for (const auto& t : internal::triangulate_polygon(loops)) {
      mesh.outer.triangles.push_back({t[0], t[1], t[2]});
      mesh.rest.triangles.push_back({t[0], t[2], t[1]});
    }
  }

  /// \param loop with the part on its left
  void add_walls(const Outline& loop)
  {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point_2 &before = loop[(i + n - 1) % n], &a = loop[i], &b = loop[(i + 1) % n];
      const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::hypot(dx, dy);
      if (!(length > 0)) continue;
      const Vector_3 normal = (dy * frame.u - dx * frame.v) / length;
      const int a0 = add_point(mesh.rest, at(a, 0), normal, a), b0 = add_point(mesh.rest, at(b, 0), normal, b),
                b1 = add_point(mesh.rest, at(b, thickness), normal, b),
                a1 = add_point(mesh.rest, at(a, thickness), normal, a);
      mesh.rest.triangles.push_back({a0, a1, b1});
      mesh.rest.triangles.push_back({a0, b1, b0});
      mesh.lines.push_back({at(a, 0), at(b, 0)});
      mesh.lines.push_back({at(a, thickness), at(b, thickness)});
      const double x = a.x() - before.x(), y = a.y() - before.y();
      if (std::abs(std::atan2(x * dy - y * dx, x * dx + y * dy)) > 0.4)
        mesh.lines.push_back({at(a, 0), at(a, thickness)});
    }
  }

  const Frame& frame;
  double thickness;
  Vector_3 shift;
  std::vector<Outline> loops;
  Part_mesh mesh;
};

} // namespace

Part_mesh part_mesh(const Part& part, double thickness, const Point_3& origin)
{
  return Builder(part, thickness, origin).build();
}
