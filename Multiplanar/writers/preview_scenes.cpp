// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preview_scenes.h"
#include "panel_colours.h"

#include <CGAL/Multiplanar/panel_triangulation.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

constexpr Linear_colour ink{{0.02f, 0.02f, 0.025f}};

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// A part in space: shifted, in one colour.
struct Solid_part
{
  const Part& part;
  double thickness;
  Vector_3 shift;
  Linear_colour colour;
  Part_picture picture;

  Point_3 at(const Point_2& p, double depth) const { return part.frame(p) - depth * part.frame.normal + shift; }
};

Outline oriented(Outline loop, bool counter_clockwise)
{
  if ((twice_signed_area(loop) > 0) != counter_clockwise) std::reverse(loop.begin(), loop.end());
  return loop;
}

void add_triangle(Scene& scene, const std::array<Point_3, 3>& points, const Vector_3& normal,
                  const Linear_colour& colour)
{
  Scene_triangle t;
  t.points = points;
  t.normals = {normal, normal, normal};
  t.colours = {colour, colour, colour};
  scene.triangles.push_back(t);
}

void paint(Scene_triangle& t, const Part_picture& picture, const std::array<Point_2, 3>& places)
{
  t.texture = picture.texture;
  for (int i = 0; i < 3; ++i) {
    t.colours[i] = {1, 1, 1};
    t.texture_points[i] = {float((places[i].x() - picture.origin.x()) / picture.width),
                           float((places[i].y() - picture.origin.y()) / picture.height)};
  }
}

void add_faces(Scene& scene, const Solid_part& solid, const std::vector<Outline>& loops)
{
  if (!internal::is_polygon_with_holes(loops)) return; // what touches itself cannot be triangulated: its edges are seen
  std::vector<Point_2> all;
  for (const Outline& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  const Vector_3 n = solid.part.frame.normal;
  for (const auto& t : internal::triangulate_polygon(loops)) {
    const Point_2 &a = all[t[0]], &b = all[t[1]], &c = all[t[2]];
    add_triangle(scene, {solid.at(a, 0), solid.at(b, 0), solid.at(c, 0)}, n, solid.colour);
    if (solid.picture.texture) paint(scene.triangles.back(), solid.picture, {a, b, c});
    const double d = solid.thickness;
    add_triangle(scene, {solid.at(a, d), solid.at(c, d), solid.at(b, d)}, -n, solid.colour);
  }
}

/// \param loop with the part on its left
void add_wall(Scene& scene, const Solid_part& solid, const Outline& loop)
{
  const Frame& frame = solid.part.frame;
  Linear_colour cut = solid.colour; // what the laser leaves is darker
  for (float& c : cut) c *= 0.55f;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point_2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::hypot(dx, dy);
    if (!(length > 0)) continue;
    const Vector_3 n = dy / length * frame.u - dx / length * frame.v;
    const Point_3 a0 = solid.at(a, 0), b0 = solid.at(b, 0), a1 = solid.at(a, solid.thickness),
                  b1 = solid.at(b, solid.thickness);
    add_triangle(scene, {a0, a1, b1}, n, cut);
    add_triangle(scene, {a0, b1, b0}, n, cut);
    scene.lines.push_back({a0, b0, 1.1, ink});
    scene.lines.push_back({a1, b1, 0.8, ink});
    const Point_2& before = loop[(i + loop.size() - 1) % loop.size()];
    const double turn = std::atan2((a.x() - before.x()) * dy - (a.y() - before.y()) * dx,
                                   (a.x() - before.x()) * dx + (a.y() - before.y()) * dy);
    if (std::abs(turn) > 0.4) scene.lines.push_back({a0, a1, 0.8, ink});
  }
}

void add_solid(Scene& scene, const Solid_part& solid)
{
  std::vector<Outline> loops(1, oriented(solid.part.outline, true));
  for (const Outline& hole : solid.part.holes) loops.push_back(oriented(hole, false));
  add_faces(scene, solid, loops);
  for (const Outline& loop : loops) add_wall(scene, solid, loop);
}

Point_3 middle_of(const Part& part)
{
  double x = 0, y = 0;
  for (const Point_2& p : part.outline) x += p.x(), y += p.y();
  const double n = double(part.outline.size());
  return part.frame(Point_2(x / n, y / n));
}

