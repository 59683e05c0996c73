// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"
#include "check_measures.h"
#include "failure.h"
#include "number_parsing.h"

#include <CGAL/Multiplanar/Joint_options.h>
#include <CGAL/Multiplanar/Material.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using CGAL::Multiplanar::Effort;
using CGAL::Multiplanar::Joint_mode;
using CGAL::Multiplanar::Solver;

/// Values that the parser holds as text until they are checked.
struct Raw_values
{
  std::string panel_numbers = "30,50,70,90"; ///< of compare
  std::string seed = "0", effort = "normal", solver = "auto", sheet = "600x400", joints = "auto", engrave = "inside";
  std::string palette = "default";
  std::string material; ///< empty: none
  bool quiet = false, json_progress = false;
};

void add_files(CLI::App& app, Settings& s, const std::string& input, const std::string& output)
{
  app.add_option("INPUT", s.input, input)->required()->type_name("");
  app.add_option("-o,--output", s.output, output)->required()->type_name("PATH");
}

/// How panels are looked for, whatever their number.
void add_search_options(CLI::App& app, Settings& s, Raw_values& raw)
{
  auto& a = s.approximation;
  app.add_option("--effort", raw.effort, "fast, normal or best (normal)")->type_name("NAME");
  app.add_option("--iterations", a.iterations, "passes of the main loop (50)")->type_name("N");
  app.add_option("--seed", raw.seed, "of all random choices (0)")->type_name("N");
  app.add_option("--restarts", a.restarts, "seeds tried; kept is the one whose panels are closest, both ways (1)")
      ->type_name("N");
  app.add_option("--smoothness", a.smoothness, "weight of the smoothness term (0)")->type_name("W");
  app.add_option("--min-edge", s.min_edge, "shorter edges of panels are removed (half the thickness)")->type_name("MM");
  app.add_option("--min-width", s.min_width, "narrower panels are merged (the thickness)")->type_name("MM");
  app.add_option("--solver", raw.solver, "auto, ceres or direct (auto)")->type_name("NAME");
  for (const char* name :
       {"--effort", "--iterations", "--seed", "--restarts", "--smoothness", "--min-edge", "--min-width", "--solver"})
    app.get_option(name)->group("Shape");
}

void add_approximation_options(CLI::App& app, Settings& s, Raw_values& raw)
{
  auto& a = s.approximation;
  app.add_option("-k,--panels", a.panels, "at most so many panels (50)")->type_name("N")->group("Shape");
  add_search_options(app, s, raw);
  app.add_option("--saliency", s.saliency_file,
                 "where more panels are wanted: 0..1 a face, text or PLY, or a picture on the texture")
      ->type_name("FILE")
      ->group("Shape");
  app.add_option("--saliency-weight", a.saliency_weight,
                 "W: where saliency is 1, panels come about 1 + W/4 times closer (1)")
      ->type_name("W")
      ->group("Shape");
}

void add_comparison_options(CLI::App& app, Settings& s, Raw_values& raw)
{
  app.add_option("INPUT", s.input, "mesh: OFF, PLY, STL, OBJ or GLB")->required()->type_name("");
  app.add_option("-k,--panels", raw.panel_numbers, "numbers of panels, one comparison each (30,50,70,90)")
      ->type_name("N,N,...")
      ->group("Shape");
  add_search_options(app, s, raw);
  app.add_flag("--tsv", s.tsv, "tab-separated values, and nothing else on standard output")->group("Run");
}

/// What --min-edge and --min-width are measured on, where nothing is cut.
void add_measures(CLI::App& app, Settings& s)
{
  app.add_option("--size", s.model.size, "longest side of the finished model (300)")->type_name("MM")->group("Cutting");
  app.add_option("--thickness", s.model.thickness, "of the material (3)")->type_name("MM")->group("Cutting");
}

