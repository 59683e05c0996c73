// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "textures.h"
#include "failure.h"
#include "write_png.h"

#include <CGAL/Multiplanar/internal/parallel_ranges.h>
#include <CGAL/Multiplanar/kerf_compensation.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace CGAL::Multiplanar;

namespace {

/// The images of a sheet are in memory together, and once more as they are drawn.
constexpr double most_pixels_a_sheet = 1e8;

std::string file_of(const Panel_complex& complex, int panel) { return "textures/" + panel_id(complex, panel) + ".png"; }

/// \pre opaque
Image reduced(Image image, int size)
{
  while (std::max(image.width, image.height) > size) image = internal::halved(image);
  return image;
}

/// A polygon and what lies within `distance` of it, or up to a tenth of a millimetre further; as it is if it touches
/// itself.
std::vector<Outline> grown(const Outline& outline, const std::vector<Outline>& holes, double distance)
{
  const double slack = (std::min)(0.1, distance / 4); // the disc is a polygon between two circles
  std::vector<Outline> loops = holes;
  loops.push_back(outline);
  if (!std::all_of(loops.begin(), loops.end(), [](const Outline& loop) { return is_simple_outline(loop); }))
    return loops;
  const double radius = distance + slack, chord = 2 * std::sqrt(2 * radius * slack - slack * slack);
  Exact_polygon region(internal::oriented_loop(outline, CGAL::COUNTERCLOCKWISE));
  for (const Outline& hole : holes) region.add_hole(internal::oriented_loop(hole, CGAL::CLOCKWISE));
  const auto sum = CGAL::minkowski_sum_2(region, internal::inscribed_polygon(radius, chord));
  loops.assign(1, internal::rounded(sum.outer_boundary()));
  for (auto hole = sum.holes_begin(); hole != sum.holes_end(); ++hole) loops.push_back(internal::rounded(*hole));
  return loops;
}

std::vector<Outline> placed(std::vector<Outline> loops, const Placement& placement)
{
  for (Outline& loop : loops)
    for (Point_2& p : loop) p = placement(p);
  return loops;
}

} // namespace

Textures::Textures(Model& model, const Texture_source& source, const Baking_options& options, double gap, int threads)
    : model(model), source(source), options(options), gap(gap), threads(internal::resolved_threads(threads))
{
  for (Part& part : model.parts) {
    const int panel = panel_number(part);
    if (panel < 0 || panel >= model.complex.number_of_panels()) continue;
    if (!grids.count(panel)) // the pieces of a panel share its plane
      grids[panel] = texture_grid(panel_loops(model.complex, panel, part.frame), options);
    const Texture_grid& grid = grids[panel];
    part.texture = {file_of(model.complex, panel), grid.origin, grid.mm_per_pixel};
  }
  check_size();
}

std::vector<int> Textures::panels_on(const Sheet& sheet) const
{
  std::set<int> panels;
  for (const Placement& placement : sheet.placements) {
    const int panel = panel_number(model.parts[placement.part]);
    if (grids.count(panel)) panels.insert(panel);
  }
  return {panels.begin(), panels.end()};
}

void Textures::check_size() const
{
  for (std::size_t s = 0; s < model.sheets.size(); ++s) {
    double pixels = 0;
    for (int panel : panels_on(model.sheets[s])) pixels += double(grids.at(panel).width) * grids.at(panel).height;
    if (pixels <= most_pixels_a_sheet) continue;
    char text[200];
    std::snprintf(text, sizeof text,
                  "--dpi %g: the textures of sheet %zu would have %.0f million pixels: give at most "
                  "--dpi %.0f",
                  options.dpi, s + 1, pixels / 1e6,
                  std::floor(0.98 * options.dpi * std::sqrt(most_pixels_a_sheet / pixels)));
    throw input_error(text);
  }
}

void Textures::keep_small(int panel, Image image)
{
  internal::put_on_white(image);
  small.emplace_back(reduced(std::move(image), 900), Texture_wrap::clamp, Texture_wrap::clamp);
  const Texture_grid& grid = grids.at(panel);
  for (const Part& part : model.parts)
    if (panel_number(part) == panel)
      small_pictures[part.id] = {&small.back(), grid.origin, grid.width * grid.mm_per_pixel,
                                 grid.height * grid.mm_per_pixel};
}

std::vector<Image> Textures::bake(const std::vector<int>& panels) const
{
  std::map<int, Frame> frames;
  for (const Part& part : model.parts) frames[panel_number(part)] = part.frame;
  std::vector<std::vector<int>> faces(model.complex.number_of_panels());
  for (int f = 0; f < int(source.panel_of_face.size()); ++f) faces[source.panel_of_face[f]].push_back(f);
  std::vector<Image> images(panels.size());
  // Panels differ in size: every thread takes each so-many-th one.
  internal::parallel_ranges(threads, threads, [&](int, int first, int last) {
    for (int t = first; t < last; ++t)
      for (std::size_t i = t; i < panels.size(); i += threads)
        images[i] = bake_panel(grids.at(panels[i]), faces[panels[i]], source.triangles, source.points,
                               frames.at(panels[i]), source.looks, options);
  });
  return images;
}

void Textures::write_images(const File_writer& write, const std::vector<int>& panels, const std::vector<Image>& images)
{
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::string file = file_of(model.complex, panels[i]);
    if (!files.emplace(panels[i], file).second) continue; // written with another piece of the panel
    write(file, [&](std::ostream& out) { write_png(out, images[i], 1 / grids.at(panels[i]).mm_per_pixel); });
    keep_small(panels[i], images[i]);
  }
}

Printed_part Textures::printed_part(const Placement& placement, const Part_drawing& drawing, const Image& image) const
{
  const Part& part = model.parts[placement.part];
  const int panel = panel_number(part);
  Printed_part printed{&image, grids.at(panel), {}, {}};
  const std::vector<Outline> loops = panel_loops(model.complex, panel, part.frame);
  printed.with_bleed = placed(grown(loops[0], {loops.begin() + 1, loops.end()}, options.bleed), placement);
  for (const Outline& outline : drawing.outer)
    for (Outline& loop : grown(outline, {}, 0.4 * gap)) printed.own.push_back(std::move(loop));
  return printed;
}

void Textures::write_sheet(const File_writer& write, int number)
{
  const Sheet& sheet = model.sheets[number];
  const std::vector<int> panels = panels_on(sheet);
  const std::vector<Image> images = bake(panels);
  write_images(write, panels, images);
  const Sheet_drawing drawing = draw_sheet(sheet, model.parts, model.settings.kerf, model.settings.fit);
  Texture_sheet printed{sheet, drawing, model.parts, {}, number + 1};
  for (std::size_t i = 0; i < sheet.placements.size(); ++i) {
    const auto found =
        std::lower_bound(panels.begin(), panels.end(), panel_number(model.parts[sheet.placements[i].part]));
    const bool has_image = found != panels.end() && *found == panel_number(model.parts[sheet.placements[i].part]);
    printed.printed.push_back(has_image
                                  ? printed_part(sheet.placements[i], drawing.parts[i], images[found - panels.begin()])
                                  : Printed_part());
  }
  for (bool mirrored : {false, true})
    write("textures/sheet-" + std::to_string(number + 1) + (mirrored ? "-mirrored.pdf" : ".pdf"),
          [&](std::ostream& out) { write_texture_sheet(out, printed, mirrored); });
}

void Textures::write(const File_writer& write, Progress& progress)
{
  for (int s = 0; s < int(model.sheets.size()); ++s) {
    progress.update("textures", double(s) / double(model.sheets.size()));
    write_sheet(write, s);
  }
}
