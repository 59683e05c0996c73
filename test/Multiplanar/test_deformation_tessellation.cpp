// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The panels must depend on the surface and its labels, not on how the surface is cut into triangles.

#include "deformation_fixtures.h"

#include <CGAL/Multiplanar/Cholmod_deformation_solver.h>
#include <CGAL/Multiplanar/Plane.h>

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

/// A mesh whose label borders are the same curves on the surface however fine it is.
struct Labelled_mesh
{
  Mesh mesh;
  std::vector<int> labels;
  int number_of_labels;
};

/// The bumpy sphere with one panel around each vertex of `polyhedron`, whose faces are triangles: three panels meet in
/// the middle of each face. Six pieces a face, n^2 triangles each.
Labelled_mesh bumpy_dual(const Mesh& polyhedron, int n)
{
  Mesh pieces = {polyhedron.points, {}};
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](int a, int b) {
    const auto found = middle.emplace(std::minmax(a, b), int(pieces.points.size()));
    if (found.second) pieces.points.push_back(CGAL::midpoint(polyhedron.points[a], polyhedron.points[b]));
    return found.first->second;
  };
  std::vector<int> piece_labels;
  for (const auto& t : polyhedron.triangles) {
    const int centre = int(pieces.points.size());
    pieces.points.push_back(CGAL::centroid(polyhedron.points[t[0]], polyhedron.points[t[1]], polyhedron.points[t[2]]));
    for (int i = 0; i < 3; ++i) {
      pieces.triangles.push_back({t[i], middle_of(t[i], t[(i + 1) % 3]), centre});
      pieces.triangles.push_back({t[i], centre, middle_of(t[i], t[(i + 2) % 3])});
      piece_labels.insert(piece_labels.end(), 2, t[i]);
    }
  }
  const Mesh sphere =
      mapped(subdivided(pieces, n), [](const Point_3& p) { return CGAL::ORIGIN + unit(p - CGAL::ORIGIN); });
  Labelled_mesh result = {bumpy(sphere), {}, int(polyhedron.points.size())};
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) result.labels.push_back(piece_labels[f / (n * n)]);
  return result;
}

/// A torus in 10 x 5 patches, each an i x j grid.
Labelled_mesh patched_torus(int i, int j)
{
  Labelled_mesh result = {torus(10 * i, 5 * j), {}, 50};
  for (int a = 0; a < 10 * i; ++a)
    for (int b = 0; b < 5 * j; ++b) result.labels.insert(result.labels.end(), 2, a / i * 5 + b / j);
  return result;
}

/// The panels' planes after `passes` passes with growing flattening weight.
std::vector<Plane> panels(const Labelled_mesh& labelled, const Deformation_weights& weights, int passes = 10)
{
  Deformation_problem p = problem_at_rest("", labelled.mesh, 1);
  const Connectivity& c = p.connectivity;
  Cholmod_deformation_solver solver(c, p.rest, weights, 1);
  for (int pass = 0; pass < passes; ++pass) {
    p.normals = mean_normals(c, p.current, labelled.labels, labelled.number_of_labels);
    Points target;
    EXPECT_TRUE(solver.solve(p.current, labelled.labels, p.normals, weights.flattening(pass, passes), {}, target));
    p.current = target;
  }
  std::vector<Plane> planes(labelled.number_of_labels);
  std::vector<double> area(labelled.number_of_labels);
  p.normals = mean_normals(c, p.current, labelled.labels, labelled.number_of_labels);
  for (int f = 0; f < c.number_of_faces(); ++f) {
    const auto& t = c.triangles[f];
    const int label = labelled.labels[f];
    const double a = std::sqrt(CGAL::squared_area(p.current[t[0]], p.current[t[1]], p.current[t[2]]));
    area[label] += a;
    planes[label].normal = p.normals[label];
    planes[label].offset +=
        a * (p.normals[label] * (CGAL::centroid(p.current[t[0]], p.current[t[1]], p.current[t[2]]) - CGAL::ORIGIN));
  }
  for (int i = 0; i < labelled.number_of_labels; ++i) planes[i].offset /= area[i];
  return planes;
}

/// Root mean square difference of normals (radians) and offsets (shares of the diagonal).
struct Difference
{
  double angle = 0, offset = 0;
};

Difference difference(const std::vector<Plane>& a, const std::vector<Plane>& b)
{
  Difference d;
  for (std::size_t i = 0; i < a.size(); ++i) {
    d.angle += (a[i].normal - b[i].normal).squared_length() / double(a.size());
    d.offset += CGAL::square(a[i].offset - b[i].offset) / double(a.size());
  }
  return {std::sqrt(d.angle), std::sqrt(d.offset)};
}