void add_fabrication_options(CLI::App& app, Settings& s, Raw_values& raw)
{
  app.add_option("--size", s.model.size, "longest side of the finished model (300)")->type_name("MM");
  app.add_option("--material", raw.material, "sets thickness, kerf and fit: see --list-materials")->type_name("NAME");
  app.add_option("--thickness", s.model.thickness, "of the material (3)")->type_name("MM");
  app.add_option("--kerf", s.model.kerf, "full width of the cut (0.15)")->type_name("MM");
  app.add_option("--fit", s.model.fit, "how much wider than its slot a tab is cut (0.05)")->type_name("MM");
  app.add_option("--sheet", raw.sheet, "size of the material (600x400)")->type_name("WxH");
  app.add_option("--margin", s.model.margin, "no cut nearer to the edge of a sheet (5)")->type_name("MM");
  app.add_option("--gap", s.model.gap, "material left between two parts (1)")->type_name("MM");
  app.add_option("--rotations", s.sheet.rotations, "angles a part is tried at on the sheet (16)")->type_name("N");
  app.add_option("--nest-seconds", s.sheet.seconds,
                 "search so long for a denser nest; 0: not at all (a fixed number of steps, the same everywhere)")
      ->type_name("S");
  app.add_option("--joints", raw.joints, "auto, connectors, teeth or none (auto)")->type_name("NAME");
  app.add_option("--dpi", s.dpi, "dots per inch of textures (150)")->type_name("N");
  app.add_option("--palette", raw.palette, "colours of the lines: default, lightburn, score or blue-cut (default)")
      ->type_name("NAME");
  app.add_option("--engrave", raw.engrave, "ids inside or outside of the model (inside)")->type_name("NAME");
  for (const char* name : {"--size", "--material", "--thickness", "--kerf", "--fit", "--sheet", "--margin", "--gap",
                           "--rotations", "--nest-seconds", "--joints", "--dpi", "--palette", "--engrave"})
    app.get_option(name)->group("Cutting");
}

void add_run_options(CLI::App& app, Settings& s, Raw_values& raw)
{
  app.add_option("--threads", s.approximation.threads, "0: all that the machine has (0)")->type_name("N")->group("Run");
  app.add_flag("--quiet", raw.quiet, "print errors only")->group("Run");
  app.add_flag("--json-progress", raw.json_progress, "progress as a JSON object a line")->group("Run");
}

std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

void read_sheet(const std::string& text, Settings& s)
{
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lfx%lf%c", &s.sheet.width, &s.sheet.height, &rest) != 2)
    throw usage_error("--sheet " + quoted(text) + ": give width and height in mm, for instance 600x400");
}

/// What `values` says for a word.
template <class Value>
Value chosen(const std::string& option, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& values)
{
  std::string list;
  for (const auto& v : values) {
    if (v.first == word) return v.second;
    list += (list.empty() ? "" : ", ") + v.first;
  }
  throw usage_error(option + " " + quoted(word) + ": give one of " + list);
}

Progress::Style progress_style(const Raw_values& raw, bool tsv)
{
  if (raw.quiet || tsv) return Progress::Style::quiet;
  if (raw.json_progress) return Progress::Style::json;
  return isatty(STDOUT_FILENO) ? Progress::Style::bar : Progress::Style::lines;
}

/// Not left to the parser: it takes -1 for 2^64 - 1.
std::uint64_t read_seed(const std::string& text)
{
  long long seed = 0;
  if (!parse_integer(text, seed) || seed < 0)
    throw usage_error("--seed " + quoted(text) + ": give a whole number from 0 to 9223372036854775807");
  return std::uint64_t(seed);
}

std::vector<int> read_panel_numbers(const std::string& text)
{
  std::vector<int> numbers;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    long long k = 0;
    if (!parse_integer(std::string_view(text).substr(begin, end - begin), k) || k < 1 || k > 1000000)
      throw usage_error("--panels " + quoted(text) + ": give numbers with commas between them, for instance 30,50,70");
    numbers.push_back(int(k));
  }
  return numbers;
}

std::string list_of_materials()
{
  std::string list = "material      thickness  kerf   fit   (mm; without a number: 3 mm stock)\n";
  for (const CGAL::Multiplanar::Material& m : CGAL::Multiplanar::materials()) {
    char line[80];
    std::snprintf(line, sizeof line, "%-13s %9g  %.3f  %.2f\n", m.name, m.thickness, m.kerf, m.fit);
    list += line;
  }
  list.pop_back();
  return list;
}

/// The material's measures, but for those that were given one by one.
void read_material(const CLI::App& command, const Raw_values& raw, Settings& s)
{
  if (raw.material.empty()) return;
  const CGAL::Multiplanar::Material* material = CGAL::Multiplanar::find_material(raw.material);
  if (!material) throw usage_error("--material " + quoted(raw.material) + ": see multiplanar --list-materials");
  if (command.count("--thickness") == 0) s.model.thickness = material->thickness;
  if (command.count("--kerf") == 0) s.model.kerf = material->kerf;
  if (command.count("--fit") == 0) s.model.fit = material->fit;
}

