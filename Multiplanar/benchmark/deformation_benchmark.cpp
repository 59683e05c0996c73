// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The two models of MultiplanarDeformationSolver on the same passes.
//
//   deformation_benchmark [--panels K] [--passes N] [--threads N] [--smoothness W] mesh.off ...
//
// Give the same surface at several sizes, small ones first, to read how time grows. For each mesh and model: the time
// to set up, the median and largest time of a solve, each stage's share of the median solve, the largest disagreement
// of the models, and memory a face (peak of the process over what it held before, where the system tells).

#include "../../test/Multiplanar/meshes.h"

#include <CGAL/Multiplanar/Ceres_deformation_solver.h>
#include <CGAL/Multiplanar/Cholmod_deformation_solver.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using namespace CGAL::Multiplanar;
using internal::Connectivity;

struct Arguments
{
  int panels = 50;
  int passes = 12;
  int threads = 2;
  double smoothness = 0;
  std::vector<std::string> meshes;
};

struct Problem
{
  Connectivity connectivity;
  Points rest;
  std::vector<int> labels;
};

using Stages = std::vector<std::pair<const char*, double>>;

struct Result
{
  double setup = 0;
  std::vector<double> seconds; // of each solve
  Stages stages;               // of the last solve
  double bytes_per_face = 0;
  std::vector<Points> targets;

  double median() const
  {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
  double largest() const { return *std::max_element(seconds.begin(), seconds.end()); }
};

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// A line of /proc/self/status in bytes; 0 where there is no such file.
double memory(const std::string& what)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == what + ":") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// Gives freed memory back and starts a new peak.
void reset_peak_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}

std::vector<Vector_3> mean_normals(const Connectivity& c, const Points& points, const std::vector<int>& labels, int k)
{
  std::vector<Vector_3> normals(k, CGAL::NULL_VECTOR);
  for (int f = 0; f < c.number_of_faces(); ++f)
    normals[labels[f]] = normals[labels[f]] + internal::area_vector(c, points, f);
  for (Vector_3& n : normals)
    if (n.squared_length() > 0) n = n / std::sqrt(n.squared_length());
  return normals;
}

/// k clusters of faces by normal and place, from evenly spread seeds (Lloyd's iteration).
std::vector<int> clusters(const Connectivity& c, const Points& points, int k)
{
  const int faces = c.number_of_faces();
  std::vector<Point_3> centre(k), middle(faces);
  for (int f = 0; f < faces; ++f) {
    const auto& t = c.triangles[f];
    middle[f] = CGAL::centroid(points[t[0]], points[t[1]], points[t[2]]);
  }
  std::vector<int> labels(faces);
  std::vector<Vector_3> normals(k);
  for (int i = 0; i < k; ++i) {
    const int seed = int(static_cast<long long>(i) * faces / k);
    centre[i] = middle[seed];
    const Vector_3 n = internal::area_vector(c, points, seed);
    normals[i] = n.squared_length() > 0 ? n / std::sqrt(n.squared_length()) : n;
  }
  for (int round = 0; round < 8; ++round) {
    std::vector<Vector_3> sum(k, CGAL::NULL_VECTOR);
    std::vector<double> count(k, 0);
    for (int f = 0; f < faces; ++f) {
      Vector_3 n = internal::area_vector(c, points, f);
      if (n.squared_length() > 0) n = n / std::sqrt(n.squared_length());
      double best = 1e300;
      for (int i = 0; i < k; ++i) {
        const double cost = (n - normals[i]).squared_length() + 8 * CGAL::squared_distance(middle[f], centre[i]);
        if (cost < best) {
          best = cost;
          labels[f] = i;
        }
      }
      sum[labels[f]] = sum[labels[f]] + (middle[f] - CGAL::ORIGIN);
      count[labels[f]] += 1;
    }
    normals = mean_normals(c, points, labels, k);
    for (int i = 0; i < k; ++i)
      if (count[i] > 0) centre[i] = CGAL::ORIGIN + sum[i] / count[i];
  }
  return labels;
}

Stages stages(const Cholmod_deformation_solver& solver)
{
  const internal::Deformation_stage_times& t = solver.stage_times();
  return {{"coefficients", t.coefficients},
          {"assembly", t.assembly},
          {"factorization", t.factorization},
          {"substitution", t.substitution}};
}

Stages stages(const Ceres_deformation_solver& solver)
{
  const ceres::Solver::Summary& s = solver.summary();
  return {{"preprocessing", s.preprocessor_time_in_seconds},
          {"evaluation", s.residual_evaluation_time_in_seconds + s.jacobian_evaluation_time_in_seconds},
          {"linear solver", s.linear_solver_time_in_seconds}};
}

