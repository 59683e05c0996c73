// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_JOINT_ROOM_H
#define CGAL_MULTIPLANAR_INTERNAL_JOINT_ROOM_H

#include <CGAL/Multiplanar/internal/Flat_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Which edges of untruncated panels will have room for a joint, guessed from the two panels of each edge alone, in a
// millionth of the time that truncating and joining takes: for a search that prefers panels that hold together.
//
// Notation: theta interior dihedral angle, t thickness. Truncation takes a strip of width s(theta) off a panel along an
// edge (section 3.2.2 of the paper): t cot(theta/2) if theta < 90 degrees, t sin(theta) of one of the panels if convex,
// nothing if reflex, and what the panel that comes later needs to get past the other one above 270 degrees.

namespace CGAL {
namespace Multiplanar {
namespace internal {

class Joint_room
{
public:
  /// \param thickness of the sheets, in the units of the corners; 0: nothing is asked of the edges
  explicit Joint_room(double thickness) : t(thickness) {}

  struct Lack
  {
    double share = 0;       ///< of the length of the long edges, in 0..1
    std::vector<int> edges; ///< long ones without room, the longest first
  };

  /// The edges longer than five thicknesses that have room neither for a connector nor for teeth.
  Lack lack(const Complex_topology& topology, const Flat_state& s) const
  {
    Lack result;
    if (!(t > 0)) return result;
    double total = 0, lacking = 0;
    std::vector<std::pair<double, int>> found;
    for (int e = 0; e < int(topology.edges.size()); ++e) {
      const auto& edge = topology.edges[e];
      const double length = (s.corner[edge.corners[1]] - s.corner[edge.corners[0]]).norm();
      if (!(length > 5 * t)) continue;
      total += length;
      if (has_room(topology, s, e, length)) continue;
      lacking += length;
      found.emplace_back(-length, e);
    }
    std::sort(found.begin(), found.end());
    for (const auto& f : found) result.edges.push_back(f.second);
    if (total > 0) result.share = lacking / total;
    return result;
  }

private:
  static constexpr double pi = 3.14159265358979323846;

  struct Side
  {
    double ax, ay, bx, by;
    double strip; ///< what truncation takes off along it, on average over who gives way
    bool is_edge; ///< the edge itself
  };

  /// A panel seen from one of its edges: x along the edge, y into the panel.
  struct View
  {
    std::vector<Side> sides;

    /// Is a point in the polygon and at least `margin` from all strips along other edges?
    bool is_free(double x, double y, double margin) const
    {
      bool inside = false;
      for (const Side& s : sides)
        if ((s.ay > y) != (s.by > y) && x < (s.bx - s.ax) * (y - s.ay) / (s.by - s.ay) + s.ax) inside = !inside;
      if (!inside) return false;
      for (const Side& s : sides)
        if (!s.is_edge && squared_distance(s, x, y) < (s.strip + margin) * (s.strip + margin)) return false;
      return true;
    }

    static double squared_distance(const Side& s, double x, double y)
    {
      const double ux = s.bx - s.ax, uy = s.by - s.ay, l = ux * ux + uy * uy;
      double at = l > 0 ? ((x - s.ax) * ux + (y - s.ay) * uy) / l : 0;
      at = (std::max)(0., (std::min)(1., at));
      const double dx = x - s.ax - at * ux, dy = y - s.ay - at * uy;
      return dx * dx + dy * dy;
    }
  };

  double strip(double theta) const
  {
    if (theta < pi / 2) return t / std::tan(theta / 2);
    if (theta < pi) return t * std::sin(theta);
    if (theta <= 1.5 * pi) return 0;
    return 4. / 3 * t * std::tan((std::min)(theta - 1.5 * pi, 1.4)); // the last t + 1 mm of the way, at 3 mm
  }
  /// Along an edge where it is not known which panel gives way.
  double likely_strip(double theta) const { return (theta < pi / 2 ? 0.7 : 0.5) * strip(theta); }

