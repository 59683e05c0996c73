// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Multiplanar/Texture.h>
#include <CGAL/Multiplanar/texture_distortion.h>

#include <Eigen/SVD>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

// Colours and their mixing, the pyramid of a texture, wrapping, and how a map stretches.

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

double unit(std::mt19937& random) { return double(random()) / 4294967296.0; }

Image random_image(std::mt19937& random, int width, int height)
{
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? 255 : std::uint8_t(random() % 256);
  return image;
}

std::array<double, 3> mean_light(const Image& image)
{
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 < 3) sum[i % 4] += linear_of_srgb(float(image.rgba[i]) / 255);
  for (double& s : sum) s /= double(image.width) * image.height;
  return sum;
}

TEST(Linear_colour_test, the_byte_is_the_nearest_one)
{
  for (int byte = 0; byte < 256; ++byte) EXPECT_EQ(internal::byte_of_linear(internal::linear_of_bytes()[byte]), byte);
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const float light = float(std::pow(unit(random), 3));
    const double srgb = 255 * double(srgb_of_linear(light));
    EXPECT_LE(std::abs(internal::byte_of_linear(light) - srgb), 0.5 + 1e-3) << light;
  }
  EXPECT_EQ(internal::byte_of_linear(-1), 0);
  EXPECT_EQ(internal::byte_of_linear(7), 255);
}

TEST(Texture_test, halving_keeps_the_mean_light_for_any_size)
{
  std::mt19937 random(2);
  for (const auto& size : {std::array<int, 2>{64, 32}, {63, 31}, {5, 1}, {1, 9}, {3, 3}, {2, 2}}) {
    const Image image = random_image(random, size[0], size[1]), half = internal::halved(image);
    EXPECT_EQ(half.width, std::max(1, size[0] / 2));
    EXPECT_EQ(half.height, std::max(1, size[1] / 2));
    const auto before = mean_light(image), after = mean_light(half);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 0.004) << size[0] << " x " << size[1];
  }
}

TEST(Texture_test, transparent_texels_are_white)
{
  Image image(1, 1);
  EXPECT_NEAR(Texture(image)(0.5, 0.5)[0], 1, 1e-6);
}

/// The texel at (i, j), any whole numbers, by walking period after period.
int walked(int i, int n, Texture_wrap wrap)
{
  if (wrap == Texture_wrap::clamp) return std::min(n - 1, std::max(0, i));
  bool reversed = false;
  while (i < 0) i += n, reversed = !reversed;
  while (i >= n) i -= n, reversed = !reversed;
  return wrap == Texture_wrap::mirror && reversed ? n - 1 - i : i;
}

TEST(Texture_test, looks_up_and_wraps_as_a_slow_twin_does)
{
  std::mt19937 random(3);
  const Image image = random_image(random, 7, 5);
  const Texture_wrap modes[] = {Texture_wrap::repeat, Texture_wrap::clamp, Texture_wrap::mirror};
  for (const Texture_wrap s_mode : modes)
    for (const Texture_wrap t_mode : modes) {
      const Texture texture(image, s_mode, t_mode);
      for (int k = 0; k < 300; ++k) {
        const double s = 6 * unit(random) - 3, t = 6 * unit(random) - 3;
        const double x = s * 7 - 0.5, y = (1 - t) * 5 - 0.5;
        const int i = int(std::floor(x)), j = int(std::floor(y));
        double expected[3] = {0, 0, 0};
        for (int b = 0; b < 2; ++b)
          for (int a = 0; a < 2; ++a) {
            const double weight = (a ? x - i : 1 - (x - i)) * (b ? y - j : 1 - (y - j));
            const std::uint8_t* texel = image.pixel(walked(i + a, 7, s_mode), walked(j + b, 5, t_mode));
            for (int c = 0; c < 3; ++c) expected[c] += weight * linear_of_srgb(float(texel[c]) / 255);
          }
        const Linear_colour colour = texture(s, t);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], expected[c], 1e-4) << s << " " << t;
      }
    }
}

TEST(Texture_test, a_wide_filter_sees_the_mean)
{
  std::mt19937 random(4);
  const Image image = random_image(random, 256, 256);
  const auto mean = mean_light(image);
  const Texture texture(image);
  for (int k = 0; k < 50; ++k) {
    const Linear_colour colour = texture(unit(random), unit(random), 64);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], mean[c], 0.03);
  }
}

TEST(Texture_test, places_out_of_all_bounds_do_no_harm)
{
  const Texture texture(Image(2, 2));
  for (double x : {1e300, -1e300, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isfinite(texture(x, x, 1e300)[0]));
}

TEST(Distortion_test, singular_values_are_those_of_eigen)
{
  std::mt19937 random(5);
  for (int k = 0; k < 500; ++k) {
    Eigen::Matrix2d m;
    for (int i = 0; i < 4; ++i) m(i / 2, i % 2) = 4 * unit(random) - 2;
    const Eigen::Vector2d s = Eigen::JacobiSVD<Eigen::Matrix2d>(m).singularValues();
    EXPECT_NEAR(internal::largest_singular_value(m(0, 0), m(0, 1), m(1, 0), m(1, 1)), s[0], 1e-12);
    EXPECT_NEAR(internal::smallest_singular_value(m(0, 0), m(0, 1), m(1, 0), m(1, 1)), s[1], 1e-12);
  }
}

TEST(Distortion_test, a_stretched_and_turned_triangle_tells_by_how_much)
{
  std::mt19937 random(6);
  for (int k = 0; k < 200; ++k) {
    std::array<Point_3, 3> source, target;
    const double sx = 0.2 + 2 * unit(random), sy = 0.2 + 2 * unit(random), a = 6 * unit(random);
    for (int i = 0; i < 3; ++i) {
      const double x = unit(random), y = unit(random);
      source[i] = Point_3(x, y, 1);
      target[i] = Point_3(3, std::cos(a) * sx * x - std::sin(a) * sy * y, std::sin(a) * sx * x + std::cos(a) * sy * y);
    }
    const auto s = internal::stretch(source, target);
    EXPECT_NEAR(s[0], std::max(sx, sy), 1e-6);
    EXPECT_NEAR(s[1], std::min(sx, sy), 1e-6);
  }
}

TEST(Distortion_test, counts_by_area_and_knows_the_scale)
{
  // Two squares of area 9 and 1, the smaller one stretched twofold: the median sees nothing of it, the 95 % do.
  const Points source = {Point_3(0, 0, 0), Point_3(3, 0, 0),  Point_3(3, 3, 0),  Point_3(0, 3, 0),
                         Point_3(9, 0, 0), Point_3(10, 0, 0), Point_3(10, 1, 0), Point_3(9, 1, 0)};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  Points target;
  for (const Point_3& p : source) target.emplace_back(10 * p.x() * (p.x() > 8 ? 2 : 1), 10 * p.y(), 0);
  const Texture_distortion d = texture_distortion(triangles, source, target, 10);
  EXPECT_NEAR(d.largest.median, 1, 1e-12);
  EXPECT_NEAR(d.largest.p95, 2, 1e-12);
  EXPECT_NEAR(d.smallest.p95, 1, 1e-12);
  EXPECT_NEAR(d.distortion.p95, 2, 1e-12);
}

} // namespace
