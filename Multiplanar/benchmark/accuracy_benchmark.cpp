// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How close exactly flat panels come to a model, beside CGAL's variational shape approximation in the same process.
//
//   accuracy_benchmark [--k 30,50,70,90] [--effort fast|normal|best] [--seed N] [--threads N] [--time SECONDS]
//   [--work FACTOR]
//   MESH.off...
//
// One line a mesh and k: the symmetric Hausdorff distances of both in percent of the bounding-box diagonal, each within
// 1e-4 of the diagonal, their ratio, and what was checked on our panels. At the end the geometric mean of the ratios.

#include "../comparison/other_methods.h"
#include "../comparison/surface_quality.h"

#include <CGAL/Multiplanar/flat_panels.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;
using Mesh = CGAL::Surface_mesh<Point_3>;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Is the triangulated surface of the panels closed and embedded? Exact.
bool is_closed_and_embedded(const Panel_complex& complex)
{
  const comparison::Compared_surface surface = comparison::surface_of_panels(complex);
  return comparison::is_closed_manifold(surface.triangles) &&
         comparison::number_of_intersections(surface.points, surface.triangles) == 0;
}

double shortest_edge(const Panel_complex& complex)
{
  double result = 1e300;
  for (int e = 0; e < complex.number_of_edges(); ++e) result = (std::min)(result, complex.edge_length(e));
  return result;
}

std::vector<int> numbers(const std::string& text)
{
  std::vector<int> result;
  std::stringstream in(text);
  for (std::string item; std::getline(in, item, ',');) result.push_back(std::atoi(item.c_str()));
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<int> ks{30, 50, 70, 90};
  std::vector<std::string> files;
  Flat_panels_options options;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    if (a.compare(0, 2, "--") != 0) {
      files.push_back(a);
      continue;
    }
    if (i + 1 == argc) {
      std::fprintf(stderr, "%s needs a value\n", a.c_str());
      return 2;
    }
    const std::string value = argv[++i];
    if (a == "--k") ks = numbers(value);
    if (a == "--effort")
      options.effort = value == "fast" ? Effort::fast : value == "best" ? Effort::best : Effort::normal;
    if (a == "--seed") options.seed = std::uint64_t(std::atoll(value.c_str()));
    if (a == "--threads") options.threads = std::atoi(value.c_str());
    if (a == "--work") options.work = std::atof(value.c_str());
    if (a == "--time") options.time_limit = std::atof(value.c_str());
  }
  std::printf("%-18s %3s %7s %7s %7s %7s %7s %7s %7s %9s %5s %8s %7s\n", "mesh", "k", "VSA %", "ours %", "ratio",
              "to pan", "to inp", "mean %", "panels", "flatness", "ok", "edge %", "seconds");
  double logs = 0;
  int runs = 0, good = 0;
  std::map<int, std::pair<double, int>> by_k;
  for (const std::string& file : files) {
    Mesh mesh;
    if (!CGAL::IO::read_OFF(file, mesh)) {
      std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
      return 3;
    }
    Points points;
    for (const auto v : mesh.vertices()) points.push_back(mesh.point(v));
    const auto c = internal::make_connectivity(mesh);
    const double diagonal = internal::bounding_box_diagonal(internal::as_vecs(points));
    const std::string name = file.substr(file.find_last_of('/') + 1);
    for (int k : ks) {
      const comparison::Compared_surface proxies = comparison::surface_of_vsa(mesh, k);
      const double vsa =
          symmetric_hausdorff(points, c.triangles, proxies.points, proxies.triangles, 1e-4 * diagonal).upper();
      options.max_panels = k;
      const double begin = seconds();
      const Flat_panels_result r = flat_panels(c, points, {}, options);
      const double time = seconds() - begin;
      const bool ok = r.ok && r.complex.number_of_panels() <= k && is_closed_and_embedded(r.complex) &&
                      r.complex.planarity_deviation() < 1e-9 * diagonal;
      const double ratio = r.ok ? r.hausdorff / vsa : 1;
      std::printf("%-18s %3d %7.2f %7.2f %7.3f %7.2f %7.2f %7.3f %7d %9.1e %5s %8.3f %7.1f", name.c_str(), k,
                  100 * vsa / diagonal, 100 * r.hausdorff / diagonal, ratio, 100 * r.to_panels / diagonal,
                  100 * r.to_input / diagonal, 100 * r.mean / diagonal, r.complex.number_of_panels(),
                  r.complex.planarity_deviation() / diagonal, ok ? "yes" : "NO",
                  100 * shortest_edge(r.complex) / diagonal, time);
      for (const std::string& note : r.notes) std::printf(" (%s)", note.c_str());
      std::printf("\n");
      std::fflush(stdout);
      logs += std::log(ratio), ++runs, good += ok;
      by_k[k].first += std::log(ratio), ++by_k[k].second;
    }
  }
  if (runs == 0) return 0;
  std::printf("geometric mean of ours / VSA: %.3f; all promises kept in %d of %d runs;", std::exp(logs / runs), good,
              runs);
  for (const auto& item : by_k) std::printf(" k=%d %.3f", item.first, std::exp(item.second.first / item.second.second));
  std::printf("\n");
  return good == runs ? 0 : 1;
}
