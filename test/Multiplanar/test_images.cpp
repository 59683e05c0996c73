// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "jpeg_bytes.h"

#include "read_image.h"
#include "write_png.h"

#include <CGAL/Multiplanar/saliency_image.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

// Pictures as files: what is written is what is read, and nothing that a file says does harm.

namespace {

using namespace CGAL::Multiplanar;
using namespace Multiplanar_test;

Image random_image(unsigned seed, int width, int height, bool opaque)
{
  std::mt19937 random(seed);
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = opaque && i % 4 == 3 ? 255 : std::uint8_t(random() % 256);
  return image;
}

std::string png_bytes(const Image& image)
{
  std::ostringstream out;
  write_png(out, image);
  return out.str();
}

TEST(Image_test, png_comes_back_as_it_was)
{
  for (const bool opaque : {false, true})
    for (const auto& size : {std::array<int, 2>{1, 1}, {17, 3}, {64, 65}}) {
      const Image image = random_image(1, size[0], size[1], opaque), read = read_image(png_bytes(image));
      EXPECT_EQ(read.width, image.width);
      EXPECT_EQ(read.height, image.height);
      EXPECT_EQ(read.rgba, image.rgba);
    }
}

TEST(Image_test, jpeg_comes_back_nearly)
{
  Image image(32, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const int rgb[4] = {8 * x, 16 * y, 128, 255};
      for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = std::uint8_t(rgb[c]);
    }
  const Image read = read_image(jpeg_bytes(image));
  ASSERT_EQ(read.width, 32);
  ASSERT_EQ(read.height, 16);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) EXPECT_NEAR(read.rgba[i], image.rgba[i], 12);
}

TEST(Image_test, too_many_pixels_are_reduced_to_their_mean_light)
{
  const Image image = random_image(2, 90, 60, true);
  const Image read = read_image(png_bytes(image), 700);
  EXPECT_LE(read.width * read.height, 700);
  EXPECT_EQ(read.width, 30);
  EXPECT_EQ(read.height, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 30; ++x)
      for (int c = 0; c < 3; ++c) {
        double light = 0;
        for (int k = 0; k < 9; ++k)
          light += linear_of_srgb(float(image.pixel(3 * x + k % 3, 3 * y + k / 3)[c]) / 255) / 9;
        EXPECT_NEAR(read.pixel(x, y)[c], 255 * srgb_of_linear(float(light)), 0.51);
      }
  EXPECT_LE(read_image(jpeg_bytes(image), 700).rgba.size(), 4 * 700u);
}

TEST(Image_test, damaged_files_are_refused_wherever_they_break)
{
  const Image image = random_image(3, 20, 20, true);
  for (const std::string& bytes : {png_bytes(image), jpeg_bytes(image)}) {
    int refused = 0;
    for (std::size_t n = 0; n < bytes.size(); n += 7) {
      try {
        read_image(bytes.substr(0, n));
      } catch (const std::runtime_error&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 0);
    std::mt19937 random(4);
    for (int k = 0; k < 300; ++k) {
      std::string damaged = bytes;
      for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = char(random());
      try {
        read_image(damaged);
      } catch (const std::runtime_error&) {
      }
    }
  }
  EXPECT_THROW(read_image("GIF89a"), std::runtime_error);
  EXPECT_THROW(read_image(""), std::runtime_error);
}

TEST(Saliency_image_test, a_face_gets_the_mean_of_what_is_painted_on_it)
{
  Image image(64, 64); // white in the right half; grey in the lower left quarter
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = c == 3 || x >= 32 ? 255 : y >= 32 ? 51 : 0;
  const float nan = std::nanf("");
  const std::vector<double> s = saliency_of_image(image, {{{{{0.6f, 0.1f}}, {{0.9f, 0.1f}}, {{0.9f, 0.9f}}}},
                                                          {{{{0.1f, 0.6f}}, {{0.4f, 0.6f}}, {{0.1f, 0.9f}}}},
                                                          {{{{0.1f, 0.1f}}, {{0.4f, 0.1f}}, {{0.1f, 0.4f}}}},
                                                          {{{{0.f, 0.f}}, {{1.f, 0.f}}, {{0.5f, 0.49f}}}},
                                                          {{{{1.6f, -1.9f}}, {{1.9f, -1.9f}}, {{1.6f, -1.6f}}}},
                                                          {{{{nan, nan}}, {{0.9f, 0.1f}}, {{0.9f, 0.9f}}}}});
  EXPECT_NEAR(s[0], 1, 1e-9);
  EXPECT_NEAR(s[1], 0, 1e-9);
  EXPECT_NEAR(s[2], 0.2, 1e-9);
  EXPECT_NEAR(s[3], 0.6, 0.02);
  EXPECT_NEAR(s[4], 1, 1e-9);
  EXPECT_EQ(s[5], 0);
}

} // namespace
