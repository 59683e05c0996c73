// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "summary.h"

#include <CGAL/Multiplanar/utilisation.h>

#include <cstdio>

using namespace CGAL::Multiplanar;

namespace {

double percent_of_diagonal(const Report& report, double distance)
{
  return report.input.diagonal > 0 ? 100 * distance / report.input.diagonal : 0;
}

std::string joints_in_words(const Model& model)
{
  int count[3] = {0, 0, 0};
  for (const Edge_joint& joint : model.joints) ++count[int(joint.kind)];
  char text[160];
  std::snprintf(text, sizeof text, "%d edges with connectors, %d with teeth, %d not joined; joined length: %.0f %%",
                count[int(Edge_joint::Kind::connector)], count[int(Edge_joint::Kind::teeth)],
                count[int(Edge_joint::Kind::none)], 100 * joined_share(model));
  return text;
}

std::string textures_in_words(const Texture_counts& t)
{
  char text[200];
  int n = std::snprintf(text, sizeof text, "textures of %d panels at %g dpi", t.images, t.dpi);
  if (t.distortion)
    std::snprintf(text + n, sizeof text - n, "; distortion: median %.3f, 95 %% of the area below %.3f (1: none)",
                  t.distortion->distortion.median, t.distortion->distortion.p95);
  return text;
}

std::string sheets_in_words(const Model& model)
{
  const Utilisation u = utilisation(model.sheets, model.parts, model.settings.margin);
  char text[200];
  std::snprintf(
      text, sizeof text,
      "%zu parts on %zu sheet%s of %g x %g mm; parts are %.0f %% of the material, the last sheet cut off at %.0f mm",
      model.parts.size(), model.sheets.size(), model.sheets.size() == 1 ? "" : "s", model.sheets[0].width,
      model.sheets[0].height, 100 * u.of_used(), u.used_length);
  return text;
}

void print_words(const Report& report, const Model& model, double seconds, const std::string& output,
                 const std::string& look_at)
{
  std::printf("%d panels, %d corners, %d edges\n", model.complex.number_of_panels(), model.complex.number_of_corners(),
              model.complex.number_of_edges());
  if (report.accuracy)
    std::printf("Hausdorff distance to the input: %.2f %% of its diagonal\n",
                percent_of_diagonal(report, report.accuracy->hausdorff));
  if (!model.joints.empty()) std::printf("%s\n", joints_in_words(model).c_str());
  if (!model.sheets.empty()) std::printf("%s\n", sheets_in_words(model).c_str());
  if (report.textures) std::printf("%s\n", textures_in_words(*report.textures).c_str());
  for (const std::string& warning : report.warnings) std::printf("warning: %s\n", warning.c_str());
  std::printf("%.1f s\n", seconds);
  std::printf("written: %s\n", output.c_str());
  if (look_at != output) std::printf("look at: %s\n", look_at.c_str());
}

void print_json(const Report& report, const Model& model, double seconds, const std::string& output,
                const std::string& look_at)
{
  internal::Json json = {{"event", "done"},
                         {"panels", model.complex.number_of_panels()},
                         {"corners", model.complex.number_of_corners()},
                         {"edges", model.complex.number_of_edges()}};
  if (report.accuracy) json["hausdorff_percent"] = percent_of_diagonal(report, report.accuracy->hausdorff);
  if (!model.joints.empty()) json["joined_share"] = joined_share(model);
  json["sheets"] = model.sheets.size();
  json["warnings"] = report.warnings;
  json["seconds"] = seconds;
  json["output"] = output;
  json["look_at"] = look_at;
  std::printf("%s\n", internal::one_line(json).c_str());
}

} // namespace

void print_summary(const Report& report, const Model& model, double seconds, const std::string& output,
                   const std::string& look_at, Progress::Style style)
{
  if (style == Progress::Style::quiet) return;
  (style == Progress::Style::json ? print_json : print_words)(report, model, seconds, output, look_at);
}
