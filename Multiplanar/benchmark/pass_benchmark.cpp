// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Seconds of a pass, deformation and guarded motion, in the approximation's own loop.
//
//   pass_benchmark [--panels K] [--passes N] [--threads N] [--solver ceres|direct|both] mesh.off ...
//
// Runs the loop on each mesh (closed, embedded; seed 0) and takes the time of every pass: `solve` is the deformation,
// `guard` the guarded motion, `pass` their sum. The first pass also sets up the solver and is told apart. Elapsed time
// is what a user waits for, on a machine that does nothing else; processor time counts all threads and tells of others'
// work least. Give one surface at several sizes, small ones first, for the exponents of growth of the medians.

#include <CGAL/Multiplanar/internal/Approximation_loop.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;
using internal::Approximation_loop;
using internal::Connectivity;

struct Arguments
{
  Approximation_options options;
  std::vector<Solver> solvers = {Solver::ceres, Solver::direct};
  std::vector<std::string> meshes;
};

const char* name(Solver solver) { return solver == Solver::ceres ? "Ceres" : "direct"; }

/// Elapsed and processor seconds.
struct Seconds
{
  double elapsed = 0, processor = 0;
  Seconds operator+(const Seconds& other) const { return {elapsed + other.elapsed, processor + other.processor}; }
  Seconds operator-(const Seconds& other) const { return {elapsed - other.elapsed, processor - other.processor}; }
};

struct Pass
{
  Seconds solve, guard;
  Seconds both() const { return solve + guard; }
};

/// Of a loop that has done nothing yet: zero.
Seconds stage(const Approximation_loop& loop, const char* name)
{
  const auto of = [&](const std::map<std::string, double>& times) {
    const auto found = times.find(name);
    return found == times.end() ? 0 : found->second;
  };
  return {of(loop.seconds()), of(loop.processor_seconds())};
}

/// The medians of both kinds of time, each by itself.
template <class F>
Seconds median(const std::vector<Pass>& passes, const F& part)
{
  std::vector<double> elapsed, processor;
  for (const Pass& pass : passes) {
    elapsed.push_back(part(pass).elapsed);
    processor.push_back(part(pass).processor);
  }
  const auto middle = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  };
  return {middle(elapsed), middle(processor)};
}

/// All passes but the first, then the first, then the sum of all with the segmentation.
struct Run
{
  std::vector<Pass> passes;
  Pass first;
  Seconds whole, segmentation;
};

Run run(const Connectivity& c, const Points& points, const Approximation_options& options)
{
  Approximation_loop loop(c, points, options, options.seed, options.threads);
  Run result;
  Seconds solve, guard;
  for (bool more = true; more;) {
    more = loop.step();
    const Seconds solve_now = stage(loop, "deformation"), guard_now = stage(loop, "guard");
    result.passes.push_back({solve_now - solve, guard_now - guard});
    solve = solve_now;
    guard = guard_now;
  }
  if (!internal::is_embedded(c, loop.points())) throw std::runtime_error("the mesh is not embedded any more");
  result.segmentation = stage(loop, "segmentation");
  result.whole = result.segmentation + solve + guard;
  result.first = result.passes.front();
  if (result.passes.size() > 1) result.passes.erase(result.passes.begin());
  return result;
}

Seconds print(Solver solver, const Run& r)
{
  const auto solve = [](const Pass& p) { return p.solve; };
  const auto guard = [](const Pass& p) { return p.guard; };
  const auto both = [](const Pass& p) { return p.both(); };
  const Seconds s = median(r.passes, solve), g = median(r.passes, guard), b = median(r.passes, both);
  double least = r.passes[0].both().elapsed, most = least;
  for (const Pass& pass : r.passes) {
    least = (std::min)(least, pass.both().elapsed);
    most = (std::max)(most, pass.both().elapsed);
  }
  std::printf(
      "  %-6s pass %.4f s elapsed (%.4f to %.4f), %.4f s processor; solve %.4f s, %.4f s; guard %.4f s, %.4f s; "
      "guard / solve %.2f, %.2f\n",
      name(solver), b.elapsed, least, most, b.processor, s.elapsed, s.processor, g.elapsed, g.processor,
      g.elapsed / s.elapsed, g.processor / s.processor);
  std::printf(
      "         first pass %.4f s, segmentation %.2f s, whole loop of %zu passes %.2f s elapsed, %.2f s processor\n",
      r.first.both().elapsed, r.segmentation.elapsed, r.passes.size() + 1, r.whole.elapsed, r.whole.processor);
  std::fflush(stdout);
  return b;
}

struct Sample
{
  double faces;
  Seconds pass;
};

void print_growth(Solver solver, const std::vector<Sample>& samples)
{
  const auto exponent = [](const Sample& a, const Sample& b, double ratio) {
    return std::log(ratio) / std::log(b.faces / a.faces);
  };
  for (std::size_t i = 1; i < samples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Sample &a = samples[j], &b = samples[i];
      if (b.faces <= a.faces) continue;
      std::printf("%-6s from %.0f to %.0f faces: exponent %.2f elapsed, %.2f processor\n", name(solver), a.faces,
                  b.faces, exponent(a, b, b.pass.elapsed / a.pass.elapsed),
                  exponent(a, b, b.pass.processor / a.pass.processor));
    }
}

void measure(const Arguments& arguments)
{
  std::map<Solver, std::vector<Sample>> samples;
  for (const std::string& path : arguments.meshes) {
    CGAL::Surface_mesh<Point_3> mesh;
    if (!CGAL::IO::read_polygon_mesh(path, mesh)) throw std::runtime_error(path + " cannot be read");
    const Connectivity c = internal::make_connectivity(mesh);
    const Points points(mesh.points().begin(), mesh.points().end());
    std::printf("%s: %d faces, k = %d, %d passes, %d threads\n", path.c_str(), c.number_of_faces(),
                arguments.options.panels, arguments.options.iterations, arguments.options.threads);
    for (Solver solver : arguments.solvers) {
      Approximation_options options = arguments.options;
      options.solver = solver;
      samples[solver].push_back({double(c.number_of_faces()), print(solver, run(c, points, options))});
    }
  }
  for (const auto& of_solver : samples) print_growth(of_solver.first, of_solver.second);
}

Arguments parse(int argc, char** argv)
{
  Arguments a;
  a.options.threads = 2;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] {
      return i + 1 < argc ? std::string(argv[++i]) : throw std::runtime_error("value missing");
    };
    if (word == "--panels") a.options.panels = std::atoi(value().c_str());
    else if (word == "--passes") a.options.iterations = std::atoi(value().c_str());
    else if (word == "--threads") a.options.threads = std::atoi(value().c_str());
    else if (word == "--solver") {
      const std::string which = value();
      if (which == "ceres") a.solvers = {Solver::ceres};
      else if (which == "direct") a.solvers = {Solver::direct};
      else if (which != "both") throw std::runtime_error("--solver is ceres, direct or both");
    } else a.meshes.push_back(word);
  }
  if (a.meshes.empty()) throw std::runtime_error("no mesh given");
  if (a.options.panels < 4 || a.options.iterations < 1 || a.options.threads < 1)
    throw std::runtime_error("at least 4 panels, 1 pass and 1 thread are needed");
  return a;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    measure(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pass_benchmark: %s\n", error.what());
    return 1;
  }
}
