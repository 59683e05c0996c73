// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <sstream>

// What the options of the segmentation do, from the outside: saliency, restarts, the log of energies.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

Mesh sphere() { return bumpy_sphere(6); } // 720 faces

std::vector<int> panels_of_shell(const std::string& file)
{
  using Surface_mesh = CGAL::Surface_mesh<Point_3>;
  std::ifstream in(file, std::ios::binary);
  Surface_mesh mesh;
  std::string comments;
  EXPECT_TRUE(CGAL::IO::read_PLY(in, mesh, comments));
  const auto found = mesh.property_map<Surface_mesh::Face_index, std::int32_t>("f:panel");
  EXPECT_TRUE(found.second);
  std::vector<int> result;
  for (auto f : mesh.faces()) result.push_back(found.first[f]);
  return result;
}

std::string ply_with_saliency(const Mesh& mesh, bool binary)
{
  std::ostringstream out;
  out << "ply\nformat " << (binary ? "binary_little_endian" : "ascii") << " 1.0\nelement vertex " << mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nproperty float saliency\nend_header\n";
  out.precision(17);
  const auto put = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const Point_3& p : mesh.points)
    if (binary) put(p.x()), put(p.y()), put(p.z());
    else out << p << "\n";
  for (const auto& t : mesh.triangles) {
    const float saliency = mesh.points[t[0]].z() + mesh.points[t[1]].z() + mesh.points[t[2]].z() > 0 ? 1 : 0;
    if (binary) put((unsigned char)3), put(t), put(saliency);
    else out << "3 " << t[0] << " " << t[1] << " " << t[2] << " " << saliency << "\n";
  }
  return out.str();
}

TEST_F(Program_test, saliency_moves_panels_whichever_file_it_comes_from)
{
  const Mesh mesh = geodesic_sphere(12); // 2,880 faces
  const std::string input = write("m.off", off_text(mesh)), ascii = write("ascii.ply", ply_with_saliency(mesh, false)),
                    binary = write("binary.ply", ply_with_saliency(mesh, true));
  std::string values;
  for (const auto& t : mesh.triangles)
    values += mesh.points[t[0]].z() + mesh.points[t[1]].z() + mesh.points[t[2]].z() > 0 ? "1\n" : "0\n";
  const std::string text = write("values.txt", values);
  // Panels with most of their faces on the upper half, by those on the lower one.
  const auto ratio = [&](const std::string& file, const std::string& weight) {
    EXPECT_EQ(run({"approximate", input, "-o", path("s.ply"), "-k", "30", "--effort", "fast", "--iterations", "10",
                   "--saliency", file, "--saliency-weight", weight})
                  .code,
              0);
    const std::vector<int> panels = panels_of_shell(path("s.ply"));
    std::vector<int> height(30, 0);
    for (std::size_t f = 0; f < panels.size(); ++f) height[panels[f]] += values[2 * f] == '1' ? 1 : -1;
    return double(std::count_if(height.begin(), height.end(), [](int h) { return h > 0; })) /
           double(std::count_if(height.begin(), height.end(), [](int h) { return h < 0; }));
  };
  EXPECT_NEAR(ratio(text, "0"), 1, 0.35);
  const double much = ratio(text, "8");
  EXPECT_GT(much, 1.5); // 1 + W/4 = 3, within the factor of 2 that a short search leaves
  const std::string shell = content(path("s.ply"));
  for (const std::string& file : {ascii, binary}) {
    EXPECT_EQ(ratio(file, "8"), much);
    EXPECT_EQ(content(path("s.ply")), shell);
  }
}

TEST_F(Program_test, restarts_give_the_same_bytes_for_any_number_of_threads)
{
  const std::string input = write("m.off", off_text(sphere()));
  const auto shell = [&](const std::string& threads, const std::string& seed) {
    EXPECT_EQ(run({"approximate", input, "-o", path("s.ply"), "-k", "14", "--effort", "fast", "--restarts", "4",
                   "--threads", threads, "--seed", seed})
                  .code,
              0);
    return content(path("s.ply"));
  };
  const std::string one = shell("1", "3");
  for (const char* threads : {"2", "3"}) EXPECT_EQ(shell(threads, "3"), one);
  EXPECT_NE(shell("1", "40"), one);
}

TEST_F(Program_test, energies_of_the_labellings_are_told_and_reported)
{
  const std::string input = write("m.off", off_text(sphere()));
  const Outcome outcome = run({"make", input, "-o", path("out"), "-k", "14", "--effort", "fast", "--json-progress"});
  ASSERT_EQ(outcome.code, 0);
  std::stringstream lines(outcome.out);
  json told = json::array();
  for (std::string line; std::getline(lines, line);) {
    json event = json::parse(line);
    if (event["event"] != "labelling") continue;
    event.erase("event");
    EXPECT_LE(event["energy_after_expansions"], event["energy_after_planes"].get<double>() * (1 + 1e-12));
    told.push_back(event);
  }
  EXPECT_GE(told.size(), 2u);
  EXPECT_EQ(told, json::parse(content(path("out/report.json")))["labellings"]);
}

} // namespace
