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

/// What the search knows of a start, and what comes of it: the better of its partitions by the criterion, finished.
Start measure(const internal::Connectivity& c, const Points& source, int k, int seed)
{
  Approximation_options options;
  options.panels = k;
  Approximation_visitor silent;
  const auto outcome = internal::run_loop(c, source, options, seed, 1, silent);

  const Flat_panels_options flat; // with its measures of what is too small
  internal::Panel_search_options search_options;
  search_options.max_panels = k;
  search_options.threads = 1;
  search_options.min_edge = flat.min_edge;
  search_options.min_width = flat.min_width;
  const internal::Input_surface input = internal::make_input_surface(c, source);
  Points unit;
  for (const auto& x : input.points) unit.push_back(internal::as_point(x));
  const Label_costs costs(c, unit);
  const internal::Panel_search search(input, search_options, {});
  internal::Panel_model best;
  Start start{HUGE_VAL, HUGE_VAL};
  for (const auto& labels : outcome.partitions) {
    internal::Panel_model model;
    if (!search.start_model(costs, labels, model) || model.faults > 0) continue;
    const double criterion = model.cost() * (1 + 0.02 * model.offences);
    if (!(criterion < start.criterion)) continue;
    start.criterion = criterion;
    best = std::move(model);
  }
  if (start.criterion == HUGE_VAL) return start;

  internal::Accuracy_options last; // as the search ends
  last.min_edge = flat.min_edge;
  last.powers = {16, 32, 64, 128};
  last.steps = 20;
  last.least_gain = 1e-4;
  const internal::Panel_modeller modeller(input, std::sqrt(input.area / 3000), flat.min_edge, flat.min_width);
  modeller.improve_all(best, last);
  Flat_panels_result result = internal::result_of(c, source, input, best);
  internal::measure_panels(c, source, input.scale, result);
  start.hausdorff = 100 * result.hausdorff / internal::Unit_frame(source).diagonal();
  return start;
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
