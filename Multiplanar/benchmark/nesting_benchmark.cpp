// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How dense parts lie on sheets, and how long it takes to lay them.
//
//   nesting_benchmark [--insertions N] [--rotations N] [--gap MM] MODEL.json ...
//
// Models are what `multiplanar make` writes; nesting_table.sh makes them from a folder of meshes. Prints a line per
// model: parts, different shapes, sheets, where the last sheet is cut off, the parts' share of the material with the
// last sheet cut off there and of whole sheets, the same share for parts packed in rows of boxes, and processor
// seconds: for what is known before parts are laid, for the first nest alone, and for all.

#include <CGAL/Multiplanar/nesting.h>
#include <CGAL/Multiplanar/row_packing.h>
#include <CGAL/Multiplanar/utilisation.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL::Multiplanar;
using nlohmann::json;

namespace {

Outline outline_of(const json& points)
{
  Outline outline;
  for (const json& p : points) outline.emplace_back(p[0].get<double>(), p[1].get<double>());
  return outline;
}

std::vector<Part> parts_of(const json& model)
{
  std::vector<Part> parts;
  for (const json& j : model["parts"]) {
    Part part;
    part.id = j["id"];
    part.outline = outline_of(j["outline"]);
    for (const json& hole : j["holes"]) part.holes.push_back(outline_of(hole));
    for (const json& tab : j["tabs"]) part.tabs.push_back({{tab[0].get<int>(), tab[1].get<int>()}});
    parts.push_back(part);
  }
  return parts;
}

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
double seconds_of(Work work)
{
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

void run(const std::string& file, Sheet_options options)
{
  std::ifstream in(file);
  const json model = json::parse(in);
  const std::vector<Part> parts = parts_of(model);
  options.kerf = model["settings"]["kerf"];
  options.fit = model["settings"]["fit"];
  std::size_t shapes = 0;
  const double before = seconds_of([&] { shapes = internal::make_nesting_problem(parts, options).shapes.size(); });
  Sheet_options first_only = options;
  first_only.insertions = 0;
  std::vector<Sheet> first, sheets, rows;
  const double first_seconds = seconds_of([&] { first = nest_parts(parts, first_only); });
  const double all_seconds = seconds_of([&] { sheets = nest_parts(parts, options); });
  rows = pack_in_rows(parts, options);
  const Utilisation u = utilisation(sheets, parts, options.border);
  std::printf("%-44s %5zu %6zu %6zu %8.1f %6.1f %6.1f %6.1f %6.1f %7.2f %6.2f %6.2f\n", file.c_str(), parts.size(),
              shapes, sheets.size(), u.used_length, 100 * u.of_used(), 100 * u.of_sheets(),
              100 * utilisation(first, parts, options.border).of_used(),
              100 * utilisation(rows, parts, options.border).of_used(), before, first_seconds, all_seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  Sheet_options options;
  std::printf("%-44s %5s %6s %6s %8s %6s %6s %6s %6s %7s %6s %6s\n", "model", "parts", "shapes", "sheets", "cut off",
              "used", "whole", "first", "rows", "outlines", "first", "all");
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool has_value = i + 1 < argc;
    if (argument == "--insertions" && has_value) options.insertions = std::atoi(argv[++i]);
    else if (argument == "--rotations" && has_value) options.rotations = std::atoi(argv[++i]);
    else if (argument == "--gap" && has_value) options.gap = std::atof(argv[++i]);
    else run(argument, options);
  }
}
