// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a labelling costs, by number of faces and of labels:
//   labelling_benchmark mesh.off ...
// For each mesh and k = 10 .. 100: seconds for the seeds, for the first labelling (data costs, cheapest labels and
// alpha-expansion), and for a later labelling after the planes were estimated anew: the median over some passes, each
// from the labels of the pass before. At k = 60,
// - meshes of at most 15,000 faces are also labelled by CGAL's alpha-expansion with its Boost back end, from the same
//   initial labels (building its matrix of data costs is not counted);
// - the first labelling is repeated with all threads of the machine.
// At the end, growth exponents between consecutive meshes, k = 60. Seconds are processor time, so that other work on
// the machine does not count, except where threads are compared: there they are by the clock on the wall.

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
#include <ctime>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;

double wall_time()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double processor_time() { return double(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
double seconds(const Work& work, double (*time)() = processor_time)
{
  const double start = time();
  work();
  return time() - start;
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
  Alpha_expansion_result result, later_result; // of the first labelling, and of the last one
  double boost = 0, boost_energy = 0;
  double one_thread = 0, all_threads = 0;
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

Alpha_expansion_result label(const Label_costs& costs, const Potts_graph& graph, const Plane_costs& data, int threads,
                             std::vector<int>& labelling)
{
  Alpha_expansion_options options;
  options.threads = threads;
  labelling = cheapest_labels(costs.faces(), data.labels(), data, threads);
  return alpha_expansion(graph, data.labels(), data, labelling, options);
}

template <class Work>
std::vector<double> repeated(int times, const Work& work, double (*time)())
{
  std::vector<double> result;
  for (int i = 0; i < times; ++i) result.push_back(seconds(work, time));
  return result;
}

/// By the clock on the wall, where other work on the machine can only do harm: the least of many.
double least_wall_time(const Label_costs& costs, const Potts_graph& graph, const Plane_costs& data, int threads)
{
  std::vector<int> labelling;
  const auto times = repeated(
      25, [&] { label(costs, graph, data, threads, labelling); }, wall_time);
  return *std::min_element(times.begin(), times.end());
}

Timing measure(const Model& model, int k)
{
  const Label_costs costs(model.connectivity, model.points);
  const Potts_graph graph = costs.potts_graph();
  Timing timing{};
  std::vector<Plane> planes;
  timing.seeds = seconds([&] { planes = seed_planes(costs, k, 1); });

  const Plane_costs data = costs.data_cost(planes);
  std::vector<int> labelling;
  timing.first = median(repeated(
      5, [&] { timing.result = label(costs, graph, data, 1, labelling); }, processor_time));
  if (k == 60) {
    if (costs.faces() <= 15000) run_boost(costs, data, cheapest_labels(costs.faces(), k, data), timing);
    timing.one_thread = least_wall_time(costs, graph, data, 1);
    timing.all_threads = least_wall_time(costs, graph, data, 0);
  }

  const auto pass = [&] {
    estimate_planes(costs, labelling, planes);
    timing.later_result = alpha_expansion(graph, k, costs.data_cost(planes), labelling);
  };
  timing.later = median(repeated(9, pass, processor_time));
  return timing;
}

// "looked at": nodes that the flows touched, in per cent of what expansions without pruning would look at.
double looked_at(const Alpha_expansion_result& result, int faces, int k)
{
  return 100. * double(result.survivors) / (double(faces) * k * result.sweeps);
}

void print(const std::string& name, int faces, int k, const Timing& t)
{
  std::printf("%-18s %7d %4d %9.5f %9.5f %6d %8.2f%% %9.5f %8.2f%%\n", name.c_str(), faces, k, t.seeds, t.first,
              t.result.sweeps, looked_at(t.result, faces, k), t.later, looked_at(t.later_result, faces, k));
  if (t.boost > 0)
    std::printf("%-18s %7d %4d CGAL with Boost %.3f s: ratio %.0f; energies %.12g and %.12g\n", name.c_str(), faces, k,
                t.boost, t.boost / t.first, t.result.energy, t.boost_energy);
  if (t.all_threads > 0)
    std::printf("%-18s %7d %4d by the clock: one thread %.5f s, all %u threads %.5f s: gain %.2f\n", name.c_str(),
                faces, k, t.one_thread, std::thread::hardware_concurrency(), t.all_threads,
                t.one_thread / t.all_threads);
  std::fflush(stdout);
}

double growth(double time, double larger_time, int faces, int more_faces)
{
  return std::log(larger_time / time) / std::log(double(more_faces) / faces);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "usage: labelling_benchmark mesh.off ...\n");
    return 2;
  }
  struct Row
  {
    int faces;
    Timing timing;
  };
  std::vector<Row> rows;
  std::printf("%-18s %7s %4s %9s %9s %6s %9s %9s %9s\n", "mesh", "faces", "k", "seeds s", "first s", "sweeps",
              "looked at", "later s", "looked at");
  for (int i = 1; i < argc; ++i) {
    const std::string file = argv[i];
    const Model model = read_model(file);
    const int faces = model.connectivity.number_of_faces();
    for (int k : {10, 20, 30, 40, 50, 60, 70, 80, 90, 100}) {
      const Timing t = measure(model, k);
      print(file.substr(file.find_last_of('/') + 1), faces, k, t);
      if (k == 60) rows.push_back({faces, t});
    }
  }
  for (std::size_t i = 1; i < rows.size(); ++i)
    std::printf("growth exponent from %d to %d faces, k = 60: first %.2f, later %.2f\n", rows[i - 1].faces,
                rows[i].faces, growth(rows[i - 1].timing.first, rows[i].timing.first, rows[i - 1].faces, rows[i].faces),
                growth(rows[i - 1].timing.later, rows[i].timing.later, rows[i - 1].faces, rows[i].faces));
  return 0;
}
