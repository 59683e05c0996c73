// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/multiplanar_approximation.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <set>

using namespace CGAL::Multiplanar;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;

namespace {

Surface_mesh surface_mesh(const Multiplanar_test::Mesh& mesh)
{
  Surface_mesh result;
  for (const Point_3& p : mesh.points) result.add_vertex(p);
  for (const auto& t : mesh.triangles)
    result.add_face(Surface_mesh::Vertex_index(t[0]), Surface_mesh::Vertex_index(t[1]),
                    Surface_mesh::Vertex_index(t[2]));
  return result;
}

struct Outcome
{
  Surface_mesh mesh;
  std::vector<int> panels;
  Approximation_result result;
};

template <class NamedParameters>
Outcome approximated(const Multiplanar_test::Mesh& source, const NamedParameters& np)
{
  Outcome run;
  run.mesh = surface_mesh(source);
  auto map = run.mesh.template add_property_map<Surface_mesh::Face_index, int>("f:panel").first;
  run.result = CGAL::multiplanar_approximation(run.mesh, map, np);
  for (auto f : run.mesh.faces()) run.panels.push_back(map[f]);
  return run;
}

double diagonal(const Multiplanar_test::Mesh& mesh) { return internal::Unit_frame(mesh.points).diagonal(); }

/// Everything that every run promises, checked on the mesh that the user gets with CGAL's own functions.
void expect_promises(const Multiplanar_test::Mesh& source, const Outcome& run, int k)
{
  ASSERT_EQ(run.mesh.number_of_faces(), source.triangles.size());
  std::size_t i = 0;
  for (auto f : run.mesh.faces()) {
    std::array<std::size_t, 3> t{};
    int j = 0;
    for (auto v : vertices_around_face(run.mesh.halfedge(f), run.mesh)) t[j++] = std::size_t(v);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::array<std::size_t, 3> s{std::size_t(source.triangles[i][0]), std::size_t(source.triangles[i][1]),
                                 std::size_t(source.triangles[i][2])};
    std::rotate(s.begin(), std::min_element(s.begin(), s.end()), s.end());
    ASSERT_EQ(t, s) << "the connectivity has changed at face " << i;
    ++i;
  }
  EXPECT_TRUE(CGAL::is_closed(run.mesh));
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(run.mesh));
  const std::set<int> used(run.panels.begin(), run.panels.end());
  EXPECT_LE(int(used.size()), k);
  EXPECT_EQ(int(used.size()), run.result.complex.number_of_panels());
  EXPECT_EQ(*used.rbegin(), int(used.size()) - 1);
  EXPECT_TRUE(run.result.embedded);
  EXPECT_TRUE(panel_complex_problems(run.result.complex).empty());
  // Flat, measured from the written numbers: distance of each vertex from the plane of its panel.
  double worst = 0;
  for (auto f : run.mesh.faces())
    for (auto v : vertices_around_face(run.mesh.halfedge(f), run.mesh))
      worst = (std::max)(worst,
                         std::abs(signed_distance(run.result.complex.panels[run.panels[f]].plane, run.mesh.point(v))));
  EXPECT_LE(worst, 1e-9 * diagonal(source));
  // Each triangle keeps its side up in its panel.
  for (auto f : run.mesh.faces()) {
    std::vector<Point_3> p;
    for (auto v : vertices_around_face(run.mesh.halfedge(f), run.mesh)) p.push_back(run.mesh.point(v));
    EXPECT_GT(CGAL::cross_product(p[1] - p[0], p[2] - p[0]) * run.result.complex.panels[run.panels[f]].plane.normal, 0);
  }
}

auto fast(int k) { return parameters::number_of_panels(k).effort(Effort::fast).number_of_iterations(10); }

