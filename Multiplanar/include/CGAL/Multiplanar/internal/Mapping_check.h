// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MAPPING_CHECK_H
#define CGAL_MULTIPLANAR_INTERNAL_MAPPING_CHECK_H

#include <CGAL/Multiplanar/internal/embedding.h>
#include <CGAL/Multiplanar/internal/flat_ears.h>
#include <CGAL/Multiplanar/internal/panel_targets.h>

#include <cstdint>
#include <cstring>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Whether a mesh can be mapped into flat panels as it is, without any mending: for one set of panels after another
/// that are mostly the same. What was found about a panel is remembered by its faces and the places of its corners.
class Mapping_check
{
public:
  Mapping_check(const Connectivity& c, const Points& shape) : c(c), shape(shape), local(c.number_of_vertices(), -1) {}

  /// \return the panels that the mesh cannot be mapped into, ascending
  std::vector<int> unmapped(const std::vector<int>& labels, const Panel_complex& complex)
  {
    std::vector<std::uint64_t> names;
    for (int p = 0; p < complex.number_of_panels(); ++p) names.push_back(name(complex, p));
    for (const Flat_ear& ear : flat_ears(c, labels, complex)) bad.insert(names[labels[ear.face]]);
    map_unknown(labels, complex, names);
    std::vector<int> result;
    for (int p = 0; p < complex.number_of_panels(); ++p)
      if (bad.count(names[p])) result.push_back(p);
    return result;
  }

  /// \return panels with faces that meet where they are mapped to, though the polygons are apart: by less than
  /// rounding. Nothing is remembered.
  std::vector<int> touching(const std::vector<int>& labels, const Panel_complex& complex) const
  {
    std::vector<int> failed;
    const Points all = panel_targets(c, shape, labels, complex, failed);
    if (!failed.empty()) return failed;
    const auto fault = find_embedding_fault(c, all);
    if (!fault) return {};
    return {labels[fault->first], labels[fault->second]};
  }

private:
  void map_unknown(const std::vector<int>& labels, const Panel_complex& complex,
                   const std::vector<std::uint64_t>& names)
  {
    std::vector<std::vector<int>> edges_of(names.size());
    for (int e = 0; e < int(complex.edges.size()); ++e)
      for (int p : complex.edges[e].panels) edges_of[p].push_back(e);
    targets.resize(shape.size(), CGAL::ORIGIN);
    for (int p = 0; p < int(names.size()); ++p) {
      if (good.count(names[p]) || bad.count(names[p])) continue;
      for (int i : edges_of[p]) {
        const auto& e = complex.edges[i];
        place_chain(e.chain, shape, complex.corners[e.corners[0]].point, complex.corners[e.corners[1]].point, targets);
      }
      (place_panel(c, shape, labels, complex, p, local, targets) ? good : bad).insert(names[p]);
    }
  }

  static std::uint64_t name(const Panel_complex& complex, int p)
  {
    std::uint64_t h = 1469598103934665603u;
    const auto add = [&](std::uint64_t x) { h = (h ^ x) * 1099511628211u, h ^= h >> 29; };
    for (int f : complex.panels[p].faces) add(std::uint64_t(f));
    std::uint64_t corners = 0; // in any order
    for (const auto& loop : complex.panels[p].loops)
      for (int i : complex.loop_corners(loop)) {
        const auto& corner = complex.corners[i];
        std::uint64_t k = std::uint64_t(corner.vertex) * 0x9e3779b97f4a7c15u;
        for (int axis = 0; axis < 3; ++axis) {
          const double x = corner.point[axis];
          std::uint64_t bits;
          std::memcpy(&bits, &x, sizeof bits);
          k = (k ^ bits) * 1099511628211u, k ^= k >> 31;
        }
        corners += k;
      }
    add(corners);
    return h;
  }

  const Connectivity& c;
  const Points& shape;
  std::vector<int> local;
  Points targets;
  std::unordered_set<std::uint64_t> good, bad;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MAPPING_CHECK_H
