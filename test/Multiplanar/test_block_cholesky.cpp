// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse factorisation behind the direct deformation solver, against a dense one.

#include "deformation_fixtures.h"

#include <CGAL/Multiplanar/internal/Block_cholesky.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using internal::Block_cholesky;
using internal::Symmetric_block;
using internal::Vertex_graph;

Vertex_graph graph_of(const Mesh& mesh, int rings)
{
  return internal::vertex_graph(internal::make_connectivity(mesh.triangles, int(mesh.points.size())), rings);
}

/// A random symmetric matrix over a graph, diagonally dominant if `diagonal` is large, and its dense twin by vertex.
struct Random_system
{
  Random_system(const Vertex_graph& graph, double diagonal, int threads)
      : sparse(graph, threads),
        dense(Eigen::MatrixXd::Zero(3 * graph.number_of_vertices(), 3 * graph.number_of_vertices()))
  {
    std::mt19937_64 random(1234);
    const int n = graph.number_of_vertices();
    sparse.set_zero();
    for (int v = 0; v < n; ++v) {
      add(v, v, random_block(random, diagonal));
      for (int u : graph.adjacent(v))
        if (u > v) add(u, v, random_block(random, 0));
    }
    right = Eigen::VectorXd::NullaryExpr(3 * n, [&] { return random_unit(random); });
  }

  static Symmetric_block random_block(std::mt19937_64& random, double diagonal)
  {
    Symmetric_block b;
    for (double& x : b) x = random_unit(random);
    for (int i : {0, 3, 5}) b[i] += diagonal;
    return b;
  }

  void add(int u, int v, const Symmetric_block& b)
  {
    if (u == v) sparse.add_diagonal(sparse.slot(u, u), b);
    else sparse.add_off_diagonal(sparse.slot(u, v), b);
    Eigen::Matrix3d block;
    block << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5];
    dense.block<3, 3>(3 * u, 3 * v) += block;
    if (u != v) dense.block<3, 3>(3 * v, 3 * u) += block;
  }

  std::vector<double> right_by_rank() const
  {
    std::vector<double> b(right.size());
    for (int v = 0; v < sparse.number_of_vertices(); ++v)
      for (int d = 0; d < 3; ++d) b[3 * sparse.rank(v) + d] = right(3 * v + d);
    return b;
  }

  Block_cholesky sparse;
  Eigen::MatrixXd dense;
  Eigen::VectorXd right;
};

/// A graph without edges but those given, to reach forests and single vertices.
Vertex_graph graph_of_edges(int n, const std::vector<std::array<int, 2>>& edges)
{
  std::vector<std::set<int>> adjacent(n);
  for (const auto& e : edges) {
    adjacent[e[0]].insert(e[1]);
    adjacent[e[1]].insert(e[0]);
  }
  Vertex_graph graph;
  graph.begin.push_back(0);
  for (const auto& set : adjacent) {
    graph.neighbours.insert(graph.neighbours.end(), set.begin(), set.end());
    graph.begin.push_back(int(graph.neighbours.size()));
  }
  return graph;
}

/// The blocks of the factor's lower triangle, the diagonal included, by symbolic elimination: the slow twin of
/// CHOLMOD's analysis. Column j has the rows of the matrix and those of the columns whose first row below the diagonal
/// is j.
std::size_t number_of_factor_blocks(const Vertex_graph& graph, const std::vector<int>& order)
{
  const int n = graph.number_of_vertices();
  std::vector<int> rank(n);
  for (int i = 0; i < n; ++i) rank[order[i]] = i;
  std::vector<std::set<int>> below(n);
  std::size_t blocks = 0;
  for (int j = 0; j < n; ++j) {
    for (int u : graph.adjacent(order[j]))
      if (rank[u] > j) below[j].insert(rank[u]);
    blocks += 1 + below[j].size();
    if (below[j].empty()) continue;
    const int parent = *below[j].begin();
    below[parent].insert(std::next(below[j].begin()), below[j].end());
    below[j].clear();
  }
  return blocks;
}

