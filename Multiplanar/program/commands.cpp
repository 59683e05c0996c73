// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "Input_mesh.h"
#include "Output.h"
#include "fabricate.h"
#include "failure.h"
#include "guides.h"
#include "load_appearance.h"
#include "panels_of_shell.h"
#include "previews.h"
#include "proof.h"
#include "read_mesh.h"
#include "repair.h"
#include "run_approximation.h"
#include "saliency.h"
#include "smallest_measures.h"
#include "summary.h"
#include "textures.h"

#include <CGAL/Multiplanar/io/write_shell_ply.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/version.h>

#include <ceres/version.h>

#include <chrono>
#include <optional>

using namespace CGAL::Multiplanar;

namespace {

/// What all commands share: the clock, and the report that grows from step to step.
class Run
{
public:
  Run(const Settings& settings, Progress& progress) : settings(settings), progress(progress)
  {
    report.command = settings.command;
    report.options = settings.approximation;
    report.versions = {{"multiplanar", MULTIPLANAR_VERSION},
                       {"CGAL", CGAL_VERSION_STR},
                       {"Ceres", CERES_VERSION_STRING},
                       {"compiler", __VERSION__}};
  }

  Input_mesh read(const std::vector<std::string>& face_properties)
  {
    Input_mesh mesh = read_file(settings.input, face_properties);
    report.input = {mesh.connectivity.number_of_vertices(), mesh.connectivity.number_of_faces(),
                    mesh.connectivity.genus(), mesh.diagonal};
    warn(mesh.notes);
    report.seconds = progress.seconds();
    return mesh;
  }

  /// The mesh that a shell was made from. \throws Failure if it has other triangles
  Input_mesh read_source(const Input_mesh& shell)
  {
    Input_mesh source = read_file(settings.source, {});
    if (source.connectivity.triangles != shell.connectivity.triangles)
      throw input_error(settings.source + ": its triangles are not those of " + shell.file +
                        ": give the mesh that it was made from");
    return source;
  }

  Surface_appearance looks_of(const Input_mesh& mesh) { return load_appearance(mesh, report.warnings); }

  Approximation_result approximate(const Input_mesh& mesh)
  {
    Approximation_options options = settings.approximation;
    check_number_of_panels(mesh, options.panels);
    if (!settings.saliency_file.empty()) options.saliency = read_saliency(settings.saliency_file, mesh);
    set_smallest_measures(settings, mesh, options);
    report.options = options;
    Approximation_result result = run_approximation(mesh, options, progress);
    report.accuracy = accuracy_of(result);
    report.labellings = result.labellings;
    report.seconds.insert(report.seconds.end(), result.seconds.begin(), result.seconds.end());
    warn(result.notes);
    return result;
  }

  Model make_parts(const Panel_complex& complex)
  {
    progress.update("fabricate", 0);
    Model model = make_model(complex, settings, report.warnings);
    progress.finish();
    report.seconds.push_back(progress.seconds().back());
    return model;
  }

  /// The mesh that --repair made of the input, if it had to do anything.
  void write_repaired(Output& output, const Input_mesh& mesh)
  {
    if (!repaired) return;
    const auto write = [&](std::ostream& out) {
      write_shell_ply(out, mesh.points, mesh.connectivity.triangles, {},
                      {"multiplanar " MULTIPLANAR_VERSION, "repaired"}, texture_points_of(mesh));
    };
    if (settings.command == "make") output.write("repaired.ply", write);
    else output.write_beside(".repaired.ply", write);
  }

  void write_shell(Output& output, const std::string& name, const Input_mesh& mesh, const Points& points,
                   const std::vector<int>& panel_of_face)
  {
    output.write(name, [&](std::ostream& out) {
      write_shell_ply(out, points, mesh.connectivity.triangles, panel_of_face, {"multiplanar " MULTIPLANAR_VERSION},
                      texture_points_of(mesh));
    });
  }