CGAL::Bbox_3 box_of(const Panel_complex& complex)
{
  CGAL::Bbox_3 box;
  for (const auto& corner : complex.corners) box += corner.point.bbox();
  return box;
}

Point_3 centre_of(const CGAL::Bbox_3& box)
{
  return Point_3((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
}

/// The solids of all parts, each shifted by what `shift` says, without those that it leaves out.
template <class Shift, class Is_shown>
Scene parts_scene(const Model& model, const Vector_3& up, const Part_pictures& pictures, const Shift& shift,
                  const Is_shown& is_shown)
{
  const std::vector<Linear_colour> colours = panel_colours(model.complex);
  Scene scene;
  scene.up = up;
  for (const Part& part : model.parts) {
    const int panel = panel_number(part);
    if (!is_shown(part)) continue;
    const bool known = panel >= 0 && panel < int(colours.size());
    const auto picture = pictures.find(part.id);
    add_solid(scene, {part, model.settings.thickness, shift(part), known ? colours[panel] : connector_colour,
                      picture == pictures.end() ? Part_picture() : picture->second});
  }
  return scene;
}

Vector_3 stays(const Part&) { return Vector_3(0, 0, 0); }

/// By panel: outward from the middle, and along its normal.
std::vector<Vector_3> explosion(const Model& model)
{
  const CGAL::Bbox_3 box = box_of(model.complex);
  const Point_3 centre = centre_of(box);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  std::vector<Vector_3> shifts(model.complex.number_of_panels(), Vector_3(0, 0, 0));
  for (const Part& part : model.parts) {
    const int panel = panel_number(part);
    if (panel >= 0 && panel < int(shifts.size()))
      shifts[panel] = 0.5 * (middle_of(part) - centre) + 0.06 * diagonal * part.frame.normal;
  }
  return shifts;
}

} // namespace

Scene panels_scene(const Panel_complex& complex, const Vector_3& up)
{
  const std::vector<Linear_colour> colours = panel_colours(complex);
  Scene scene;
  scene.up = up;
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    if (!is_simple_panel(complex, p)) continue;
    std::vector<Point_3> corners;
    for (const auto& loop : complex.panels[p].loops)
      for (int c : complex.loop_corners(loop)) corners.push_back(complex.corners[c].point);
    const Vector_3 n = unit(complex.panels[p].plane.normal);
    for (const auto& t : internal::triangulate_polygon(internal::projected_loops(complex, p)))
      add_triangle(scene, {corners[t[0]], corners[t[1]], corners[t[2]]}, n, colours[p]);
  }
  for (const auto& edge : complex.edges)
    if (!edge.is_closed())
      scene.lines.push_back({complex.corners[edge.corners[0]].point, complex.corners[edge.corners[1]].point, 1.8, ink});
  return scene;
}

Scene assembled_scene(const Model& model, const Vector_3& up, const Part_pictures& pictures)
{
  return parts_scene(model, up, pictures, stays, [](const Part&) { return true; });
}

Scene opened_scene(const Model& model, const Vector_3& up, const Vector_3& view)
{
  return parts_scene(model, up, {}, stays, [&](const Part& part) {
    return part.kind != Part::Kind::panel || part.frame.normal * view < 0.3;
  });
}

Scene exploded_scene(const Model& model, const Vector_3& up, const Part_pictures& pictures)
{
  const std::vector<Vector_3> shifts = explosion(model);
  std::map<std::string, Vector_3> of_connector;
  for (int e = 0; e < int(model.joints.size()); ++e)
    for (const std::string& id : model.joints[e].parts) {
      const auto& panels = model.complex.edges[e].panels;
      of_connector[id] = 0.5 * (shifts[panels[0]] + shifts[panels[1]]);
    }
  const auto shift = [&](const Part& part) {
    const int panel = panel_number(part);
    if (panel >= 0 && panel < int(shifts.size())) return shifts[panel];
    const auto found = of_connector.find(part.id);
    return found == of_connector.end() ? Vector_3(0, 0, 0) : found->second;
  };
  return parts_scene(model, up, pictures, shift, [](const Part&) { return true; });
}
