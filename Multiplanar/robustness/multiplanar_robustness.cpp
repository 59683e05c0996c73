// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input.h"
#include "Verdict.h"
#include "check_parts.h"
#include "check_shell.h"
#include "run_limited.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

// One mesh through the whole program, and every promise checked anew from the files that it wrote. See the chapter on
// robustness in the manual.

namespace fs = std::filesystem;

namespace {

const char* const help =
    "multiplanar_robustness MESH [options]: runs `multiplanar make` and `verify` on a mesh and checks every promise\n"
    "from what they wrote. Prints a line of a table; what is broken goes to standard error, a line each.\n"
    "  -k N          panels (40); more where the genus asks for it, fewer where the mesh has fewer faces\n"
    "  --effort E    fast, normal or best (fast)\n"
    "  --program P   the program (multiplanar beside this one)\n"
    "  --seconds S   of the processor, for each of the two commands (600)\n"
    "  --megabytes M resident, for each of the two commands (2048)\n"
    "  --written D   checks the folder D that an earlier `make` wrote, and runs only `verify`\n"
    "  --header      prints the heads of the columns\n"
    "exit codes: 0 kept (or rightly refused), 10 connectivity, 11 closed, 12 embedded, 13 flat, 14 k exceeded,\n"
    "  15 parts overlap, 16 outside, 17 parts, 18 unreadable output, 19 wrong refusal, 20 left behind, 21 time limit,\n"
    "  22 memory limit, 23 crash, 24 no flat panels found; 1 usage\n";

const char* const heads = "mesh\tfaces\tgenus\tk\tpanels\tHausdorff %\tseconds\tMB\tresult\tremark\n";

struct Job
{
  std::string mesh, program, written, effort = "fast";
  int panels = 40;
  Limits limits;
};

/// A line of the table.
struct Row
{
  int faces = 0, genus = 0, k = 0, panels = -1;
  double hausdorff = -1, seconds = 0, megabytes = 0;
  bool refused = false;
  std::string remark;
  Broken_promises broken;
};

/// A folder that goes with this object.
struct Work_folder
{
  Work_folder()
  {
    std::string name = (fs::temp_directory_path() / "multiplanar-robustness-XXXXXX").string();
    if (!mkdtemp(&name[0])) throw std::runtime_error("cannot make a folder for temporary files");
    path = name;
  }
  ~Work_folder()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string path;
};

Job read_job(int argc, char** argv)
{
  Job job;
  job.program = (fs::canonical("/proc/self/exe").parent_path() / "multiplanar").string();
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.empty() || word[0] != '-') {
      if (!job.mesh.empty()) throw std::invalid_argument("one mesh at a time");
      job.mesh = word;
      continue;
    }
    if (++i == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "-k") job.panels = std::stoi(argv[i]);
    else if (word == "--effort") job.effort = argv[i];
    else if (word == "--program") job.program = argv[i];
    else if (word == "--seconds") job.limits.seconds = std::stod(argv[i]);
    else if (word == "--megabytes") job.limits.megabytes = std::stod(argv[i]);
    else if (word == "--written") job.written = argv[i];
    else throw std::invalid_argument(word + ": no such option");
  }
  if (job.mesh.empty()) throw std::invalid_argument("name a mesh");
  return job;
}

/// The number asked for, within what a surface like this can have.
int possible_panels(const Input& input, int wanted)
{
  if (!input.faults.empty()) return wanted;
  return std::min(std::max(wanted, 4 + 3 * input.genus), std::max(input.faces, 4));
}

/// Limits and signals. \return did the process end by itself?
bool ended_well(const Process_result& process, const std::string& command, Row& row)
{
  row.seconds += process.seconds;
  row.megabytes = std::max(row.megabytes, process.megabytes);
  if (process.out_of_time) row.broken.emplace_back(Verdict::time_limit, command + " takes too long");
  else if (process.out_of_memory) row.broken.emplace_back(Verdict::memory_limit, command + " takes too much memory");
  else if (process.exit_code < 0)
    row.broken.emplace_back(Verdict::crash, command + " was ended by signal " + std::to_string(process.signal));
  else if (process.exit_code == 1 && command == "make")
    row.broken.emplace_back(Verdict::crash, "make: " + process.errors);
  return row.broken.empty();
}

