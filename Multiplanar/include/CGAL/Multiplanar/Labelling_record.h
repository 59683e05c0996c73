// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_LABELLING_RECORD_H
#define CGAL_MULTIPLANAR_LABELLING_RECORD_H

#include <cstddef>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSegmentation
/// What one labelling of an approximation did to the energy of eq. 1, step by step, at the positions that the vertices
/// had by then. Only the step to `expanded` promises anything: it never raises the energy. Estimating planes may (a
/// mean normal does not minimise a sum of absolute values), and so may merging and splitting labels into panels.
struct Labelling_record
{
  int restart = 0;     ///< of which start
  int pass = 0;        ///< 0: the labels made from the seeds; i: those at the beginning of the i-th pass
  bool frozen = false; ///< no expansion, only the changes that make panels that can be flat; these labels stay

  double before = 0;   ///< the labels and planes of the labelling before (of the seeds, in the first)
  double planes = 0;   ///< the same labels, their planes estimated anew
  double expanded = 0; ///< after alpha-expansion at these planes
  double panels = 0;   ///< after merging and splitting into panels, with the planes of the panels

  int sweeps = 0;             ///< of the alpha-expansion over all labels
  std::size_t expansions = 0; ///< that lowered the energy
  int merges = 0 /**< of pieces */, splits = 0 /**< of panels */;
  int number_of_panels = 0;   ///< in the end
  int changed_faces = 0;      ///< faces whose label is another one than before
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_LABELLING_RECORD_H
