// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_PARTS_CSV_H
#define CGAL_MULTIPLANAR_IO_WRITE_PARTS_CSV_H

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/internal/turned_boxes.h>
#include <CGAL/Multiplanar/io/number_format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

inline double path_length(const std::vector<Point_2>& path, bool closed)
{
  double sum = 0;
  for (std::size_t i = closed ? 0 : 1; i < path.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(path[i], path[i == 0 ? path.size() - 1 : i - 1]));
  return sum;
}

/// A field of a CSV file: in quotes if need be.
inline std::string csv_field(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// What a part is joined to, edge by edge: "P02 126° E001 (C001 C002)"; for a connector its two panels and the edge.
inline std::map<std::string, std::string> neighbours_of_parts(const Model& model)
{
  std::map<std::string, std::string> result;
  const auto add = [&](const std::string& id, const std::string& text) {
    result[id] += (result[id].empty() ? "" : "; ") + text;
  };
  std::vector<std::string> of_panel(model.complex.number_of_panels());
  for (int e = 0; e < model.complex.number_of_edges(); ++e) {
    const auto& edge = model.complex.edges[e];
    if (edge.is_closed()) continue;
    const std::string name = edge_id(model.complex, e);
    std::string joint;
    for (const std::string& id : model.joints[e].parts) joint += (joint.empty() ? "" : " ") + id;
    if (joint.empty()) joint = to_string(model.joints[e].kind);
    const std::string angle = std::to_string(std::lround(model.complex.dihedral(e))) + "\xc2\xb0";
    for (int side = 0; side < 2; ++side) {
      std::string& list = of_panel[edge.panels[side]];
      list += (list.empty() ? "" : "; ") + panel_id(model.complex, edge.panels[1 - side]) + " " + angle + " " + name +
              " (" + joint + ")";
    }
    for (const std::string& id : model.joints[e].parts)
      add(id, panel_id(model.complex, edge.panels[0]) + " " + panel_id(model.complex, edge.panels[1]) + " " + angle +
                  " " + name);
  }
  for (const Part& part : model.parts)
    if (const int panel = panel_number(part); panel >= 0) result[part.id] = of_panel[panel];
  return result;
}

} // namespace internal

/// \ingroup PkgMultiplanarSheets
/// Length of all cuts of a drawn part, in mm.
inline double cut_length(const Part_drawing& part)
{
  double sum = 0;
  for (const auto* list : {&part.inner, &part.outer})
    for (const Outline& path : *list) sum += internal::path_length(path, true);
  return sum;
}

/// \ingroup PkgMultiplanarSheets
/// Length of all engraved lines of a drawn part, in mm.
inline double engraved_length(const Part_drawing& part)
{
  double sum = 0;
  for (const Stroke& stroke : part.engraving) sum += internal::path_length(stroke, false);
  return sum;
}

/*!
\ingroup PkgMultiplanarIO

Writes the bill of materials: a line a part with its id, kind, the sides of the smallest rectangle around it in mm, its
nominal area in mm^2, the number of its sheet, the length of its cuts in mm, the parts it is joined to, and what is not
engraved on it for want of room. Comma-separated, UTF-8, a header line first. The caller checks the state of `out`.

\param out the stream
\param model in mm
\param drawings of the model's sheets
*/
inline void write_parts_csv(std::ostream& out, const Model& model, const std::vector<Sheet_drawing>& drawings)
{
  CGAL_precondition(drawings.size() == model.sheets.size());
  std::vector<int> sheet_of(model.parts.size(), -1);
  std::vector<double> cut(model.parts.size(), 0);
  for (std::size_t s = 0; s < drawings.size(); ++s)
    for (std::size_t i = 0; i < drawings[s].parts.size(); ++i) {
      const int part = model.sheets[s].placements[i].part;
      sheet_of[part] = int(s);
      cut[part] = cut_length(drawings[s].parts[i]);
    }
  std::map<std::string, std::string> joined = internal::neighbours_of_parts(model);
  const auto rounded = [](double x) { return internal::drawing_number(std::round(x * 100) / 100); };
  out << "id,kind,width_mm,height_mm,area_mm2,sheet,cut_length_mm,joined_to,not_engraved\n";
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    std::string missing;
    for (const std::string& text : part.not_engraved) missing += (missing.empty() ? "" : "; ") + text;
    const auto boxes = internal::turned_boxes(part, false).along_sides;
    const auto box = *std::min_element(boxes.begin(), boxes.end(), internal::smaller_box);
    out << part.id << "," << (part.kind == Part::Kind::panel ? "panel" : "connector") << ","
        << rounded((std::max)(box.width, box.height)) << "," << rounded((std::min)(box.width, box.height)) << ","
        << rounded(part.area()) << "," << sheet_of[i] + 1 << "," << rounded(cut[i]) << ","
        << internal::csv_field(joined[part.id]) << "," << internal::csv_field(missing) << "\n";
  }
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_PARTS_CSV_H
