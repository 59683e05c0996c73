// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include "Frame_buffer.h"
#include "preview_scenes.h"
#include "render.h"
#include "write_png.h"

#include <CGAL/Multiplanar/make_panel_complex.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <sstream>

// The rasteriser: what it sees is compared with rays, sample by sample.

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

Scene_triangle triangle(const Point_3& a, const Point_3& b, const Point_3& c, const Linear_colour& colour = {1, 1, 1})
{
  Scene_triangle t;
  t.points = {a, b, c};
  const Vector_3 n = CGAL::cross_product(b - a, c - a);
  const Vector_3 unit = n / std::sqrt(n.squared_length());
  t.normals = {unit, unit, unit};
  t.colours = {colour, colour, colour};
  return t;
}

/// One over the depth at which the ray through (x, y) meets the triangle, 0 if it passes; `edge`: how near to its
/// border.
double meet(const Camera& camera, const Scene_triangle& t, double x, double y, double& edge)
{
  const Vector_3 ray = camera.ray(x, y); // of depth 1
  const Vector_3 a = t.points[0] - camera.eye, b = t.points[1] - camera.eye, c = t.points[2] - camera.eye;
  double s[3] = {CGAL::determinant(ray, b, c), CGAL::determinant(ray, c, a), CGAL::determinant(ray, a, b)};
  const double sum = s[0] + s[1] + s[2];
  for (double& w : s) w /= sum;
  edge = std::min({std::abs(s[0]), std::abs(s[1]), std::abs(s[2])});
  if (s[0] < 0 || s[1] < 0 || s[2] < 0) return 0;
  return sum / CGAL::determinant(a, b, c);
}

Scene random_scene(unsigned seed, int n)
{
  std::mt19937 random(seed);
  const auto coordinate = [&] { return double(random()) / 4294967296.0 * 2 - 1; };
  const auto point = [&] {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return Point_3(x, y, z);
  };
  Scene scene;
  for (int i = 0; i < n; ++i) {
    const Point_3 a = point(), b = point(), c = point();
    scene.triangles.push_back(triangle(a, b, c));
  }
  return scene;
}

TEST(Rasteriser_test, sees_what_rays_see)
{
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(seed, 12);
    const Camera camera = fit_camera(points_of(scene), Vector_3(0.3, 0.2 * seed, 1), Vector_3(0, 1, 0), 40, 30);
    Frame_buffer buffer(40, 30, 2);
    for (const Scene_triangle& t : scene.triangles) draw_triangle(buffer, {0, buffer.height}, camera, t, scene.up);
    int seen = 0;
    for (int j = 0; j < buffer.height; ++j)
      for (int i = 0; i < buffer.width; ++i) {
        double nearest = 0, clearance = 1;
        for (const Scene_triangle& t : scene.triangles) {
          double edge = 0;
          nearest = std::max(nearest, meet(camera, t, (i + 0.5) / 2, (j + 0.5) / 2, edge));
          clearance = std::min(clearance, edge);
        }
        if (clearance < 1e-9) continue; // on a border either answer is right
        EXPECT_NEAR(buffer.inverse_depth[j * buffer.width + i], nearest, 1e-6 * (1 + nearest)) << i << " " << j;
        seen += nearest > 0;
      }
    EXPECT_GT(seen, 200);
  }
}

TEST(Rasteriser_test, the_camera_shows_all_and_fills_the_picture)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Points points = points_of(random_scene(seed, 5));
    const Camera camera = fit_camera(points, Vector_3(1, 0.1 * seed, 1), Vector_3(0, 1, 0), 1200, 900);
    double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
    for (const Point_3& p : points) {
      const Camera::Projected q = camera(p);
      ASSERT_GT(q.inverse_depth, 0);
      low_x = std::min(low_x, q.x), high_x = std::max(high_x, q.x);
      low_y = std::min(low_y, q.y), high_y = std::max(high_y, q.y);
    }
    EXPECT_GE(low_x, 59.9);
    EXPECT_LE(high_x, 1140.1);
    EXPECT_GE(low_y, 44.9);
    EXPECT_LE(high_y, 855.1);
    EXPECT_TRUE(high_x - low_x > 1079 || high_y - low_y > 809) << "seed " << seed;
    const Camera::Projected q = camera(camera.eye + 3 * camera.ray(17, 23));
    EXPECT_NEAR(q.x, 17, 1e-6);
    EXPECT_NEAR(q.y, 23, 1e-6);
  }
}

