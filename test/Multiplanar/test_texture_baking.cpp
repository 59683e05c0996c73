// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/parts_from_panels.h>
#include <CGAL/Multiplanar/texture_baking.h>

#include <CGAL/Polygon_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

// A sphere becomes an octahedron. Its texture says in every colour which point of the sphere it belongs to, and every
// triangle lies somewhere else in it: seams all around. The panels must tell the same points.

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

constexpr double size_mm = 60; // of the octahedron, from corner to corner

struct Coloured_model
{
  Mesh source;
  Points shell; ///< mm
  std::vector<int> panel;
  Panel_complex complex;
  Surface_appearance looks;
  double texel = 0; ///< the largest texel on the source
};

/// A point of the unit sphere as a colour.
std::array<double, 3> coded(const Point_3& p) { return {(p.x() + 1) / 2, (p.y() + 1) / 2, (p.z() + 1) / 2}; }

Point_3 decoded(const std::uint8_t* pixel)
{
  return Point_3(pixel[0] / 127.5 - 1, pixel[1] / 127.5 - 1, pixel[2] / 127.5 - 1);
}

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

/// Puts a triangle into its cell of the texture: corners (2, 2), (c - 2, 2), (2, c - 2) in texels, colours carried on
/// beyond its sides so that filters at its border see what belongs there.
void draw_cell(Image& image, int f, int columns, int cell, const std::array<Point_3, 3>& corners,
               std::array<Texture_point, 3>& places)
{
  const int x0 = f % columns * cell, y0 = f / columns * cell; // y upward
  const double low = 2, high = cell - 2;
  const double at[3][2] = {{low, low}, {high, low}, {low, high}};
  for (int i = 0; i < 3; ++i) places[i] = {float((x0 + at[i][0]) / image.width), float((y0 + at[i][1]) / image.height)};
  for (int j = 0; j < cell; ++j)
    for (int i = 0; i < cell; ++i) {
      const double u = (i + 0.5 - low) / (high - low), v = (j + 0.5 - low) / (high - low);
      const Point_3 p = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
      const std::array<double, 3> colour = coded(p);
      std::uint8_t* pixel = image.pixel(x0 + i, image.height - 1 - (y0 + j));
      for (int c = 0; c < 3; ++c) pixel[c] = std::uint8_t(std::lround(255 * std::min(1., std::max(0., colour[c]))));
      pixel[3] = 255;
    }
}

