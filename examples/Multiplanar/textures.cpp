// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A globe of a few panels: a sphere with a map of meridians and parallels becomes flat panels, and each panel gets an
// image of what was there on the sphere, to be printed at 150 dpi and glued on. Writes panel-1.ppm ... into the current
// folder, and says by how much the map is stretched. Fails if a point at the middle of a panel shows another latitude.
//   textures [panels [size in mm]]

#include "globe.h"

#include <CGAL/Multiplanar/approximate.h>
#include <CGAL/Multiplanar/parts_from_panels.h>
#include <CGAL/Multiplanar/texture_baking.h>
#include <CGAL/Multiplanar/texture_distortion.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace MP = CGAL::Multiplanar;

namespace {

void write_ppm(const std::string& name, const MP::Image& image)
{
  std::ofstream out(name, std::ios::binary);
  out << "P6\n" << image.width << " " << image.height << "\n255\n";
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    for (int c = 0; c < 3; ++c) out.put(char(image.rgba[i + 3] ? image.rgba[i + c] : 255));
}

} // namespace

int main(int argc, char** argv)
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 24;
  const double size = argc > 2 ? std::atof(argv[2]) : 120;
  const Globe globe;

  // The shell has the triangles of the globe, moved so that each panel is flat.
  MP::Approximation_options options;
  options.panels = k;
  options.effort = MP::Effort::fast;
  const auto connectivity = MP::internal::make_connectivity(globe.triangles, int(globe.points.size()));
  MP::Approximation_visitor visitor;
  const MP::Approximation_result shell = MP::internal::approximate(connectivity, globe.points, options, visitor);
  const double scale = size / MP::longest_side(shell.complex);
  const MP::Panel_complex complex = MP::scaled(shell.complex, scale);
  MP::Points points;
  for (const auto& p : shell.points) points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());

  std::vector<std::vector<int>> faces(complex.number_of_panels());
  for (int f = 0; f < connectivity.number_of_faces(); ++f) faces[shell.panel_of_face[f]].push_back(f);
  std::vector<std::string> warnings;
  bool right = true;
  for (const MP::Part& part : MP::parts_from_panels(complex, warnings)) {
    const int p = MP::panel_number(part);
    const auto grid = MP::texture_grid(MP::panel_loops(complex, p, part.frame), MP::Baking_options());
    const MP::Image image = MP::bake_panel(grid, faces[p], globe.triangles, points, part.frame, globe.looks);
    write_ppm("panel-" + std::to_string(p + 1) + ".ppm", image);

    // What stands at the middle of the panel's largest triangle is the latitude that this triangle had on the sphere.
    int largest = faces[p][0];
    const auto area = [&](int f) { return MP::internal::area_vector(connectivity, points, f).squared_length(); };
    for (int f : faces[p])
      if (area(f) > area(largest)) largest = f;
    const auto& t = globe.triangles[largest];
    const MP::Point_2 q = part.frame.project(CGAL::centroid(points[t[0]], points[t[1]], points[t[2]]));
    const std::uint8_t* pixel = image.pixel(int((q.x() - grid.origin.x()) / grid.mm_per_pixel),
                                            grid.height - 1 - int((q.y() - grid.origin.y()) / grid.mm_per_pixel));
    double north = 0;
    for (const auto& place : globe.looks.texture_points[largest]) north += 255 * place[1] / 3;
    right = right && pixel[3] == 255 && (std::abs(pixel[0] - north) < 12 || std::abs(3 * pixel[0] - north) < 60);
  }
  const MP::Texture_distortion d = MP::texture_distortion(globe.triangles, globe.points, points, scale);
  std::printf("%d panels; distortion of the map: median %.2f, 95 %% of the area below %.2f\n",
              complex.number_of_panels(), d.distortion.median, d.distortion.p95);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
