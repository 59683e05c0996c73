// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the criterion by which restarts are compared ranks them as the result does.
//   restart_ranking [--k N] [--seeds N] mesh.off ...
// Restarts are compared early, by the 32-norm of the sampled distances between input and panels both ways, after the
// panels of a start were made flat and fitted once (`internal::ranks_before()`). A line for each mesh: over the seeds,
// the two-sided Hausdorff distance of the result at `Effort::fast` (least, median, largest; per cent of the diagonal),
// that of the start that the criterion prefers, its rank, and Spearman's rank correlation of criterion and result.

#include <CGAL/Multiplanar/approximate.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;

struct Start
{
  double criterion, hausdorff;
};

/// The least of what the criterion says about the partitions of one start; infinite if none leads to sound panels.
double criterion_of(const internal::Connectivity& c, const Points& source, const Flat_panels_options& options,
                    const std::vector<std::vector<int>>& partitions)
{
  internal::Panel_search_options search_options;
  search_options.max_panels = options.max_panels;
  search_options.effort = options.effort;
  search_options.threads = 1;
  search_options.min_edge = options.min_edge;
  search_options.min_width = options.min_width;
  const internal::Input_surface input = internal::make_input_surface(c, source);
  Points unit;
  for (const auto& x : input.points) unit.push_back(internal::as_point(x));
  const Label_costs costs(c, unit);
  const internal::Panel_search search(input, search_options, {});
  double least = HUGE_VAL;
  for (const auto& labels : partitions) {
    internal::Panel_model model;
    if (search.start_model(costs, labels, model) && model.faults == 0)
      least = (std::min)(least, model.merit * (1 + 0.02 * model.offences));
  }
  return least;
}

Start measure(const internal::Connectivity& c, const Points& source, int k, int seed)
{
  Approximation_options options;
  options.panels = k;
  Approximation_visitor silent;
  const auto outcome = internal::run_loop(c, source, options, seed, 1, silent);
  Flat_panels_options flat;
  flat.max_panels = k;
  flat.effort = Effort::fast;
  flat.threads = 1;
  const double percent = 100 / internal::Unit_frame(source).diagonal();
  return {criterion_of(c, source, flat, outcome.partitions),
          flat_panels(c, source, outcome.partitions, flat).hausdorff * percent};
}

std::vector<double> ranks(const std::vector<double>& values)
{
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = double(i + 1);
  return rank;
}

/// \pre no ties
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const double n = double(a.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return 1 - 6 * sum / (n * (n * n - 1));
}

void run(const std::string& file, int k, int seeds)
{
  CGAL::Surface_mesh<Point_3> mesh;
  if (!CGAL::IO::read_OFF(file, mesh)) {
    std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
    std::exit(3);
  }
  Points points;
  for (auto v : mesh.vertices()) points.push_back(mesh.point(v));
  const auto c = internal::make_connectivity(mesh);
  std::vector<double> criterion, hausdorff;
  for (int seed = 0; seed < seeds; ++seed) {
    const Start start = measure(c, points, k, seed);
    criterion.push_back(start.criterion);
    hausdorff.push_back(start.hausdorff);
  }
  std::vector<double> sorted = hausdorff;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t chosen = std::min_element(criterion.begin(), criterion.end()) - criterion.begin();
  const std::vector<double> rank = ranks(hausdorff);
  std::printf("%-18s %4d %6d %8.2f %8.2f %8.2f %8.2f %5.0f %8.2f\n", file.substr(file.find_last_of('/') + 1).c_str(), k,
              seeds, sorted.front(), sorted[sorted.size() / 2], sorted.back(), hausdorff[chosen], rank[chosen],
              rank_correlation(ranks(criterion), rank));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  int k = 50, seeds = 8;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
    if (!std::strcmp(argv[i], "--k") && i + 1 < argc) k = std::atoi(argv[++i]);
    else if (!std::strcmp(argv[i], "--seeds") && i + 1 < argc) seeds = std::atoi(argv[++i]);
    else files.push_back(argv[i]);
  if (files.empty() || seeds < 2) {
    std::fprintf(stderr, "usage: restart_ranking [--k N] [--seeds N] mesh.off ...\n");
    return 2;
  }
  std::printf("%-18s %4s %6s %8s %8s %8s %8s %5s %8s\n", "mesh", "k", "seeds", "least", "median", "largest", "chosen",
              "rank", "correl.");
  for (const std::string& file : files) run(file, k, seeds);
  return 0;
}
