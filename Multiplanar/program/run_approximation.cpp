// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_approximation.h"
#include "failure.h"

#include <CGAL/Multiplanar/approximate.h>

#include <algorithm>
#include <stdexcept>

using namespace CGAL::Multiplanar;

namespace {

struct Progress_visitor : Approximation_visitor
{
  explicit Progress_visitor(Progress& progress) : shown(progress) {}
  bool progress(const std::string& stage, double fraction) override
  {
    shown.update(stage, fraction);
    return true;
  }
  void labelled(const Labelling_record& record) override
  {
    internal::Json json = {{"event", "labelling"}};
    json.update(internal::json_labelling(record));
    shown.event(internal::one_line(json));
  }
  Progress& shown;
};

Failure broken(const Input_mesh& mesh, const std::string& what)
{
  return Failure(exit_broken_promise,
                 mesh.file + ": " + what + ": nothing was written: try another --seed, and report it");
}

void check_result(const Input_mesh& mesh, const Approximation_result& result, int most_panels)
{
  const int panels = result.complex.number_of_panels();
  if (!result.embedded) throw broken(mesh, "the result intersects itself");
  if (panels > most_panels)
    throw broken(mesh, "the result has " + std::to_string(panels) + " panels, not " + std::to_string(most_panels));
  if (result.points.size() != mesh.points.size() ||
      int(result.panel_of_face.size()) != mesh.connectivity.number_of_faces())
    throw broken(mesh, "the result has another connectivity than the input");
  const auto range = std::minmax_element(result.panel_of_face.begin(), result.panel_of_face.end());
  if (*range.first < 0 || *range.second >= panels) throw broken(mesh, "a face of the result has no panel");
}

/// The approximation says in one line why it could not keep its promises.
Approximation_result approximated(const Input_mesh& mesh, const Approximation_options& options,
                                  Approximation_visitor& visitor)
{
  try {
    return internal::approximate(mesh.connectivity, mesh.points, options, visitor);
  } catch (const std::invalid_argument& error) {
    throw input_error(mesh.file + ": " + error.what());
  } catch (const No_flat_panels& error) {
    throw input_error(mesh.file + ": " + error.what());
  } catch (const std::runtime_error& error) {
    throw broken(mesh, error.what());
  }
}

} // namespace

Approximation_result run_approximation(const Input_mesh& mesh, const Approximation_options& options, Progress& progress)
{
  Progress_visitor visitor(progress);
  Approximation_result result = approximated(mesh, options, visitor);
  progress.finish();
  check_result(mesh, result, options.panels);
  return result;
}

Accuracy accuracy_of(const Approximation_result& result)
{
  Accuracy a;
  a.hausdorff = result.hausdorff;
  a.hausdorff_to_panels = result.hausdorff_to_panels;
  a.hausdorff_to_input = result.hausdorff_to_input;
  a.mean_distance = result.mean_distance;
  a.planarity_deviation = result.planarity_deviation;
  a.embedded = result.embedded;
  a.iterations = result.iterations;
  a.converged = result.converged;
  return a;
}