TEST(Named_parameters, none_is_dropped_in_a_mixed_chain)
{
  const Surface_mesh mesh;
  const Approximation_options o = internal::approximation_options(
      mesh, fast(16).number_of_restarts(3).random_seed(7).deformation_solver(Solver::ceres));
  EXPECT_EQ(o.panels, 16);
  EXPECT_EQ(o.effort, Effort::fast);
  EXPECT_EQ(o.iterations, 10);
  EXPECT_EQ(o.restarts, 3);
  EXPECT_EQ(o.seed, 7u);
  EXPECT_EQ(o.solver, Solver::ceres);
}

TEST(Approximation, cube_stays_a_cube_and_stops_early)
{
  const auto source = Multiplanar_test::cube(6);
  const Outcome run = approximated(source, parameters::number_of_panels(6).effort(Effort::fast));
  expect_promises(source, run, 6);
  EXPECT_EQ(run.result.complex.number_of_panels(), 6);
  EXPECT_LT(run.result.hausdorff, 1e-4 * diagonal(source));
  EXPECT_TRUE(run.result.converged);
  EXPECT_LT(run.result.iterations, 50);
  EXPECT_FALSE(run.result.notes.empty()); // says that it stopped early
}

TEST(Approximation, tetrahedron_with_four_panels)
{
  const auto source = Multiplanar_test::tetrahedron();
  const Outcome run = approximated(source, fast(4));
  expect_promises(source, run, 4);
  EXPECT_EQ(run.result.complex.number_of_panels(), 4);
  EXPECT_LT(run.result.hausdorff, 1e-4 * diagonal(source));
}

TEST(Approximation, sphere_gets_closer_with_more_panels)
{
  const auto source = Multiplanar_test::icosphere(3);
  double previous = 1e300;
  for (int k : {8, 40}) {
    const Outcome run = approximated(source, fast(k));
    expect_promises(source, run, k);
    EXPECT_LT(run.result.hausdorff, previous);
    previous = run.result.hausdorff;
  }
}

TEST(Approximation, torus_keeps_its_handle)
{
  const auto source = Multiplanar_test::torus(40, 24);
  const Outcome run = approximated(source, fast(24));
  expect_promises(source, run, 24);
}

TEST(Approximation, bumpy_sphere)
{
  const auto source = Multiplanar_test::bumpy_sphere(12, 0.25);
  const Outcome run = approximated(source, fast(30));
  expect_promises(source, run, 30);
}

TEST(Approximation, both_solvers_keep_the_promises)
{
  const auto source = Multiplanar_test::bumpy_sphere(8);
  for (Solver solver : {Solver::ceres, Solver::direct}) {
    const Outcome run = approximated(source, fast(16).deformation_solver(solver));
    expect_promises(source, run, 16);
  }
}

TEST(Approximation, same_result_for_any_number_of_threads)
{
  const auto source = Multiplanar_test::bumpy_sphere(8);
  const Outcome one = approximated(source, fast(16).number_of_threads(1).number_of_restarts(3));
  for (int threads : {2, 5}) {
    const Outcome more = approximated(source, fast(16).number_of_threads(threads).number_of_restarts(3));
    EXPECT_EQ(one.panels, more.panels);
    EXPECT_EQ(one.result.points, more.result.points);
  }
  const Outcome other = approximated(source, fast(16).number_of_threads(1).number_of_restarts(1));
  EXPECT_LE(one.result.hausdorff, 1.02 * other.result.hausdorff); // one of the three
}

TEST(Approximation, scaling_by_a_power_of_two_scales_the_result)
{
  const auto source = Multiplanar_test::bumpy_sphere(8);
  const double scale = 1.0 / (1 << 20);
  const auto small = Multiplanar_test::mapped(
      source, [&](const Point_3& p) { return Point_3(p.x() * scale, p.y() * scale, p.z() * scale); });
  const Outcome a = approximated(source, fast(16)), b = approximated(small, fast(16));
  expect_promises(small, b, 16);
  EXPECT_EQ(a.panels, b.panels);
}

