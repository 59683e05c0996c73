// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of an approximation goes, by faces and by k, beside CGAL's own methods in the same process.
//
//   stage_benchmark [--k 50] [--effort fast|normal] [--threads 1] [--sizes 2000,10000] mesh.off ...
//
// A line a mesh and k, in seconds of processor time of all threads: the stages of the paper's loop (50 passes at most),
// the exactly flat panels with the mesh moved onto them, all of it, then CGAL's variational shape approximation and
// quadric edge collapses. Memory is the peak of the process beyond what it had at the start, over the faces: meaningful
// if meshes come small ones first. With several meshes or several k, the exponents of growth follow: of the total, each
// from one line to the next and from the first to the last. With --sizes, each mesh is first brought to these numbers
// of faces by edge collapses.

#include "../comparison/other_methods.h"

#include <CGAL/Multiplanar/approximate.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace {

using namespace CGAL::Multiplanar;
using internal::Connectivity;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

double peak_kilobytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss);
}

struct Line
{
  double faces = 0, k = 0, segmentation = 0, deformation = 0, guard = 0, panels = 0, vsa = 0, qem = 0, kilobytes = 0;
  int passes = 0;
  double total() const { return segmentation + deformation + guard + panels; }
};

template <class Work>
double seconds_of(const Work& work)
{
  const double begin = processor_seconds();
  work();
  return processor_seconds() - begin;
}

/// The loop, stage by stage, and what it leaves for the finish.
std::vector<std::vector<int>> run_loop(const Connectivity& c, const Points& points,
                                       const Approximation_options& options, Line& line)
{
  internal::Approximation_loop loop(c, points, options, options.seed, options.threads);
  const std::vector<int> first_labels = loop.realisable_labels();
  while (loop.step()) {
  }
  loop.finish_labels();
  const auto& seconds = loop.processor_seconds();
  line.segmentation = seconds.at("segmentation");
  line.deformation = seconds.at("deformation");
  line.guard = seconds.at("guard");
  line.passes = loop.passes();
  return {first_labels, loop.labels()};
}

Line measure(const Connectivity& c, const Points& points, const Approximation_options& options, double kilobytes)
{
  Line line;
  line.faces = c.number_of_faces();
  line.k = options.panels;
  const auto partitions = run_loop(c, points, options, line);
  Approximation_visitor silent;
  Approximation_result result;
  line.panels = seconds_of([&] { internal::finish(c, points, partitions, options, silent, result); });
  if (result.complex.number_of_panels() == 0) throw std::runtime_error("no panels were found");
  line.kilobytes = (peak_kilobytes() - kilobytes) / line.faces;
  const comparison::Compared_mesh mesh = comparison::compared_mesh(c, points);
  line.vsa = seconds_of([&] { comparison::surface_of_vsa(mesh, options.panels); });
  line.qem = seconds_of([&] { comparison::surface_of_qem(mesh, options.panels); });
  return line;
}

void print(const Line& l)
{
  std::printf("| %.0f | %.0f | %d | %.2f | %.2f | %.2f | %.2f | %.2f | %.1f | %.2f | %.2f |\n", l.faces, l.k, l.passes,
              l.segmentation, l.deformation, l.guard, l.panels, l.total(), l.kilobytes, l.vsa, l.qem);
  std::fflush(stdout);
}

double exponent(const Line& a, const Line& b, double Line::*size)
{
  return std::log(b.total() / a.total()) / std::log(b.*size / a.*size);
}

/// Of the total, where one size changes and the other does not.
void print_growth(const std::vector<Line>& lines, const char* name, double Line::*size, double Line::*other)
{
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j)
      if (lines[i].*other == lines[j].*other && lines[i].*size < lines[j].*size)
        std::printf("from %.0f to %.0f %s: exponent %.2f\n", lines[i].*size, lines[j].*size, name,
                    exponent(lines[i], lines[j], size));
}

std::vector<int> numbers(const std::string& text)
{
  std::vector<int> result;
  std::stringstream in(text);
  for (std::string item; std::getline(in, item, ',');) result.push_back(std::atoi(item.c_str()));
  return result;
}

struct Arguments
{
  std::vector<int> ks{50}, sizes;
  std::vector<std::string> files;
  Approximation_options options;
};

Arguments parse(int argc, char** argv)
{
  Arguments a;
  a.options.effort = Effort::fast;
  a.options.threads = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] {
      return i + 1 < argc ? std::string(argv[++i]) : throw std::runtime_error(word + " needs a value");
    };
    if (word == "--k") a.ks = numbers(value());
    else if (word == "--sizes") a.sizes = numbers(value());
    else if (word == "--threads") a.options.threads = std::atoi(value().c_str());
    else if (word == "--effort") a.options.effort = value() == "normal" ? Effort::normal : Effort::fast;
    else a.files.push_back(word);
  }
  if (a.files.empty()) throw std::runtime_error("no mesh given");
  return a;
}

bool is_embedded(const comparison::Compared_surface& s)
{
  return internal::is_embedded(internal::make_connectivity(s.triangles, int(s.points.size())), s.points);
}

/// The mesh of a file, or that mesh with about `faces` faces if this is not 0: QEM does not look for intersections, and
/// where it makes some, faces are taken away until there are none.
comparison::Compared_surface read(const std::string& file, int faces)
{
  comparison::Compared_mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error(file + " cannot be read");
  for (int percent = 100; percent > 70; --percent) {
    const int wanted = faces > 0 ? int(faces * (percent / 100.0)) : int(mesh.number_of_faces());
    const comparison::Compared_surface surface = comparison::surface_of_qem(mesh, wanted);
    if (is_embedded(surface)) return surface;
    if (faces == 0) break;
  }
  throw std::runtime_error(file + " intersects itself");
}

void measure_all(const Arguments& arguments)
{
  std::printf("| faces | k | passes | segmentation | deformation | guard | flat panels | all, s | kB a face | VSA, s | "
              "QEM, s |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  const double kilobytes = peak_kilobytes();
  std::vector<Line> lines;
  for (const std::string& file : arguments.files)
    for (int size : arguments.sizes.empty() ? std::vector<int>{0} : arguments.sizes) {
      const comparison::Compared_surface surface = read(file, size);
      const Connectivity c = internal::make_connectivity(surface.triangles, int(surface.points.size()));
      for (int k : arguments.ks) {
        Approximation_options options = arguments.options;
        options.panels = k;
        lines.push_back(measure(c, surface.points, options, kilobytes));
        print(lines.back());
      }
    }
  print_growth(lines, "faces", &Line::faces, &Line::k);
  print_growth(lines, "panels", &Line::k, &Line::faces);
}

} // namespace

int main(int argc, char** argv)
{
  try {
    measure_all(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stage_benchmark: %s\n", error.what());
    return 1;
  }
}
