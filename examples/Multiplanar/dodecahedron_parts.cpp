// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a polygon mesh made elsewhere to flat parts that go together: a dodecahedron, cut out of 3 mm sheet.

#include <CGAL/Multiplanar/parts_from_joints.h>
#include <CGAL/Multiplanar/make_panel_complex.h>

#include <cmath>
#include <iostream>

namespace MP = CGAL::Multiplanar;

int main()
{
  // Corners in mm, and for every panel a list of loops: here only the outline, counter-clockwise seen from outside.
  const double r = 60, g = (1 + std::sqrt(5.0)) / 2, a = r, b = r / g, c = r * g;
  const MP::Points corners = {{a, a, a},    {a, a, -a},  {a, -a, a}, {a, -a, -a}, {-a, a, a},  {-a, a, -a}, {-a, -a, a},
                              {-a, -a, -a}, {0, b, c},   {0, b, -c}, {0, -b, c},  {0, -b, -c}, {b, c, 0},   {b, -c, 0},
                              {-b, c, 0},   {-b, -c, 0}, {c, 0, b},  {c, 0, -b},  {-c, 0, b},  {-c, 0, -b}};
  const std::vector<std::vector<std::vector<int>>> panels = {
      {{0, 8, 10, 2, 16}},  {{0, 16, 17, 1, 12}}, {{0, 12, 14, 4, 8}},  {{1, 17, 3, 11, 9}},
      {{1, 9, 5, 14, 12}},  {{2, 10, 6, 15, 13}}, {{2, 13, 3, 17, 16}}, {{3, 13, 15, 7, 11}},
      {{4, 14, 5, 19, 18}}, {{4, 18, 6, 10, 8}},  {{5, 9, 11, 7, 19}},  {{6, 18, 19, 7, 15}}};
  const MP::Panel_complex complex = MP::make_panel_complex_from_polygons(corners, panels);

  MP::Joint_options options;
  options.thickness = 3;
  const MP::Joined_parts model = MP::make_joined_parts(complex, options);

  for (int e = 0; e < complex.number_of_edges(); ++e) {
    std::cout << MP::edge_id(complex, e) << "  " << complex.dihedral(e)
              << " degrees: " << to_string(model.joints[e].kind);
    for (const std::string& id : model.joints[e].parts) std::cout << ' ' << id;
    std::cout << model.joints[e].reason << '\n';
  }
  for (const MP::Part& part : model.parts)
    std::cout << part.id << ": " << part.outline.size() << " corners, " << part.holes.size() << " holes, "
              << part.area() << " mm2\n";
  for (const std::string& warning : model.warnings) std::cout << "warning: " << warning << '\n';
  return model.parts.empty();
}