/// From one side of the surface to the other: a band matrix.
std::vector<int> order_in_strips(const Mesh& mesh)
{
  std::vector<int> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int u, int v) { return mesh.points[u] < mesh.points[v]; });
  return order;
}

} // namespace

TEST(BlockCholesky, SolvesLikeADenseFactorisation)
{
  for (const Vertex_graph& graph :
       {graph_of(icosphere(2), 1), graph_of(icosphere(2), 2), graph_of(torus(13, 9), 1), graph_of(tetrahedron(), 1),
        graph_of_edges(1, {}), graph_of_edges(7, {{0, 1}, {2, 3}, {3, 4}}), graph_of_edges(40, {})}) {
    Random_system system(graph, 40, 2);
    ASSERT_TRUE(system.sparse.is_valid());
    ASSERT_TRUE(system.sparse.factorize());
    std::vector<double> b = system.right_by_rank(), x;
    ASSERT_TRUE(system.sparse.solve(b, x));
    const Eigen::VectorXd expected = system.dense.llt().solve(system.right);
    for (int v = 0; v < graph.number_of_vertices(); ++v)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(x[3 * system.sparse.rank(v) + d], expected(3 * v + d), 1e-13);
  }
}

TEST(BlockCholesky, RefusesWhatIsNotPositiveDefiniteAndRecovers)
{
  const Vertex_graph graph = graph_of(icosphere(3), 1);
  Random_system system(graph, 40, 2);
  ASSERT_TRUE(system.sparse.factorize());
  std::vector<double> b = system.right_by_rank(), x, again;
  ASSERT_TRUE(system.sparse.solve(b, x));
  for (int v : {0, 17, graph.number_of_vertices() - 1}) {
    system.sparse.add_isotropic(system.sparse.slot(v, v), -64);
    EXPECT_FALSE(system.sparse.factorize());
    system.sparse.add_isotropic(system.sparse.slot(v, v), 64);
  }
  ASSERT_TRUE(system.sparse.factorize());
  ASSERT_TRUE(system.sparse.solve(b, again));
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], again[i], 1e-13);
}

TEST(BlockCholesky, GivesTheSameBitsForAnyNumberOfThreads)
{
  const Vertex_graph graph = graph_of(geodesic_sphere(24), 1);
  std::vector<double> expected;
  for (int threads : {1, 2, 3, 7}) {
    Block_cholesky system(graph, threads);
    system.set_zero();
    std::mt19937_64 random(5);
    for (int v = 0; v < graph.number_of_vertices(); ++v) {
      system.add_isotropic(system.slot(v, v), 8);
      for (int u : graph.adjacent(v))
        if (u > v) system.add_isotropic(system.slot(u, v), random_unit(random));
    }
    for (int run = 0; run < 3; ++run) {
      ASSERT_TRUE(system.factorize());
      std::vector<double> b(3 * std::size_t(graph.number_of_vertices())), x;
      std::iota(b.begin(), b.end(), -1.);
      ASSERT_TRUE(system.solve(b, x));
      if (expected.empty()) expected = x;
      EXPECT_EQ(x, expected) << threads;
    }
  }
}

TEST(EliminationOrder, IsAPermutationAlwaysTheSame)
{
  const Vertex_graph graph = graph_of(geodesic_sphere(24), 1);
  std::vector<int> order = internal::elimination_order(graph);
  EXPECT_EQ(order, internal::elimination_order(graph));
  std::sort(order.begin(), order.end());
  for (int v = 0; v < int(order.size()); ++v) ASSERT_EQ(order[v], v);
}

