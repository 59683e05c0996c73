// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H
#define CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H

#include <CGAL/Multiplanar/internal/Flat_state.h>
#include <CGAL/Multiplanar/internal/Joint_room.h>
#include <CGAL/Multiplanar/internal/Panel_surface.h>
#include <CGAL/Multiplanar/internal/first_fit.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The largest distances, by owner: what a sample of the panels measured.
struct Sample_record
{
  double r, area;
  int face;                 ///< of the model, the closest
  std::array<int, 3> owner; ///< panels that the sample lies on; at a corner with more, some of them
};

/// An approximation under work: labels of the faces, the complex that follows from them, where its planes and corners
/// are, and how far the surfaces are apart.
struct Panel_model
{
  std::vector<int> labels;
  std::shared_ptr<const Complex_topology> topology;
  std::vector<int> corner_vertex; ///< the mesh vertex of each corner
  Flat_state state;
  std::shared_ptr<const Panel_surface> surface;
  std::vector<Moments> moments;             ///< of the faces of each panel
  std::vector<std::array<int, 2>> contacts; ///< panels of triangles that meet outside shared corners and edges
  int faults = 0;                           ///< their number, and that of the panels that are not simple

  std::vector<double> r;              ///< distance of every sample of the model
  std::vector<int> near_panel;        ///< and the panel that it is from; -1: to be measured
  std::vector<Sample_record> records; ///< of samples of the panels
  std::vector<double> panel_error;    ///< largest distance by the panel of the model's face, both ways
  std::vector<int> panel_worst;       ///< the face of the model where it is
  int offences = 0;                   ///< edges that are too short, and panels that are too narrow
  Joint_room::Lack lack;              ///< long edges without room for a joint
  double merit = 0;                   ///< p-norm of all distances, p = 32
  double largest = 0;
  double work = 0; ///< spent since it was built, in distances measured

  int panels() const { return topology->number_of_panels(); }
  /// What the search lowers: the p-norm, more of it for edges that nothing would hold together.
  double cost() const { return merit * (1 + 8 * lack.share); }
};

/// Free for local work: the panels in `touched` and all that share a corner with them.
inline std::vector<char> with_ring(const Complex_topology& t, const std::vector<char>& touched)
{
  std::vector<char> result = touched;
  for (const auto& around : t.corner_panels) {
    bool any = false;
    for (int p : around) any = any || touched[p];
    if (any)
      for (int p : around) result[p] = 1;
  }
  return result;
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PANEL_MODEL_H