  /// \param source the mesh that was read first, whose looks the panels get
  /// \param points, panel_of_face the mesh that became the panels, in the units of the source
  void write_folder(Output& output, Model& model, const Input_mesh& source, const Points& points,
                    const std::vector<int>& panel_of_face)
  {
    const File_writer write = [&](const std::string& name, const std::function<void(std::ostream&)>& write_to) {
      output.write(name, write_to);
    };
    const Surface_appearance looks = looks_of(source);
    Texture_source textured{looks, source.connectivity.triangles, panel_of_face, {}};
    std::optional<Textures> textures;
    if (!looks.empty()) {
      for (const Point_3& p : points)
        textured.points.emplace_back(p.x() * model.scale, p.y() * model.scale, p.z() * model.scale);
      Baking_options options;
      options.dpi = settings.dpi;
      textures.emplace(model, textured, options, settings.sheet.gap, settings.approximation.threads);
      textures->write(write, progress);
      report.textures = Texture_counts{textures->number_of_images(), options.dpi, options.bleed, {}};
      if (&points != &source.points)
        report.textures->distortion = texture_distortion(source.connectivity.triangles, source.points, points);
    }
    progress.update("write", 0);
    write_shell(output, "shell.ply", source, points, panel_of_face);
    write_model(output, model, settings.palette, report);
    const Preview_view view = preview_view(model.complex, settings.approximation.threads);
    const Part_pictures pictures = textures ? textures->pictures() : Part_pictures();
    if (settings.preview) write_pictures(write, model, source, looks, view, pictures);
    progress.update("guide", 0);
    write_guides(write, model, view, pictures);
    progress.update("verify", 0);
    require_proof(output.temporary_path(), settings.output);
    output.commit();
    progress.finish();
  }

  void write_pictures(const File_writer& write, const Model& model, const Input_mesh& source,
                      const Surface_appearance& looks, const Preview_view& view, const Part_pictures& pictures)
  {
    progress.update("preview", 0);
    write_input_preview(write, mesh_scene(source.points, source.connectivity.triangles, view.up, looks), view);
    write_model_previews(write, model, view, pictures);
  }

  void summarize(const Model& model, const std::string& look_at) const
  {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    print_summary(report, model, seconds, settings.output, look_at, settings.progress);
  }

  std::string first_sheet() const { return settings.output + "/" + sheet_file(0, "svg"); }

private:
  Input_mesh read_file(const std::string& file, const std::vector<std::string>& face_properties)
  {
    progress.update("read", 0);
    Polygon_soup soup = read_mesh(file, face_properties);
    progress.update("read", 0.3);
    std::vector<std::string> repairs;
    if (settings.repair) {
      soup = repair(std::move(soup), repairs);
      repaired = !repairs.empty();
    }
    Input_mesh mesh = make_input_mesh(std::move(soup), file);
    mesh.notes.insert(mesh.notes.begin(), repairs.begin(), repairs.end());
    progress.finish();
    return mesh;
  }

  void warn(const std::vector<std::string>& lines)
  {
    report.warnings.insert(report.warnings.end(), lines.begin(), lines.end());
  }

  const Settings& settings;
  Progress& progress;
  Report report;
  bool repaired = false; ///< the input is not what the file holds
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

} // namespace

void make(const Settings& settings, Progress& progress)
{
  Run run(settings, progress);
  Output output(Output::Kind::folder, settings.output);
  const Input_mesh mesh = run.read({});
  const Approximation_result result = run.approximate(mesh);
  Model model = run.make_parts(result.complex);
  run.write_repaired(output, mesh);
  run.write_folder(output, model, mesh, result.points, result.panel_of_face);
  run.summarize(model, run.first_sheet());
}

void approximate(const Settings& settings, Progress& progress)
{
  Run run(settings, progress);
  Output output(Output::Kind::file, settings.output);
  const Input_mesh mesh = run.read({});
  const Approximation_result result = run.approximate(mesh);
  run.write_shell(output, "", mesh, result.points, result.panel_of_face);
  run.write_repaired(output, mesh);
  output.commit();
  Model model;
  model.complex = result.complex;
  run.summarize(model, settings.output);
}

void fabricate(const Settings& given, Progress& progress)
{
  Settings settings = given;
  Run run(settings, progress);
  Output output(Output::Kind::folder, settings.output);
  const Input_mesh mesh = run.read({"panel"});
  const std::vector<int> panel_of_face = panels_of_shell(mesh);
  const Panel_complex complex = complex_of_shell(mesh, panel_of_face);
  settings.model.panels = complex.number_of_panels();
  Model model = run.make_parts(complex);
  if (settings.source.empty()) run.write_folder(output, model, mesh, mesh.points, panel_of_face);
  else run.write_folder(output, model, run.read_source(mesh), mesh.points, panel_of_face);
  run.summarize(model, run.first_sheet());
}