TEST(Rasteriser_test, a_line_behind_a_face_is_hidden_and_one_on_it_is_not)
{
  Scene scene;
  scene.has_ground = false;
  scene.triangles.push_back(triangle(Point_3(-1, -1, 0), Point_3(1, -1, 0), Point_3(0, 1, 0)));
  const Camera camera = fit_camera(points_of(scene), Vector_3(0, 0, 1), Vector_3(0, 1, 0), 60, 60);
  const auto darkest = [&](double z) {
    Scene with_line = scene;
    with_line.lines.push_back({Point_3(-0.2, -0.5, z), Point_3(0.2, -0.5, z), 2, {0, 0, 0}});
    const Image image = render(with_line, camera);
    int result = 255;
    for (int y = 20; y < 58; ++y) result = std::min<int>(result, image.pixel(30, y)[0]);
    return result;
  };
  EXPECT_LT(darkest(0), 20);
  EXPECT_GT(darkest(-0.2), 100);
}

TEST(Rasteriser_test, borders_are_smooth_and_threads_change_nothing)
{
  const Mesh mesh = bumpy_sphere(6);
  const Scene scene = mesh_scene(mesh.points, mesh.triangles, Vector_3(0, 1, 0));
  const Camera camera = fit_camera(mesh.points, Vector_3(1, 0.4, 1), Vector_3(0, 1, 0), 160, 120);
  const Image one = render(scene, camera, 3, 1), three = render(scene, camera, 3, 3);
  EXPECT_EQ(one.rgba, three.rgba);
  // Along a row through the middle, the way from the background to the model takes a step in between.
  std::set<int> levels;
  for (int y = 0; y < one.height; ++y)
    for (int x = 0; x < one.width; ++x) levels.insert(one.pixel(x, y)[0]);
  EXPECT_GT(levels.size(), 40u);
  for (std::size_t i = 3; i < one.rgba.size(); i += 4) ASSERT_EQ(one.rgba[i], 255);
}

TEST(Rasteriser_test, a_model_is_seen_standing_on_its_base)
{
  Mesh box = cube(2);
  Points tall;
  for (const Point_3& p : box.points) tall.emplace_back(p.x(), p.y(), 3 * p.z());
  EXPECT_EQ(upward(tall, box.triangles), Vector_3(0, 1, 0)) << "a cuboid stands on any side";
  Points pyramid; // a flat base along z only
  for (const Point_3& p : box.points) {
    const double s = 1 - 0.4 * (p.z() - box.points[0].z());
    pyramid.emplace_back(s * p.x(), s * p.y(), p.z());
  }
  const Vector_3 up = upward(pyramid, box.triangles);
  EXPECT_EQ(up, Vector_3(0, 0, 1));
  const Vector_3 view = best_view(pyramid, box.triangles, up);
  EXPECT_NEAR(view.squared_length(), 1, 1e-12);
  EXPECT_GT(view * up, 0.2);
}

TEST(Panel_scene_test, shows_every_panel_and_every_edge)
{
  const Mesh mesh = cube(2);
  const auto connectivity = internal::make_connectivity(mesh.triangles, int(mesh.points.size()));
  std::vector<int> panel;
  for (const auto& t : mesh.triangles) {
    const Vector_3 n =
        CGAL::cross_product(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
    panel.push_back(2 * axis + (n[axis] > 0));
  }
  const Panel_complex complex = make_panel_complex(connectivity, mesh.points, panel, 6);
  const Scene scene = panels_scene(complex, Vector_3(0, 1, 0));
  EXPECT_EQ(scene.triangles.size(), 12u);
  EXPECT_EQ(scene.lines.size(), 12u);
  std::set<Linear_colour> colours;
  for (const Scene_triangle& t : scene.triangles) colours.insert(t.colours[0]);
  EXPECT_EQ(colours.size(), 6u);
}

TEST(Png_test, is_a_png_of_the_right_size)
{
  Image image(3, 2);
  std::ostringstream out;
  write_png(out, image, 5.9055);
  const std::string bytes = out.str();
  ASSERT_GT(bytes.size(), 60u);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\3\0\0\0\2", 8));
  EXPECT_NE(bytes.find(std::string("pHYs\0\0\x17\x12", 8)), std::string::npos); // 5906 pixels a metre
}

} // namespace