Coloured_model coloured_model(int n, int cell)
{
  Coloured_model model;
  const Mesh flat = subdivided(octahedron(), n);
  model.source = flat;
  for (Point_3& p : model.source.points) p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / distance(p, Point_3(0, 0, 0));
  for (const Point_3& p : flat.points) {
    const double s = size_mm / 2 / (std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()));
    model.shell.emplace_back(s * p.x(), s * p.y(), s * p.z());
  }
  const int faces = int(flat.triangles.size()), columns = int(std::ceil(std::sqrt(double(faces))));
  Image image(columns * cell, (faces + columns - 1) / columns * cell);
  model.looks.texture_points.resize(faces);
  model.looks.texture_of_triangle.assign(faces, 0);
  model.looks.colours.assign(faces, {Linear_colour{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  for (int f = 0; f < faces; ++f) {
    std::array<Point_3, 3> corners;
    Vector_3 sum(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      corners[i] = model.source.points[flat.triangles[f][i]];
      sum = sum + (model.shell[flat.triangles[f][i]] - CGAL::ORIGIN);
    }
    model.panel.push_back((sum.x() > 0) + 2 * (sum.y() > 0) + 4 * (sum.z() > 0));
    draw_cell(image, f, columns, cell, corners, model.looks.texture_points[f]);
    for (int i = 0; i < 3; ++i)
      model.texel = std::max(model.texel, distance(corners[i], corners[(i + 1) % 3]) / (cell - 4));
  }
  model.looks.textures.emplace_back(std::move(image));
  const auto connectivity = internal::make_connectivity(flat.triangles, int(flat.points.size()));
  model.complex = make_panel_complex(connectivity, model.shell, model.panel, 8);
  return model;
}

struct Baked_panel
{
  Frame frame;
  std::vector<Outline> loops;
  Texture_grid grid;
  Image image;
  std::vector<int> faces;
};

Baked_panel bake(const Coloured_model& model, int p, const Baking_options& options)
{
  Baked_panel result;
  result.frame = internal::part_from_panel(model.complex, p).frame;
  result.loops = panel_loops(model.complex, p, result.frame);
  result.grid = texture_grid(result.loops, options);
  for (int f = 0; f < int(model.panel.size()); ++f)
    if (model.panel[f] == p) result.faces.push_back(f);
  result.image =
      bake_panel(result.grid, result.faces, model.source.triangles, model.shell, result.frame, model.looks, options);
  return result;
}

/// The point of the source that became the point `q` of the shell: by trying all triangles of the panel.
Point_3 source_point(const Coloured_model& model, const std::vector<int>& faces, const Point_3& q)
{
  double best = -1e300;
  Point_3 result;
  for (int f : faces) {
    const auto& t = model.source.triangles[f];
    const Point_3 &a = model.shell[t[0]], &b = model.shell[t[1]], &c = model.shell[t[2]];
    const Vector_3 n = CGAL::cross_product(b - a, c - a);
    const double nn = n * n, wb = CGAL::cross_product(q - a, c - a) * n / nn,
                 wc = CGAL::cross_product(b - a, q - a) * n / nn;
    const double inside = std::min({1 - wb - wc, wb, wc});
    if (inside <= best) continue;
    best = inside;
    const Point_3 &sa = model.source.points[t[0]], &sb = model.source.points[t[1]], &sc = model.source.points[t[2]];
    result = sa + wb * (sb - sa) + wc * (sc - sa);
  }
  return result;
}

/// Distance from a polygon, 0 inside.
double distance_to(const std::vector<Outline>& loops, const Point_2& q)
{
  const CGAL::Polygon_2<Kernel> polygon(loops[0].begin(), loops[0].end());
  if (polygon.bounded_side(q) != CGAL::ON_UNBOUNDED_SIDE) return 0;
  double best = 1e300;
  for (auto e = polygon.edges_begin(); e != polygon.edges_end(); ++e)
    best = std::min(best, std::sqrt(CGAL::squared_distance(q, *e)));
  return best;
}

TEST(Texture_baking_test, random_points_of_each_panel_show_their_source_point)
{
  const Coloured_model model = coloured_model(6, 20);
  std::mt19937 random(11);
  const auto unit = [&] { return double(random()) / 4294967296.0; };
  for (int p = 0; p < 8; ++p) {
    const Baked_panel panel = bake(model, p, {300, 3});
    int checked = 0;
    for (int k = 0; k < 4000; ++k) {
      const int i = int(unit() * panel.grid.width), j = int(unit() * panel.grid.height);
      const Point_2 q = panel.grid.centre(i, j);
      if (distance_to(panel.loops, q) > 0) continue;
      const std::uint8_t* pixel = panel.image.pixel(i, j);
      ASSERT_EQ(pixel[3], 255);
      const Point_3 expected = source_point(model, panel.faces, panel.frame(q));
      // The rounding of colours comes on top of the texel.
      EXPECT_LT(distance(decoded(pixel), expected), model.texel + 1. / 127.5)
          << "panel " << p << " pixel " << i << " " << j;
      ++checked;
    }
    EXPECT_GT(checked, 500);
  }
}

TEST(Texture_baking_test, reducing_keeps_the_place_too)
{
  const Coloured_model model = coloured_model(3, 120); // about five texels a pixel
  const Baked_panel panel = bake(model, 5, {25, 3});
  int checked = 0;
  for (int j = 0; j < panel.grid.height; ++j)
    for (int i = 0; i < panel.grid.width; ++i) {
      const Point_2 q = panel.grid.centre(i, j);
      bool whole = true; // the pixel lies in the panel
      for (int k = 0; k < 4; ++k)
        whole =
            whole && distance_to(panel.loops, q + Kernel::Vector_2(k % 2 ? 0.52 : -0.52, k / 2 ? 0.52 : -0.52)) == 0;
      if (!whole) continue;
      const Point_3 expected = source_point(model, panel.faces, panel.frame(q));
      EXPECT_LT(distance(decoded(panel.image.pixel(i, j)), expected), model.texel + 2. / 127.5);
      ++checked;
    }
  EXPECT_GT(checked, 200);
}

TEST(Texture_baking_test, the_bleed_reaches_as_far_as_asked_and_shows_the_nearest_point)
{
  const Coloured_model model = coloured_model(4, 20);
  const Baking_options options{150, 3};
  const Baked_panel panel = bake(model, 2, options);
  const CGAL::Polygon_2<Kernel> polygon(panel.loops[0].begin(), panel.loops[0].end());
  int beyond = 0;
  for (int j = 0; j < panel.grid.height; ++j)
    for (int i = 0; i < panel.grid.width; ++i) {
      const Point_2 q = panel.grid.centre(i, j);
      const double d = distance_to(panel.loops, q);
      const std::uint8_t* pixel = panel.image.pixel(i, j);
      if (d <= options.bleed) ASSERT_EQ(pixel[3], 255) << d;
      if (d > options.bleed + 2 * panel.grid.mm_per_pixel) ASSERT_EQ(pixel[3], 0) << d;
      if (pixel[3] == 0 || d == 0) continue;
      Point_2 nearest;
      for (auto e = polygon.edges_begin(); e != polygon.edges_end(); ++e) {
        Point_2 foot = e->supporting_line().projection(q);
        if ((foot - e->source()) * (e->target() - e->source()) < 0) foot = e->source();
        if ((foot - e->target()) * (e->source() - e->target()) < 0) foot = e->target();
        if (e == polygon.edges_begin() || CGAL::squared_distance(q, foot) < CGAL::squared_distance(q, nearest))
          nearest = foot;
      }
      const Point_3 expected = source_point(model, panel.faces, panel.frame(nearest));
      // A pixel that the panel covers in part shows the part that it covers.
      EXPECT_LT(distance(decoded(pixel), expected),
                model.texel + 1. / 127.5 + (d < panel.grid.mm_per_pixel ? 0.02 : 0));
      ++beyond;
    }
  EXPECT_GT(beyond, 1000);
}

TEST(Texture_baking_test, fine_patterns_turn_into_their_mean_not_into_others)
{
  // A chess board of single texels on one flat square, 20 texels a pixel and 3: no stripes, the same light everywhere.
  for (const int texels : {60, 400}) {
    Image board(texels, texels);
    for (int j = 0; j < texels; ++j)
      for (int i = 0; i < texels; ++i)
        for (int c = 0; c < 4; ++c) board.pixel(i, j)[c] = c == 3 || (i + j) % 2 ? 255 : 0;
    Surface_appearance looks;
    looks.textures.emplace_back(std::move(board));
    looks.texture_of_triangle = {0, 0};
    looks.texture_points = {{Texture_point{0, 0}, {1, 0}, {1, 1}}, {Texture_point{0, 0}, {1, 1}, {0, 1}}};
    looks.colours.assign(2, {Linear_colour{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    const Points square = {Point_3(0, 0, 0), Point_3(20, 0, 0), Point_3(20, 20, 0), Point_3(0, 20, 0)};
    const std::vector<Outline> loops = {{Point_2(0, 0), Point_2(20, 0), Point_2(20, 20), Point_2(0, 20)}};
    Baking_options options;
    options.dpi = 25.4 * 1.013; // out of step with the board
    const Texture_grid grid = texture_grid(loops, options);
    const Image image = bake_panel(grid, {0, 1}, {{0, 1, 2}, {0, 2, 3}}, square, Frame(), looks, options);
    for (int j = 0; j < grid.height; ++j)
      for (int i = 0; i < grid.width; ++i) {
        const Point_2 q = grid.centre(i, j);
        if (q.x() < 1 || q.y() < 1 || q.x() > 19 || q.y() > 19) continue;
        // Half the light is byte 188. Three texels a pixel leave the pixel's box some unevenness.
        EXPECT_NEAR(image.pixel(i, j)[0], 188, texels == 60 ? 24 : 4) << i << " " << j;
      }
  }
}

TEST(Texture_baking_test, colours_of_corners_are_mixed_over_the_panel)
{
  Surface_appearance looks;
  looks.colours = {{Linear_colour{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Points points = {Point_3(0, 0, 0), Point_3(30, 0, 0), Point_3(0, 30, 0)};
  const std::vector<Outline> loops = {{Point_2(0, 0), Point_2(30, 0), Point_2(0, 30)}};
  const Texture_grid grid = texture_grid(loops, {});
  const Image image = bake_panel(grid, {0}, {{0, 1, 2}}, points, Frame(), looks);
  const auto& light = internal::linear_of_bytes();
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i) {
      const Point_2 q = grid.centre(i, j);
      if (q.x() < 1 || q.y() < 1 || q.x() + q.y() > 29) continue;
      const double expected[3] = {1 - (q.x() + q.y()) / 30, q.x() / 30, q.y() / 30};
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[image.pixel(i, j)[c]], expected[c], 0.01);
    }
}

} // namespace
