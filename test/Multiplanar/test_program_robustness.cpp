// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <nlohmann/json.hpp>

#include <map>
#include <random>
#include <utility>

// The robustness suite on meshes made to be hard: each keeps all promises, as exact predicates on the written files see
// it, or is refused with the right message. And the suite itself: for every promise, a result that breaks it is
// noticed.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

/// What `multiplanar_robustness` says by its exit code.
enum Code
{
  kept = 0,
  connectivity = 10,
  not_closed = 11,
  not_embedded = 12,
  k_exceeded = 14,
  parts_overlap = 15,
  outside = 16,
  other_parts = 17,
  unreadable = 18,
  wrong_refusal = 19,
  left_behind = 20,
  time_limit = 21,
  memory_limit = 22,
  crash = 23
};

Mesh renumbered(const Mesh& mesh)
{
  std::mt19937_64 random(5);
  std::vector<int> place(mesh.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::size_t j = random() % (i + 1);
    place[i] = place[j];
    place[j] = int(i);
  }
  Mesh result = mesh;
  for (std::size_t i = 0; i < place.size(); ++i) result.points[std::size_t(place[i])] = mesh.points[i];
  for (auto& t : result.triangles)
    for (int& v : t) v = place[std::size_t(v)];
  for (std::size_t f = result.triangles.size(); f-- > 1;)
    std::swap(result.triangles[f], result.triangles[random() % (f + 1)]);
  return result;
}

Mesh scaled(const Mesh& mesh, double s)
{
  return mapped(mesh, [s](const Point_3& p) { return Point_3(s * p.x(), s * p.y(), s * p.z()); });
}

/// The surface of the cells of a grid that `is_inside` says; corners of cell i at x[i], x[i + 1] and so on.
template <class Is_inside>
Mesh surface_of_cells(const std::array<std::vector<double>, 3>& x, Is_inside is_inside)
{
  Mesh mesh;
  std::map<std::array<int, 3>, int> index;
  std::array<int, 3> n{};
  for (int k = 0; k < 3; ++k) n[k] = int(x[k].size()) - 1;
  const auto inside = [&](const std::array<int, 3>& c) {
    for (int k = 0; k < 3; ++k)
      if (c[k] < 0 || c[k] >= n[k]) return false;
    return bool(is_inside(c[0], c[1], c[2]));
  };
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto found = index.emplace(c, int(mesh.points.size()));
    if (found.second) mesh.points.emplace_back(x[0][c[0]], x[1][c[1]], x[2][c[2]]);
    return found.first->second;
  };
  for (std::array<int, 3> c{}; c[0] < n[0]; ++c[0])
    for (c[1] = 0; c[1] < n[1]; ++c[1])
      for (c[2] = 0; c[2] < n[2]; ++c[2])
        for (int axis = 0; axis < 3 && inside(c); ++axis)
          for (int side = 0; side < 2; ++side) {
            std::array<int, 3> next = c;
            next[axis] += side ? 1 : -1;
            if (inside(next)) continue;
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (!side) std::swap(u, v);
            std::array<int, 3> a = c;
            a[axis] += side;
            std::array<int, 3> b = a, d = a;
            ++b[u], ++d[v];
            std::array<int, 3> o = b;
            ++o[v];
            mesh.triangles.push_back({vertex(a), vertex(b), vertex(o)});
            mesh.triangles.push_back({vertex(a), vertex(o), vertex(d)});
          }
  return mesh;
}

/// A plate with eight square holes.
Mesh frame_of_genus_8()
{
  std::array<std::vector<double>, 3> x;
  for (int i = 0; i <= 9; ++i) x[0].push_back(i);
  for (int i = 0; i <= 5; ++i) x[1].push_back(i);
  x[2] = {0, 1};
  return surface_of_cells(x, [](int i, int j, int) { return i % 2 == 0 || j % 2 == 0; });
}

