// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Assembly_guide.h"
#include "panel_colours.h"
#include "write_jpeg.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

using namespace CGAL::Multiplanar;

namespace {

/// "bunny_10k.off" as "Bunny 10k".
std::string title_of(std::string file)
{
  file = file.substr(0, file.find_last_of('.'));
  for (char& c : file)
    if (c == '_' || c == '-') c = ' ';
  if (file.empty()) return "Model";
  if (file[0] >= 'a' && file[0] <= 'z') file[0] = char(file[0] - 'a' + 'A');
  return file;
}

void find_steps_and_sheets(Assembly_guide& guide)
{
  const Model& model = guide.model;
  guide.step.assign(model.parts.size(), -1);
  guide.sheet.assign(model.parts.size(), -1);
  for (int s = 0; s < int(model.assembly.size()); ++s)
    for (const int part : model.assembly[s].parts) guide.step[part] = s;
  for (int s = 0; s < int(model.sheets.size()); ++s)
    for (const Placement& placement : model.sheets[s].placements) guide.sheet[placement.part] = s;
}

void find_panels_and_edges(Assembly_guide& guide)
{
  const Model& model = guide.model;
  std::map<std::string, int> edge_of;
  for (int e = 0; e < int(model.joints.size()); ++e)
    for (const std::string& id : model.joints[e].parts) edge_of[id] = e;
  guide.parts_of_panel.resize(model.complex.number_of_panels());
  for (int i = 0; i < int(model.parts.size()); ++i) {
    const Part& part = model.parts[i];
    const int p = part.kind == Part::Kind::panel ? std::atoi(part.id.c_str() + 1) - 1 : -1;
    const auto edge = edge_of.find(part.id);
    guide.panel.push_back(p);
    guide.edge.push_back(edge == edge_of.end() ? -1 : edge->second);
    if (p >= 0) guide.parts_of_panel[p].push_back(i);
  }
}

void find_neighbours(Assembly_guide& guide)
{
  const Panel_complex& complex = guide.model.complex;
  guide.neighbours.resize(complex.number_of_panels());
  for (int e = 0; e < complex.number_of_edges(); ++e)
    for (int side = 0; side < 2; ++side)
      guide.neighbours[complex.edges[e].panels[side]].push_back({complex.edges[e].panels[1 - side], e});
  for (auto& list : guide.neighbours)
    std::stable_sort(list.begin(), list.end(),
                     [](const Guide_neighbour& a, const Guide_neighbour& b) { return a.panel < b.panel; });
}

void find_colours(Assembly_guide& guide)
{
  const auto colours = panel_colours(guide.model.complex);
  for (const int p : guide.panel) guide.colour.push_back(p >= 0 ? colours[p] : connector_colour);
}

Point_3 middle_of(const Outline& outline, const Frame& frame)
{
  double x = 0, y = 0;
  for (const Point_2& p : outline) x += p.x(), y += p.y();
  const double n = double(outline.size());
  return frame(Point_2(x / n, y / n));
}

} // namespace

int Assembly_guide::count_panels() const
{
  return int(std::count_if(panel.begin(), panel.end(), [](int p) { return p >= 0; }));
}

Assembly_guide make_assembly_guide(const Model& model, const Vector_3& up, const Vector_3& towards_viewer,
                                   const Part_pictures& pictures)
{
  Assembly_guide guide{model, title_of(model.input_file), up, towards_viewer, pictures, {}, {}, {}, {}, {}, {}, {}};
  find_steps_and_sheets(guide);
  find_panels_and_edges(guide);
  find_neighbours(guide);
  find_colours(guide);
  return guide;
}

std::string jpeg_of_picture(const Part_picture& picture)
{
  const Texture& texture = *picture.texture;
  Image image(texture.width(), texture.height());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Linear_colour light = texture((x + 0.5) / image.width, 1 - (y + 0.5) / image.height);
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = internal::byte_of_linear(light[c]);
    }
  return jpeg_of(image);
}

Vector_3 explosion_of(const Assembly_guide& guide, int part)
{
  const Model& model = guide.model;
  if (!guide.is_panel(part)) { // between its panels
    if (guide.edge[part] < 0) return Vector_3(0, 0, 0);
    Vector_3 sum(0, 0, 0);
    for (const int p : model.complex.edges[guide.edge[part]].panels)
      if (!guide.parts_of_panel[p].empty()) sum = sum + explosion_of(guide, guide.parts_of_panel[p][0]) / 2;
    return sum;
  }
  CGAL::Bbox_3 box;
  for (const auto& corner : model.complex.corners) box += corner.point.bbox();
  const Point_3 centre((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  const double diagonal = std::hypot(box.x_span(), std::hypot(box.y_span(), box.z_span()));
  const Frame& frame = model.parts[part].frame;
  return 0.5 * (middle_of(model.parts[part].outline, frame) - centre) + 0.06 * diagonal * frame.normal;
}