template <class Solver>
Result run(const Problem& problem, const Arguments& arguments)
{
  Result result;
  reset_peak_memory();
  const double held = memory("VmRSS");
  Deformation_weights weights;
  weights.smoothness = arguments.smoothness;
  double begin = now();
  Solver solver(problem.connectivity, problem.rest, weights, arguments.threads);
  result.setup = now() - begin;
  Points current = problem.rest;
  for (int pass = 0; pass < arguments.passes; ++pass) {
    const std::vector<Vector_3> normals = mean_normals(problem.connectivity, current, problem.labels, arguments.panels);
    begin = now();
    Points target;
    if (!solver.solve(current, problem.labels, normals, weights.flattening(pass, arguments.passes), {}, target))
      throw std::runtime_error("a solve failed");
    result.seconds.push_back(now() - begin);
    result.targets.push_back(target);
    // A mesh that follows without a guard could fold; the systems stay alike if it goes a part of the way.
    for (std::size_t v = 0; v < current.size(); ++v) current[v] = CGAL::midpoint(current[v], target[v]);
  }
  result.stages = stages(solver);
  result.bytes_per_face = (memory("VmHWM") - held) / problem.connectivity.number_of_faces();
  return result;
}

double largest_disagreement(const Result& a, const Result& b)
{
  double squared = 0;
  for (std::size_t pass = 0; pass < a.targets.size(); ++pass)
    for (std::size_t v = 0; v < a.targets[pass].size(); ++v)
      squared = (std::max)(squared, CGAL::squared_distance(a.targets[pass][v], b.targets[pass][v]));
  return std::sqrt(squared);
}

void print(const char* name, const Result& r)
{
  std::printf("  %-8s set-up %.3f s, solve %.4f s (largest %.4f), %.2f kB a face:", name, r.setup, r.median(),
              r.largest(), r.bytes_per_face / 1000);
  double rest = 1;
  for (const auto& stage : r.stages) {
    const double share = stage.second / r.seconds.back();
    std::printf(" %s %.0f%%,", stage.first, 100 * share);
    rest -= share;
  }
  std::printf(" other %.0f%%\n", 100 * rest);
}

Problem read(const std::string& path, int panels)
{
  Multiplanar_test::Mesh mesh = Multiplanar_test::normalised(Multiplanar_test::read_off(path));
  Problem problem;
  problem.connectivity = internal::make_connectivity(std::move(mesh.triangles), int(mesh.points.size()));
  problem.rest = std::move(mesh.points);
  problem.labels = clusters(problem.connectivity, problem.rest, panels);
  return problem;
}

Arguments parse(int argc, char** argv)
{
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::atof(argv[++i]) : throw std::runtime_error("value missing"); };
    if (word == "--panels") a.panels = int(value());
    else if (word == "--passes") a.passes = int(value());
    else if (word == "--threads") a.threads = int(value());
    else if (word == "--smoothness") a.smoothness = value();
    else a.meshes.push_back(word);
  }
  if (a.meshes.empty()) throw std::runtime_error("no mesh given");
  return a;
}

void compare(const Arguments& arguments)
{
  double faces = 0, ceres = 0, direct = 0; // of the mesh before
  double first_faces = 0, first_ceres = 0, first_direct = 0;
  for (const std::string& path : arguments.meshes) {
    const Problem problem = read(path, arguments.panels);
    const double n = problem.connectivity.number_of_faces();
    std::printf("%s: %.0f faces, %d panels, %d passes\n", path.c_str(), n, arguments.panels, arguments.passes);
    const Result a = run<Cholmod_deformation_solver>(problem, arguments);
    const Result b = run<Ceres_deformation_solver>(problem, arguments);
    print("CHOLMOD", a);
    print("Ceres", b);
    std::printf("  Ceres / CHOLMOD %.2f, largest disagreement %.1e\n", b.median() / a.median(),
                largest_disagreement(a, b));
    if (faces > 0 && n > faces)
      std::printf("  exponent since the last mesh: CHOLMOD %.2f, Ceres %.2f; since the first: %.2f, %.2f\n",
                  std::log(a.median() / direct) / std::log(n / faces),
                  std::log(b.median() / ceres) / std::log(n / faces),
                  std::log(a.median() / first_direct) / std::log(n / first_faces),
                  std::log(b.median() / first_ceres) / std::log(n / first_faces));
    faces = n;
    ceres = b.median();
    direct = a.median();
    if (first_faces == 0) {
      first_faces = faces;
      first_ceres = ceres;
      first_direct = direct;
    }
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  try {
    compare(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "deformation_benchmark: %s\n", error.what());
    return 1;
  }
}