/// A block with a slit of this width from one side: its walls face each other.
Mesh slit_block(double width)
{
  const std::array<std::vector<double>, 3> x = {{{0, 1, 2}, {0, 1, 2}, {0, 0.5, 0.5 + width, 1 + width}}};
  return surface_of_cells(x, [](int i, int, int k) { return k != 1 || i == 0; });
}

/// A double pyramid of needles.
Mesh needles(int n)
{
  Mesh mesh;
  mesh.points = {Point_3(0, 0, 1), Point_3(0, 0, -1)};
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::acos(-1.) * i / n;
    mesh.points.emplace_back(std::cos(a), std::sin(a), 0);
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 + i, b = 2 + (i + 1) % n;
    mesh.triangles.push_back({a, b, 0});
    mesh.triangles.push_back({b, a, 1});
  }
  return mesh;
}

/// A cube whose sides are fans around points this far outside.
Mesh fans(double height)
{
  Mesh mesh = cube(1);
  const Mesh plain = mesh;
  mesh.triangles.clear();
  for (std::size_t f = 0; f < plain.triangles.size(); f += 2) {
    const auto t = plain.triangles[f];
    const int square[4] = {t[0], t[1], t[2], plain.triangles[f + 1][2]};
    const Point_3 middle = CGAL::midpoint(plain.points[std::size_t(t[0])], plain.points[std::size_t(t[2])]);
    const int m = int(mesh.points.size());
    mesh.points.push_back(CGAL::ORIGIN + (1 + height) * (middle - CGAL::ORIGIN));
    for (int i = 0; i < 4; ++i) mesh.triangles.push_back({square[i], square[(i + 1) % 4], m});
  }
  return mesh;
}

/// A tetrahedron of which one face is split again and again near one corner.
Mesh huge_and_tiny()
{
  Mesh mesh = tetrahedron();
  for (int i = 0; i < 12; ++i) {
    const auto t = mesh.triangles.back();
    const Point_3 a = mesh.points[std::size_t(t[0])], b = mesh.points[std::size_t(t[1])],
                  c = mesh.points[std::size_t(t[2])];
    const int m = int(mesh.points.size());
    mesh.points.push_back(a + 0.25 * (b - a) + 0.25 * (c - a) + 0.01 * CGAL::cross_product(b - a, c - a));
    mesh.triangles.back() = {t[1], t[2], m};
    mesh.triangles.push_back({t[2], t[0], m});
    mesh.triangles.push_back({t[0], t[1], m});
  }
  return mesh;
}

