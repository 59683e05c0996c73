// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PANEL_PARTITION_OPTIONS_H
#define CGAL_MULTIPLANAR_PANEL_PARTITION_OPTIONS_H

#include <array>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSegmentation
/// What `make_panels()` is to make.
struct Panel_partition_options
{
  int max_panels = 0;    ///< k: at most so many panels
  double min_area = 0;   ///< smaller panels are merged with a neighbour where that is possible (in squared units of the
                         ///< points)
  double min_width = 0;  ///< so are narrower ones; the width of a panel is 4 area / perimeter (of a disc, its diameter)
  int max_teleports = 0; ///< so many panels may move from where they are needed least to where the error is largest
  bool realisable = true; ///< false: only connected panels that do not touch themselves, in a fraction of the time
};

/// \ingroup PkgMultiplanarSegmentation
/// What `make_panels()` did.
struct Panel_partition_report
{
  bool ok = false;          ///< whether the labels keep all promises
  int panels = 0;           ///< labels are 0 .. panels - 1
  int pieces_before = 0;    ///< connected pieces of the labels given
  int merges = 0;           ///< of two pieces or panels
  int splits = 0;           ///< of a panel in two
  int teleports = 0;        ///< mergers paired with a split elsewhere, not counted in `merges` and `splits`
  int relabelled_faces = 0; ///< faces that changed hands in local repairs
  int attempt = 0;          ///< 0 if the labels given could be repaired, else the number of the start that could
  double cost_before = 0;   ///< data cost (eq. 2) of the labels given, planes refitted to them
  double cost_after = 0;    ///< the same of the result
  std::array<int, 8> corner_valences{}; ///< corners of 0, 1, ... panels; the last entry counts 7 and more
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PANEL_PARTITION_OPTIONS_H