TEST(Approximation, visitor_sees_every_pass_and_may_stop)
{
  struct Stop_after_two : Approximation_visitor
  {
    int passes = 0;
    bool progress(const std::string& stage, double) override { return stage != "approximate" || passes < 2; }
    void pass_done(int pass, const std::vector<Point_3>&, const std::vector<int>&) override { passes = pass + 1; }
  } visitor;
  const auto source = Multiplanar_test::bumpy_sphere(6);
  const Outcome run = approximated(source, fast(12).visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.passes, 2);
  EXPECT_EQ(run.result.iterations, 2);
  expect_promises(source, run, 12);
}

TEST(Approximation, refuses_what_does_not_fit)
{
  const auto sphere = Multiplanar_test::icosphere(1), ring = Multiplanar_test::torus(12, 8);
  EXPECT_THROW(approximated(sphere, fast(3)), std::invalid_argument);
  EXPECT_THROW(approximated(ring, fast(6)), std::invalid_argument);
  EXPECT_THROW(approximated(sphere, fast(100000)), std::invalid_argument);
  EXPECT_THROW(approximated(sphere, parameters::number_of_panels(8).smoothness_weight(-1.0)), std::invalid_argument);
  EXPECT_THROW(approximated(sphere, parameters::number_of_panels(8).number_of_iterations(0)), std::invalid_argument);
}

/// The panels with more of their faces above the equator than below, and those below; and the mean distances of the
/// two halves of the sphere from the panels.
struct Halves
{
  double panels_above = 0, panels_below = 0, distance_above = 0, distance_below = 0;
};

/// A sphere with its upper half painted, or nothing if `weight` is negative.
Halves halves_of_a_sphere(int k, double weight)
{
  const auto source = Multiplanar_test::icosphere(4);
  auto mesh = surface_mesh(source);
  auto saliency = mesh.add_property_map<Surface_mesh::Face_index, double>("f:saliency", 0).first;
  auto panel = mesh.add_property_map<Surface_mesh::Face_index, int>("f:panel").first;
  std::vector<std::array<int, 3>> triangles[2];
  for (auto f : mesh.faces()) {
    double z = 0;
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh)) z += mesh.point(v).z();
    saliency[f] = z > 0;
    triangles[z > 0].push_back(source.triangles[std::size_t(f)]);
  }
  const auto np = fast(k);
  const auto result =
      weight < 0 ? CGAL::multiplanar_approximation(mesh, panel, np)
                 : CGAL::multiplanar_approximation(mesh, panel, np.face_saliency_map(saliency).saliency_weight(weight));
  std::vector<int> height(result.complex.number_of_panels(), 0);
  for (auto f : mesh.faces()) height[panel[f]] += saliency[f] > 0 ? 1 : -1;
  Halves halves;
  for (int h : height) ++(h > 0 ? halves.panels_above : halves.panels_below);
  halves.distance_above = mean_distance(source.points, triangles[1], result.points, source.triangles);
  halves.distance_below = mean_distance(source.points, triangles[0], result.points, source.triangles);
  return halves;
}

TEST(Approximation, panels_go_where_the_saliency_is)
{
  const Halves plain = halves_of_a_sphere(30, -1), none = halves_of_a_sphere(30, 0), much = halves_of_a_sphere(30, 8);
  EXPECT_EQ(none.panels_above, plain.panels_above); // W = 0 changes nothing at all
  EXPECT_EQ(none.distance_above, plain.distance_above);
  EXPECT_NEAR(plain.panels_above / plain.panels_below, 1, 0.35);
  // 1 + W/4 = 3 where the search is long; here panels move one at a time, which ends within a factor of about 2 of that
  // (two panels cost as much more when merged as what is saved where one of twice their weight is split).
  EXPECT_GT(much.panels_above / much.panels_below, 1.5);
  EXPECT_LT(much.distance_above, 0.8 * plain.distance_above);
  EXPECT_GT(much.distance_below, 1.2 * plain.distance_below);
}

