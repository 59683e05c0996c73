// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_ENGRAVE_PARTS_H
#define CGAL_MULTIPLANAR_ENGRAVE_PARTS_H

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/internal/Text_fitter.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarSheets
/// Sizes of the letters that `engrave_parts()` engraves, in mm.
struct Engraving_options
{
  double smallest = 1.3;           ///< height of the smallest legible capital letters, in mm
  double largest = 7;              ///< of a panel's own id
  double largest_of_edges = 2.6;   ///< of what stands along edges, at slots and on connectors
  double clearance = 0.5;          ///< between a text and any cut or other text
  Vector_3 up = Vector_3(0, 1, 0); ///< the direction of the model that up marks point to
};

namespace internal {

/// Engraves the parts of one model.
class Part_engraver
{
public:
  Part_engraver(Model& model, const Engraving_options& options)
      : model(model), o(options), upright(model.parts.size(), 0), edge_of_part(model.parts.size(), -1)
  {
    for (const Sheet& sheet : model.sheets)
      for (const Placement& p : sheet.placements) upright[p.part] = p.mirrored ? p.rotation : -p.rotation;
    std::map<std::string, int> edge_of_connector;
    for (int e = 0; e < int(model.joints.size()); ++e)
      for (const std::string& id : model.joints[e].parts) edge_of_connector[id] = e;
    for (std::size_t i = 0; i < model.parts.size(); ++i)
      if (const auto found = edge_of_connector.find(model.parts[i].id); found != edge_of_connector.end())
        edge_of_part[i] = found->second;
  }

  void run()
  {
    for (int i = 0; i < int(model.parts.size()); ++i) {
      Part& part = model.parts[i];
      Text_fitter fitter(part, o.clearance);
      if (part.kind == Part::Kind::panel) engrave_panel(i, fitter);
      else if (edge_of_part[i] >= 0) engrave_connector(i, fitter);
      part.engraving.insert(part.engraving.end(), fitter.texts().begin(), fitter.texts().end());
    }
  }

private:
  void miss(int part, const std::string& text) { model.parts[part].not_engraved.push_back(text); }

  // ----- panels -----

  void engrave_panel(int i, Text_fitter& fitter)
  {
    const Part& part = model.parts[i];
    const double height = (std::min)(o.largest, (std::max)(2., 0.1 * std::sqrt(part.area())));
    place_own_id(i, fitter, height);
    place_up_mark(i, fitter, height);
    for (const auto& loop : model.complex.panels[panel_number(model.parts[i])].loops)
      for (const auto& side : loop) engrave_side(i, side, fitter);
    for (int connector = 0; connector < int(model.parts.size()); ++connector)
      if (edge_of_part[connector] >= 0) engrave_slot(i, connector, fitter);
  }

  void place_own_id(int i, Text_fitter& fitter, double largest)
  {
    if (!place_id(model.parts[i], fitter, largest, upright[i])) miss(i, model.parts[i].id);
  }

  /// Where a part has most room, smaller where the clearance asks for it. \return whether it fits
  bool place_id(const Part& part, Text_fitter& fitter, double largest, double upright_angle) const
  {
    Engraving id = place_label(part.id, part.outline, part.holes, largest, upright_angle);
    while (id.height >= o.smallest && !fitter.is_clear(id)) id.height *= 0.95;
    if (id.height < o.smallest) return false;
    fitter.add(id);
    return true;
  }

  /// An arrow; a word on a panel that lies flat.
  void place_up_mark(int i, Text_fitter& fitter, double largest)
  {
    const Frame& frame = model.parts[i].frame;
    const double x = o.up * frame.u, y = o.up * frame.v, z = o.up * frame.normal;
    const bool flat = std::hypot(x, y) < 0.1 * std::abs(z);
    const std::string text = !flat ? "\xe2\x86\x91" : z > 0 ? "TOP" : "BOTTOM";
    // Letters stand at right angles to their base line, to the left of it.
    const double angle = flat ? upright[i] : std::atan2(-x, y) * 180 / 3.14159265358979323846;
    const Point_2 near = fitter.texts().empty() ? model.parts[i].outline[0] : fitter.texts()[0].at;
    if (place_turned(fitter, text, near, angle, largest)) return;
    miss(i, "up mark");
  }

  /// As near as possible to a point, at one angle.
  bool place_turned(Text_fitter& fitter, const std::string& text, const Point_2& near, double angle, double largest)
  {
    for (double h : text_heights(largest, o.smallest)) {
      const double step = (std::max)(0.8, h / 4);
      Engraving best;
      double nearest = 1e300;
      for (int k = -12; k <= 12; ++k)
        for (int l = -12; l <= 12; ++l) {
          const double d = step * step * (k * k + l * l);
          if (d >= nearest) continue;
          const Engraving label{text, Point_2(near.x() + step * k, near.y() + step * l), angle, h};
          if (fitter.is_clear(label)) best = label, nearest = d;
        }
      if (best.height == 0) continue;
      fitter.add(best);
      return true;
    }
    return false;
  }

