// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Both models of MultiplanarDeformationSolver: that they agree, that threads change nothing, that bad triangles do no
// harm.

#include "deformation_fixtures.h"

#include <CGAL/Multiplanar/Ceres_deformation_solver.h>
#include <CGAL/Multiplanar/Cholmod_deformation_solver.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <string>
#include <thread>

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

template <class Solver>
Points solved(const Deformation_problem& p, int threads = 1)
{
  Solver solver(p.connectivity, p.rest, p.weights, threads);
  Points target;
  EXPECT_TRUE(solver.solve(p.current, p.labels, p.normals, p.w_p, p.similarity_scale, target)) << p.name;
  return target;
}

/// Passes with both solvers from the same positions, with all the options; returns the largest difference.
double largest_disagreement(Deformation_problem p, const std::vector<double>& flattening, int threads = 2)
{
  double largest = 0;
  for (double smoothness : {0., 1e-3}) {
    p.weights.smoothness = smoothness;
    p.current = p.rest;
    Ceres_deformation_solver ceres(p.connectivity, p.rest, p.weights, threads);
    Cholmod_deformation_solver cholmod(p.connectivity, p.rest, p.weights, threads);
    for (double w_p : flattening) {
      Points a, b;
      EXPECT_TRUE(ceres.solve(p.current, p.labels, p.normals, w_p, p.similarity_scale, a)) << p.name << ' ' << w_p;
      EXPECT_TRUE(cholmod.solve(p.current, p.labels, p.normals, w_p, p.similarity_scale, b)) << p.name << ' ' << w_p;
      largest = (std::max)(largest, largest_distance(a, b));
      // As in the loop: vertices that have moved are held back more.
      p.similarity_scale.assign(p.rest.size(), 1.);
      for (std::size_t v = 0; v < p.rest.size(); ++v)
        p.similarity_scale[v] = (std::min)(10., 0.1 + 1e4 * CGAL::squared_distance(b[v], p.rest[v]));
      p.current = b;
      p.normals = mean_normals(p.connectivity, p.current, p.labels, int(p.normals.size()));
    }
  }
  std::printf("  %s: %d faces, largest disagreement %.1e\n", p.name.c_str(), p.connectivity.number_of_faces(), largest);
  return largest;
}

const std::vector<double> schedule = {1, 5, 20, 100, 500, 2000};

/// A sphere in which every tenth face is split at a point very near an edge or a corner, `offset` of the height away.
Mesh sphere_with_slivers(double offset)
{
  Mesh mesh = geodesic_sphere(8);
  const std::size_t faces = mesh.triangles.size();
  for (std::size_t f = 0; f < faces; f += 10) {
    const auto t = mesh.triangles[f];
    const double a = offset, b = f % 20 == 0 ? offset : (1 - offset) / 2, c = 1 - a - b;
    const Vector_3 p = a * (mesh.points[t[0]] - CGAL::ORIGIN) + b * (mesh.points[t[1]] - CGAL::ORIGIN) +
                       c * (mesh.points[t[2]] - CGAL::ORIGIN);
    const int v = int(mesh.points.size());
    mesh.points.push_back(CGAL::ORIGIN + p);
    mesh.triangles[f] = {t[0], t[1], v};
    mesh.triangles.push_back({t[1], t[2], v});
    mesh.triangles.push_back({t[2], t[0], v});
  }
  return mesh;
}

std::string cgal_mesh_folder()
{
  const char* folder = std::getenv("MULTIPLANAR_CGAL_DATA");
  if (folder == nullptr) return "";
  for (const char* below : {"", "/meshes", "/data/meshes"})
    if (std::ifstream(std::string(folder) + below + "/elephant.off")) return std::string(folder) + below + '/';
  return "";
}

} // namespace