  /// Interior dihedral angle at the side of panel `p` that runs in direction `d`, the neighbour being `q`.
  static double dihedral(const Flat_state& s, int p, int q, const Vec3& d)
  {
    return pi - std::atan2(s.normal[p].cross(s.normal[q]).dot(d), s.normal[p].dot(s.normal[q]));
  }

  static int neighbour(const Complex_topology& topology, int p, int a, int b)
  {
    for (int q : topology.corner_panels[a])
      if (q != p)
        for (const auto& loop : topology.loops[q])
          for (std::size_t i = 0; i < loop.size(); ++i)
            if (loop[i] == b && loop[(i + 1) % loop.size()] == a) return q;
    return -1;
  }

  /// \param theta receives the dihedral angle of the edge
  View view(const Complex_topology& topology, const Flat_state& s, int e, int p, double& theta) const
  {
    const auto& edge = topology.edges[e];
    const Vec3 &origin = s.corner[edge.corners[0]], end = s.corner[edge.corners[1]];
    const Vec3 u = (end - origin).normalized();
    Vec3 v = s.normal[p].cross(u);
    View result;
    for (const auto& loop : topology.loops[p])
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int ca = loop[i], cb = loop[(i + 1) % loop.size()];
        const Vec3 a = s.corner[ca] - origin, b = s.corner[cb] - origin;
        const int q = neighbour(topology, p, ca, cb);
        const double angle = q < 0 ? pi : dihedral(s, p, q, (b - a).normalized());
        const bool forth = ca == edge.corners[0] && cb == edge.corners[1];
        const bool back = ca == edge.corners[1] && cb == edge.corners[0];
        if (back) v = -v;
        if (forth || back) theta = angle;
        result.sides.push_back({u.dot(a), 0, u.dot(b), 0, likely_strip(angle), forth || back});
      }
    std::size_t k = 0;
    for (const auto& loop : topology.loops[p])
      for (std::size_t i = 0; i < loop.size(); ++i, ++k) {
        result.sides[k].ay = v.dot(s.corner[loop[i]] - origin);
        result.sides[k].by = v.dot(s.corner[loop[(i + 1) % loop.size()]] - origin);
      }
    return result;
  }

  bool has_room(const Complex_topology& topology, const Flat_state& s, int e, double length) const
  {
    double theta = pi;
    const std::array<View, 2> views{view(topology, s, e, topology.edges[e].panels[0], theta),
                                    view(topology, s, e, topology.edges[e].panels[1], theta)};
    return has_room_for_connector(views, theta, length) || has_room_for_teeth(views, theta, length);
  }

  bool teeth_hold(double theta) const { return theta < pi / 2 || (theta < pi && std::sin(theta) > 0.27); }

  bool has_room_for_connector(const std::array<View, 2>& views, double theta, double length) const
  {
    const double first = strip(theta) + 1.5 * t, last = first + (teeth_hold(theta) ? 1 : 0.7) * t;
    if (theta < pi / 18 || (theta > 1.5 * pi && strip(theta) > t / 2)) return false; // see `connector_obstacle()`
    const int places = (std::max)(6, (std::min)(16, int(length / t)));
    for (int i = 0; i < places; ++i) {
      const double x = (length - t) * i / (places - 1);
      bool free = true;
      for (const View& v : views)
        for (double along : {x, x + t})
          for (double deep : {first, last}) free = free && v.is_free(along, deep, 1.5 * t);
      if (free) return true;
    }
    return false;
  }

  /// A stretch of 3.5 thicknesses where both panels reach their edge.
  bool has_room_for_teeth(const std::array<View, 2>& views, double theta, double length) const
  {
    if (!teeth_hold(theta)) return false;
    const int places = (std::max)(6, (std::min)(24, int(length / t)));
    double run = 0;
    for (int i = 0; i < places; ++i) {
      const double x = length * (i + 0.5) / places, y = strip(theta) + 0.3 * t;
      run = views[0].is_free(x, y, 0.3 * t) && views[1].is_free(x, y, 0.3 * t) ? run + length / places : 0;
      if (run >= 3.5 * t) return true;
    }
    return false;
  }

  double t;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_JOINT_ROOM_H