  /// At an edge: the neighbour, the angle inside the solid, and the joint.
  void engrave_side(int i, const Panel_complex::Side& side, Text_fitter& fitter)
  {
    const Panel_complex& complex = model.complex;
    if (complex.edges[side.edge].is_closed()) return;
    const Frame& frame = model.parts[i].frame;
    const Point_2 a = frame.project(complex.corners[complex.source(side)].point),
                  b = frame.project(complex.corners[complex.target(side)].point);
    if (!is_near_outline(model.parts[i], CGAL::midpoint(a, b))) return; // the edge of another piece of the panel
    const std::string neighbour = panel_id(complex, complex.neighbour(side));
    const std::string angle = std::to_string(int(std::lround(complex.dihedral(side.edge)))) + "\xc2\xb0";
    const std::string full = neighbour + " " + angle + " " + edge_id(complex, side.edge);
    const bool is_there =
        place_along_side(fitter, {full, neighbour + " " + angle, neighbour}, a, b, o.largest_of_edges, o.smallest);
    if (!is_there || fitter.texts().back().text != full) miss(i, full);
  }

  bool is_near_outline(const Part& part, const Point_2& p) const
  {
    const double reach = 4 * model.settings.thickness;
    for (std::size_t i = 0; i < part.outline.size(); ++i)
      if (CGAL::squared_distance(p, Kernel::Segment_2(part.outline[i], part.outline[(i + 1) % part.outline.size()])) <
          reach * reach)
        return true;
    return false;
  }

  /// Which connector goes into a slot, if it is one of this part.
  void engrave_slot(int i, int connector, Text_fitter& fitter)
  {
    const auto& panels = model.complex.edges[edge_of_part[connector]].panels;
    const int panel = panel_number(model.parts[i]);
    if (panels[0] != panel && panels[1] != panel) return;
    const Part& c = model.parts[connector];
    for (const auto& tab : c.tabs) {
      const Point_3 end = tab_end(c, tab);
      const Frame& frame = model.parts[i].frame;
      if (std::abs((end - frame.origin) * frame.normal) > 1e-3 * model.settings.thickness) continue;
      const Point_2 at = frame.project(end);
      if (!is_in_hole(model.parts[i], at)) continue;
      if (!place_near(fitter, c.id, at, 9, upright[i], o.largest_of_edges * 0.8, o.smallest))
        miss(i, "slot of " + c.id);
    }
  }

  static bool is_in_hole(const Part& part, const Point_2& p)
  {
    for (const Outline& hole : part.holes)
      if (CGAL::bounded_side_2(hole.begin(), hole.end(), p, Kernel()) == CGAL::ON_BOUNDED_SIDE) return true;
    return false;
  }

  // ----- connectors -----

  /// In the model: the middle of the side of a tab that lies in the outer face of its panel.
  Point_3 tab_end(const Part& part, const std::array<int, 2>& tab) const
  {
    const int n = int(part.outline.size());
    return part.frame(CGAL::midpoint(part.outline[(tab[0] + 1) % n], part.outline[(tab[1] + n - 1) % n])) -
           model.settings.thickness / 2 * part.frame.normal;
  }

  /// Its own id, and near each tab the panel that the tab goes into. The id is as high as leaves room for the panels.
  void engrave_connector(int i, Text_fitter& fitter)
  {
    const Part& part = model.parts[i];
    const Text_fitter empty = fitter;
    for (double h : text_heights(o.largest_of_edges, o.smallest)) {
      Text_fitter trial = empty;
      if (!place_id(part, trial, h, upright[i])) break;
      const auto left_out = place_panels(i, trial);
      if (!left_out.empty() && h > o.smallest) continue;
      fitter = trial;
      for (const std::string& text : left_out) miss(i, text);
      return;
    }
    miss(i, part.id);
    for (int p : model.complex.edges[edge_of_part[i]].panels) miss(i, panel_id(model.complex, p));
  }

  /// \return what does not fit
  std::vector<std::string> place_panels(int i, Text_fitter& fitter) const
  {
    const Part& part = model.parts[i];
    std::vector<std::string> left_out;
    for (int p : model.complex.edges[edge_of_part[i]].panels) {
      const std::string text = panel_id(model.complex, p);
      bool done = false;
      for (const auto& tab : part.tabs) {
        const Plane& plane = model.complex.panels[p].plane;
        if (std::abs(signed_distance(plane, tab_end(part, tab))) > 1e-3 * model.settings.thickness) continue;
        done = done || place_near(fitter, text, part.frame.project(tab_end(part, tab)), 3 * model.settings.thickness,
                                  upright[i], o.largest_of_edges, o.smallest);
      }
      if (!done) left_out.push_back(text);
    }
    return left_out;
  }

  Model& model;
  const Engraving_options o;
  std::vector<double> upright;   ///< by part: the angle at which text stands upright on its sheet
  std::vector<int> edge_of_part; ///< by part: the edge of a connector
};

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

Engraves what a person needs to put the parts together.

On a panel: its id, an arrow toward `up` (or TOP, BOTTOM on a level panel), along every edge the neighbour's id, the
dihedral angle and the edge's id, at every slot the connector's id. On a connector: its id, and at each tab the panel
that it goes into. Every text keeps `clearance` from all cuts and from other texts; where there is no room, letters get
smaller down to `smallest`, then text shorter. What does not fit, or only in part, is added to `Part::not_engraved`.

\param model with parts on sheets; texts are added to its parts
\param options sizes of the letters, and which way is up
*/
inline void engrave_parts(Model& model, const Engraving_options& options = Engraving_options())
{
  internal::Part_engraver(model, options).run();
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_ENGRAVE_PARTS_H
