// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a polygon mesh made elsewhere to flat parts that go together: a dodecahedron, cut out of 3 mm plywood.
// Writes dodecahedron-1.svg, ... in true size, ready for a laser cutter.

#include <CGAL/Multiplanar/Material.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/engrave_ids.h>
#include <CGAL/Multiplanar/io/write_svg.h>
#include <CGAL/Multiplanar/make_panel_complex.h>
#include <CGAL/Multiplanar/parts_from_joints.h>
#include <CGAL/Multiplanar/row_packing.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

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

  const MP::Material& plywood = *MP::find_material("plywood-3");
  MP::Joint_options options;
  options.thickness = plywood.thickness;
  MP::Joined_parts model = MP::make_joined_parts(complex, options);

  int unjoined = 0;
  for (int e = 0; e < complex.number_of_edges(); ++e) {
    unjoined += model.joints[e].kind == MP::Edge_joint::Kind::none;
    std::cout << MP::edge_id(complex, e) << "  " << complex.dihedral(e)
              << " degrees: " << to_string(model.joints[e].kind);
    for (const std::string& id : model.joints[e].parts) std::cout << ' ' << id;
    std::cout << model.joints[e].reason << '\n';
  }
  for (const MP::Part& part : model.parts)
    std::cout << part.id << ": " << part.outline.size() << " corners, " << part.holes.size() << " holes, "
              << part.area() << " mm2\n";
  for (const std::string& warning : model.warnings) std::cout << "warning: " << warning << '\n';

  MP::Sheet_options layout;
  layout.kerf = plywood.kerf;
  const std::vector<MP::Sheet> sheets = MP::pack_in_rows(model.parts, layout);
  MP::engrave_ids(model.parts, sheets, 1.5, 8); // letters of 1.5 to 8 mm
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string file = "dodecahedron-" + std::to_string(i + 1) + ".svg";
    std::ofstream out(file);
    MP::write_svg(out, MP::draw_sheet(sheets[i], model.parts, plywood.kerf, plywood.fit));
    if (!out.flush()) {
      std::cerr << file << ": cannot be written\n";
      return 1;
    }
    std::cout << file << ": " << sheets[i].placements.size() << " parts\n";
  }
  return unjoined == 0 ? 0 : 1;
}
