// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "jpeg_bytes.h"
#include "program_runner.h"
#include "textured_cube.h"

#include "read_image.h"
#include "write_png.h"

#include <CGAL/Multiplanar/Linear_colour.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

// A cube with a texture, a colour a face, or a colour a vertex, in every format, through the program: what the images
// of the panels show at a point of the model is what the input shows there.

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;
using nlohmann::json;

class Textures_test : public Program_test
{
protected:
  void SetUp() override
  {
    Program_test::SetUp();
    std::ostringstream out;
    write_png(out, cube_texture());
    write("cube texture.png", out.str());
  }

  Outcome make(const std::string& input, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments = {"make", path(input), "-o", path("out"), "-k",  "6",           "--effort",
                                          "fast", "--size",    "40", "--dpi",     "100", "--no-preview"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Compares the images of all six panels with `expected`, a function of a point of the cube [0, 1]^3 and of the axis
  /// and the side (0 or 1) that it lies on; away from the borders of its colours.
  template <class Expected>
  void expect_panels(const Expected& expected, int tolerance = 2) const
  {
    const json model = json::parse(content(folder / "out/model.json"));
    const double scale = model["input"]["scale"];
    int panels = 0, checked = 0;
    for (const json& part : model["parts"]) {
      if (part["kind"] != "panel") continue;
      ++panels;
      ASSERT_TRUE(part.contains("texture")) << part["id"];
      const json& texture = part["texture"];
      const Image image = read_image(content(folder / "out" / std::string(texture["file"])));
      const double s = texture["mm_per_pixel"];
      EXPECT_NEAR(s, 25.4 / 100, 1e-12);
      for (int j = 0; j < image.height; ++j)
        for (int i = 0; i < image.width; ++i) {
          const double x = double(texture["origin"][0]) + (i + 0.5) * s;
          const double y = double(texture["origin"][1]) + (image.height - j - 0.5) * s;
          double p[3];
          int axis = 0, side = 0;
          bool inside = true;
          for (int k = 0; k < 3; ++k) {
            const json& frame = part["frame"];
            p[k] = (double(frame["origin"][k]) + x * double(frame["u"][k]) + y * double(frame["v"][k])) / scale;
            if (std::abs(double(frame["normal"][k])) > 0.9) axis = k, side = double(frame["normal"][k]) > 0;
            inside = inside && p[k] > -1e-6 && p[k] < 1 + 1e-6;
          }
          for (int k = 0; k < 3; ++k) // borders of colours: the sides and the middles
            if (k != axis) inside = inside && p[k] > 0.03 && p[k] < 0.97 && std::abs(p[k] - 0.5) > 0.06;
          if (!inside) continue;
          const std::array<int, 3> colour = expected(p, axis, side);
          const std::uint8_t* pixel = image.pixel(i, j);
          for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], colour[c], tolerance) << part["id"] << " " << i << " " << j;
          ++checked;
        }
    }
    EXPECT_EQ(panels, 6);
    EXPECT_GT(checked, 10000);
  }

  /// The input, the images and the rest are in one folder that the verifier accepts.
  void expect_verified() const
  {
    const Outcome verified = run({"verify", path("out")});
    EXPECT_EQ(verified.code, 0) << verified.out;
  }
};

std::array<int, 3> textured(const double* p, int axis, int side) { return cube_colour(p, axis, side); }