TEST(DeformationSolvers, AgreeOnGeneratedMeshes)
{
  EXPECT_LT(largest_disagreement(problem_at_rest("icosphere", icosphere(3), 50), schedule), 1e-8);
  EXPECT_LT(largest_disagreement(problem_at_rest("torus", torus(40, 25), 50), schedule), 1e-8);
  EXPECT_LT(largest_disagreement(problem_at_rest("bumpy sphere", bumpy_sphere(16), 50), schedule), 1e-8);
  EXPECT_LT(largest_disagreement(problem_at_rest("cube", cube(10), 30), schedule), 1e-8);
  EXPECT_LT(largest_disagreement(problem_at_rest("tetrahedron", tetrahedron(), 3), schedule), 1e-8);
}

TEST(DeformationSolvers, AgreeOnMeshesOfCgal)
{
  const std::string folder = cgal_mesh_folder();
  if (folder.empty()) GTEST_SKIP() << "MULTIPLANAR_CGAL_DATA does not name CGAL's mesh folder";
  for (const char* name : {"elephant.off", "eight.off", "fandisk.off", "rotor.off", "3torus.off", "knot1.off"})
    EXPECT_LT(largest_disagreement(problem_at_rest(name, read_off(folder + name), 50), schedule), 1e-8);
}

// As many labels as faces, and nearly as many, at random.
TEST(DeformationSolvers, AgreeWithNearlyAsManyLabelsAsFaces)
{
  const std::uint64_t seed = 99;
  std::mt19937_64 random(seed);
  Deformation_problem p = problem_at_rest("labels by face", bumpy_sphere(8), 1);
  const int faces = p.connectivity.number_of_faces();
  for (int f = 0; f < faces; ++f) p.labels[f] = f;
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, faces);
  EXPECT_LT(largest_disagreement(p, schedule), 1e-8);
  p.name = "random labels, seed " + std::to_string(seed);
  for (int f = 0; f < faces; ++f)
    if (random() % 10 == 0) p.labels[f] = p.labels[p.connectivity.neighbours[f][random() % 3]];
  p.normals = mean_normals(p.connectivity, p.rest, p.labels, faces); // some labels have lost their faces: no normal
  EXPECT_LT(largest_disagreement(p, schedule), 1e-8);
}

// The pull of 12 planes on a sphere with slivers of a millionth of the mean area moves its proper vertices as it moves
// them without slivers, and carries the slivers' vertices along with their neighbours.
TEST(DeformationSolvers, AreNotDisturbedBySlivers)
{
  const Mesh clean = geodesic_sphere(8);
  for (double offset : {1e-6, 1e-9}) {
    const Mesh mesh = sphere_with_slivers(offset);
    Deformation_problem p = problem_at_rest("slivers", mesh, 12), q = problem_at_rest("clean", clean, 12);
    ASSERT_EQ(p.rest.front(), q.rest.front()); // the same unit frame
    std::vector<double> areas;
    for (int f = 0; f < p.connectivity.number_of_faces(); ++f)
      areas.push_back(std::sqrt(internal::area_vector(p.connectivity, p.rest, f).squared_length()));
    const double mean = std::accumulate(areas.begin(), areas.end(), 0.) / double(areas.size());
    ASSERT_LT(*std::min_element(areas.begin(), areas.end()) / mean, 2 * offset);
    for (std::size_t f = 0; f < areas.size(); ++f) // a sliver gets the label of the face it was cut from
      p.labels[f] = f < q.labels.size() ? q.labels[f] : q.labels[10 * ((f - q.labels.size()) / 2)];
    p.normals = q.normals;
    for (double w_p : {1., 10., 100., 2000.}) {
      p.w_p = q.w_p = w_p;
      const Points a = solved<Ceres_deformation_solver>(p), b = solved<Cholmod_deformation_solver>(p);
      const Points expected = solved<Cholmod_deformation_solver>(q);
      EXPECT_LT(largest_distance(a, b), 1e-8);
      const double moved = largest_distance(expected, q.rest);
      const Points proper(b.begin(), b.begin() + int(expected.size()));
      std::printf("  sliver %g, w_p %g: moved %.2e, disturbed %.2e, slivers' vertices moved %.2e\n", offset, w_p, moved,
                  largest_distance(proper, expected), largest_distance(b, p.rest));
      EXPECT_LT(largest_distance(proper, expected), 0.25 * moved);
      EXPECT_LT(largest_distance(b, p.rest), 1.3 * moved);
    }
  }
}

