// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersections of intersections are rare here: the plain triangulation is the fast one.
#define CGAL_NO_CDT_2_WARNING

#include "erosion.h"

#include "loops.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The structuring element K, counter-clockwise.
struct Octagon
{
  std::array<Vector_2<Kernel>, 8> corners, normals; ///< normals[i] belongs to the side from corner i to corner i + 1
  double inradius, circumradius;

  explicit Octagon(double depth) : inradius(depth * (1 + 1e-4)), circumradius(inradius / std::cos(pi / 8))
  {
    for (int i = 0; i < 8; ++i) {
      // Turned by an odd angle, so that sides of parts are seldom parallel to sides of K.
      const double a = 0.1 + i * pi / 4, m = a + pi / 8;
      corners[i] = Vector_2<Kernel>(circumradius * std::cos(a), circumradius * std::sin(a));
      normals[i] = Vector_2<Kernel>(std::cos(m), std::sin(m));
    }
  }

  /// The corner farthest in direction (x, y).
  int extreme(double x, double y) const
  {
    int best = 0;
    for (int i = 1; i < 8; ++i)
      if (corners[i].x() * x + corners[i].y() * y > corners[best].x() * x + corners[best].y() * y) best = i;
    return best;
  }
};

struct Side
{
  Point_2 a, b;  ///< A lies on the left
  double nx, ny; ///< unit normal into A
  int extreme;   ///< corner of K farthest into A
};

/// The sides of all loops of A, loop by loop.
std::vector<std::vector<Side>> sides_of(const Loop& outline, const std::vector<Loop>& holes, const Octagon& k)
{
  std::vector<std::vector<Side>> result;
  const auto add = [&](const Loop& loop) {
    result.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point_2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::hypot(dx, dy);
      result.back().push_back({a, b, -dy / length, dx / length, k.extreme(-dy, dx)});
    }
  };
  add(oriented(outline, true));
  for (const Loop& hole : holes) add(oriented(hole, false));
  return result;
}

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Face_info = CGAL::Triangulation_face_base_with_info_2<int, Exact>;
using Face_base = CGAL::Constrained_triangulation_face_base_2<Exact, Face_info>;
using Arrangement = CGAL::Constrained_Delaunay_triangulation_2<
    Exact, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Exact>, Face_base>,
    CGAL::Exact_intersections_tag>;

Exact::Point_2 moved(const Point_2& p, const Vector_2<Kernel>& v)
{
  return Exact::Point_2(Exact::FT(p.x()) + v.x(), Exact::FT(p.y()) + v.y());
}

/// The reduced convolution of one loop: all that can bound the eroded region.
void insert_convolution(Arrangement& t, const std::vector<Side>& sides, const Octagon& k)
{
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side &s = sides[i], &next = sides[(i + 1) % sides.size()];
    t.insert_constraint(moved(s.a, k.corners[s.extreme]), moved(s.b, k.corners[s.extreme]));
    if (CGAL::orientation(s.a, s.b, next.b) != CGAL::RIGHT_TURN) continue;
    for (int c = s.extreme; c != next.extreme; c = (c + 7) % 8) // the inward normal turns clockwise
      t.insert_constraint(moved(s.b, k.corners[c]), moved(s.b, k.corners[(c + 7) % 8]));
  }
}

/// Is c in the interior of side + K?
bool is_near(const Point_2& c, const Side& s, const Octagon& k)
{
  const double ax = s.a.x() - c.x(), ay = s.a.y() - c.y(), bx = s.b.x() - c.x(), by = s.b.y() - c.y();
  if ((std::min)(ax, bx) > k.circumradius || (std::max)(ax, bx) < -k.circumradius ||
      (std::min)(ay, by) > k.circumradius || (std::max)(ay, by) < -k.circumradius)
    return false;
  const auto& far = k.corners[s.extreme]; // K is symmetric: as wide on the other side
  if (std::abs(s.nx * ax + s.ny * ay) >= s.nx * far.x() + s.ny * far.y()) return false;
  for (const auto& m : k.normals)
    if ((std::min)(m.x() * ax + m.y() * ay, m.x() * bx + m.y() * by) >= k.inradius) return false;
  return true;
}

/// Is c in A? For points that are not within rounding of the boundary.
bool is_inside(const Point_2& c, const std::vector<std::vector<Side>>& loops)
{
  bool inside = false;
  for (const auto& sides : loops)
    for (const Side& s : sides) {
      if ((s.a.y() <= c.y()) == (s.b.y() <= c.y())) continue;
      const double x = s.a.x() + (c.y() - s.a.y()) / (s.b.y() - s.a.y()) * (s.b.x() - s.a.x());
      if (x > c.x()) inside = !inside;
    }
  return inside;
}

bool belongs(const Point_2& c, const std::vector<std::vector<Side>>& loops, const Octagon& k)
{
  for (const auto& sides : loops)
    for (const Side& s : sides)
      if (is_near(c, s, k)) return false;
  return is_inside(c, loops);
}

Point_2 rounded(const Exact::Point_2& p) { return Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y())); }

/// Numbers the pieces of the accepted faces (info -2) from 0.
void number_pieces(Arrangement& t)
{
  int pieces = 0;
  for (auto start : t.finite_face_handles()) {
    if (start->info() != -2) continue;
    std::vector<Arrangement::Face_handle> stack = {start};
    start->info() = pieces;
    while (!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i)
        if (f->neighbor(i)->info() == -2) {
          f->neighbor(i)->info() = pieces;
          stack.push_back(f->neighbor(i));
        }
    }
    ++pieces;
  }
}

} // namespace

std::vector<Eroded_triangle> erode(const Loop& outline, const std::vector<Loop>& holes, double depth)
{
  const Octagon k(depth);
  const auto loops = sides_of(outline, holes, k);
  Arrangement t;
  for (const auto& sides : loops) insert_convolution(t, sides, k);
  for (auto f : t.all_face_handles()) f->info() = -1;
  for (auto f : t.finite_face_handles()) {
    const Point_2 centroid =
        CGAL::centroid(rounded(f->vertex(0)->point()), rounded(f->vertex(1)->point()), rounded(f->vertex(2)->point()));
    if (belongs(centroid, loops, k)) f->info() = -2;
  }
  number_pieces(t);

  std::vector<Eroded_triangle> result;
  for (auto f : t.finite_face_handles()) {
    if (f->info() < 0) continue;
    Eroded_triangle e{{rounded(f->vertex(0)->point()), rounded(f->vertex(1)->point()), rounded(f->vertex(2)->point())},
                      f->info()};
    if (CGAL::orientation(e.vertices[0], e.vertices[1], e.vertices[2]) == CGAL::LEFT_TURN) result.push_back(e);
  }
  return result;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
