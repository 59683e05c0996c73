// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <CGAL/IO/PLY.h>
#include <CGAL/squared_distance_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

// --repair: for every step a mesh that is refused without it and mended by it, with the words that say so.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

Mesh joined(Mesh a, const Mesh& b)
{
  const int shift = int(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

/// Every triangle on its own, its vertices moved by up to `most`.
Mesh torn(const Mesh& mesh, double most)
{
  std::mt19937_64 random(7);
  Mesh result;
  for (const auto& t : mesh.triangles) {
    const int first = int(result.points.size());
    for (int v : t) {
      double d[3];
      for (double& x : d) x = most * (double(random() % 2001) / 1000 - 1);
      const Point_3& p = mesh.points[std::size_t(v)];
      result.points.emplace_back(p.x() + d[0], p.y() + d[1], p.z() + d[2]);
    }
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// A torus whose tube goes around twice before it closes, so that it passes through itself all along.
Mesh doubly_wound_torus(int n, int m)
{
  Mesh mesh;
  const double full = 2 * std::acos(-1.);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = full * i / n, v = full * j / m, r = 1 + 0.3 * std::cos(v), x = 3 + r * std::cos(2 * v);
      mesh.points.emplace_back(x * std::cos(u), x * std::sin(u), r * std::sin(2 * v));
    }
  const auto vertex = [&](int i, int j) { return i % n * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh;
}

/// The largest distance of a point from the triangles of a mesh.
double farthest(const std::vector<Point_3>& points, const Mesh& mesh)
{
  using Triangle_3 = CGAL::Kernel_traits<Point_3>::Kernel::Triangle_3;
  double worst = 0;
  for (const Point_3& p : points) {
    double least = 1e300;
    for (const auto& t : mesh.triangles)
      least = (std::min)(
          least, CGAL::squared_distance(p, Triangle_3(mesh.points[std::size_t(t[0])], mesh.points[std::size_t(t[1])],
                                                      mesh.points[std::size_t(t[2])])));
    worst = (std::max)(worst, least);
  }
  return std::sqrt(worst);
}

class Program_repair : public Program_test
{
protected:
  Outcome approximate(const std::string& file, bool repair, const std::string& panels = "6") const
  {
    std::vector<std::string> words = {"approximate", file, "-o", path("shell.ply"), "-k", panels, "--effort", "fast"};
    if (repair) words.push_back("--repair");
    return run(words);
  }

  /// Refused without --repair; with it, mended by the step that says `words`, alone if `alone`.
  void expect_mended(const Mesh& mesh, const std::string& words, bool alone = true,
                     const std::string& panels = "6") const
  {
    SCOPED_TRACE(words);
    const std::string file = write("m.off", off_text(mesh));
    const Outcome refused = approximate(file, false, panels);
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("--repair"), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(path("shell.repaired.ply")));
    const Outcome mended = approximate(file, true, panels);
    ASSERT_EQ(mended.code, 0) << mended.err;
    EXPECT_NE(mended.out.find("warning: repair: " + words), std::string::npos) << mended.out;
    if (alone) {
      EXPECT_EQ(mended.out.find("repair: "), mended.out.rfind("repair: ")) << mended.out;
    }
    // What was saved needs no repair any more, and gives the same result.
    const std::string shell = content(path("shell.ply"));
    ASSERT_TRUE(fs::exists(path("shell.repaired.ply")));
    fs::copy_file(path("shell.repaired.ply"), path("saved.ply"), fs::copy_options::overwrite_existing);
    const Outcome again = approximate(path("shell.repaired.ply"), false, panels);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(content(path("shell.ply")), shell);
    fs::remove(path("shell.repaired.ply"));
    fs::remove(path("shell.ply"));
  }
};

} // namespace

TEST_F(Program_repair, open_edges_are_welded) { expect_mended(torn(cube(2), 1e-6), "welded "); }

TEST_F(Program_repair, degenerate_faces_are_removed)
{
  Mesh flat = cube(2);
  const auto t = flat.triangles[7];
  flat.points[std::size_t(t[0])] = CGAL::midpoint(flat.points[std::size_t(t[1])], flat.points[std::size_t(t[2])]);
  expect_mended(flat, "removed 1 face without area");

  Mesh twice = cube(2);
  twice.triangles.push_back({3, 3, 4});
  expect_mended(twice, "removed 1 face that used a vertex twice");

  Mesh copied = cube(2);
  copied.triangles.push_back(copied.triangles[5]);
  expect_mended(copied, "removed 1 copy of faces");

  Mesh fin = cube(2);
  fin.points.push_back(Point_3(3, 3, 3));
  fin.triangles.push_back({fin.triangles[0][0], fin.triangles[0][1], int(fin.points.size()) - 1});
  expect_mended(fin, "removed 1 face that hung on an edge of others");
}

TEST_F(Program_repair, faces_are_turned_to_agree)
{
  Mesh turned = cube(2);
  for (std::size_t f : {5, 17, 30}) std::swap(turned.triangles[f][0], turned.triangles[f][1]);
  expect_mended(turned, "turned 3 faces");
}

TEST_F(Program_repair, holes_are_filled)
{
  Mesh open = cube(2);
  open.triangles.erase(open.triangles.begin() + 12);
  open.triangles.erase(open.triangles.begin());
  expect_mended(open, "filled 2 holes with 2 triangles");
}

TEST_F(Program_repair, the_largest_component_is_kept)
{
  const Mesh crumb = mapped(cube(4), [](const Point_3& p) { return Point_3(5 + p.x() / 8, p.y() / 8, p.z() / 8); });
  expect_mended(joined(crumb, cube(2)), "kept the component of largest volume, left out 1 other");
}

TEST_F(Program_repair, self_intersections_are_resolved)
{
  Mesh spike = geodesic_sphere(3);
  spike.points[0] = Point_3(0, -3, 0.1); // through the other side
  expect_mended(spike, "resolved self-intersections", false);
}

TEST_F(Program_repair, what_cannot_be_mended_is_wrapped)
{
  const Mesh torus = doubly_wound_torus(16, 15);
  expect_mended(torus, "wrapped the mesh in a new surface", true, "30");
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  ASSERT_TRUE(CGAL::IO::read_PLY(path("saved.ply"), points, faces));
  EXPECT_LT(farthest(points, torus), 0.01);           // a 1800th of the diagonal and some
  EXPECT_GT(farthest(points, geodesic_sphere(2)), 1); // what is far is seen to be far
}

TEST_F(Program_repair, walls_that_cross_and_loose_walls_are_resolved)
{
  Mesh crossing = joined(cube(1), mapped(cube(1), [](const Point_3& p) { // every wall of one stands in the other
                           return Point_3(p.x() + 0.5, p.y() + 0.4, p.z() + 0.3);
                         }));
  std::mt19937_64 random(11);
  for (int i = 0; i < 20; ++i) { // loose walls
    for (int j = 0; j < 3; ++j)
      crossing.points.emplace_back(random() % 1000 / 500. - 1, random() % 1000 / 500. - 1, random() % 1000 / 500. - 1);
    const int n = int(crossing.points.size());
    crossing.triangles.push_back({0, n - 3, n - 2});
    crossing.triangles.push_back({n - 3, n - 1, 1});
  }
  const std::string file = write("m.off", off_text(crossing));
  EXPECT_EQ(approximate(file, false, "12").code, 3);
  const Outcome mended = approximate(file, true, "12");
  ASSERT_EQ(mended.code, 0) << mended.err;
  EXPECT_NE(mended.out.find("repair: "), std::string::npos) << mended.out;
}

TEST_F(Program_repair, a_moebius_band_becomes_a_closed_surface)
{
  const std::string file =
      write("m.off", "OFF\n5 5 0\n0 0 0\n1 0 0\n2 1 0\n1 2 1\n0 1 1\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n");
  const Outcome refused = approximate(file, false);
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find("not orientable"), std::string::npos) << refused.err;
  const Outcome mended = approximate(file, true, "3"); // closed and embedded: only the panels are too few
  EXPECT_EQ(mended.code, 3);
  EXPECT_NE(mended.err.find("panels are too few"), std::string::npos) << mended.err;
}

TEST_F(Program_repair, what_is_sound_stays_as_it_is)
{
  const std::string file = write("m.off", off_text(bumpy_sphere(4)));
  ASSERT_EQ(approximate(file, false).code, 0);
  const std::string shell = content(path("shell.ply"));
  const Outcome outcome = approximate(file, true);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("repair"), std::string::npos) << outcome.out;
  EXPECT_EQ(content(path("shell.ply")), shell);
  EXPECT_EQ(names(), (std::vector<std::string>{"m.off", "shell.ply"}));
}

