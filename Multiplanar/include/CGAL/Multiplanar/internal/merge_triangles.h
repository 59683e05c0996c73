// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MERGE_TRIANGLES_H
#define CGAL_MULTIPLANAR_INTERNAL_MERGE_TRIANGLES_H

#include <CGAL/Multiplanar/internal/last_mergers.h>
#include <CGAL/Multiplanar/internal/merge_rounds.h>

#include <algorithm>

// Where no partition leads to flat panels, the mesh itself does: a panel for each triangle needs nothing to be made
// flat. From there neighbours are merged, cheapest first, each merger only if the polygons stay simple and apart, and
// the caller accepts them. It starts from many panels, so it takes long, and always has a model that holds.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Faces of a mesh whose triangles are merged.
constexpr int most_merged_triangles = 20000;

/// Pairs are merged down to so many panels, or to as many as are wanted. That does not depend on fewer that are wanted,
/// so that who asks for as many as were found for fewer gets them.
constexpr int merged_in_pairs = 120;

/// For each panel wanted, what is left to merge one by one at most.
constexpr int too_many = 40;

/// Merges the triangles of a mesh to at most `panels` panels.
/// \param unusable asked of every step: all panels of the models that are taken are of use
/// \param m receives the smallest model found, if any
/// \return whether there is one of at most `panels`
inline bool merge_triangles(const Panel_modeller& modeller, const Accuracy_options& accuracy, int panels,
                            const Unusable_panels& unusable, Panel_model& m, const Panels_left& go_on = {})
{
  if (!modeller.of_triangles(m) || m.faults > 0) return false;
  Merge_rounds(modeller, unusable).run((std::max)(merged_in_pairs, panels), m, go_on);
  if (m.panels() <= panels) return true;
  if (m.panels() > too_many * panels) return false; // one by one from there would take too long
  Last_mergers last(modeller, accuracy,
                    [&](Panel_model& changed) { return unusable(changed).empty() && changed.faults == 0; });
  return last.run(panels, m, go_on);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MERGE_TRIANGLES_H