// All triangles of one vertex are slivers: a spike of no area. It still has a place.
TEST(DeformationSolvers, HoldVerticesWithoutArea)
{
  Mesh mesh = icosphere(2);
  const auto t = mesh.triangles[7];
  mesh.points.push_back(mesh.points[t[0]]); // a new vertex exactly on a corner: two triangles without area
  const int v = int(mesh.points.size()) - 1;
  mesh.triangles[7] = {t[0], t[1], v};
  mesh.triangles.push_back({t[1], t[2], v});
  mesh.triangles.push_back({t[2], t[0], v});
  Deformation_problem p = problem_at_rest("coincident vertices", mesh, 12);
  Deformation_problem q = problem_at_rest("clean", icosphere(2), 12);
  p.labels[7] = q.labels[7]; // the new faces have no normal to be labelled by
  for (std::size_t f = q.labels.size(); f < p.labels.size(); ++f) p.labels[f] = q.labels[7];
  p.normals = q.normals;
  for (double w_p : {0., 1., 2000.}) {
    p.w_p = q.w_p = w_p;
    const Points a = solved<Ceres_deformation_solver>(p), b = solved<Cholmod_deformation_solver>(p);
    EXPECT_LT(largest_distance(a, b), 1e-8);
    EXPECT_LE(largest_distance(b, p.rest),
              1.1 * largest_distance(solved<Cholmod_deformation_solver>(q), q.rest) + 1e-12);
  }
}

TEST(DeformationSolvers, GiveTheSameBitsForAnyNumberOfThreads)
{
  Deformation_problem p = problem_at_rest("bumpy sphere", bumpy_sphere(20), 40);
  p.weights.smoothness = 1e-4;
  p.w_p = 50;
  const Points ceres = solved<Ceres_deformation_solver>(p, 1), cholmod = solved<Cholmod_deformation_solver>(p, 1);
  for (int threads : {2, 3, 8}) {
    EXPECT_EQ(ceres, solved<Ceres_deformation_solver>(p, threads)) << threads;
    EXPECT_EQ(cholmod, solved<Cholmod_deformation_solver>(p, threads)) << threads;
  }
}

// Solvers in different threads, as parallel restarts use them, do not disturb each other, METIS included.
TEST(DeformationSolvers, GiveTheSameBitsSideBySide)
{
  Deformation_problem p = problem_at_rest("bumpy sphere", bumpy_sphere(14), 40);
  p.w_p = 50;
  const Points expected = solved<Cholmod_deformation_solver>(p);
  std::vector<Points> results(6);
  std::vector<std::thread> threads;
  for (Points& result : results) threads.emplace_back([&] { result = solved<Cholmod_deformation_solver>(p); });
  for (std::thread& thread : threads) thread.join();
  for (const Points& result : results) EXPECT_EQ(result, expected);
}

// What was solved before leaves no trace: a solver gives what a fresh one gives.
TEST(DeformationSolvers, HaveNoMemory)
{
  Deformation_problem p = problem_at_rest("torus", torus(30, 20), 25);
  Ceres_deformation_solver ceres(p.connectivity, p.rest, p.weights, 1);
  Cholmod_deformation_solver cholmod(p.connectivity, p.rest, p.weights, 1);
  Points target;
  for (double w_p : {700., 3.}) {
    p.w_p = w_p;
    ASSERT_TRUE(ceres.solve(p.current, p.labels, p.normals, w_p, {}, target));
    EXPECT_EQ(target, solved<Ceres_deformation_solver>(p));
    ASSERT_TRUE(cholmod.solve(p.current, p.labels, p.normals, w_p, {}, target));
    EXPECT_EQ(target, solved<Cholmod_deformation_solver>(p));
    p.current = target;
  }
}