/// Root mean square displacement of the surface in a single pass from rest.
double displacement(const Labelled_mesh& labelled, const Deformation_weights& weights, double w_p)
{
  Deformation_problem p = problem_at_rest("", labelled.mesh, 1);
  const Connectivity& c = p.connectivity;
  Cholmod_deformation_solver solver(c, p.rest, weights, 1);
  p.normals = mean_normals(c, p.rest, labelled.labels, labelled.number_of_labels);
  Points target;
  EXPECT_TRUE(solver.solve(p.rest, labelled.labels, p.normals, w_p, {}, target));
  double sum = 0, area = 0;
  for (const auto& t : c.triangles) {
    const double a = std::sqrt(CGAL::squared_area(p.rest[t[0]], p.rest[t[1]], p.rest[t[2]]));
    area += a;
    for (int v : t) sum += a / 3 * CGAL::squared_distance(p.rest[v], target[v]);
  }
  return std::sqrt(sum / area);
}

/// How much the displacement changes, relatively, from the coarse to the fine mesh.
double change(const Labelled_mesh& coarse, const Labelled_mesh& fine, const Deformation_weights& weights, double w_p)
{
  const double a = displacement(coarse, weights, w_p), b = displacement(fine, weights, w_p);
  std::printf("  w_p %g, smoothness %g: displacement %.5f and %.5f\n", w_p, weights.smoothness, a, b);
  return std::abs(a / b - 1);
}

} // namespace

// Ten passes on the same surface with 2 000 and 10 000 faces. Measured differences: normals 2.0e-3 rad, offsets
// 8.3e-4 of the diagonal with 12 panels, 2.1e-3 and 8.2e-4 with 42. They are the coarse mesh's distance from the smooth
// surface: between 10 000 and 50 000 faces they are 4 times smaller. The panels move by 5 to 10 times as much.
TEST(DeformationTessellation, PanelsAreThoseOfTheSurface)
{
  const Deformation_weights weights;
  for (int frequency : {1, 2}) {
    const Mesh polyhedron = geodesic_sphere(frequency);
    const int coarse = 4 / frequency, fine = 10 / frequency - (frequency == 1);
    const std::vector<Plane> a = panels(bumpy_dual(polyhedron, coarse), weights),
                             b = panels(bumpy_dual(polyhedron, fine), weights);
    const Difference d = difference(a, b), moved = difference(b, panels(bumpy_dual(polyhedron, fine), weights, 0));
    std::printf("%d panels, %d and %d faces: normals %.2e rad, offsets %.2e; moved %.2e rad, %.2e\n", int(a.size()),
                int(polyhedron.triangles.size()) * 6 * coarse * coarse,
                int(polyhedron.triangles.size()) * 6 * fine * fine, d.angle, d.offset, moved.angle, moved.offset);
    EXPECT_LT(d.angle, 3e-3);
    EXPECT_LT(d.offset, 1.2e-3);
    EXPECT_GT(moved.angle, 4 * d.angle);
    EXPECT_GT(moved.offset, 3 * d.offset);
  }
}

// Where flattening and the other objectives are in balance, their ratios show. Without the area weights the fine mesh
// would have five times the similarity and transformation: the last line shows what that would do.
TEST(DeformationTessellation, BalanceOfTheObjectivesIsThatOfTheSurface)
{
  Deformation_weights weights, five = weights;
  five.similarity *= 5;
  five.transformation *= 5;
  for (double w_p : {0.3, 1., 3.}) {
    EXPECT_LT(change(bumpy_dual(icosahedron(), 4), bumpy_dual(icosahedron(), 9), weights, w_p), 0.1);
    EXPECT_LT(change(patched_torus(4, 5), patched_torus(10, 10), weights, w_p), 0.06);
  }
  const Labelled_mesh fine = patched_torus(10, 10);
  EXPECT_GT(std::abs(displacement(fine, five, 1) / displacement(fine, weights, 1) - 1), 0.4);
}

TEST(DeformationTessellation, SmoothnessIsThatOfTheSurface)
{
  Deformation_weights weights;
  weights.smoothness = 1e-3;
  for (double w_p : {0.3, 1., 3.}) {
    EXPECT_LT(change(bumpy_dual(icosahedron(), 4), bumpy_dual(icosahedron(), 9), weights, w_p), 0.1);
    EXPECT_LT(change(patched_torus(4, 5), patched_torus(10, 10), weights, w_p), 0.15);
  }
  Deformation_weights five = weights;
  five.smoothness *= 5;
  const Labelled_mesh fine = patched_torus(10, 10);
  EXPECT_GT(std::abs(displacement(fine, five, 0.3) / displacement(fine, weights, 0.3) - 1), 0.4);
}
