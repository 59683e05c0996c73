// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_EXAMPLES_GLOBE_H
#define MULTIPLANAR_EXAMPLES_GLOBE_H

#include <CGAL/Multiplanar/Surface_appearance.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

constexpr int meridians = 48, parallels = 24;
constexpr double globe_pi = 3.14159265358979323846;

/// A sphere by longitude and latitude. Its map is cut along one meridian: vertices are shared there, places are not.
struct Globe
{
  CGAL::Multiplanar::Points points;
  std::vector<std::array<int, 3>> triangles;
  CGAL::Multiplanar::Surface_appearance looks;

  Globe()
  {
    points = {CGAL::Multiplanar::Point_3(0, 0, -1), CGAL::Multiplanar::Point_3(0, 0, 1)};
    for (int j = 1; j < parallels; ++j)
      for (int i = 0; i < meridians; ++i) {
        const double latitude = globe_pi * j / parallels - globe_pi / 2, longitude = 2 * globe_pi * i / meridians;
        points.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                            std::sin(latitude));
      }
    for (int i = 0; i < meridians; ++i) {
      add(i, 0, i + 1, 1, i, 1);
      for (int j = 1; j + 1 < parallels; ++j) add(i, j, i + 1, j, i + 1, j + 1), add(i, j, i + 1, j + 1, i, j + 1);
      add(i, parallels - 1, i + 1, parallels - 1, i, parallels);
    }
    looks.textures.push_back(map());
  }

private:
  /// Blue in the south, yellow in the north, with a dark grid.
  static CGAL::Multiplanar::Texture map()
  {
    CGAL::Multiplanar::Image image(960, 480);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const bool line = x % 80 < 3 || y % 80 < 3;
        const int north = 255 * (image.height - 1 - y) / image.height;
        const int rgb[3] = {north, 60 + north / 2, 255 - north};
        for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::uint8_t(line ? rgb[c] / 3 : rgb[c]);
        image.pixel(x, y)[3] = 255;
      }
    return CGAL::Multiplanar::Texture(image, CGAL::Multiplanar::Texture_wrap::repeat,
                                      CGAL::Multiplanar::Texture_wrap::clamp);
  }
  static int vertex(int i, int j) { return j == 0 ? 0 : j == parallels ? 1 : 2 + (j - 1) * meridians + i % meridians; }
  void add(int i0, int j0, int i1, int j1, int i2, int j2)
  {
    const auto place = [](int i, int j) {
      return CGAL::Multiplanar::Texture_point{float(i) / meridians, float(j) / parallels};
    };
    triangles.push_back({vertex(i0, j0), vertex(i1, j1), vertex(i2, j2)});
    looks.texture_points.push_back({place(i0, j0), place(i1, j1), place(i2, j2)});
    looks.texture_of_triangle.push_back(0);
    looks.colours.push_back({CGAL::Multiplanar::Linear_colour{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  }
};

#endif // MULTIPLANAR_EXAMPLES_GLOBE_H
