// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include "../../Multiplanar/comparison/surface_quality.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// The command `compare`, and how it measures what other methods return.

using namespace Multiplanar_test;
namespace MPC = CGAL::Multiplanar::comparison;

namespace {

using Row = std::map<std::string, std::string>; // by the name of the column

std::vector<std::string> split(const std::string& line, char separator)
{
  std::vector<std::string> cells;
  std::stringstream in(line + separator);
  for (std::string cell; std::getline(in, cell, separator);) cells.push_back(cell);
  return cells;
}

std::vector<Row> rows_of(const std::string& tsv)
{
  std::vector<Row> rows;
  std::stringstream in(tsv);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = split(line, '\t');
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line, '\t');
    EXPECT_EQ(cells.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) rows.back()[names[i]] = cells[i];
  }
  return rows;
}

Mesh sphere() { return geodesic_sphere(6); }

double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

const Mesh corner = {{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// A surface over the points of a mesh, one panel a triangle.
MPC::Compared_surface as_surface(const Mesh& mesh)
{
  MPC::Compared_surface surface;
  surface.points = mesh.points;
  surface.triangles = mesh.triangles;
  surface.panels = int(mesh.triangles.size());
  for (const auto& t : mesh.triangles) surface.flat_together.emplace_back(t.begin(), t.end());
  return surface;
}

MPC::Surface_quality quality(const MPC::Compared_surface& surface)
{
  return MPC::surface_quality(corner.points, corner.triangles, surface);
}

} // namespace

TEST_F(Program_test, comparison_as_values)
{
  const std::string mesh = write("my_Bunny.off", off_text(sphere()));
  const Outcome outcome = run({"compare", mesh, "-k", "12,30", "--effort", "fast", "--tsv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::vector<Row> rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 6u) << outcome.out;
  const char* methods[] = {"Multiplanar", "CGAL VSA", "CGAL QEM"};
  const char* paper[] = {"", "", "", "4.66", "5.90", "8.25"}; // Table 1 has k = 30 and not 12
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    EXPECT_EQ(row.at("method"), methods[i % 3]);
    EXPECT_EQ(row.at("k"), i < 3 ? "12" : "30");
    EXPECT_EQ(row.at("paper_hausdorff_percent"), paper[i]);
    EXPECT_LE(number(row, "panels"), number(row, "k"));
    EXPECT_GE(number(row, "panels"), 4);
    EXPECT_EQ(number(row, "hausdorff_percent"),
              (std::max)(number(row, "to_panels_percent"), number(row, "to_input_percent")));
    EXPECT_GT(number(row, "mean_percent"), 0);
    EXPECT_LT(number(row, "mean_percent"), number(row, "hausdorff_percent"));
    EXPECT_GE(number(row, "processor_seconds"), 0);
  }
  for (std::size_t i : {0, 3}) {
    EXPECT_EQ(rows[i].at("closed") + rows[i].at("flat") + rows[i].at("intersections"), "yesyes0");
    EXPECT_LT(number(rows[i], "bent_percent"), 1e-7);
    EXPECT_EQ(rows[i].at("note"), "");
    EXPECT_EQ(rows[i + 1].at("flat"), "no"); // proxies are not planes that their corners lie in
    EXPECT_GT(number(rows[i + 1], "bent_percent"), 1e-3);
    EXPECT_EQ(rows[i + 2].at("flat"), "yes"); // triangles
  }
  EXPECT_EQ(names(), std::vector<std::string>{"my_Bunny.off"});
}

TEST_F(Program_test, comparison_as_a_table)
{
  const std::string mesh = write("ball.off", off_text(sphere()));
  const Outcome outcome = run({"compare", mesh, "-k", "12", "--effort", "fast", "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* word : {"ball.off", "Hausdorff", "to panels", "to input", "mean", "bent", "closed", "flat",
                           "intersections", "seconds", "Multiplanar", "CGAL VSA", "CGAL QEM", "geometric mean"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << "\n" << outcome.out;
  EXPECT_EQ(outcome.out.find("paper"), std::string::npos) << outcome.out; // no bunny
}

TEST_F(Program_test, comparison_measures_what_approximate_writes)
{
  const std::string mesh = write("ball.off", off_text(sphere()));
  const std::vector<std::string> options{"-k", "14", "--effort", "fast", "--seed", "5", "--thickness", "2"};
  std::vector<std::string> first{"approximate", mesh, "-o", path("shell.ply"), "--json-progress"},
      second{"compare", mesh, "--tsv"};
  first.insert(first.end(), options.begin(), options.end());
  second.insert(second.end(), options.begin(), options.end());
  const Outcome written = run(first), compared = run(second);
  ASSERT_EQ(written.code, 0) << written.err;
  ASSERT_EQ(compared.code, 0) << compared.err;
  const auto lines = split(written.out, '\n');
  const auto summary = nlohmann::json::parse(lines.at(lines.size() - 2));
  const Row row = rows_of(compared.out).at(0);
  EXPECT_EQ(number(row, "panels"), summary["panels"].get<double>());
  EXPECT_NEAR(number(row, "hausdorff_percent"), summary["hausdorff_percent"].get<double>(), 0.02); // bounds' width
}

TEST_F(Program_test, comparison_is_refused_where_it_cannot_be)
{
  const std::string mesh = write("ball.off", off_text(sphere()));
  for (const char* wrong : {"", "12,", "12,,14", "many", "12;14", "-3", "0"}) {
    const Outcome outcome = run({"compare", mesh, "-k", wrong});
    EXPECT_EQ(outcome.code, 2) << wrong << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  }
  for (const char* impossible : {"12,3", "12,100000"}) {
    const Outcome outcome = run({"compare", mesh, "-k", impossible});
    EXPECT_EQ(outcome.code, 3) << impossible << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(outcome.out.find("Multiplanar  "), std::string::npos); // before anything is computed
  }
  EXPECT_EQ(run({"compare", path("none.off")}).code, 3);
  EXPECT_EQ(run({"compare", mesh, "-o", path("out")}).code, 2); // it writes nothing
}

TEST(Surface_quality, of_the_model_itself)
{
  const auto q = quality(as_surface(corner));
  EXPECT_TRUE(q.closed);
  EXPECT_EQ(q.open_edges + q.crowded_edges + q.flat_triangles + q.intersections, 0);
  EXPECT_LT(q.hausdorff(), 2e-4);
  EXPECT_LT(q.mean, 1e-12);
  EXPECT_EQ(q.bend, 0);
}

TEST(Surface_quality, a_soup_is_measured_as_it_is)
{
  auto open = as_surface(corner);
  open.triangles.pop_back(); // the face x = 0: y = z = (1 - y - z) / sqrt 3 at the worst point
  auto q = quality(open);
  EXPECT_FALSE(q.closed);
  EXPECT_EQ(q.open_edges, 3);
  EXPECT_EQ(q.crowded_edges, 0);
  EXPECT_NEAR(q.to_surface, 1 / (2 + std::sqrt(3.)), 2e-4);
  EXPECT_LT(q.to_input, 2e-4);

  auto twice = as_surface(corner);
  twice.triangles.push_back(twice.triangles[0]);
  q = quality(twice);
  EXPECT_FALSE(q.closed);
  EXPECT_EQ(q.crowded_edges, 3);
  EXPECT_EQ(q.intersections, 1); // the face and its copy

  auto turned = as_surface(corner);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  q = quality(turned);
  EXPECT_FALSE(q.closed);
  EXPECT_EQ(q.crowded_edges, 3);
  EXPECT_EQ(q.intersections, 0);

  auto sliver = as_surface(corner);
  sliver.points.push_back(Point_3(0.5, 0, 0));
  sliver.triangles.push_back({0, 4, 1});
  q = quality(sliver);
  EXPECT_FALSE(q.closed);
  EXPECT_EQ(q.flat_triangles, 1);
}

TEST(Surface_quality, intersections_are_counted_between_closed_parts)
{
  auto two = as_surface(corner);
  for (const auto& p : corner.points) two.points.push_back(Point_3(p.x() + 0.1, p.y() + 0.1, p.z() + 0.1));
  for (const auto& t : corner.triangles) two.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  const auto q = quality(two);
  EXPECT_TRUE(q.closed);
  EXPECT_EQ(q.intersections, 3); // the slanted face of the first cuts three faces of the second
  two.points.resize(4);
  for (const auto& p : corner.points) two.points.push_back(Point_3(p.x() + 3, p.y(), p.z()));
  EXPECT_EQ(quality(two).intersections, 0);
}

TEST(Surface_quality, bends_are_distances_from_the_best_plane)
{
  auto bent = as_surface(corner);
  bent.points = {Point_3(0, 0, 0), Point_3(4, 0, 1), Point_3(4, 4, 0), Point_3(0, 4, 1)};
  bent.flat_together = {{0, 1, 2, 3}}; // a saddle: the plane z = 1/2
  EXPECT_NEAR(quality(bent).bend, 0.5, 1e-12);
  bent.flat_together = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(quality(bent).bend, 0);
}