// With n vertices, the blocks a vertex are in proportion to n^0.5 if the order goes in strips across the surface, since
// a strip has so many vertices; they are a + b log n in nested dissection. So from one size to the next, with 4 times
// the vertices, their growth doubles, or stays the same.
TEST(EliminationOrder, FillsInAsNestedDissectionDoes)
{
  std::vector<double> dissected, strips; // blocks a vertex
  for (int frequency : {12, 24, 48}) {
    const Mesh sphere = geodesic_sphere(frequency);
    const Vertex_graph graph = graph_of(sphere, 1);
    const double n = graph.number_of_vertices();
    dissected.push_back(double(number_of_factor_blocks(graph, internal::elimination_order(graph))) / n);
    strips.push_back(double(number_of_factor_blocks(graph, order_in_strips(sphere))) / n);
    std::printf("  %.0f vertices: %.1f blocks a vertex, in strips %.1f\n", n, dissected.back(), strips.back());
    EXPECT_LT(dissected.back(), strips.back() / 2);
  }
  const auto change_of_growth = [](const std::vector<double>& x) { return (x[2] - x[1]) / (x[1] - x[0]); };
  EXPECT_LT(change_of_growth(dissected), std::sqrt(2.)); // halfway between 1 and 2
  EXPECT_GT(change_of_growth(strips), std::sqrt(2.));
}

// CHOLMOD keeps runs of columns as dense rectangles, which holds zeros too: more than the factor itself, but by far not
// what another order would take.
TEST(BlockCholesky, HoldsLittleMoreThanTheFactor)
{
  const Mesh sphere = geodesic_sphere(24);
  const Vertex_graph graph = graph_of(sphere, 1);
  const auto bytes = [&](const std::vector<int>& order) { // of the lower triangle
    const double n = graph.number_of_vertices();
    return sizeof(double) * (6 * n + 9 * (double(number_of_factor_blocks(graph, order)) - n));
  };
  const double held = double(Block_cholesky(graph, 1).factor_bytes());
  const double needed = bytes(internal::elimination_order(graph)), in_strips = bytes(order_in_strips(sphere));
  std::printf("  held %.2f MB, needed %.2f MB, in strips %.2f MB\n", held / 1e6, needed / 1e6, in_strips / 1e6);
  EXPECT_GE(held, needed);
  EXPECT_LT(held, in_strips / 2);
}

TEST(VertexGraph, HoldsRings)
{
  for (const Mesh& mesh : {icosphere(2), torus(9, 6), tetrahedron()}) {
    const auto c = internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
    std::vector<std::set<int>> ring(mesh.points.size());
    for (const auto& t : mesh.triangles)
      for (int u : t)
        for (int v : t)
          if (u != v) ring[u].insert(v);
    for (int rings : {1, 2}) {
      const Vertex_graph graph = internal::vertex_graph(c, rings);
      for (int v = 0; v < graph.number_of_vertices(); ++v) {
        std::set<int> expected = ring[v];
        if (rings == 2)
          for (int u : ring[v]) expected.insert(ring[u].begin(), ring[u].end());
        expected.erase(v);
        EXPECT_EQ(std::set<int>(graph.adjacent(v).begin(), graph.adjacent(v).end()), expected);
      }
    }
  }
}

// The caller's settings are back when the last of several is gone; each thread has its own of OpenMP.
TEST(SerialLibraries, RestoreWhatTheyFound)
{
  auto* const blas_threads = internal::loaded_function<int()>("openblas_get_num_threads");
  auto* const levels = internal::loaded_function<int()>("omp_get_max_active_levels");
  auto* const team = internal::loaded_function<int()>("omp_get_max_threads");
  const auto settings = [&] {
    return std::array<int, 3>{blas_threads ? blas_threads() : 1, levels ? levels() : 0, team ? team() : 1};
  };
  const std::array<int, 3> serial = {1, 0, 1}, before = settings();
  {
    internal::Serial_libraries outer;
    {
      internal::Serial_libraries inner;
      EXPECT_EQ(settings(), serial);
    }
    EXPECT_EQ(settings(), serial);
    std::thread([&] {
      internal::Serial_libraries other;
      EXPECT_EQ(settings(), serial);
    }).join();
    EXPECT_EQ(settings(), serial);
  }
  EXPECT_EQ(settings(), before);
}