TEST_F(Textures_test, obj_with_a_material_and_seams)
{
  write("cube.mtl",
        "# a library\nnewmtl other\nKd 1 0 0\nnewmtl the skin\nKd 0 0 0\nmap_Kd -s 1 1 1 -o 0 0 cube texture.png\n");
  write("cube.obj", cube_obj("cube.mtl", "the skin"));
  const Outcome outcome = make("cube.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("distortion"), std::string::npos);
  EXPECT_EQ(outcome.out.find("warning: texture"), std::string::npos) << outcome.out;
  expect_panels(textured);
  expect_verified();
  for (const char* name : {"sheet-1.pdf", "sheet-1-mirrored.pdf"})
    EXPECT_EQ(content(folder / "out/textures" / name).substr(0, 5), "%PDF-") << name;
  const json report = json::parse(content(folder / "out/report.json"));
  EXPECT_EQ(report["textures"]["images"], 6);
  EXPECT_NEAR(double(report["textures"]["distortion"]["median"]), 1, 1e-3);
  EXPECT_NEAR(double(report["textures"]["distortion"]["p95"]), 1, 1e-3);
}

TEST_F(Textures_test, beyond_its_border_a_texture_repeats_or_stops)
{
  write("cube.obj", cube_obj("cube.mtl", "skin"));
  write("cube.mtl", "newmtl skin\nmap_Kd -o 0 1 cube texture.png\n");
  ASSERT_EQ(make("cube.obj").code, 0);
  expect_panels(textured);
  write("cube.mtl", "newmtl skin\nmap_Kd -clamp on -o 0 1 0 cube texture.png\n");
  ASSERT_EQ(make("cube.obj").code, 0);
  expect_panels([](const double* p, int axis, int side) {
    double top[3] = {p[0], p[1], p[2]};
    top[Cube_side(axis, side).b] = 0.99;
    return cube_colour(top, axis, side);
  });
}

TEST_F(Textures_test, the_shell_keeps_the_places_and_fabricate_takes_the_looks_from_the_source)
{
  write("cube.mtl", "newmtl skin\nmap_Kd cube texture.png\n");
  write("cube.obj", cube_obj("cube.mtl", "skin"));
  ASSERT_EQ(run({"approximate", path("cube.obj"), "-o", path("shell.ply"), "-k", "6", "--effort", "fast"}).code, 0);
  CGAL::Surface_mesh<Point_3> mesh;
  std::string comments;
  std::ifstream in(path("shell.ply"), std::ios::binary);
  ASSERT_TRUE(CGAL::IO::read_PLY(in, mesh, comments));
  for (const char* name : {"f:s0", "f:t0", "f:s1", "f:t1", "f:s2", "f:t2"})
    EXPECT_TRUE((mesh.property_map<CGAL::Surface_mesh<Point_3>::Face_index, float>(name).second)) << name;
  const Outcome outcome = run({"fabricate", path("shell.ply"), "--source", path("cube.obj"), "-o", path("out"),
                               "--size", "40", "--dpi", "100", "--no-preview"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_panels(textured);
  const Outcome other = run({"fabricate", path("shell.ply"), "--source", write("o.off", off_text(octahedron())), "-o",
                             path("other"), "--size", "40"});
  EXPECT_EQ(other.code, 3);
  EXPECT_EQ(other.error_lines(), 1) << other.err;
}

TEST_F(Textures_test, glb_with_an_embedded_picture)
{
  std::ostringstream png;
  write_png(png, cube_texture());
  for (const bool jpeg : {false, true}) {
    write("cube.glb", cube_glb(jpeg ? jpeg_bytes(cube_texture()) : png.str(), jpeg ? "image/jpeg" : "image/png"));
    const Outcome outcome = make("cube.glb");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_panels(textured, jpeg ? 12 : 2);
  }
  expect_verified();
}

TEST_F(Textures_test, damaged_glb_is_refused_with_one_line)
{
  std::ostringstream png;
  write_png(png, cube_texture());
  const std::string glb = cube_glb(png.str(), "image/png");
  for (std::size_t n : {std::size_t(4), std::size_t(20), glb.size() / 2, glb.size() - 10}) {
    write("cut.glb", glb.substr(0, n));
    const Outcome outcome = make("cut.glb");
    EXPECT_EQ(outcome.code, 3) << n << outcome.out << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  }
}

TEST_F(Textures_test, ply_with_places_at_corners)
{
  write("cube.ply", cube_ply("cube texture.png"));
  const Outcome outcome = make("cube.ply");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_panels(textured);
}

TEST_F(Textures_test, colours_of_materials_vertices_and_faces)
{
  write("cube.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0.2 1\n");
  write("two.obj", cube_obj_of_two_materials("cube.mtl", "a", "b"));
  ASSERT_EQ(make("two.obj").code, 0);
  expect_panels([](const double*, int axis, int) {
    return axis == 2 ? std::array<int, 3>{0, 51, 255} : std::array<int, 3>{255, 0, 0};
  });
  // The light of a vertex's colour is its place in the cube.
  const auto by_place = [](const double* p, int, int) {
    std::array<int, 3> colour;
    for (int c = 0; c < 3; ++c) colour[c] = int(std::lround(255 * srgb_of_linear(float(p[c]))));
    return colour;
  };
  for (const auto& file : {std::array<std::string, 2>{"v.obj", cube_obj_with_colours()},
                           {"v.ply", cube_ply_with_colours()},
                           {"v.off", cube_off_with_colours()}}) {
    write(file[0], file[1]);
    const Outcome outcome = make(file[0]);
    ASSERT_EQ(outcome.code, 0) << file[0] << outcome.err;
    expect_panels(by_place, 6);
  }
}

TEST_F(Textures_test, what_is_missing_is_told_and_stays_plain)
{
  fs::create_directory(folder / "below");
  for (const char* picture : {"nowhere.png", "../cube texture.png", "/etc/hostname", "cube.mtl", ""}) {
    write("below/cube.mtl", std::string("newmtl skin\nKd 0 1 0\nmap_Kd ") + picture + "\n");
    write("below/cube.obj", cube_obj("cube.mtl", "skin"));
    const Outcome outcome = make("below/cube.obj");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("stays plain"), std::string::npos) << picture << outcome.out;
    expect_panels([](const double*, int, int) { return std::array<int, 3>{0, 255, 0}; });
  }
  write("below/cube.obj", cube_obj("gone.mtl", "skin"));
  EXPECT_EQ(make("below/cube.obj").code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/textures")) << "nothing to print";
}

TEST_F(Textures_test, saliency_is_painted_on_the_texture)
{
  write("cube.obj", cube_obj("", ""));
  Image white = cube_texture();
  std::fill(white.rgba.begin(), white.rgba.end(), std::uint8_t(255));
  std::ostringstream out;
  write_png(out, white);
  write("s.png", out.str());
  write("broken.png", out.str().substr(0, 60));
  EXPECT_EQ(make("cube.obj", {"--saliency", path("s.png")}).code, 0);
  EXPECT_EQ(json::parse(content(folder / "out/report.json"))["settings"]["saliency"], true);
  const Outcome broken = make("cube.obj", {"--saliency", path("broken.png")});
  EXPECT_EQ(broken.code, 3);
  EXPECT_EQ(broken.error_lines(), 1) << broken.err;
  write("plain.off", off_text(cube()));
  const Outcome plain = make("plain.off", {"--saliency", path("s.png")});
  EXPECT_EQ(plain.code, 3);
  EXPECT_NE(plain.err.find("texture coordinates"), std::string::npos) << plain.err;
}

TEST_F(Textures_test, dots_per_inch_have_bounds)
{
  write("cube.mtl", "newmtl skin\nmap_Kd cube texture.png\n");
  write("cube.obj", cube_obj("cube.mtl", "skin"));
  EXPECT_EQ(make("cube.obj", {"--dpi", "5"}).code, 2);
  const std::vector<std::string> arguments = {"make",     path("cube.obj"), "-o",     path("big"), "-k",    "6",
                                              "--effort", "fast",           "--size", "380",       "--dpi", "2400"};
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("at most --dpi"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "big"));
}

TEST_F(Textures_test, pictures_of_everything_are_drawn_and_drawn_anew)
{
  write("cube.mtl", "newmtl skin\nmap_Kd cube texture.png\n");
  write("cube.obj", cube_obj("cube.mtl", "skin"));
  ASSERT_EQ(run({"make", path("cube.obj"), "-o", path("out"), "-k", "6", "--effort", "fast", "--size", "60"}).code, 0);
  std::map<std::string, std::string> before;
  for (const char* name : {"input", "panels", "assembled", "inside", "exploded", "sheet-1"}) {
    const std::string file = std::string("preview/") + name + ".png";
    before[file] = content(folder / "out" / file);
    const Image image = read_image(before[file]);
    EXPECT_GE(image.width, 1200) << file;
    std::set<std::array<int, 3>> colours;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    EXPECT_GT(colours.size(), 50u) << file;
  }
  fs::remove(folder / "out/preview/panels.png");
  const Outcome again = run({"preview", path("out")});
  ASSERT_EQ(again.code, 0) << again.err;
  for (const char* name : {"panels", "inside", "sheet-1"}) {
    const std::string file = std::string("preview/") + name + ".png";
    EXPECT_EQ(content(folder / "out" / file), before[file]) << file;
  }
  EXPECT_EQ(run({"preview", path("nowhere")}).code, 3);
  write("out/model.json", "{\"format\": \"multiplanar-model\"}");
  const Outcome damaged = run({"preview", path("out")});
  EXPECT_EQ(damaged.code, 3);
  EXPECT_EQ(damaged.error_lines(), 1) << damaged.err;
}

} // namespace
