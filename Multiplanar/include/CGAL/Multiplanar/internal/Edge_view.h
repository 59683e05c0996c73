// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_EDGE_VIEW_H
#define CGAL_MULTIPLANAR_INTERNAL_EDGE_VIEW_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/connector.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

using Vector_2 = Kernel::Vector_2;

/// An edge in the plane of one of its panels: positions along the edge count from its first corner, distances inward
/// from the edge; both in mm.
struct Edge_in_panel
{
  int panel;
  Point_2 start;
  Vector_2 along, inward; ///< unit vectors

  Point_2 operator()(double position, double distance) const { return start + position * along + distance * inward; }
  double position(const Point_2& p) const { return (p - start) * along; }
  double distance(const Point_2& p) const { return (p - start) * inward; }

  /// The rectangle positions x distances, clockwise: a hole.
  Outline rectangle(double from, double to, double near, double far) const
  {
    const Outline ccw{(*this)(from, near), (*this)(to, near), (*this)(to, far), (*this)(from, far)};
    return twice_signed_area(ccw) < 0 ? ccw : Outline(ccw.rbegin(), ccw.rend());
  }
};

struct Edge_view
{
  std::array<Edge_in_panel, 2> sides;
  double length, theta; ///< mm; interior dihedral angle in radians

  bool is_reflex() const { return theta > 3.14159265358979323846; }
};

/// \param frames by panel
inline Edge_view edge_view(const Panel_complex& complex, int e, const std::vector<Frame>& frames)
{
  const auto& edge = complex.edges[e];
  Edge_view view;
  view.length = complex.edge_length(e);
  view.theta = complex.dihedral(e) * 3.14159265358979323846 / 180;
  for (int i = 0; i < 2; ++i) {
    const Frame& frame = frames[edge.panels[i]];
    Edge_in_panel& side = view.sides[i];
    side.panel = edge.panels[i];
    side.start = frame.project(complex.corners[edge.corners[0]].point);
    side.along = frame.project(complex.corners[edge.corners[1]].point) - side.start;
    side.along = side.along / std::sqrt(side.along.squared_length());
    const Vector_2 left(-side.along.y(), side.along.x());
    side.inward = i == 0 ? left : -left;
  }
  return view;
}

/// The frame of a connector at a position along the edge: u and v are x and y of its profile, and its sheet reaches
/// from there along the edge.
inline Frame connector_frame(const Edge_view& view, double position, const Frame& first_panel)
{
  const Edge_in_panel& side = view.sides[0];
  Frame frame;
  frame.origin = first_panel(side(position, 0));
  frame.u = side.inward.x() * first_panel.u + side.inward.y() * first_panel.v;
  frame.v = -first_panel.normal;
  frame.normal = CGAL::cross_product(frame.u, frame.v);
  return frame;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_EDGE_VIEW_H
