// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Partitions of meshes into panels that can be flat, checked: a line for each mesh, number of panels k = 4 + 3 genus,
// 6, 12, 30, 50, 70, 90, and kind of labels. Meshes that are not closed or not connected are skipped.
//   partition_check MESH.off ...   (exit code 1 if any partition breaks a promise)

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/panel_complex_problems.h>
#include <CGAL/Multiplanar/panel_partition.h>
#include <CGAL/Multiplanar/panel_partition_problems.h>
#include <CGAL/Multiplanar/seeding.h>

#include "../../test/Multiplanar/meshes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

using namespace CGAL::Multiplanar;

namespace {

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

/// Median wall-clock milliseconds of three runs.
template <class F>
double milliseconds(F run)
{
  std::vector<double> times;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    times.push_back(1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[1];
}

/// How often panels were counted, and in how many of these cases some were left unused.
struct Tally
{
  int partitions = 0, failures = 0, wanted_many = 0, used_few = 0;
};

/// Prints a line.
void check(const std::string& name, const internal::Connectivity& c, const Points& points, const Label_costs& costs,
           int k, bool smooth, Tally& tally)
{
  const std::vector<int> start = first_labels(costs, k, smooth, 0);
  Panel_partition_options options;
  options.max_panels = k;
  std::vector<int> labels;
  Panel_partition_report report;
  const auto run = [&] {
    labels = start;
    report = make_panels(c, points, costs, labels, options);
  };
  options.realisable = false;
  const double light = milliseconds(run);
  options.realisable = true;
  const double full = milliseconds(run);

  int chords = 0;
  const auto problems = partition_problems(c, points, labels, report.panels);
  for (const auto& p : problems) chords += p.kind == Partition_problem::chord;
  int large_corners = 0;
  for (std::size_t n = 4; n < report.corner_valences.size(); ++n) large_corners += report.corner_valences[n];
  const bool good = problems.empty() && report.panels <= k && report.ok;
  std::printf("%-18s %6d %5d %3d %-6s %6d %6d %6d %6d %5d %6d %6d %6d %6d %8.4f %8.4f %8.1f %8.1f", name.c_str(),
              c.number_of_faces(), c.genus(), k, smooth ? "alpha" : "kmeans", report.pieces_before, report.panels,
              int(problems.size()), chords, large_corners, report.merges, report.splits, report.relabelled_faces,
              report.attempt, report.cost_before, report.cost_after, light, full);
  const bool few = k >= 30 && 10 * report.panels < 9 * k; // right on shapes made of few planes
  std::printf("%s\n", good ? few ? "  few" : "" : "  FAILED");
  std::fflush(stdout);
  ++tally.partitions;
  tally.failures += !good;
  tally.wanted_many += k >= 30;
  tally.used_few += few;
}

} // namespace

int main(int argc, char** argv)
{
  std::printf("%-18s %6s %5s %3s %-6s %6s %6s %6s %6s %5s %6s %6s %6s %6s %8s %8s %8s %8s\n", "mesh", "faces", "genus",
              "k", "labels", "pieces", "panels", "probl.", "chords", "val>3", "merges", "splits", "flips", "starts",
              "cost in", "cost out", "light ms", "full ms");
  Tally tally;
  int meshes = 0, handles = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string path = argv[i], name = path.substr(path.rfind('/') + 1);
    try {
      const auto mesh = Multiplanar_test::normalised(Multiplanar_test::read_off(path));
      const auto c = internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
      std::vector<int> whole(c.number_of_faces(), 0);
      if (internal::label_connected_pieces(c, whole) > 1) throw std::invalid_argument("several components");
      const Label_costs costs(c, mesh.points);
      const int fewest = 4 + 3 * c.genus();
      for (int k : {fewest, 6, 12, 30, 50, 70, 90})
        if (k >= fewest && k <= c.number_of_faces())
          for (bool smooth : {true, false}) check(name, c, mesh.points, costs, k, smooth, tally);
      ++meshes;
      handles += c.genus() > 0;
    } catch (const std::exception& e) {
      std::printf("%-18s skipped: %s\n", name.c_str(), e.what());
    }
  }
  std::printf("%d meshes, %d of them with handles; %d partitions, %d failures; less than 0.9 k panels in %d of %d with "
              "k >= 30\n",
              meshes, handles, tally.partitions, tally.failures, tally.used_few, tally.wanted_many);
  return tally.failures > 0;
}
