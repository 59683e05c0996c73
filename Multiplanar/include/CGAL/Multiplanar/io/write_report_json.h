// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_REPORT_JSON_H
#define CGAL_MULTIPLANAR_IO_WRITE_REPORT_JSON_H

#include <CGAL/Multiplanar/Approximation_options.h>
#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/io/json_format.h>
#include <CGAL/Multiplanar/texture_distortion.h>
#include <CGAL/Multiplanar/utilisation.h>

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What a run read.
struct Input_counts
{
  int vertices = 0;    ///< of the mesh that was read
  int faces = 0;       ///< triangles
  int genus = 0;       ///< handles
  double diagonal = 0; ///< of the bounding box, in input units
};

/// How well the panels follow the input, in input units.
struct Accuracy
{
  double hausdorff = 0;           ///< symmetric
  double hausdorff_to_panels = 0; ///< from the input to the panels
  double hausdorff_to_input = 0;  ///< from the panels to the input
  double mean_distance = 0;       ///< both ways
  double planarity_deviation = 0; ///< largest distance of a vertex from its panel
  bool embedded = false; ///< checked exactly
  int iterations = 0;    ///< passes done
  bool converged = false; ///< ended before the last pass because nothing changed
};

/// The images of the panels.
struct Texture_counts
{
  int images = 0;                               ///< of panels
  double dpi = 0;                               ///< dots per inch
  double bleed = 0;                             ///< in mm
  std::optional<Texture_distortion> distortion; ///< none if the source's shape is not known
};

/// What a run did, apart from the model itself.
struct Report
{
  std::map<std::string, std::string> versions; ///< by name of the program or library
  std::string command;                         ///< make, approximate or fabricate
  Approximation_options options; ///< meaningful if there is an accuracy
  Input_counts input;            ///< what was read
  std::optional<Accuracy> accuracy;                    ///< none if only parts were made
  std::optional<Texture_counts> textures;              ///< none if the input has no colours
  std::vector<std::pair<std::string, double>> seconds; ///< by stage, in order
  std::vector<Labelling_record> labellings;            ///< of the approximation, by restart and pass
  double cut_length = 0;                               ///< of all sheets, in mm
  double engraved_length = 0;                          ///< of all sheets, in mm
  std::vector<std::string> warnings;                   ///< a sentence each
};

