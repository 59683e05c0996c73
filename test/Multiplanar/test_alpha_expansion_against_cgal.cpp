// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same problems to this package's alpha-expansion and to CGAL's own with its Boost back end.

#include <CGAL/Multiplanar/alpha_expansion.h>
#include <CGAL/Multiplanar/alpha_expansion_graphcut.h>
#include <CGAL/Multiplanar/label_costs.h>
#include <CGAL/Multiplanar/seeding.h>

#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include "meshes.h"
#include "potts_problems.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

namespace {

using namespace Multiplanar_test;
namespace internal = CGAL::Multiplanar::internal;

double cgal_energy(const Problem& p, Labels& labelling)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges(p.edges.begin(), p.edges.end());
  const int n = p.graph.nodes();
  std::vector<std::vector<double>> costs(p.cost.labels, std::vector<double>(n));
  for (int f = 0; f < p.cost.labels; ++f)
    for (int i = 0; i < n; ++i) costs[f][i] = p.cost(i, f);
  std::vector<std::size_t> labels(p.start.begin(), p.start.end());
  const double energy =
      CGAL::alpha_expansion_graphcut(edges, p.weights, costs, labels, CGAL::Alpha_expansion_boost_adjacency_list_tag());
  labelling.assign(labels.begin(), labels.end());
  return energy;
}

// The labelling of a mesh's faces by k planes, as the segmentation sees it first.
Problem labelling_problem(Mesh mesh, int k)
{
  mesh = normalised(std::move(mesh));
  const auto connectivity = internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
  const Label_costs costs(connectivity, mesh.points);
  const Plane_costs planes = costs.data_cost(seed_planes(costs, k, 5));
  Problem p;
  p.graph = costs.potts_graph();
  p.cost.labels = k;
  for (int f = 0; f < costs.faces(); ++f) {
    for (int label = 0; label < k; ++label) p.cost.values.push_back(planes(f, label));
    for (int a = p.graph.begin[f]; a < p.graph.begin[f + 1]; ++a)
      if (f < p.graph.adjacent[a]) {
        p.edges.emplace_back(f, p.graph.adjacent[a]);
        p.weights.push_back(p.graph.weight[a]);
      }
  }
  p.start = cheapest_labels(costs.faces(), k, planes);
  return p;
}

void expect_the_energy_of_cgal(const Mesh& mesh, const std::string& name)
{
  for (int k : {10, 50, 90}) {
    const Problem p = labelling_problem(mesh, k);
    Labels ours = p.start, cgal;
    const auto result = alpha_expansion(p.graph, k, p.cost, ours);
    cgal_energy(p, cgal);
    const double energy = slow_energy(p, cgal);
    EXPECT_NEAR(result.energy, energy, 1e-9 * energy) << name << ", k = " << k;
    EXPECT_LE(result.energy, slow_energy(p, p.start));
  }
}

TEST(Against_CGAL, bumpy_sphere) { expect_the_energy_of_cgal(bumpy_sphere(8), "bumpy sphere"); }
TEST(Against_CGAL, very_bumpy_sphere) { expect_the_energy_of_cgal(bumpy_sphere(10, 0.28), "very bumpy sphere"); }
TEST(Against_CGAL, icosphere) { expect_the_energy_of_cgal(icosphere(3), "icosphere"); }
TEST(Against_CGAL, torus) { expect_the_energy_of_cgal(torus(40, 20), "torus"); }
TEST(Against_CGAL, bumpy_torus) { expect_the_energy_of_cgal(bumpy(torus(36, 18)), "bumpy torus"); }
TEST(Against_CGAL, bumpy_cube) { expect_the_energy_of_cgal(bumpy(cube(11)), "bumpy cube"); }

TEST(Against_CGAL, cube) { expect_the_energy_of_cgal(cube(10), "cube"); }

// Scanned and modelled shapes, 2,000 to 6,000 faces.
class Against_CGAL_on_its_meshes : public ::testing::TestWithParam<const char*>
{
};

TEST_P(Against_CGAL_on_its_meshes, reaches_its_energy)
{
  const char* folder = std::getenv("MULTIPLANAR_CGAL_DATA");
  if (folder == nullptr) GTEST_SKIP() << "MULTIPLANAR_CGAL_DATA names no folder";
  expect_the_energy_of_cgal(read_off(std::string(folder) + "/meshes/" + GetParam() + ".off"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(meshes, Against_CGAL_on_its_meshes,
                         ::testing::Values("hand", "elk", "blobby", "cow", "elephant", "triceratops"));

// The same graph through the functions for BGL graphs.
TEST(Against_CGAL, same_interface)
{
  using Graph = boost::adjacency_list<boost::setS, boost::listS, boost::undirectedS>;
  using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;
  std::mt19937_64 rng(41);
  const Problem p = random_problem(rng, 200, 400, 5, false, 6);
  Graph g;
  std::map<Vertex, std::size_t> index;
  std::map<Vertex, std::vector<double>> costs;
  std::map<Vertex, std::size_t> start;
  std::vector<Vertex> vertex;
  for (int i = 0; i < 200; ++i) {
    const Vertex v = add_vertex(g);
    vertex.push_back(v);
    index[v] = i;
    start[v] = p.start[i];
    for (int f = 0; f < 5; ++f) costs[v].push_back(p.cost(i, f));
  }
  std::map<Edge, double> weights;
  for (std::size_t e = 0; e < p.edges.size(); ++e)
    weights[add_edge(vertex[p.edges[e].first], vertex[p.edges[e].second], g).first] = p.weights[e];
  const auto np = CGAL::parameters::vertex_index_map(boost::make_assoc_property_map(index));
  const auto edge_costs = boost::make_assoc_property_map(weights);
  const auto label_costs = boost::make_assoc_property_map(costs);

  auto cgal = start, ours = start, parallel = start, one_sweep = start;
  const double expected =
      CGAL::alpha_expansion_graphcut(g, edge_costs, label_costs, boost::make_assoc_property_map(cgal), np);
  const double energy =
      CGAL::Multiplanar::alpha_expansion_graphcut(g, edge_costs, label_costs, boost::make_assoc_property_map(ours), np);
  EXPECT_NEAR(energy, expected, 1e-9 * expected);
  EXPECT_EQ(ours, cgal);
  EXPECT_NE(ours, start);
  EXPECT_EQ(energy, CGAL::Multiplanar::alpha_expansion_graphcut<CGAL::Parallel_tag>(
                        g, edge_costs, label_costs, boost::make_assoc_property_map(parallel), np));
  EXPECT_EQ(ours, parallel);
  const double early = CGAL::Multiplanar::alpha_expansion_graphcut(
      g, edge_costs, label_costs, boost::make_assoc_property_map(one_sweep), np.number_of_iterations(1));
  EXPECT_GT(early, energy);
}

TEST(Against_CGAL, meshes_of_a_folder)
{
  const char* folder = std::getenv("MULTIPLANAR_TEST_MESHES");
  if (folder == nullptr) GTEST_SKIP() << "set MULTIPLANAR_TEST_MESHES to a folder of closed meshes in OFF format";
  int meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".off") continue;
    const auto mesh = read_off(entry.path().string());
    if (mesh.triangles.size() > 12000) continue; // CGAL's own would take minutes
    expect_the_energy_of_cgal(mesh, entry.path().filename().string());
    ++meshes;
  }
  EXPECT_GT(meshes, 0);
}

} // namespace