class Program_robustness : public Program_test
{
protected:
  /// The suite's exit code for a mesh file.
  int suite(const std::string& file, std::vector<std::string> options = {}) const
  {
    std::string command = std::string("\"") + MULTIPLANAR_ROBUSTNESS + "\" \"" + file + "\"";
    for (const std::string& option : options) command += " \"" + option + "\"";
    const int status = std::system((command + " > \"" + path("said") + "\" 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// All promises hold, and the mesh is taken or refused as `result` says.
  void expect_kept(const Mesh& mesh, int k, const std::string& result = "\tkept\t") const
  {
    EXPECT_EQ(suite(write("m.off", off_text(mesh)), {"-k", std::to_string(k)}), kept) << content(path("said"));
    EXPECT_NE(content(path("said")).find(result), std::string::npos) << content(path("said"));
  }

  /// A program that does this instead of multiplanar.
  std::string impostor(const std::string& script) const
  {
    const std::string file = write("impostor", "#!/bin/sh\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }
};

} // namespace

TEST_F(Program_robustness, renumbering_moving_and_scaling)
{
  const Mesh mesh = bumpy_sphere(4);
  expect_kept(renumbered(mesh), 14);
  expect_kept(mapped(mesh, [](const Point_3& p) { return p + Vector_3(1e6, -1e6, 1e6); }), 14);
  expect_kept(scaled(mesh, std::ldexp(1, -27)), 14);
  expect_kept(scaled(mesh, std::ldexp(1, 27)), 14);
}

TEST_F(Program_robustness, needles_and_near_coplanar_fans)
{
  expect_kept(needles(40), 20);
  expect_kept(fans(1e-12), 6);
}

TEST_F(Program_robustness, sheets_next_to_each_other)
{
  for (double width : {1e-12, 1e-7}) expect_kept(slit_block(width), 10);
  Mesh touching = slit_block(1);
  touching = mapped(touching, [](const Point_3& p) {
    return Point_3(p.x(), p.y(), p.z() > 1 ? p.z() - 1 : p.z()); // the slit closes: its walls touch
  });
  expect_kept(touching, 10, "\trefused\t");
}

TEST_F(Program_robustness, few_faces_many_handles_and_uneven_triangles)
{
  expect_kept(tetrahedron(), 4);
  expect_kept(frame_of_genus_8(), 40);
  expect_kept(huge_and_tiny(), 12);
}

TEST_F(Program_robustness, the_suite_notices_what_is_broken)
{
  const std::string mesh = write("m.off", off_text(cube(2)));
  ASSERT_EQ(run({"make", mesh, "-o", path("out"), "-k", "6", "--effort", "fast", "--quiet"}).code, 0);
  const std::vector<std::string> written = {"--written", path("out"), "-k", "6"};
  EXPECT_EQ(suite(mesh, written), kept) << content(path("said"));
  EXPECT_EQ(suite(mesh, {"--written", path("out"), "-k", "5"}), k_exceeded);
  EXPECT_EQ(suite(write("other.off", off_text(renumbered(cube(2)))), written), connectivity);
  const std::string shell = content(path("out/shell.ply"));
  write("out/shell.ply", shell.substr(0, shell.size() / 2));
  EXPECT_EQ(suite(mesh, written), unreadable);
  std::string moved = shell; // the first vertex flies far away
  const std::size_t first = shell.find("end_header\n") + 11;
  const double far = 40;
  moved.replace(first, sizeof far, reinterpret_cast<const char*>(&far), sizeof far);
  moved.replace(first + 8, sizeof far, reinterpret_cast<const char*>(&far), sizeof far);
  write("out/shell.ply", moved);
  const int code = suite(mesh, written);
  EXPECT_TRUE(code == 12 || code == 13) << code; // it crosses, or is bent
  std::string open = shell;
  open.replace(open.find("element face 48"), 15, "element face 47");
  write("out/shell.ply", open);
  EXPECT_EQ(suite(mesh, written), not_closed);
}

TEST_F(Program_robustness, the_suite_notices_parts_that_break_a_promise)
{
  const std::string mesh = write("m.off", off_text(cube(2))), model = "out/model.json";
  ASSERT_EQ(run({"make", mesh, "-o", path("out"), "-k", "6", "--effort", "fast", "--quiet"}).code, 0);
  const std::vector<std::string> written = {"--written", path("out"), "-k", "6"};
  const auto text = json::parse(content(path(model)));
  const auto seen = [&](const json& changed) {
    write(model, changed.dump());
    const int code = suite(mesh, written);
    const std::string said = content(path("said")); // every broken promise on a line, the first one is the code
    EXPECT_NE(said.find("violation: "), std::string::npos) << said;
    return std::make_pair(code, said);
  };

  json thick = text; // sheets of twice the thickness
  thick["settings"]["thickness"] = 2 * double(text["settings"]["thickness"]);
  EXPECT_EQ(seen(thick).first, parts_overlap);

  json missing = text;
  missing["parts"].erase(0);
  EXPECT_EQ(seen(missing).first, other_parts);

  // A part larger than its panel; what else it breaks may come first.
  json swollen = text;
  for (auto& p : swollen["parts"][0]["outline"])
    for (auto& x : p) x = 1.01 * double(x);
  const auto found = seen(swollen);
  EXPECT_NE(found.second.find(": outside: violation: part P01 leaves the model through panel"), std::string::npos)
      << found.second;
}

TEST_F(Program_robustness, the_first_promise_broken_by_the_parts_is_the_exit_code)
{
  const std::string mesh = write("m.off", off_text(cube(2)));
  const std::string real = "[ \"$1\" = make ] && exec \"" MULTIPLANAR_PROGRAM "\" \"$@\"; ";
  const auto verify_says = [&](const std::string& line, int code) {
    return suite(mesh, {"-k", "6", "--program", impostor(real + "echo '" + line + "'; exit " + std::to_string(code))});
  };
  EXPECT_EQ(verify_says("violation: parts P01 and P02 overlap near (0, 0, 0), 3 mm deep", 1), parts_overlap);
  EXPECT_EQ(verify_says("violation: part P01 leaves the model through panel P02 near (0, 0, 0), 3 mm deep", 1),
            outside);
  EXPECT_EQ(verify_says("violation: part P01 lies outside the model at (9, 9, 9)", 1), outside);
  EXPECT_EQ(verify_says("violation: part P01 faces inward", 1), other_parts);
  EXPECT_EQ(verify_says("unreadable: model.json: cannot be opened", 3), unreadable);
  EXPECT_EQ(verify_says("all is well", 1), other_parts);                      // the exit code tells otherwise
  EXPECT_EQ(verify_says("violation: part P01 faces inward", 0), other_parts); // and here, the words
  EXPECT_EQ(verify_says("all is well", 0), kept);
}

TEST_F(Program_robustness, the_suite_notices_crashes_limits_and_wrong_words)
{
  const std::string mesh = write("m.off", off_text(cube(2)));
  const auto with = [&](const std::string& script) { return suite(mesh, {"--program", impostor(script)}); };
  EXPECT_EQ(with("kill -SEGV $$"), crash);
  EXPECT_EQ(with("echo 'internal error' >&2; exit 1"), crash);
  EXPECT_EQ(with("echo \"$2: the moon is full\" >&2; exit 3"), wrong_refusal);
  EXPECT_EQ(with("echo \"$2: 1 boundary loop\" >&2; exit 3"), wrong_refusal); // it is closed
  EXPECT_EQ(with("exit 0"), unreadable);
  EXPECT_EQ(suite(mesh, {"--program", impostor("while :; do :; done"), "--seconds", "1"}), time_limit);
  EXPECT_EQ(with("echo 'out of memory: take a smaller mesh' >&2; exit 4"), memory_limit);
  Mesh open = cube(2);
  open.triangles.pop_back();
  const std::string opened = write("open.off", off_text(open));
  EXPECT_EQ(suite(opened), kept);
  EXPECT_EQ(suite(opened, {"--program",
                           impostor("touch \"$(dirname \"$4\")/junk\"; echo \"$2: 1 boundary loop\" >&2; exit 3")}),
            left_behind);
  EXPECT_EQ(suite(opened, {"--program", impostor("mkdir \"$4\"")}), wrong_refusal);
}

TEST_F(Program_robustness, too_little_memory_is_said_and_never_waited_for)
{
  // OpenBLAS asks for its buffers again and again if it does not get them.
  const std::string mesh = write("m.off", off_text(bumpy_sphere(4)));
  for (const char* kilobytes : {"150000", "180000"}) {
    const std::string limited =
        impostor(std::string("ulimit -v ") + kilobytes + "; exec timeout 60 \"" MULTIPLANAR_PROGRAM "\" \"$@\"");
    const std::string command =
        "\"" + limited + "\" make \"" + mesh + "\" -o \"" + path("out") + "\" -k 12 --effort fast --quiet";
    const int status = std::system((command + " > \"" + path("said") + "\" 2>&1").c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 4) << kilobytes << "\n" << content(path("said"));
    EXPECT_NE(content(path("said")).find("out of memory"), std::string::npos) << content(path("said"));
    EXPECT_FALSE(fs::exists(path("out")));
  }
}
