// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Seconds of one pass of guarded motion, by size of the mesh and of the displacements.
//
// Usage: guard_benchmark mesh.off ...   (closed meshes; sizes of one shape give growth exponents)
//
// All vertices move, by a smooth random field whose largest displacement is a multiple of the mean edge length. A line
// gives the medians of several passes: processor time of the whole (one thread), elapsed time of the broad phase (swept
// boxes, tree, candidate pairs, clearance) and of the narrow phase (the moves), and what happened. Then: the candidate
// pairs by tree and by box_intersection_d, in the same run, and the check of the whole mesh beside CGAL's own.

#include <CGAL/Multiplanar/internal/Guarded_motion.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Multiplanar;
using namespace CGAL::Multiplanar::internal;
using Surface = CGAL::Surface_mesh<Point_3>;

constexpr int repetitions = 5;

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

template <class F>
double median_seconds(F f)
{
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    CGAL::Timer timer;
    timer.start();
    f();
    seconds.push_back(timer.time());
  }
  return median(seconds);
}

double mean_edge(const Connectivity& c, const Points& points)
{
  double sum = 0;
  for (const auto& t : c.triangles)
    for (int i = 0; i < 3; ++i) sum += std::sqrt(CGAL::squared_distance(points[t[i]], points[t[(i + 1) % 3]]));
  return sum / (3 * c.number_of_faces());
}

/// A random vector per vertex, averaged over neighbours a few times, the longest of length 1.
std::vector<Vector_3> smooth_field(const Connectivity& c, int smoothings)
{
  std::mt19937_64 engine(1);
  const auto number = [&] { return double(engine() >> 11) * 0x1p-52 - 1; };
  std::vector<Vector_3> field;
  for (int v = 0; v < c.number_of_vertices(); ++v) {
    const double x = number(), y = number(), z = number();
    field.emplace_back(x, y, z);
  }
  for (int i = 0; i < smoothings; ++i) {
    std::vector<Vector_3> sum(field.size(), Vector_3(0, 0, 0));
    for (const auto& t : c.triangles)
      for (int v : t) sum[v] = sum[v] + field[t[0]] + field[t[1]] + field[t[2]];
    for (std::size_t v = 0; v < field.size(); ++v) field[v] = sum[v] / (3. * double(c.star(int(v)).size()));
  }
  double longest = 0;
  for (const Vector_3& d : field) longest = (std::max)(longest, d.squared_length());
  for (Vector_3& d : field) d = d / std::sqrt(longest);
  return field;
}

struct Size
{
  const char* name;
  double edges;
};
const Size sizes[] = {{"small", 1e-3}, {"medium", 0.1}, {"large", 1}, {"huge", 3}};

double pass(const Connectivity& c, const Points& points, const Size& size, const std::vector<Vector_3>& field)
{
  Points targets;
  const double scale = size.edges * mean_edge(c, points);
  for (std::size_t v = 0; v < points.size(); ++v) targets.push_back(points[v] + scale * field[v]);
  Guarded_motion guard(c);
  std::vector<double> broad, narrow, total;
  Guard_statistics s;
  for (int i = 0; i < repetitions; ++i) {
    Points moved = points;
    total.push_back(-1);
    CGAL::Timer timer;
    timer.start();
    s = guard.move(moved, targets);
    total.back() = timer.time();
    broad.push_back(s.broad_seconds);
    narrow.push_back(s.narrow_seconds);
  }
  std::printf("  %-7s %6.3f edges: %8.4f s cpu; elapsed: broad %.4f, narrow %.4f; %zu moved, %zu partial, %zu refused; "
              "%zu pairs, %.2f%% cleared, %zu exact tests, %d rounds\n",
              size.name, size.edges, median(total), median(broad), median(narrow), s.moved, s.partial, s.refused,
              s.candidate_pairs, 100. * double(s.skipped_by_clearance) / double(s.candidate_pairs), s.exact_tests,
              s.rounds);
  return median(total);
}

void compare_broad_phases(const Connectivity& c, const Points& points)
{
  std::vector<CGAL::Bbox_3> boxes;
  for (int f = 0; f < c.number_of_faces(); ++f) boxes.push_back(swept_box(c, points, points, f));
  std::size_t by_tree = 0, by_boxes = 0;
  const double tree_seconds = median_seconds([&] {
    by_tree = 0;
    Swept_aabb_tree tree;
    build_swept_tree(tree, boxes);
    for (int f = 0; f < c.number_of_faces(); ++f)
      tree.all_intersected_primitives(boxes[f], boost::make_function_output_iterator([&](int g) { by_tree += g > f; }));
  });
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  const double box_seconds = median_seconds([&] {
    by_boxes = 0;
    std::vector<Box> items;
    for (std::size_t f = 0; f < boxes.size(); ++f) items.emplace_back(boxes[f], int(f));
    CGAL::box_self_intersection_d(items.begin(), items.end(), [&](const Box&, const Box&) { ++by_boxes; });
  });
  std::printf("  candidate pairs: tree %.4f s, box_intersection_d %.4f s (x %.1f), %zu pairs%s\n", tree_seconds,
              box_seconds, box_seconds / tree_seconds, by_tree, by_tree == by_boxes ? "" : " DIFFERENT");
}

void compare_checks(const Surface& mesh, const Connectivity& c, const Points& points)
{
  bool ours = false, theirs = false;
  const double our_seconds = median_seconds([&] { ours = is_embedded(c, points); });
  const double their_seconds =
      median_seconds([&] { theirs = !CGAL::Polygon_mesh_processing::does_self_intersect(mesh); });
  std::printf("  whole mesh: is_embedded %.4f s, does_self_intersect %.4f s%s\n", our_seconds, their_seconds,
              ours == theirs ? "" : " DIFFERENT");
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<double> faces, seconds[4];
  for (int i = 1; i < argc; ++i) {
    Surface mesh;
    if (!CGAL::IO::read_polygon_mesh(argv[i], mesh)) {
      std::cerr << argv[i] << ": cannot be read" << std::endl;
      return 1;
    }
    const Connectivity c = make_connectivity(mesh);
    const Points points(mesh.points().begin(), mesh.points().end());
    std::printf("%s: %d faces\n", argv[i], c.number_of_faces());
    faces.push_back(c.number_of_faces());
    const std::vector<Vector_3> field = smooth_field(c, 10);
    for (int s = 0; s < 4; ++s) seconds[s].push_back(pass(c, points, sizes[s], field));
    compare_broad_phases(c, points);
    compare_checks(mesh, c, points);
  }
  for (std::size_t i = 1; i < faces.size(); ++i) {
    std::printf("growth exponent from %.0f to %.0f faces:", faces[i - 1], faces[i]);
    for (int s = 0; s < 4; ++s)
      std::printf(" %s %.2f", sizes[s].name,
                  std::log(seconds[s][i] / seconds[s][i - 1]) / std::log(faces[i] / faces[i - 1]));
    std::printf("\n");
  }
}
