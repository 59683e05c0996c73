// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_SPACE_H
#define CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_SPACE_H

#include <CGAL/Multiplanar/Joint_options.h>
#include <CGAL/Multiplanar/internal/Block.h>
#include <CGAL/Multiplanar/internal/convex_pieces.h>
#include <CGAL/Multiplanar/parts_from_panels.h>

#include <CGAL/convex_hull_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The sheets of truncated panels, by panel.
inline std::vector<Block> sheet_blocks(const Truncation& truncation, double thickness)
{
  std::vector<Block> sheets;
  for (const Truncated_panel& panel : truncation.panels) {
    std::vector<Outline> pieces;
    for (const Flat_polygon& polygon : panel.pieces)
      for (Outline& piece : convex_pieces(polygon.outline, polygon.holes)) pieces.push_back(std::move(piece));
    sheets.emplace_back(panel.frame, std::move(pieces), 0, thickness);
  }
  return sheets;
}

/// What a connector must not run into: the panels' sheets, the surface of the model, and other connectors. Its tabs lie
/// in slots, its own panels lie beyond the faces that its body rests on; so only the body and other panels matter.
class Connector_space
{
public:
  Connector_space(const Panel_complex& complex, const Truncation& truncation, const Joint_options& options)
      : complex(complex), options(options), sheets(sheet_blocks(truncation, options.thickness))
  {
    for (int p = 0; p < complex.number_of_panels(); ++p) {
      const Part whole = part_from_panel(complex, p);
      skins.emplace_back(whole.frame, convex_pieces(whole.outline, whole.holes), -skin, skin);
    }
  }

  Block body_of(const Frame& frame, const Connector_profile& profile) const
  {
    return Block(frame, profile.body, 0, options.thickness);
  }

  /// Is there room for the body of a connector of edge `e`? Decided in doubles with clearance, confirmed exactly.
  bool has_room(int e, const Block& body) const { return collisions(body).empty() && is_clear_of_panels(e, body); }

  /// The bodies that leave none, by order of adding.
  std::vector<std::size_t> collisions(const Block& body) const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (!surely_apart(body, bodies[i], options.clearance) || !exactly_apart(body, bodies[i])) result.push_back(i);
    return result;
  }

  /// Is there room as far as panels are concerned?
  bool is_clear_of_panels(int e, const Block& body) const
  {
    for (int p = 0; p < int(sheets.size()); ++p)
      if (!is_beside(e, p) && !(surely_apart(body, sheets[p], options.clearance) && surely_apart(body, skins[p], 0)))
        return false;
    for (int p = 0; p < int(sheets.size()); ++p)
      if (!is_beside(e, p) && !exactly_apart(body, sheets[p])) return false;
    return true;
  }

  /// Mounted on panel `side` of edge `e` (0 or 1), the connector comes with that panel along its normal. Does it get
  /// past everything but the two panels over the last `approach_length()` mm?
  bool can_come_with(int e, const Frame& frame, const Connector_profile& profile, double theta, int side) const
  {
    const double l = options.approach_length();
    const Kernel::Vector_2 outward =
        side == 0 ? Kernel::Vector_2(0, -l) : Kernel::Vector_2(-l * std::sin(theta), l * std::cos(theta));
    std::vector<Outline> moving = profile.body;
    const auto& tab = profile.tabs[1 - side];
    moving.emplace_back(profile.outline.begin() + tab[0], profile.outline.begin() + tab[1] + 1);
    for (Outline& piece : moving) {
      const std::size_t n = piece.size();
      for (std::size_t i = 0; i < n; ++i) piece.push_back(piece[i] + outward);
      Outline hull;
      CGAL::convex_hull_2(piece.begin(), piece.end(), std::back_inserter(hull));
      piece = std::move(hull);
    }
    const Block swept(frame, moving, 0, options.thickness);
    for (const Block& other : bodies)
      if (!surely_apart(swept, other, 0)) return false;
    for (int p = 0; p < int(sheets.size()); ++p)
      if (!is_beside(e, p) && !surely_apart(swept, sheets[p], 0)) return false;
    return true;
  }

  void add(Block body) { bodies.push_back(std::move(body)); }
  const Block& sheet(int p) const { return sheets[p]; }

  /// Takes out the body that was added as number `i`; those after it move up.
  void remove(std::size_t i) { bodies.erase(bodies.begin() + std::ptrdiff_t(i)); }
  /// All that were added, to go back to them.
  const std::vector<Block>& placed_bodies() const { return bodies; }
  void restore_bodies(std::vector<Block> all) { bodies = std::move(all); }

private:
  static constexpr double skin = 1e-3; ///< half the thickness given to the surface of the model, in mm

  bool is_beside(int e, int p) const { return complex.edges[e].panels[0] == p || complex.edges[e].panels[1] == p; }

  const Panel_complex& complex;
  const Joint_options& options;
  std::vector<Block> sheets, skins; ///< by panel
  std::vector<Block> bodies;        ///< of the connectors placed
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_CONNECTOR_SPACE_H
