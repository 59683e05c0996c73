// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "step_pictures.h"
#include "Part_mesh.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

constexpr Linear_colour ink{{0.02f, 0.02f, 0.025f}}, pale_ink{{0.35f, 0.34f, 0.32f}}, paper{{0.86f, 0.84f, 0.81f}};

Linear_colour mixed(const Linear_colour& a, const Linear_colour& b, float share_of_b)
{
  Linear_colour result;
  for (int c = 0; c < 3; ++c) result[c] = a[c] + share_of_b * (b[c] - a[c]);
  return result;
}

Linear_colour darker(Linear_colour colour)
{
  for (float& c : colour) c *= 0.6f;
  return colour;
}

void add_faces(Scene& scene, const Mesh_faces& faces, const Vector_3& shift, const Linear_colour& colour)
{
  for (const auto& t : faces.triangles) {
    Scene_triangle s;
    for (int i = 0; i < 3; ++i) {
      s.points[i] = faces.points[t[i]] + shift;
      s.normals[i] = faces.normals[t[i]];
      s.colours[i] = colour;
    }
    scene.triangles.push_back(s);
  }
}

/// Where the id is engraved, or the middle of the corners.
Point_3 label_place(const Part& part)
{
  if (!part.engraving.empty()) return part.frame(part.engraving[0].at);
  double x = 0, y = 0;
  for (const Point_2& p : part.outline) x += p.x(), y += p.y();
  return part.frame(Point_2(x / double(part.outline.size()), y / double(part.outline.size())));
}

/// The middle of that tab of a connector that lies in the sheet of a panel.
Point_3 tab_in(const Part& connector, const Part& panel)
{
  Point_3 best = label_place(connector);
  double nearest = 1e300;
  for (const auto& tab : connector.tabs) {
    Vector_3 sum(0, 0, 0);
    int n = 0;
    for (int i = tab[0];; i = (i + 1) % int(connector.outline.size())) {
      sum = sum + (connector.frame(connector.outline[i]) - CGAL::ORIGIN);
      ++n;
      if (i == tab[1]) break;
    }
    const Point_3 middle = CGAL::ORIGIN + sum / n;
    const double distance = std::abs((middle - panel.frame.origin) * panel.frame.normal);
    if (distance < nearest) nearest = distance, best = middle;
  }
  return best;
}

} // namespace

Step_pictures::Step_pictures(const Assembly_guide& guide, int width, int height)
    : guide(guide), width(width), height(height), view(guide.towards_viewer)
{
  CGAL::Bbox_3 box;
  for (const auto& corner : guide.model.complex.corners) box += corner.point.bbox();
  size = std::hypot(box.x_span(), std::hypot(box.y_span(), box.z_span()));
}

/// Turns the view, if it must be, so that what looks in this direction is seen.
void Step_pictures::turn_towards(const Vector_3& direction)
{
  if (direction * view > 0.2) return;
  const double rise = direction * guide.up, height_of_view = (std::max)(-0.45, (std::min)(0.75, rise + 0.15));
  Vector_3 level = direction - rise * guide.up;
  if (level.squared_length() < 0.01) level = view - (view * guide.up) * guide.up;
  level = level / std::sqrt(level.squared_length());
  view = std::sqrt(1 - height_of_view * height_of_view) * level + height_of_view * guide.up;
}

Vector_3 Step_pictures::shift(int part, int step) const
{
  if (guide.step[part] != step || step == 0) return Vector_3(0, 0, 0);
  const Assembly_step& s = guide.model.assembly[step];
  return (guide.is_panel(s.parts[0]) ? -0.16 : -0.07) * size * s.direction;
}

void Step_pictures::add_part(Scene& scene, int i, int step) const
{
  const bool is_new = guide.step[i] == step;
  const Part_mesh mesh = part_mesh(guide.model.parts[i], guide.model.settings.thickness);
  const Vector_3 by = shift(i, step);
  const Linear_colour& colour = guide.colour[i];
  add_faces(scene, mesh.outer, by, is_new ? colour : mixed(colour, paper, 0.82f));
  add_faces(scene, mesh.rest, by, is_new ? darker(colour) : mixed(darker(colour), paper, 0.7f));
  for (const auto& line : mesh.lines)
    scene.lines.push_back({line[0] + by, line[1] + by, is_new ? 1.1 : 0.7, is_new ? ink : pale_ink});
}

Step_picture Step_pictures::picture(int step)
{
  const Assembly_step& s = guide.model.assembly[step];
  const int first = s.parts[0];
  const Vector_3 seen = guide.is_panel(first) ? guide.model.parts[first].frame.normal : s.direction;
  turn_towards(step == 0 ? -seen : seen); // the first is seen from inside, as it lies on the table
  Step_picture result;
  result.scene.up = guide.up;
  result.scene.has_ground = false;
  for (int i = 0; i < int(guide.model.parts.size()); ++i)
    if (guide.step[i] >= 0 && guide.step[i] <= step) add_part(result.scene, i, step);
  result.camera = fit_camera(points_of(result.scene), view, guide.up, width, height);
  add_labels(result, step);
  add_arrow(result, step);
  return result;
}

void Step_pictures::add_labels(Step_picture& picture, int step) const
{
  const auto& parts = guide.model.parts;
  const int first = guide.model.assembly[step].parts[0];
  const auto add = [&](const std::string& text, const Point_3& p, Picture_label::Kind kind) {
    const auto q = picture.camera(p);
    picture.marks.labels.push_back({text, q.x, q.y, kind});
  };
  std::vector<int> neighbours; // panels
  if (guide.is_panel(first))
    for (const Guide_neighbour& n : guide.neighbours[guide.panel[first]]) neighbours.push_back(n.panel);
  for (int i = 0; i < int(parts.size()); ++i) {
    const Point_3 p = label_place(parts[i]) + shift(i, step);
    const bool is_near =
        guide.is_panel(i) && std::find(neighbours.begin(), neighbours.end(), guide.panel[i]) != neighbours.end();
    if (guide.step[i] >= 0 && guide.step[i] < step && is_near &&
        parts[i].frame.normal * (picture.camera.eye - p) > 0.1 * std::sqrt((picture.camera.eye - p).squared_length()))
      add(parts[i].id, p, Picture_label::Kind::placed);
    if (guide.step[i] == step && i != first)
      add(parts[i].id,
          (guide.is_panel(first) ? tab_in(parts[i], parts[first]) : label_place(parts[i])) + shift(i, step),
          Picture_label::Kind::new_connector);
  }
  add(parts[first].id, label_place(parts[first]) + shift(first, step), Picture_label::Kind::new_panel);
}

/// From the new part's place in the picture to its place in the model.
void Step_pictures::add_arrow(Step_picture& picture, int step) const
{
  if (step == 0) return;
  const int first = guide.model.assembly[step].parts[0];
  const Point_3 to = label_place(guide.model.parts[first]), from = to + shift(first, step);
  const auto a = picture.camera(from + 0.15 * (to - from)), b = picture.camera(to);
  picture.marks.arrow = {a.x, a.y, b.x, b.y};
  picture.marks.has_arrow = true;
}