TEST(Approximation, labellings_are_logged_and_expansions_never_raise_the_energy)
{
  struct Log : Approximation_visitor
  {
    std::vector<Labelling_record> records;
    void labelled(const Labelling_record& record) override { records.push_back(record); }
  } log;
  const auto source = Multiplanar_test::bumpy_sphere(10, 0.25);
  const Outcome run = approximated(source, fast(20).visitor(std::ref(log)));
  ASSERT_EQ(log.records.size(), run.result.labellings.size());
  ASSERT_EQ(log.records.size(), 10u); // from the seeds, eight passes' own, and the frozen one
  for (std::size_t i = 0; i < log.records.size(); ++i) {
    const Labelling_record &r = log.records[i], &same = run.result.labellings[i];
    EXPECT_EQ(r.pass, int(i) < 9 ? int(i) : 8);
    EXPECT_EQ(r.frozen, i == 9);
    EXPECT_EQ(r.restart, 0);
    EXPECT_GT(r.before, 0);
    EXPECT_LE(r.expanded, r.planes * (1 + 1e-12));
    EXPECT_EQ(bool(r.expansions), (r.expanded < r.planes));
    EXPECT_GT(r.panels, 0);
    EXPECT_LE(r.number_of_panels, 20);
    EXPECT_EQ(r.panels, same.panels);
    EXPECT_EQ(r.changed_faces, same.changed_faces);
  }
  EXPECT_EQ(log.records[0].before, log.records[0].planes); // the planes of the seeds
  EXPECT_LT(log.records[0].expanded, log.records[0].before);
}

TEST(Approximation, restarts_are_logged_in_order_and_stop_together)
{
  struct Log : Approximation_visitor
  {
    std::vector<int> restarts;
    double last = 0;
    bool in_order = true;
    int passes = 0, most_passes = 1 << 20;
    void labelled(const Labelling_record& record) override { restarts.push_back(record.restart); }
    void pass_done(int, const std::vector<Point_3>&, const std::vector<int>&) override { ++passes; }
    bool progress(const std::string& stage, double fraction) override
    {
      if (stage != "approximate") return true;
      in_order = in_order && last <= fraction && fraction <= 1;
      last = fraction;
      return passes < most_passes;
    }
  };
  const auto source = Multiplanar_test::bumpy_sphere(6);
  Log log;
  const Outcome run = approximated(source, fast(12).number_of_restarts(3).number_of_threads(2).visitor(std::ref(log)));
  expect_promises(source, run, 12);
  ASSERT_EQ(log.restarts.size(), 30u);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(log.restarts[i], i / 10);
  EXPECT_TRUE(log.in_order);

  Log impatient;
  impatient.most_passes = 2;
  const Outcome stopped =
      approximated(source, fast(12).number_of_restarts(3).number_of_threads(1).visitor(std::ref(impatient)));
  EXPECT_EQ(impatient.passes, 4); // two passes, and one of each run that begins after that
  expect_promises(source, stopped, 12);
}

TEST(Approximation, changed_faces_do_not_depend_on_names)
{
  using internal::changed_faces;
  EXPECT_EQ(changed_faces({0, 0, 1, 1, 2}, {2, 2, 0, 0, 1}), 0);
  EXPECT_EQ(changed_faces({0, 0, 1, 1, 2}, {0, 0, 1, 2, 2}), 1);
  EXPECT_EQ(changed_faces({0, 0, 0, 0}, {0, 0, 0, 1}), 1); // a split moves the smaller part,
  EXPECT_EQ(changed_faces({0, 0, 0, 1}, {0, 0, 0, 0}), 1); // and so does a merger
}

/// A mesh of CGAL's own collection, from end to end.
TEST(Approximation, model_of_the_cgal_collection)
{
  const char* folder = std::getenv("MULTIPLANAR_CGAL_DATA");
  if (!folder) GTEST_SKIP() << "MULTIPLANAR_CGAL_DATA names no folder";
  const auto source = Multiplanar_test::read_off(std::string(folder) + "/meshes/homer.off");
  const Outcome run = approximated(source, fast(40));
  expect_promises(source, run, 40);
  EXPECT_LT(run.result.hausdorff, 0.1 * diagonal(source));
}

} // namespace