namespace internal {

inline const char* to_string(Effort effort)
{
  return effort == Effort::fast ? "fast" : effort == Effort::best ? "best" : "normal";
}

inline const char* to_string(Solver solver)
{
  return solver == Solver::ceres ? "ceres" : solver == Solver::direct ? "direct" : "auto";
}

inline Json json_approximation_settings(const Approximation_options& o)
{
  return {{"panels", o.panels},
          {"effort", to_string(o.effort)},
          {"iterations", o.iterations},
          {"seed", o.seed},
          {"restarts", o.restarts},
          {"threads", o.threads},
          {"solver", to_string(o.solver)},
          {"smoothness", o.smoothness},
          {"minEdge", o.min_edge},
          {"minWidth", o.min_width},
          {"sheetThickness", o.sheet_thickness},
          {"saliency", !o.saliency.empty()},
          {"saliency_weight", o.saliency_weight}};
}

/// Distances in input units and in percent of the input's diagonal.
inline Json json_accuracy(const Accuracy& a, double diagonal)
{
  const double percent = diagonal > 0 ? 100 / diagonal : 0;
  Json json = {{"hausdorff", a.hausdorff},
               {"hausdorff_percent", a.hausdorff * percent},
               {"hausdorff_input_to_panels", a.hausdorff_to_panels},
               {"hausdorff_input_to_panels_percent", a.hausdorff_to_panels * percent},
               {"hausdorff_panels_to_input", a.hausdorff_to_input},
               {"hausdorff_panels_to_input_percent", a.hausdorff_to_input * percent},
               {"mean_distance", a.mean_distance},
               {"mean_distance_percent", a.mean_distance * percent},
               {"planarity_deviation", a.planarity_deviation},
               {"planarity_deviation_percent", a.planarity_deviation * percent},
               {"embedded", a.embedded},
               {"iterations", a.iterations},
               {"converged", a.converged}};
  if (a.embedded) json["intersections"] = 0;
  return json;
}

/// What one labelling did to the energy of eq. 1.
inline Json json_labelling(const Labelling_record& r)
{
  return {{"restart", r.restart},
          {"pass", r.pass},
          {"frozen", r.frozen},
          {"energy_before", r.before},
          {"energy_after_planes", r.planes},
          {"energy_after_expansions", r.expanded},
          {"energy_after_panels", r.panels},
          {"sweeps", r.sweeps},
          {"expansions", r.expansions},
          {"merges", r.merges},
          {"splits", r.splits},
          {"panels", r.number_of_panels},
          {"changed_faces", r.changed_faces}};
}

/// How many edges have each kind of joint, what share of their length is joined, and the unjoined ones by reason.
inline Json json_joints(const Model& model)
{
  Json counts = {{"connector", 0}, {"teeth", 0}, {"none", 0}};
  std::map<std::string, Json> unjoined;
  for (int e = 0; e < int(model.joints.size()); ++e) {
    const Edge_joint& joint = model.joints[e];
    counts[Multiplanar::to_string(joint.kind)] = counts[Multiplanar::to_string(joint.kind)].get<int>() + 1;
    if (joint.kind == Edge_joint::Kind::none) unjoined[joint.reason].push_back(edge_id(model.complex, e));
  }
  Json reasons = Json::array();
  for (const auto& item : unjoined) reasons.push_back({{"reason", item.first}, {"edges", item.second}});
  return {{"by_kind", counts}, {"joined_share", joined_share(model)}, {"unjoined", reasons}};
}

inline Json json_quantiles(const Quantiles& q) { return {{"median", q.median}, {"p95", q.p95}}; }

/// Singular values of the maps from the source to the panels, over the area; 1 is no distortion.
inline Json json_textures(const Texture_counts& t)
{
  Json json = {{"images", t.images}, {"dpi", t.dpi}, {"bleed_mm", t.bleed}};
  if (t.distortion)
    json["distortion"] = {{"median", t.distortion->distortion.median},
                          {"p95", t.distortion->distortion.p95},
                          {"largest_singular_value", json_quantiles(t.distortion->largest)},
                          {"inverse_of_smallest_singular_value", json_quantiles(t.distortion->smallest)}};
  return json;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes what a run did as `report.json`: versions, settings, counts, seconds, accuracy, what each labelling did to the
energy, joints, parts, sheets, warnings.
The caller checks the state of `out` afterwards.
*/
inline void write_report_json(std::ostream& out, const Report& report, const Model& model)
{
  using namespace internal;
  Json json = {{"format", "multiplanar-report"}, {"version", 1}, {"command", report.command}};
  json["versions"] = report.versions;
  json["input"] = {{"file", model.input_file},
                   {"vertices", report.input.vertices},
                   {"faces", report.input.faces},
                   {"genus", report.input.genus},
                   {"diagonal", report.input.diagonal}};
  const Model_settings& s = model.settings;
  json["settings"] = {{"size", s.size}, {"thickness", s.thickness}, {"kerf", s.kerf},
                      {"fit", s.fit},   {"margin", s.margin},       {"gap", s.gap}};
  if (report.accuracy) json["settings"].update(json_approximation_settings(report.options));
  json["seconds"] = Json::object();
  for (const auto& stage : report.seconds) json["seconds"][stage.first] = stage.second;
  json["panels"] = model.complex.number_of_panels();
  json["corners"] = model.complex.number_of_corners();
  json["edges"] = model.complex.number_of_edges();
  if (report.accuracy) json["accuracy"] = json_accuracy(*report.accuracy, report.input.diagonal);
  if (report.accuracy) {
    json["labellings"] = Json::array();
    for (const Labelling_record& record : report.labellings) json["labellings"].push_back(json_labelling(record));
  }
  json["joints"] = json_joints(model);
  json["parts"] = model.parts.size();
  json["sheets"] = model.sheets.size();
  const Utilisation u = utilisation(model.sheets, model.parts, s.margin);
  json["utilisation"] = u.of_used();
  json["utilisation_of_whole_sheets"] = u.of_sheets();
  json["area"] = {{"parts", u.parts}, {"sheets", u.sheets}, {"sheets_last_cut_off", u.used}};
  json["last_sheet_length"] = u.used_length;
  json["cut_length"] = report.cut_length;
  json["engraved_length"] = report.engraved_length;
  if (report.textures) json["textures"] = json_textures(*report.textures);
  json["warnings"] = report.warnings;
  write_json(out, json);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_REPORT_JSON_H
