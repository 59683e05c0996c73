// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>

// What the program reads, in every format, and what it refuses, in words that help.

using namespace Multiplanar_test;

namespace {

/// The value's bytes, least significant first or last.
template <class T>
std::string bytes_of(T value, bool big_endian)
{
  std::string bytes(sizeof value, 0);
  std::memcpy(&bytes[0], &value, sizeof value);
  const std::uint16_t probe = 1;
  const bool host_is_big = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  if (host_is_big != big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Binary PLY with properties and an element that do not concern the surface.
std::string binary_ply(const Mesh& mesh, bool big_endian)
{
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\ncomment # here\nelement vertex " + std::to_string(mesh.points.size()) +
                     "\nproperty float quality\nproperty double x\nproperty double y\nproperty double z\n"
                     "element junk 2\nproperty list uchar short of\nelement face " +
                     std::to_string(mesh.triangles.size()) +
                     "\nproperty uchar red\nproperty list uint uint vertex_index\nend_header\n";
  for (const Point_3& p : mesh.points) {
    text += bytes_of(1.5f, big_endian);
    for (int i = 0; i < 3; ++i) text += bytes_of(p[i], big_endian);
  }
  text += std::string(1, '\2') + "abcd" + std::string(1, '\0');
  for (const auto& t : mesh.triangles) {
    text += "r" + bytes_of(std::uint32_t(3), big_endian);
    for (int v : t) text += bytes_of(std::uint32_t(v), big_endian);
  }
  return text;
}

std::string binary_stl(const Mesh& mesh)
{
  std::string text(80, ' ');
  text.replace(0, 5, "solid"); // some writers begin so, though the rest is binary
  text += bytes_of(std::uint32_t(mesh.triangles.size()), false);
  for (const auto& t : mesh.triangles) {
    text += std::string(12, '\0');
    for (int v : t)
      for (int i = 0; i < 3; ++i) text += bytes_of(float(mesh.points[v][i]), false);
    text += std::string(2, '\0');
  }
  return text;
}

/// The unit cube with six square faces, and a hexagon-shaped list of vertices around it in the same order.
const char* const square_cube = "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                                "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// Replaces the first `from` in `text`.
std::string with(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Mesh joined(Mesh a, const Mesh& b)
{
  const int shift = int(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

Mesh moved(const Mesh& mesh, double x)
{
  return mapped(mesh, [x](const Point_3& p) { return Point_3(p.x() + x, p.y(), p.z()); });
}

class Program_input : public Program_test
{
protected:
  Outcome approximate(const std::string& file, const std::string& panels = "6") const
  {
    return run({"approximate", file, "-o", path("shell.ply"), "-k", panels, "--effort", "fast", "--quiet"});
  }

  /// The file is refused with exit code 3 and one line that names it and says all of `words`.
  void expect_refusal(const std::string& name, const std::string& text, const std::vector<std::string>& words,
                      const std::string& panels = "6") const
  {
    const std::string file = write(name, text);
    const Outcome outcome = approximate(file, panels);
    EXPECT_EQ(outcome.code, 3) << name << ": " << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind(file, 0), 0u) << outcome.err;
    for (const std::string& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_EQ(names(), std::vector<std::string>{name});
    fs::remove(file);
  }
};

} // namespace

TEST_F(Program_input, all_formats_give_the_same_shell)
{
  const Mesh mesh = cube(2); // coordinates are exact in every format
  ASSERT_EQ(approximate(write("m.off", off_text(mesh))).code, 0);
  const std::string expected = content(path("shell.ply"));
  const std::vector<std::pair<std::string, std::string>> files = {
      {"m.obj", obj_text(mesh)},
      {"little.ply", binary_ply(mesh, false)},
      {"big.ply", binary_ply(mesh, true)},
      {"disguised.stl", off_text(mesh)}, // the content decides
      {"m", obj_text(mesh)}};
  for (const auto& file : files) {
    const Outcome outcome = approximate(write(file.first, file.second));
    ASSERT_EQ(outcome.code, 0) << file.first << outcome.err;
    EXPECT_EQ(content(path("shell.ply")), expected) << file.first;
  }
}

TEST_F(Program_input, stl_is_welded)
{
  const Mesh mesh = cube(2);
  for (const std::string& text : {stl_text(mesh), binary_stl(mesh)}) {
    ASSERT_EQ(approximate(write("m.stl", text)).code, 0);
    const std::string header = content(path("shell.ply")).substr(0, 200);
    EXPECT_NE(header.find("element vertex " + std::to_string(mesh.points.size())), std::string::npos) << header;
    EXPECT_NE(header.find("element face 48"), std::string::npos) << header;
  }
}

TEST_F(Program_input, planar_polygons_are_triangulated)
{
  const Outcome outcome = approximate(write("m.off", square_cube));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(content(path("shell.ply")).find("element face 12"), std::string::npos);
}

TEST_F(Program_input, notes_say_what_was_done_to_the_mesh)
{
  Mesh inside_out = cube(2);
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  inside_out.points.push_back(Point_3(9, 9, 9));
  const Outcome outcome =
      run({"approximate", write("m.off", off_text(inside_out)), "-o", path("s.ply"), "-k", "6", "--effort", "fast"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("looked inward"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 vertices that no face uses"), std::string::npos) << outcome.out;
}

TEST_F(Program_input, unreadable_and_empty_files)
{
  const Outcome missing = approximate(path("missing.off"));
  EXPECT_EQ(missing.code, 3);
  EXPECT_EQ(missing.error_lines(), 1);
  EXPECT_EQ(approximate(folder.string()).code, 3);
  expect_refusal("empty.off", "", {"empty"});
  expect_refusal("nothing.off", "OFF\n0 0 0\n", {"empty"});
  expect_refusal("points.obj", "v 0 0 0\nv 1 0 0\n", {"empty", "2 vertices"});
  expect_refusal("letter.txt", "Dear Sir or Madam,\n", {"not a mesh"});
  expect_refusal("cut.glb", std::string("glTF\2\0\0\0", 8), {"damaged"});
}

TEST_F(Program_input, parse_errors_name_the_line)
{
  const std::string off = off_text(cube(1));
  expect_refusal("a.off", with(off, "\n1 1 1\n", "\n1 one 1\n"), {":", "\"one\" is not a number"});
  expect_refusal("b.off", with(off, "OFF\n8", "OFF\nmany"), {":2:", "many"});
  expect_refusal("c.off", with(off, "3 0 1 2", "3 0 1 77"), {":11:", "vertex 77"});
  expect_refusal("d.off", with(off, "3 0 1 2", "3 0 1 -2"), {":11:", "vertex -2"});
  expect_refusal("e.off", with(off, "3 0 1 2", "2 0 1"), {":11:", "2 vertices"});
  expect_refusal("f.off", with(off, "8 12 0", "8 13 0"), {"ends after 12 of 13 faces"});
  expect_refusal("g.off", with(off, "8 12 0", "4000000000 12 0"), {":2:"});
  expect_refusal("h.off", with(off, "8 12 0", "900000000 900000000 0"), {"ends after 20 of 900000000 vertices"});
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", {":4:", "vertex 0"});
  expect_refusal("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", {":4:", "vertex 4"});
  expect_refusal("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", {":4:", "vertex -4"});
  expect_refusal("d.obj", "v 0 0\n", {":1:", "three coordinates"});
  expect_refusal("e.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", {":3:", "2 vertices"});
  expect_refusal("a.stl", with(stl_text(cube(1)), "endfacet\nendsolid test", "endfacet"), {"cut short"});
  expect_refusal("b.stl", binary_stl(cube(1)).substr(0, 400), {"12 triangles"});
}

TEST_F(Program_input, ply_headers_are_not_trusted)
{
  const std::string ply = binary_ply(cube(1), false);
  expect_refusal("a.ply", ply.substr(0, ply.size() - 1), {"cut short"});
  expect_refusal("b.ply", ply.substr(0, ply.find("property double x")), {"header"});
  expect_refusal("c.ply", with(ply, "vertex 8", "vertex 999999999"), {"too short"});
  expect_refusal("d.ply", with(ply, "face 12", "face 99999999999999"), {"too short"});
  expect_refusal("e.ply", with(ply, "vertex 8", "vertex -8"), {":4:"});
  expect_refusal("f.ply", with(ply, "double x", "dubble x"), {":6:", "dubble"});
  expect_refusal("g.ply", with(ply, "double x", "double w"), {"x"});
  expect_refusal("h.ply", with(ply, "vertex_index", "triangles"), {"vertex_indices"});
  expect_refusal("i.ply", with(ply, "little_endian", "middle_endian"), {":2:"});
  expect_refusal("j.ply", with(ply, std::string("r\3\0\0\0", 5), std::string("r\xff\xff\xff\x7f", 5)), {"face 0"});
  expect_refusal("k.ply", with(ply, "element junk 2", "element \x1b[31m 2000000000"), {"too short"});
  expect_refusal("l.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 zero\n",
                 {":10:", "zero"});
}

TEST_F(Program_input, coordinates_must_be_finite_and_sensible)
{
  const std::string off = off_text(cube(1));
  for (const char* value : {"nan", "inf", "-inf", "1e999"})
    expect_refusal("m.off", with(off, "\n1 1 1\n", std::string("\n1 ") + value + " 1\n"), {"not finite"});
  Mesh mesh = cube(1);
  mesh.points[3] = Point_3(0, std::nan(""), 0);
  expect_refusal("m.ply", binary_ply(mesh, false), {"vertex 3", "not finite"});
  expect_refusal("m.stl", binary_stl(mesh), {"not finite"});
  expect_refusal(
      "huge.off",
      off_text(mapped(cube(1), [](const Point_3& p) { return Point_3(1e200 * p.x(), 1e200 * p.y(), 1e200 * p.z()); })),
      {"too large"});
}

TEST_F(Program_input, only_closed_manifolds_are_taken)
{
  Mesh open = cube(2);
  open.triangles.erase(open.triangles.begin() + 12); // on the side -x
  open.triangles.erase(open.triangles.begin());      // on the side +x
  expect_refusal("open.off", off_text(open), {"2 boundary loops", "closed"});

  Mesh turned = cube(2);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  expect_refusal("turned.off", off_text(turned), {"not consistently oriented", " 5 "});

  expect_refusal("moebius.off",
                 "OFF\n5 5 0\n0 0 0\n1 0 0\n2 1 0\n1 2 1\n0 1 1\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n",
                 {"not orientable"}, "4");

  Mesh fins = cube(2);
  fins.points.push_back(Point_3(3, 3, 3));
  fins.triangles.push_back({fins.triangles[0][0], fins.triangles[0][1], int(fins.points.size()) - 1});
  expect_refusal("fin.off", off_text(fins), {"not manifold", "3 faces"});

  // Two tetrahedra that share vertex 0: the second is the first, mirrored in it.
  Mesh pinched = joined(
      tetrahedron(), mapped(tetrahedron(), [](const Point_3& p) { return Point_3(2 - p.x(), 2 - p.y(), 2 - p.z()); }));
  for (std::size_t f = 4; f < 8; ++f) {
    for (int& v : pinched.triangles[f])
      if (v == 4) v = 0;
    std::swap(pinched.triangles[f][0], pinched.triangles[f][1]);
  }
  expect_refusal("pinched.off", off_text(pinched), {"not manifold", "vertex 0"}, "4");

  expect_refusal("two.off", off_text(joined(cube(2), moved(cube(2), 5))), {"2 components", "face 48"});
}

TEST_F(Program_input, degenerate_and_intersecting_faces_are_named)
{
  Mesh flat = cube(2);
  const auto t = flat.triangles[7];
  flat.points[t[0]] = CGAL::midpoint(flat.points[t[1]], flat.points[t[2]]);
  expect_refusal("flat.off", off_text(flat), {"degenerate", "face "});

  Mesh twice = cube(2);
  twice.triangles[4][0] = twice.triangles[4][1];
  expect_refusal("twice.off", off_text(twice), {"degenerate", "face 4"});

  Mesh spike = geodesic_sphere(3);
  spike.points[0] = Point_3(0, -3, 0.1); // through the other side
  expect_refusal("spike.off", off_text(spike), {"self-intersecting", "faces"});
}

TEST_F(Program_input, polygons_that_cross_themselves_cannot_be_triangulated)
{
  // A pyramid whose base names its corners in a crossing order.
  expect_refusal("crossed.obj",
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 3 2 4\nf 3 1 5\nf 2 3 5\nf 4 2 5\nf 1 4 5\n",
                 {"face 0"});
}

TEST_F(Program_input, the_number_of_panels_must_suit_the_surface)
{
  const std::string off = off_text(torus(12, 8));
  expect_refusal("torus.off", off, {"genus 1", "at least 7"}, "6");
  expect_refusal("torus.off", off, {"192 faces"}, "193");
  expect_refusal("cube.off", off_text(cube(1)), {"at least 4"}, "3");
  expect_refusal("cube.off", off_text(cube(1)), {"at least 4"}, "-7");
}

TEST_F(Program_input, mutilated_files_never_crash)
{
  const Mesh mesh = cube(1);
  const std::vector<std::pair<std::string, std::string>> files = {
      {"m.off", off_text(mesh)},         {"m.obj", obj_text(mesh)},   {"t.stl", stl_text(mesh)},
      {"m.ply", binary_ply(mesh, true)}, {"b.stl", binary_stl(mesh)}, {"q.off", square_cube}};
  const unsigned seed = 20260917;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 40; ++round)
    for (const auto& file : files) {
      std::string text = file.second;
      for (int i = int(random() % 4); i >= 0; --i) text[random() % text.size()] = char(random() % 256);
      if (random() % 3 == 0) text.resize(random() % text.size());
      const Outcome outcome = approximate(write(file.first, text));
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 3) << outcome.code << " " << outcome.err;
      EXPECT_EQ(outcome.error_lines(), outcome.code == 0 ? 0 : 1) << outcome.err;
    }
}

TEST_F(Program_input, too_few_panels_for_what_is_possible_are_said_so)
{
  // Seven flat faces can make a torus (Szilassi), but not one as thin as this.
  expect_refusal("ring.off", off_text(torus(24, 3, 1, 0.1)), {"no 7 flat panels were found", "genus 1", "144 faces", "-k"},
                 "7");
}
