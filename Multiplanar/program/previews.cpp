// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "previews.h"
#include "panel_colours.h"
#include "render.h"
#include "sheet_picture.h"
#include "write_png.h"

#include <map>

using namespace CGAL::Multiplanar;

namespace {

constexpr int picture_width = 1200, picture_height = 900;

void write_scene(const File_writer& write, const std::string& name, const Scene& scene, const Preview_view& view)
{
  if (scene.triangles.empty()) return;
  const Camera camera = fit_camera(points_of(scene), view.towards_viewer, view.up, picture_width, picture_height);
  const Image image = render(scene, camera, 3, view.threads);
  write("preview/" + name, [&](std::ostream& out) { write_png(out, image); });
}

void write_sheets(const File_writer& write, const Model& model)
{
  const std::vector<Linear_colour> colours = panel_colours(model.complex);
  std::map<std::string, Linear_colour> by_id;
  for (const Part& part : model.parts) {
    const int panel = panel_number(part);
    by_id[part.id] = panel >= 0 && panel < int(colours.size()) ? colours[panel] : Linear_colour{0.85f, 0.72f, 0.55f};
  }
  const auto colour_of = [&](const std::string& id) { return by_id[id]; };
  for (int s = 0; s < int(model.sheets.size()); ++s) {
    const Sheet_drawing drawing = draw_sheet(model.sheets[s], model.parts, model.settings.kerf, model.settings.fit);
    const Image image = sheet_picture(drawing, 1800, colour_of);
    write("preview/sheet-" + std::to_string(s + 1) + ".png", [&](std::ostream& out) { write_png(out, image); });
  }
}

} // namespace

Vector_3 up_of(const Panel_complex& complex)
{
  const Points points = points_of(panels_scene(complex, Vector_3(0, 1, 0)));
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i + 2 < int(points.size()); i += 3) triangles.push_back({i, i + 1, i + 2});
  return upward(points, triangles);
}

Preview_view preview_view(const Panel_complex& complex, int threads)
{
  const Points points = points_of(panels_scene(complex, Vector_3(0, 1, 0)));
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i + 2 < int(points.size()); i += 3) triangles.push_back({i, i + 1, i + 2});
  Preview_view view;
  view.threads = threads;
  view.up = upward(points, triangles);
  view.towards_viewer = best_view(points, triangles, view.up);
  return view;
}

void write_input_preview(const File_writer& write, const Scene& input, const Preview_view& view)
{
  write_scene(write, "input.png", input, view);
}

void write_model_previews(const File_writer& write, const Model& model, const Preview_view& view,
                          const Part_pictures& pictures)
{
  write_scene(write, "panels.png", panels_scene(model.complex, view.up), view);
  write_scene(write, "assembled.png", assembled_scene(model, view.up, pictures), view);
  write_scene(write, "inside.png", opened_scene(model, view.up, view.towards_viewer), view);
  write_scene(write, "exploded.png", exploded_scene(model, view.up, pictures), view);
  write_sheets(write, model);
}
