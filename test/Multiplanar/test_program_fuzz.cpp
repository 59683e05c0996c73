// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"
#include "textured_cube.h"

#include "write_png.h"

#include <random>
#include <sstream>

// Files of every format and command lines, mutated by a seeded generator: whatever comes, the program ends by itself,
// with a documented exit code and one line.

using namespace Multiplanar_test;

namespace {

/// Words where numbers and names are expected.
const char* const hostile_words[] = {"nan",
                                     "-inf",
                                     "1e308",
                                     "-1e308",
                                     "1e-320",
                                     "-1",
                                     "0",
                                     "2147483648",
                                     "4294967297",
                                     "1e9",
                                     "",
                                     "18446744073709551616",
                                     "999999999",
                                     "\\",
                                     "../../../../etc/passwd",
                                     "%s%n",
                                     "\x1b[31m",
                                     "0x10",
                                     "1/2/3/4",
                                     "-9999999999999999999"};

class Program_fuzz : public Program_test
{
protected:
  std::uint64_t below(std::uint64_t n) { return random() % n; }

  std::string hostile_word() { return hostile_words[below(std::size(hostile_words))]; }

  /// Another word in the place of one of the words of a text.
  std::string with_hostile_word(const std::string& text)
  {
    const std::size_t at = std::size_t(below(text.size()));
    const std::size_t begin = text.find_last_of(" \n", at), end = text.find_first_of(" \n", at);
    const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
    return text.substr(0, first) + hostile_word() + (end == std::string::npos ? "" : text.substr(end));
  }

  std::string with_random_bytes(std::string text)
  {
    for (std::uint64_t i = below(4) + 1; i > 0; --i) text[std::size_t(below(text.size()))] = char(below(256));
    return text;
  }

  /// A line, or what would be one, twice or in another place.
  std::string with_moved_piece(const std::string& text)
  {
    const std::size_t a = std::size_t(below(text.size())), n = std::size_t(below(200)),
                      b = std::size_t(below(text.size()));
    return text.substr(0, b) + text.substr(a, n) + text.substr(b);
  }

  std::string mutated(std::string text)
  {
    for (std::uint64_t i = below(3) + 1; i > 0 && !text.empty(); --i) switch (below(4)) {
      case 0:
        text = with_hostile_word(text);
        break;
      case 1:
        text = with_random_bytes(text);
        break;
      case 2:
        text = with_moved_piece(text);
        break;
      default:
        text.resize(std::size_t(below(text.size())));
        break;
      }
    return text;
  }

  /// Read and judged, and then refused for its three panels at the latest.
  void expect_refusal(const std::string& file) const
  {
    const Outcome outcome = run({"approximate", file, "-o", path("s.ply"), "-k", "3", "--quiet"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }

  static constexpr unsigned seed = 20261123;
  std::mt19937_64 random{seed};
};

std::string png(const CGAL::Multiplanar::Image& image)
{
  std::ostringstream out;
  write_png(out, image);
  return out.str();
}

/// All the statements that the reader of material libraries knows.
const char* const library = "# a comment\nnewmtl paint\nKd 0.5 0.25 1\nd 0.5\nmap_Kd -clamp on -s 2 3 1 -o 0.5 0.5 0 "
                            "-mm 0 1 -bm 1 -texres 64 -imfchan r cube texture.png\nmap_Bump -bm 0.1 nowhere.png\n"
                            "newmtl other\nKd 1\nmap_kd \"cube texture.png\"\n";

} // namespace

TEST_F(Program_fuzz, files_of_every_format)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Mesh mesh = cube(1);
  const std::vector<std::pair<std::string, std::string>> files = {
      {"m.off", off_text(mesh)},
      {"c.off", cube_off_with_colours()},
      {"m.obj", cube_obj("m.mtl", "paint")},
      {"m.stl", stl_text(mesh)},
      {"m.ply", cube_ply("a.png")},
      {"c.ply", cube_ply_with_colours()},
      {"m.glb", cube_glb(png(CGAL::Multiplanar::Image(4, 4)), "image/png")}};
  for (int round = 0; round < 40; ++round)
    for (const auto& file : files) {
      const std::string text = mutated(file.second);
      SCOPED_TRACE("round " + std::to_string(round) + ", " + file.first);
      expect_refusal(write(file.first, text));
    }
}

TEST_F(Program_fuzz, material_libraries)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  write("cube texture.png", png(cube_texture()));
  const std::string mesh = write("m.obj", cube_obj("m.mtl", "paint"));
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    write("m.mtl", mutated(library));
    expect_refusal(mesh);
  }
}