/// One line that names a fault that is there; nothing written.
void check_refusal(const Process_result& made, const Input& input, const Job& job, const std::string& folder, Row& row)
{
  row.refused = true;
  row.remark = made.errors.substr(0, made.errors.find('\n'));
  const auto lines = std::count(made.errors.begin(), made.errors.end(), '\n');
  std::set<Fault> faults = input.faults;
  if (faults.empty() && (input.faces < row.k || row.k < 4 + 3 * input.genus)) faults.insert(Fault::panels);
  const bool gave_up = faults.empty() && row.remark.find("flat panels were found") != std::string::npos;
  if (gave_up && made.exit_code == 3 && lines == 1) row.broken.emplace_back(Verdict::not_found, row.remark);
  else if (made.exit_code != 3 || lines != 1 || row.remark.rfind(job.mesh, 0) != 0 || !is_right_message(row.remark, faults))
    row.broken.emplace_back(Verdict::refusal, "exit code " + std::to_string(made.exit_code) + ", " +
                                                  std::to_string(lines) + " lines: " + row.remark);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != "stdout" && entry.path().filename() != "stderr")
      row.broken.emplace_back(Verdict::left_behind, entry.path().filename().string());
}

void check_written(const std::string& written, const Input& input, const Job& job, const std::string& folder, Row& row)
{
  row.panels = check_shell(written + "/shell.ply", input, row.k, row.broken);
  const Process_result verified = run_limited({job.program, "verify", written}, folder, job.limits);
  Row end; // the promises of the shell come first
  if (ended_well(verified, "verify", end)) check_parts(verified, row.broken);
  row.broken.insert(row.broken.end(), end.broken.begin(), end.broken.end());
  row.megabytes = std::max(row.megabytes, end.megabytes);
  std::ifstream file(written + "/report.json");
  const auto report = nlohmann::json::parse(file, nullptr, false);
  if (report.is_object() && report.contains("accuracy") && report["accuracy"]["hausdorff_percent"].is_number())
    row.hausdorff = report["accuracy"]["hausdorff_percent"];
  else row.broken.emplace_back(Verdict::unreadable, "report.json says no accuracy");
}

Row check(const Job& job)
{
  Row row;
  const Work_folder folder;
  const Input input = read_input(job.mesh);
  row.faces = input.faces;
  row.genus = input.genus;
  row.k = possible_panels(input, job.panels);
  std::string written = job.written;
  if (written.empty()) {
    written = folder.path + "/out";
    const Process_result made = run_limited(
        {job.program, "make", job.mesh, "-o", written, "-k", std::to_string(row.k), "--effort", job.effort, "--quiet"},
        folder.path, job.limits);
    if (!ended_well(made, "make", row)) return row;
    if (made.exit_code != 0) {
      check_refusal(made, input, job, folder.path, row);
      return row;
    }
  }
  if (!input.faults.empty()) row.broken.emplace_back(Verdict::refusal, "taken, though it must be refused");
  else check_written(written, input, job, folder.path, row);
  return row;
}

std::string number(double value, int digits, bool known)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return known ? text : "-";
}

/// Without the name of the mesh, which begins the line already.
std::string remark_of(const Row& row, const std::string& mesh)
{
  std::string text = row.broken.empty() ? row.remark : row.broken[0].second;
  const std::size_t at = text.find(mesh + ": ");
  if (at != std::string::npos) text.erase(at, mesh.size() + 2);
  for (char& c : text)
    if (c == '\t' || c == '\n') c = ' ';
  return text;
}

void print(const Row& row, const std::string& mesh)
{
  const Verdict verdict = row.broken.empty() ? Verdict::kept : row.broken[0].first;
  const std::string result = verdict == Verdict::kept && row.refused ? "refused" : name_of(verdict);
  std::cout << fs::path(mesh).filename().string() << '\t' << number(row.faces, 0, row.faces > 0) << '\t'
            << number(row.genus, 0, row.panels >= 0) << '\t' << row.k << '\t' << number(row.panels, 0, row.panels >= 0)
            << '\t' << number(row.hausdorff, 2, row.hausdorff >= 0) << '\t' << number(row.seconds, 1, true) << '\t'
            << number(row.megabytes, 0, true) << '\t' << result << '\t' << remark_of(row, mesh) << '\n';
  for (const auto& promise : row.broken)
    std::cerr << mesh << ": " << name_of(promise.first) << ": " << promise.second << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::string first = argc == 2 ? argv[1] : "";
    if (first == "--header" || first == "--help") {
      std::cout << (first == "--help" ? help : heads);
      return int(Verdict::kept);
    }
    const Job job = read_job(argc, argv);
    const Row row = check(job);
    print(row, job.mesh);
    return int(row.broken.empty() ? Verdict::kept : row.broken[0].first);
  } catch (const std::exception& error) {
    std::cerr << "multiplanar_robustness: " << error.what() << ": see --help\n";
    return int(Verdict::usage);
  }
}
