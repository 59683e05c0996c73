// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_JOINT_OPTIONS_H
#define CGAL_MULTIPLANAR_JOINT_OPTIONS_H

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/Truncation_options.h>
#include <CGAL/Multiplanar/connector.h>
#include <CGAL/Multiplanar/internal/Alternation.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What may join the panels of an edge.
enum class Joint_mode
{
  automatic,  ///< a connector, else teeth
  connectors, ///< a connector or nothing
  teeth,      ///< teeth or nothing
  none
};

/// \ingroup PkgMultiplanarParts
/// Which joints are made, and how large. Lengths are in mm.
struct Joint_options : Truncation_options
{
  Joint_mode mode = Joint_mode::automatic; ///< for every edge
  std::vector<Joint_mode> mode_of_edge; ///< overrides `mode` edge by edge unless empty
  /// Sizes of connectors, tried in this order; those with tabs narrower than the sheet is thick are a last resort,
  /// where teeth are impossible.
  std::vector<Connector_size> sizes = {{2.5, 2}, {1.5, 1.5}, {1, 1}, {0.7, 0.8}};
  double spacing = 15;     ///< an edge has one connector for this many thicknesses of its length, and at least one
  int most_connectors = 4; ///< of one edge
  double clearance = 0.1;  ///< free space around a connector's body, in mm
  double shallowest_tooth = 0.8; ///< teeth less deep than this, in mm, do not count

  /// What is asked for at an edge.
  Joint_mode mode_at(int edge) const { return mode_of_edge.empty() ? mode : mode_of_edge[edge]; }
};

/// A connector in its place.
struct Placed_connector
{
  int edge;        ///< of the complex
  double position; ///< along the edge, from its first corner to the near face of the connector, in mm
  Frame frame;     ///< of the profile
  Connector_profile profile;    ///< its shape
  std::array<int, 2> pieces;    ///< which piece of either panel of the edge it goes through
  std::array<Outline, 2> slots; ///< in the frames of these panels; clockwise rectangles
};

/// \ingroup PkgMultiplanarParts
/// What `join_panels()` makes of the panels and edges of a complex.
struct Joints
{
  Truncation truncation;                    ///< with teeth
  std::vector<Placed_connector> connectors; ///< ordered by edge, then by position
  std::vector<internal::Alternation> teeth; ///< ordered by edge
  std::vector<Edge_joint> joints;           ///< by edge
};

/// "C013".
inline std::string connector_id(int connector, std::size_t connectors)
{
  return numbered_id('C', connector, int(connectors), 3);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_JOINT_OPTIONS_H
