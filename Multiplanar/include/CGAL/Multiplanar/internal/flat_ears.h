// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_FLAT_EARS_H
#define CGAL_MULTIPLANAR_INTERNAL_FLAT_EARS_H

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/internal/transfer_geometry.h>

#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// An ear is a face with two sides on the boundary of its panel. Where these meet, the panel has its angle. So no map
// makes an ear positive whose sides meet at a corner of 180 degrees or more, or on a straight side of the polygon.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// A face that is an ear with an angle of 180 degrees or more at its vertex at `position`.
struct Flat_ear
{
  int face, position;
};

/// The corners of the panels with less than 180 degrees, as pairs of mesh vertex and panel.
inline std::set<std::pair<int, int>> convex_corners(const Panel_complex& complex)
{
  std::set<std::pair<int, int>> result;
  for (int p = 0; p < complex.number_of_panels(); ++p)
    for (const auto& loop : complex.panels[p].loops) {
      const std::vector<int> corners = complex.loop_corners(loop);
      const int n = int(corners.size());
      for (int i = 0; i < n; ++i) {
        const Point_3 &a = complex.corners[corners[(i + n - 1) % n]].point, &b = complex.corners[corners[i]].point,
                      &d = complex.corners[corners[(i + 1) % n]].point;
        if (CGAL::cross_product(b - a, d - b) * complex.panels[p].plane.normal > 0)
          result.insert({complex.corners[corners[i]].vertex, p});
      }
    }
  return result;
}

inline std::vector<Flat_ear> flat_ears(const Connectivity& c, const std::vector<int>& labels,
                                       const Panel_complex& complex)
{
  const auto convex = convex_corners(complex);
  std::vector<Flat_ear> ears;
  for (int f = 0; f < c.number_of_faces(); ++f)
    for (int i = 0; i < 3; ++i)
      if (labels[c.neighbours[f][i]] != labels[f] && labels[c.neighbours[f][(i + 2) % 3]] != labels[f] &&
          !convex.count({c.triangles[f][i], labels[f]}))
        ears.push_back({f, i});
  return ears;
}

/// Gives an ear a neighbour for company, or to a neighbour, such that there are fewer flat ears and the complex stays the
/// same. \return false, with nothing changed, if that is not possible
inline bool mend_ear(const Connectivity& c, const Points& shape, const Flat_ear& ear, std::size_t ears,
                     std::vector<int>& labels, Panel_complex& complex)
{
  const int sides[2] = {c.neighbours[ear.face][ear.position], c.neighbours[ear.face][(ear.position + 2) % 3]};
  const std::pair<int, int> changes[4] = {{sides[0], labels[ear.face]},
                                          {sides[1], labels[ear.face]},
                                          {ear.face, labels[sides[0]]},
                                          {ear.face, labels[sides[1]]}}; // a face and the panel that it is given to
  for (const auto& change : changes) {
    std::vector<int> changed = labels;
    changed[change.first] = change.second;
    Panel_complex next;
    try {
      next = make_panel_complex(c, shape, changed, complex.number_of_panels());
    } catch (const std::invalid_argument&) {
      continue;
    }
    if (!transfer_geometry(complex, next) || flat_ears(c, changed, next).size() >= ears) continue;
    labels = std::move(changed);
    complex = std::move(next);
    return true;
  }
  return false;
}

/// Changes the labels of single faces so that there are as few flat ears as possible. O(F) for each.
/// \return how many were mended
inline int mend_flat_ears(const Connectivity& c, const Points& shape, std::vector<int>& labels, Panel_complex& complex)
{
  int mended = 0;
  std::set<int> hopeless;
  for (bool again = true; again;) {
    again = false;
    const std::vector<Flat_ear> ears = flat_ears(c, labels, complex);
    for (const Flat_ear& ear : ears) {
      if (hopeless.count(ear.face)) continue;
      again = mend_ear(c, shape, ear, ears.size(), labels, complex);
      if (again) break;
      hopeless.insert(ear.face);
    }
    mended += again;
  }
  return mended;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_FLAT_EARS_H