TEST_F(Program_fuzz, meshes_under_repair)
{
  // Few rounds: one in six has to be wrapped, which takes ten seconds.
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::string text = off_text(cube(1));
  for (int round = 0; round < 8; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Mesh mesh = cube(1);
    for (std::uint64_t i = below(4) + 1; i > 0; --i)
      mesh.triangles[std::size_t(below(12))][std::size_t(below(3))] = int(below(8));
    const Outcome outcome =
        run({"approximate", write("m.off", off_text(mesh)), "-o", path("s.ply"), "-k", "3", "--repair"});
    EXPECT_EQ(outcome.code, 3) << outcome.err << off_text(mesh);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  }
}

TEST_F(Program_fuzz, command_lines)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::string mesh = write("m.off", off_text(cube(1)));
  const std::vector<std::string> words = {
      "make",    "approximate", "fabricate",  "verify",    "preview",    "compare",   mesh,    "-o",       path("out"),
      "-k",      "3",           "--panels",   "--seed",    "--size",     "--effort",  "fast",  "--repair", "--fit",
      "--sheet", "600x400",     "--material", "birch",     "--joints",   "teeth",     "--dpi", "--help",   "--quiet",
      "--kerf",  "--margin",    "--",         "--threads", "--restarts", "--saliency"};
  for (int round = 0; round < 150; ++round) {
    std::vector<std::string> line = {words[std::size_t(below(6))], mesh, "-o", path("out"), "-k", "3"};
    for (std::uint64_t i = below(6); i > 0; --i) {
      const std::size_t at = std::size_t(below(line.size() + 1));
      line.insert(line.begin() + std::ptrdiff_t(at),
                  below(3) ? words[std::size_t(below(words.size()))] : hostile_word());
    }
    if (below(3) == 0) line.erase(line.begin() + std::ptrdiff_t(below(line.size())));
    SCOPED_TRACE(::testing::PrintToString(line));
    const Outcome outcome = run(line);
    EXPECT_TRUE(outcome.code >= 0 && outcome.code <= 4 && outcome.code != 1) << outcome.code << outcome.err;
    EXPECT_EQ(outcome.error_lines(), outcome.code == 0 ? 0 : 1) << outcome.err;
    std::error_code ignored;
    fs::remove_all(path("out"), ignored);
  }
}

TEST_F(Program_fuzz, libraries_that_name_themselves_and_each_other)
{
  // A library cannot include another: statements of meshes mean nothing in it.
  write("a.mtl", "mtllib b.mtl\nmtllib a.mtl\nnewmtl paint\nKd 1 0 0\nmap_Kd a.mtl\n");
  write("b.mtl", "mtllib a.mtl\nnewmtl paint\nmap_Kd m.obj\n");
  std::string text = cube_obj("a.mtl", "paint");
  for (int i = 0; i < 100; ++i) text = "mtllib a.mtl b.mtl m.obj\n" + text;
  const Outcome outcome = run(
      {"make", write("m.obj", text), "-o", path("out"), "-k", "6", "--effort", "fast", "--size", "40", "--no-preview"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("stays plain"), std::string::npos) << outcome.out;
}

TEST_F(Program_fuzz, pictures_that_are_very_wide_or_damaged)
{
  CGAL::Multiplanar::Image wide(20000, 40);
  for (std::size_t i = 3; i < wide.rgba.size(); i += 4) wide.rgba[i] = 255;
  const std::string bytes = png(wide);
  std::string lying = bytes;
  lying.replace(16, 8, std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff")); // says that it is 2^31 pixels wide and high
  write("m.mtl", "newmtl paint\nmap_Kd a.png\n");
  const std::string mesh = write("m.obj", cube_obj("m.mtl", "paint"));
  const std::vector<std::pair<std::string, bool>> pictures = {
      {bytes, true}, {lying, false}, {bytes.substr(0, bytes.size() / 2), false}, {"GIF89a", false}};
  for (const auto& picture : pictures) {
    write("a.png", picture.first);
    const Outcome outcome = run({"make", mesh, "-o", path("out"), "-k", "6", "--effort", "fast", "--size", "40",
                                 "--dpi", "50", "--no-preview"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("stays plain") == std::string::npos, picture.second) << outcome.out;
  }
}
