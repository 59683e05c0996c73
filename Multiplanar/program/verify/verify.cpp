// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify.h"

#include "checks.h"

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

void check_all(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  const std::optional<Boundary> boundary = check_surface(model, report);
  check_edges(model, report);
  const std::vector<Solid> solids = check_parts(model, words_of_warnings(directory), report);
  check_disjoint(solids, report);
  check_inside(solids, boundary ? &*boundary : nullptr, report);
  check_joints(model, report);
  check_assembly(model, solids, report);
  check_sheets(model, solids, report);
  check_drawings(model, directory, report);
  check_pdf(model, directory, report);
  check_panels_obj(model, directory, report);
  check_shell(model, directory, report);
  check_other_files(model, directory, report);
}

} // namespace
} // namespace verification

int verify(const std::filesystem::path& directory, std::ostream& out)
{
  using namespace verification;
  Report report(out);
  std::string name = directory.lexically_normal().generic_string();
  if (name == "." || name == "./") name = std::filesystem::absolute(directory).lexically_normal().generic_string();
  if (name.size() > 1 && name.back() == '/') name.pop_back();
  try {
    report.begin("model.json");
    const Written_model model = read_model(directory / "model.json");
    if (!model.input_file.empty()) name = model.input_file + " in " + name;
    report.checked(counted(model.panels.size(), "panel") + ", " + counted(model.edges.size(), "edge") + ", " +
                   counted(model.parts.size(), "part") + ", " + counted(model.sheets.size(), "sheet") + ", " +
                   counted(model.assembly.size(), "step"));
    check_all(model, directory, report);
  } catch (const Unreadable& e) {
    report.unreadable(e.what());
  } catch (const std::filesystem::filesystem_error& e) {
    report.unreadable(e.what());
  }
  report.write_summary("Digital assembly of " + name);
  return report.exit_code();
}

} // namespace Multiplanar
} // namespace CGAL