TEST_F(Program_repair, make_saves_the_mended_mesh_in_its_folder_and_reports)
{
  Mesh open = cube(2);
  open.triangles.erase(open.triangles.begin());
  const std::string file = write("m.off", off_text(open));
  const std::vector<std::string> words = {"make",     file,   "-o",       path("out"), "-k",     "6",
                                          "--effort", "fast", "--repair", "--quiet",   "--size", "100"};
  for (int time = 0; time < 2; ++time) { // the second run replaces the first
    const Outcome made = run(words);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  EXPECT_EQ(content(path("out/repaired.ply")).substr(0, 4), "ply\n");
  const json report = json::parse(content(path("out/report.json")));
  EXPECT_EQ(report["warnings"][0], "repair: filled 1 hole with 1 triangle");
  EXPECT_EQ(run({"verify", path("out")}).code, 0);
}

TEST_F(Program_repair, texture_coordinates_stay_with_the_triangles_that_remain)
{
  std::string text = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  for (int v = 0; v < 8; ++v)
    text += "v " + std::to_string(v & 1) + " " + std::to_string(v >> 1 & 1) + " " + std::to_string(v >> 2) + "\n";
  for (const char* side : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "2 4 8 6", "4 3 7 8"}) { // the side x = 0 is missing
    std::istringstream corners(side);
    text += "f";
    int i = 1;
    for (std::string v; corners >> v; ++i) text += " " + v + "/" + std::to_string(i);
    text += "\n";
  }
  const Outcome mended = approximate(write("m.obj", text), true);
  ASSERT_EQ(mended.code, 0) << mended.err;
  EXPECT_NE(mended.out.find("filled 1 hole with 2 triangles"), std::string::npos) << mended.out;
  EXPECT_NE(mended.out.find("were dropped on 2 new triangles of 12"), std::string::npos) << mended.out;
  const std::string saved = content(path("shell.repaired.ply"));
  EXPECT_NE(saved.find("texcoord"), std::string::npos);
}
