// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse factorisation behind the direct deformation solver, against a dense one.

#include "deformation_fixtures.h"

#include <CGAL/Multiplanar/internal/Block_cholesky.h>

#include <gtest/gtest.h>

#include <numeric>
#include <set>

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

TEST(EliminationOrder, IsAPermutationThatFillsInLittle)
{
  const Vertex_graph graph = graph_of(geodesic_sphere(24), 1);
  std::vector<int> order = internal::elimination_order(graph);
  EXPECT_EQ(order, internal::elimination_order(graph));
  Block_cholesky system(graph, 1);
  const double faces = 2. * graph.number_of_vertices() - 4;
  EXPECT_LT(double(system.factor_bytes()), 1500 * faces); // 1200 measured; a band ordering has 5 times as much
  std::sort(order.begin(), order.end());
  for (int v = 0; v < int(order.size()); ++v) ASSERT_EQ(order[v], v);
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

// The caller's settings are back when the last of several is gone.
TEST(SerialLibraries, RestoreWhatTheyFound)
{
  auto* const blas_threads = internal::loaded_function<int()>("openblas_get_num_threads");
  auto* const levels = internal::loaded_function<int()>("omp_get_max_active_levels");
  const int blas_before = blas_threads == nullptr ? 1 : blas_threads(),
            levels_before = levels == nullptr ? 1 : levels();
  {
    internal::Serial_libraries outer;
    {
      internal::Serial_libraries inner;
    }
    if (blas_threads != nullptr) EXPECT_EQ(blas_threads(), 1);
    if (levels != nullptr) EXPECT_EQ(levels(), 0);
  }
  if (blas_threads != nullptr) EXPECT_EQ(blas_threads(), blas_before);
  if (levels != nullptr) EXPECT_EQ(levels(), levels_before);
}
