// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Comparison.h"
#include "Input_mesh.h"
#include "commands.h"
#include "failure.h"
#include "read_mesh.h"
#include "run_approximation.h"
#include "smallest_measures.h"

#include "../comparison/other_methods.h"
#include "../comparison/surface_quality.h"

#include <CGAL/Multiplanar/internal/Stopwatch.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>

using namespace CGAL::Multiplanar;

namespace {

using Method = std::function<comparison::Compared_surface(int k)>;

/// Table 1 of the paper has a bunny; other models of it are not public under these names.
std::optional<double> paper_figure(const std::string& file, const std::string& method, int k)
{
  static const std::map<std::string, std::map<int, double>> bunny = {
      {"Multiplanar", {{30, 4.66}, {50, 4.36}, {70, 2.84}, {90, 1.96}}},
      {"CGAL VSA", {{30, 5.90}, {50, 4.76}, {70, 3.61}, {90, 3.37}}},
      {"CGAL QEM", {{30, 8.25}, {50, 6.73}, {70, 5.19}, {90, 5.19}}}};
  std::string name = std::filesystem::path(file).filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (name.find("bunny") == std::string::npos) return std::nullopt;
  const auto& figures = bunny.at(method);
  const auto found = figures.find(k);
  return found == figures.end() ? std::nullopt : std::optional<double>(found->second);
}

/// What keeps an output from being a surface of panels, in words.
std::string faults(const comparison::Surface_quality& q)
{
  if (q.closed && q.flat_triangles == 0) return "";
  std::string list;
  const auto add = [&](int count, const char* what) {
    if (count > 0) list += (list.empty() ? " (" : ", ") + std::to_string(count) + " " + what;
  };
  add(q.open_edges, "edges with one triangle");
  add(q.crowded_edges, "edges with more than two or wrongly turned triangles");
  add(q.flat_triangles, "triangles without area");
  if (!list.empty()) list += ")";
  return q.closed ? "a closed mesh, but" + list
                  : "not a closed manifold" + list + ": measured as the soup of triangles that it is";
}

void fill(Comparison_row& row, const comparison::Compared_surface& surface, const Input_mesh& mesh)
{
  const comparison::Surface_quality q = comparison::surface_quality(mesh.points, mesh.connectivity.triangles, surface);
  const double percent = 100 / mesh.diagonal;
  row.measured = true;
  row.panels = surface.panels;
  row.hausdorff = percent * q.hausdorff();
  row.to_panels = percent * q.to_surface;
  row.to_input = percent * q.to_input;
  row.mean = percent * q.mean;
  row.bend = percent * q.bend;
  row.closed = q.closed;
  row.flat = q.bend <= 1e-9 * mesh.diagonal;
  row.intersections = q.intersections;
  row.note = faults(q);
}

/// Runs a method and measures what it returned, outside of its time.
Comparison_row run(const std::string& name, const Method& method, int k, const Input_mesh& mesh)
{
  Comparison_row row;
  row.k = k;
  row.method = name;
  row.paper = paper_figure(mesh.file, name, k);
  internal::Stopwatch watch;
  comparison::Compared_surface surface;
  try {
    const internal::Stopwatch::Lap lap(watch, name);
    surface = method(k);
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& error) {
    row.note = std::string("failed: ") + error.what();
    std::replace_if(
        row.note.begin(), row.note.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  }
  row.seconds = watch.seconds().at(name);
  row.processor_seconds = watch.processor_seconds().at(name);
  if (surface.triangles.empty()) row.note += row.note.empty() ? "returned no triangles" : "";
  else fill(row, surface, mesh);
  return row;
}

std::string in_words(const Settings& s)
{
  const Approximation_options& a = s.approximation;
  const char* effort = a.effort == Effort::fast ? "fast" : a.effort == Effort::best ? "best" : "normal";
  return std::string("effort ") + effort + ", seed " + std::to_string(a.seed) + ", " + std::to_string(a.iterations) +
         " passes, " + std::to_string(a.restarts) + (a.restarts == 1 ? " start" : " starts");
}

Input_mesh read(const Settings& settings, Progress& progress)
{
  progress.update("read", 0);
  Input_mesh mesh = make_input_mesh(read_mesh(settings.input, {}), settings.input);
  for (int k : settings.panel_numbers) check_number_of_panels(mesh, k);
  return mesh;
}

} // namespace

void compare(const Settings& settings, Progress& progress)
{
  const Input_mesh mesh = read(settings, progress);
  const comparison::Compared_mesh plain = comparison::compared_mesh(mesh.connectivity, mesh.points);
  const Method ours = [&](int k) {
    Approximation_options options = settings.approximation;
    options.panels = k;
    set_smallest_measures(settings, mesh, options);
    return comparison::surface_of_panels(run_approximation(mesh, options, progress).complex);
  };
  Comparison comparison;
  comparison.input = std::filesystem::path(settings.input).filename().string();
  comparison.faces = mesh.connectivity.number_of_faces();
  comparison.genus = mesh.connectivity.genus();
  comparison.settings = in_words(settings);
  for (int k : settings.panel_numbers) {
    comparison.rows.push_back(run("Multiplanar", ours, k, mesh));
    progress.update("other methods", 0);
    comparison.rows.push_back(run(
        "CGAL VSA", [&](int n) { return comparison::surface_of_vsa(plain, n); }, k, mesh));
    comparison.rows.push_back(run(
        "CGAL QEM", [&](int n) { return comparison::surface_of_qem(plain, n); }, k, mesh));
  }
  progress.finish();
  (settings.tsv ? write_tsv : write_table)(std::cout, comparison);
  std::cout.flush();
}