void read_choices(const Raw_values& raw, Settings& s)
{
  s.approximation.seed = read_seed(raw.seed);
  s.approximation.effort = chosen<Effort>("--effort", raw.effort,
                                          {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}});
  s.approximation.solver = chosen<Solver>(
      "--solver", raw.solver, {{"auto", Solver::automatic}, {"ceres", Solver::ceres}, {"direct", Solver::direct}});
  s.joints = chosen<Joint_mode>("--joints", raw.joints,
                                {{"auto", Joint_mode::automatic},
                                 {"connectors", Joint_mode::connectors},
                                 {"teeth", Joint_mode::teeth},
                                 {"none", Joint_mode::none}});
  s.sheet.mirrored = chosen<bool>("--engrave", raw.engrave, {{"inside", true}, {"outside", false}});
  std::vector<std::pair<std::string, CGAL::Multiplanar::Palette>> palettes;
  for (const CGAL::Multiplanar::Palette& palette : CGAL::Multiplanar::palettes())
    palettes.push_back({palette.name, palette});
  s.palette = chosen<CGAL::Multiplanar::Palette>("--palette", raw.palette, palettes);
  s.panel_numbers = read_panel_numbers(raw.panel_numbers);
  s.progress = progress_style(raw, s.tsv);
}

/// Values that stand in several places.
void copy_shared_values(Settings& s)
{
  s.sheet.kerf = s.model.kerf;
  s.sheet.fit = s.model.fit;
  s.sheet.border = s.model.margin;
  s.sheet.gap = s.model.gap;
  s.sheet.threads = s.approximation.threads;
  s.model.panels = s.approximation.panels;
  s.model.seed = s.approximation.seed;
}

} // namespace

std::optional<Settings> parse_command_line(int argc, char** argv)
{
  Settings s;
  Raw_values raw;
  CLI::App app("Closed 3D models as flat panels to cut and assemble.", "multiplanar");
  app.footer("Each command tells its options: multiplanar make --help\n"
             "Vertices and faces in messages count from 0, lines from 1.");
  app.set_version_flag("--version", "multiplanar " MULTIPLANAR_VERSION);
  app.add_flag_callback(
      "--list-materials", [] { throw CLI::CallForVersion(list_of_materials(), 0); }, "the presets for --material");
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "this text");

  CLI::App* make =
      app.add_subcommand("make", "everything: from a mesh (OFF, PLY, STL, OBJ, GLB) to sheets ready to cut");
  add_files(*make, s, "mesh: OFF, PLY, STL, OBJ or GLB", "folder to write");
  add_approximation_options(*make, s, raw);
  add_fabrication_options(*make, s, raw);
  CLI::App* approximate = app.add_subcommand("approximate", "the mesh made of flat panels only, as PLY");
  add_files(*approximate, s, "mesh: OFF, PLY, STL, OBJ or GLB", "PLY file to write");
  add_approximation_options(*approximate, s, raw);
  add_measures(*approximate, s);
  CLI::App* fabricate = app.add_subcommand("fabricate", "from such a PLY to sheets ready to cut");
  add_files(*fabricate, s, "PLY that approximate or make wrote", "folder to write");
  add_fabrication_options(*fabricate, s, raw);
  CLI::App* verify = app.add_subcommand("verify", "checks what make or fabricate wrote by digital assembly");
  verify->add_option("DIR", s.input, "folder that make or fabricate wrote")->required()->type_name("");
  verify->footer("");
  CLI::App* compare = app.add_subcommand("compare", "a table: this method and CGAL's VSA and QEM on the same mesh");
  add_comparison_options(*compare, s, raw);
  add_measures(*compare, s);
  CLI::App* preview = app.add_subcommand("preview", "draws the pictures of what make or fabricate wrote anew");
  preview->add_option("DIR", s.input, "folder that make or fabricate wrote")->required()->type_name("");
  fabricate->add_option("--source", s.source, "the mesh that the PLY was made from: its colours go onto the panels")
      ->type_name("FILE")
      ->group("Cutting");
  for (CLI::App* command : {make, approximate})
    command
        ->add_flag("--repair", s.repair,
                   "mends the mesh first: welds, removes degenerate faces, orients, fills holes, keeps the largest "
                   "component, resolves self-intersections, or else wraps it")
        ->group("Shape");
  for (CLI::App* command : {make, fabricate})
    command->add_flag("--preview,!--no-preview", s.preview, "pictures of all in the folder preview (yes)")
        ->group("Run");
  for (CLI::App* command : {make, approximate, fabricate, compare, preview}) {
    add_run_options(*command, s, raw);
    command->footer("");
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) { // help or version
    app.exit(done);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (app.get_subcommands().empty() && argc < 2) throw usage_error("no command was given: see multiplanar --help");
    throw usage_error(one_line(error.what()) + ": see multiplanar --help");
  }
  const CLI::App* command = app.get_subcommands().front();
  s.command = command->get_name();
  read_sheet(raw.sheet, s);
  read_choices(raw, s);
  read_material(*command, raw, s);
  copy_shared_values(s);
  check_measures(s);
  return s;
}
