// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a labelling costs, by number of faces and of labels:
//   labelling_benchmark mesh.off ... [--threads N]
// For each mesh and k: seconds for the seeds, for the first labelling (data costs, cheapest labels and
// alpha-expansion), and for a later labelling after the planes were estimated anew (the median over some passes). At k
// = 60, meshes of at most 15,000 faces are also labelled by CGAL's alpha-expansion with its Boost back end, from the
// same initial labels; building its matrix of data costs is not counted. At the end, growth exponents between
// consecutive meshes, k = 60.

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/planes.h>
#include <CGAL/Multiplanar/seeding.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

template <class Work>
double seconds(const Work& work)
{
  const double start = now();
  work();
  return now() - start;
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

struct Model
{
  internal::Connectivity connectivity;
  Points points;
};

// Scaled to unit bounding-box diagonal.
Model read_model(const std::string& file)
{
  CGAL::Surface_mesh<Point_3> mesh;
  if (!CGAL::IO::read_OFF(file, mesh)) {
    std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
    std::exit(3);
  }
  Model model{internal::make_connectivity(mesh), {}};
  CGAL::Bbox_3 box;
  for (auto v : mesh.vertices()) box += mesh.point(v).bbox();
  const double diagonal = std::sqrt(
      CGAL::squared_distance(Point_3(box.xmin(), box.ymin(), box.zmin()), Point_3(box.xmax(), box.ymax(), box.zmax())));
  for (auto v : mesh.vertices()) model.points.push_back(CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / diagonal);
  return model;
}

struct Timing
{
  double seeds, first, later;
  Alpha_expansion_result result; // of the first labelling
  double boost = 0, boost_energy = 0;
};

void run_boost(const Label_costs& costs, const Plane_costs& data, const std::vector<int>& start, Timing& timing)
{
  const Potts_graph graph = costs.potts_graph();
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::vector<double> weights;
  for (int p = 0; p < graph.nodes(); ++p)
    for (int a = graph.begin[p]; a < graph.begin[p + 1]; ++a)
      if (p < graph.adjacent[a]) {
        edges.emplace_back(p, graph.adjacent[a]);
        weights.push_back(graph.weight[a]);
      }
  std::vector<std::vector<double>> matrix(data.labels(), std::vector<double>(costs.faces()));
  for (int f = 0; f < data.labels(); ++f) data.block(f, 0, costs.faces(), matrix[f].data());
  std::vector<std::size_t> labels(start.begin(), start.end());
  timing.boost = seconds([&] {
    timing.boost_energy = CGAL::alpha_expansion_graphcut(edges, weights, matrix, labels,
                                                         CGAL::Alpha_expansion_boost_adjacency_list_tag());
  });
}

Timing measure(const Model& model, int k, int threads, bool against_boost)
{
  Alpha_expansion_options options;
  options.threads = threads;
  const Label_costs costs(model.connectivity, model.points);
  const Potts_graph graph = costs.potts_graph();
  Timing timing{};
  std::vector<Plane> planes;
  timing.seeds = seconds([&] { planes = seed_planes(costs, k, 1); });

  const Plane_costs data = costs.data_cost(planes);
  std::vector<int> labelling;
  std::vector<double> times;
  for (int repetition = 0; repetition < 5; ++repetition)
    times.push_back(seconds([&] {
      labelling = cheapest_labels(costs.faces(), k, data, threads);
      timing.result = alpha_expansion(graph, k, data, labelling, options);
    }));
  timing.first = median(times);
  if (against_boost) run_boost(costs, data, cheapest_labels(costs.faces(), k, data, threads), timing);

  times.clear();
  for (int pass = 0; pass < 9; ++pass)
    times.push_back(seconds([&] {
      estimate_planes(costs, labelling, planes);
      alpha_expansion(graph, k, costs.data_cost(planes), labelling, options);
    }));
  timing.later = median(times);
  return timing;
}

double growth(double time, double larger_time, int faces, int more_faces)
{
  return std::log(larger_time / time) / std::log(double(more_faces) / faces);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> files;
  int threads = 1;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--threads" && i + 1 < argc) threads = std::atoi(argv[++i]);
    else files.push_back(argv[i]);
  if (files.empty() || threads < 0) {
    std::fprintf(stderr, "usage: labelling_benchmark mesh.off ... [--threads N]\n");
    return 2;
  }
  struct Row
  {
    int faces;
    Timing timing;
  };
  std::vector<Row> rows;
  std::printf("%-24s %8s %4s %10s %10s %10s %7s %10s\n", "mesh", "faces", "k", "seeds s", "first s", "later s",
              "sweeps", "looked at");
  for (const std::string& file : files) {
    const Model model = read_model(file);
    const int faces = model.connectivity.number_of_faces();
    const std::string name = file.substr(file.find_last_of('/') + 1);
    for (int k : {10, 20, 30, 40, 50, 60, 70, 80, 90, 100}) {
      const bool against_boost = k == 60 && faces <= 15000;
      const Timing t = measure(model, k, threads, against_boost);
      // "looked at": nodes that the flows touched, in per cent of what expansions without pruning would look at.
      std::printf("%-24s %8d %4d %10.5f %10.5f %10.5f %7d %9.2f%%\n", name.c_str(), faces, k, t.seeds, t.first, t.later,
                  t.result.sweeps, 100. * t.result.survivors / (double(faces) * k * t.result.sweeps));
      if (against_boost)
        std::printf("%-24s %8d %4d CGAL with Boost %.3f s: ratio %.0f; energies %.12g and %.12g\n", name.c_str(), faces,
                    k, t.boost, t.boost / t.first, t.result.energy, t.boost_energy);
      std::fflush(stdout);
      if (k == 60) rows.push_back({faces, t});
    }
  }
  for (std::size_t i = 1; i < rows.size(); ++i)
    std::printf("growth exponent from %d to %d faces, k = 60: first %.2f, later %.2f\n", rows[i - 1].faces,
                rows[i].faces, growth(rows[i - 1].timing.first, rows[i].timing.first, rows[i - 1].faces, rows[i].faces),
                growth(rows[i - 1].timing.later, rows[i].timing.later, rows[i - 1].faces, rows[i].faces));
  return 0;
}
