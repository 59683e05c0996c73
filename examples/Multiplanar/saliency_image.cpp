// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Saliency painted as an image: a torus is unrolled onto a square by its two angles, one half of which is painted
// white. Prints how many panels the white and the black half get, without and with the image. Fails if the image does
// not give the white half more of them.
//   saliency_image [panels [weight]]

#include <CGAL/Multiplanar/approximate.h>
#include <CGAL/Multiplanar/saliency_image.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace MP = CGAL::Multiplanar;

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 40;
  const double weight = argc > 2 ? std::atof(argv[2]) : 8;
  const int n = 48, m = 24;
  const double turn = 2 * 3.14159265358979323846;

  MP::Points points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = turn * i / n, b = turn * j / m, r = 1 + 0.45 * std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.45 * std::sin(b));
    }
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<MP::Texture_point, 3>> places;
  const auto add = [&](int i0, int j0, int i1, int j1, int i2, int j2) {
    const auto vertex = [&](int i, int j) { return i % n * m + j % m; };
    const auto place = [&](int i, int j) { return MP::Texture_point{float(i) / n, float(j) / m}; };
    triangles.push_back({vertex(i0, j0), vertex(i1, j1), vertex(i2, j2)});
    places.push_back({place(i0, j0), place(i1, j1), place(i2, j2)});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) add(i, j, i + 1, j, i + 1, j + 1), add(i, j, i + 1, j + 1, i, j + 1);

  MP::Image image(64, 64); // white where s < 1/2: the half of the torus with y > 0
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = c == 3 || x < 32 ? 255 : 0;

  const auto connectivity = MP::internal::make_connectivity(triangles, int(points.size()));
  double share[2] = {0, 0};
  for (int with : {0, 1}) {
    MP::Approximation_options options;
    options.panels = k;
    options.effort = MP::Effort::fast;
    options.saliency_weight = weight;
    if (with) options.saliency = MP::saliency_of_image(image, places);
    MP::Approximation_visitor visitor;
    const MP::Approximation_result result = MP::internal::approximate(connectivity, points, options, visitor);
    std::vector<double> faces(result.complex.number_of_panels(), 0), white = faces;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      faces[result.panel_of_face[f]] += 1;
      white[result.panel_of_face[f]] += places[f][0][0] + places[f][1][0] + places[f][2][0] < 1.5;
    }
    int count[2] = {0, 0};
    for (std::size_t p = 0; p < faces.size(); ++p) ++count[white[p] > faces[p] / 2];
    std::printf("%s: %d panels on the white half, %d on the black one\n", with ? "with the image" : "without", count[1],
                count[0]);
    share[with] = double(count[1]) / double(faces.size());
  }
  return share[1] > share[0] ? EXIT_SUCCESS : EXIT_FAILURE;
}
