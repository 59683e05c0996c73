// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Partitions of meshes into panels that can be flat, checked: a line for each mesh and number of panels.
// Usage: partition_check MESH.off ...   (exit code 1 if any partition breaks a promise)

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>
#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/panel_partition_problems.h>
#include <CGAL/Multiplanar/seeding.h>

#include "../../test/Multiplanar/meshes.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

using namespace CGAL::Multiplanar;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Labels as the first pass of an approximation has them: seeds, nearest planes, some rounds of refitting, optionally
/// alpha-expansion.
std::vector<int> first_labels(const Label_costs& costs, int k, bool smooth, unsigned seed)
{
  std::vector<Plane> planes = seed_planes(costs, k, seed);
  std::vector<int> labels;
  for (int round = 0; round < 4; ++round) {
    labels = cheapest_labels(costs.faces(), k, costs.data_cost(planes));
    if (smooth) alpha_expansion(costs.potts_graph(), k, costs.data_cost(planes), labels);
    estimate_planes(costs, labels, planes);
  }
  return labels;
}

} // namespace

int main(int argc, char** argv)
{
  int failures = 0;
  std::printf("%-18s %3s %-6s %6s %6s %5s %5s %6s %6s %6s %5s %9s %9s %8s %8s\n", "mesh", "k", "labels", "pieces",
              "panels", "merge", "split", "flips", "chords", "probl.", "val>3", "cost in", "cost out", "light ms",
              "full ms");
  for (int i = 1; i < argc; ++i) {
    const std::string path = argv[i];
    const auto mesh = Multiplanar_test::normalised(Multiplanar_test::read_off(path));
    const auto c = internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
    const Label_costs costs(c, mesh.points);
    for (int k : {6, 12, 30, 50, 70, 90}) {
      if (k < 4 + 3 * c.genus()) continue;
      for (bool smooth : {true, false}) {
        const std::vector<int> start = first_labels(costs, k, smooth, 0);
        Panel_partition_options options;
        options.max_panels = k;
        std::vector<int> labels = start;
        options.realisable = false;
        auto time = std::chrono::steady_clock::now();
        make_panels(c, mesh.points, costs, labels, options);
        const double light = seconds_since(time);
        labels = start;
        options.realisable = true;
        time = std::chrono::steady_clock::now();
        const auto report = make_panels(c, mesh.points, costs, labels, options);
        const double full = seconds_since(time);
        int chords = 0;
        const auto problems = partition_problems(c, mesh.points, labels, report.panels);
        for (const auto& p : problems) chords += p.kind == Partition_problem::chord;
        const bool bad = !problems.empty() || report.panels > k || !report.ok;
        failures += bad;
        const auto& valences = report.corner_valences;
        std::printf("%-18s %3d %-6s %6d %6d %5d %5d %6d %6d %6d %5d %9.5f %9.5f %8.1f %8.1f%s",
                    path.substr(path.rfind('/') + 1).c_str(), k, smooth ? "alpha" : "kmeans", report.pieces_before,
                    report.panels, report.merges, report.splits, report.relabelled_faces, chords, int(problems.size()),
                    valences[4] + valences[5] + valences[6] + valences[7], report.cost_before, report.cost_after,
                    1e3 * light, 1e3 * full, bad ? "  FAILED" : "");
        if (report.attempt > 0) std::printf("  attempt %d", report.attempt);
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
  std::printf("%d failures\n", failures);
  return failures > 0;
}
