// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_MODEL_H
#define CGAL_MULTIPLANAR_MODEL_H

#include <CGAL/Multiplanar/Assembly.h>
#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Multiplanar/Sheet.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What holds the two panels of an edge together.
struct Edge_joint
{
  /// The kinds of joints; `none` means glue.
  enum class Kind
  {
    connector,
    teeth,
    none
  };

  Kind kind = Kind::none;         ///< what it is
  std::vector<std::string> parts; ///< ids of the connectors
  std::string reason;             ///< why there is no joint, if there is none
};

/// The word for it in model.json.
inline const char* to_string(Edge_joint::Kind kind)
{
  switch (kind) {
  case Edge_joint::Kind::connector:
    return "connector";
  case Edge_joint::Kind::teeth:
    return "teeth";
  case Edge_joint::Kind::none:
    return "none";
  }
  return "";
}

/// The measures that parts were made with, in mm.
struct Model_settings
{
  int panels = 50;      ///< k that was asked for
  double size = 300;    ///< longest side of the model
  double thickness = 3; ///< of the material
  double kerf = 0.15;   ///< full width of the cut
  double fit = 0.05;    ///< interference across the thickness of a joint
  double margin = 5; ///< of the sheets
  double gap = 1;    ///< between parts on a sheet
  std::uint64_t seed = 0; ///< of the approximation
};

/// A model ready for the workshop, in mm: its panels, what joins them, the parts to cut and the sheets they lie on.
struct Model
{
  std::string input_file; ///< its name, without folders
  double scale = 1; ///< mm per unit of the input
  Model_settings settings;        ///< what it was made with
  Panel_complex complex;          ///< its panels, in mm
  std::vector<Edge_joint> joints; ///< by edge of the complex
  std::vector<Part> parts;        ///< panels, then connectors
  std::vector<Sheet> sheets;      ///< where the parts lie
  std::vector<Assembly_step> assembly; ///< empty if there is no order
};

/// "P07": the letter and the number counted from 1, with at least `digits` digits, and enough for `count` of them.
inline std::string numbered_id(char letter, int index, int count, int digits)
{
  char buffer[32];
  const int needed = std::snprintf(nullptr, 0, "%d", count);
  std::snprintf(buffer, sizeof buffer, "%c%0*d", letter, digits > needed ? digits : needed, index + 1);
  return buffer;
}

/// "P07": panels are counted from 0, their ids from 1.
inline std::string panel_id(const Panel_complex& complex, int panel)
{
  return numbered_id('P', panel, complex.number_of_panels(), 2);
}

/// "E001": edges are counted from 0, their ids from 1.
inline std::string edge_id(const Panel_complex& complex, int edge)
{
  return numbered_id('E', edge, complex.number_of_edges(), 3);
}

/// The number of the panel that part "P07" or "P07b" is cut from; -1 for a connector.
inline int panel_number(const Part& part)
{
  return part.kind == Part::Kind::panel && part.id.size() > 1 ? std::atoi(part.id.c_str() + 1) - 1 : -1;
}

/// The file of a sheet (counted from 0), relative to the folder of the model.
inline std::string sheet_file(int sheet, const char* extension)
{
  return "sheets/sheet-" + std::to_string(sheet + 1) + "." + extension;
}

/// The length of the edges that have a joint, as a part of the length of all, in 0..1; 0 if there are no joints.
inline double joined_share(const Model& model)
{
  double joined = 0, total = 0;
  for (int e = 0; e < int(model.joints.size()); ++e) {
    const auto& edge = model.complex.edges[e];
    if (edge.is_closed()) continue;
    const Point_3 &a = model.complex.corners[edge.corners[0]].point, &b = model.complex.corners[edge.corners[1]].point;
    const double length = std::sqrt(CGAL::squared_distance(a, b));
    total += length;
    if (model.joints[e].kind != Edge_joint::Kind::none) joined += length;
  }
  return total > 0 ? joined / total : 0;
}

/// The complex with all lengths multiplied by `scale`; nothing is moved or turned. \pre `scale` > 0
inline Panel_complex scaled(Panel_complex complex, double scale)
{
  CGAL_precondition(scale > 0);
  for (auto& corner : complex.corners)
    corner.point = Point_3(corner.point.x() * scale, corner.point.y() * scale, corner.point.z() * scale);
  for (auto& panel : complex.panels) panel.plane.offset *= scale;
  return complex;
}

/// The longest side of the bounding box of the corners: of the finished model. 0 if there are no corners.
inline double longest_side(const Panel_complex& complex)
{
  double longest = 0;
  for (int axis = 0; axis < 3 && !complex.corners.empty(); ++axis) {
    double low = complex.corners[0].point[axis], high = low;
    for (const auto& corner : complex.corners) {
      low = (std::min)(low, corner.point[axis]);
      high = (std::max)(high, corner.point[axis]);
    }
    longest = (std::max)(longest, high - low);
  }
  return longest;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_MODEL_H
