// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture_sheet_pdf.h"
#include "Pdf_document.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

using namespace CGAL::Multiplanar;

namespace {

/// From points of the sheet (y upward) to those of the page (y downward), maybe turned over.
struct Page
{
  double x(const Point_2& p) const { return turned ? width - p.x() : p.x(); }
  double y(const Point_2& p) const { return height - p.y(); }

  double width, height;
  bool turned;
};

void trace(cairo_t* c, const Page& page, const Outline& loop)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
    (i ? cairo_line_to : cairo_move_to)(c, page.x(loop[i]), page.y(loop[i]));
  cairo_close_path(c);
}

struct Surface_deleter
{
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
using Surface = std::unique_ptr<cairo_surface_t, Surface_deleter>;

/// Transparent pixels become white: the page clips them away, and without transparency no program draws fringes.
Surface cairo_surface_of(const Image& image)
{
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("PDF: an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                             " pixels is too large: take a smaller --dpi");
  cairo_surface_flush(surface.get());
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.pixel(x, y);
      reinterpret_cast<std::uint32_t*>(data + std::ptrdiff_t(y) * stride)[x] =
          p[3] == 0 ? 0xffffffu : std::uint32_t(p[0]) << 16 | std::uint32_t(p[1]) << 8 | p[2];
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

/// Paints the image of a part where the part lies. The corners of the image say where its axes go.
void paint(cairo_t* c, const Page& page, const Placement& placement, const Texture_grid& grid, cairo_surface_t* surface)
{
  const double s = grid.mm_per_pixel, h = grid.height * s;
  const Point_2 upper_left = placement(Point_2(grid.origin.x(), grid.origin.y() + h));
  const Point_2 right = placement(Point_2(grid.origin.x() + s, grid.origin.y() + h));
  const Point_2 down = placement(Point_2(grid.origin.x(), grid.origin.y() + h - s));
  cairo_matrix_t matrix;
  cairo_matrix_init(&matrix, page.x(right) - page.x(upper_left), page.y(right) - page.y(upper_left),
                    page.x(down) - page.x(upper_left), page.y(down) - page.y(upper_left), page.x(upper_left),
                    page.y(upper_left));
  cairo_save(c);
  cairo_transform(c, &matrix);
  cairo_set_source_surface(c, surface, 0, 0);
  cairo_paint(c);
  cairo_restore(c);
}

/// Keeps what follows inside loops, holes left out.
void clip(cairo_t* c, const Page& page, const std::vector<Outline>& loops)
{
  for (const Outline& loop : loops) trace(c, page, loop);
  cairo_set_fill_rule(c, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_clip(c);
}

void draw_crosses(cairo_t* c, const Page& page)
{
  cairo_set_source_rgb(c, 0, 0, 0);
  cairo_set_line_width(c, 0.1);
  const double inset = 4, arm = 3;
  for (double x : {inset, page.width - inset})
    for (double y : {inset, page.height - inset}) {
      cairo_move_to(c, x - arm, y);
      cairo_line_to(c, x + arm, y);
      cairo_move_to(c, x, y - arm);
      cairo_line_to(c, x, y + arm);
    }
  cairo_stroke(c);
}

/// A line of text in the lower border, never reversed.
void draw_note(cairo_t* c, const Page& page, const std::string& text)
{
  const double height = 2, width = text_width(text) * height;
  cairo_set_line_width(c, 0.15);
  for (const Stroke& stroke : text_strokes(text))
    for (std::size_t i = 0; i < stroke.size(); ++i)
      (i ? cairo_line_to : cairo_move_to)(c, 9 + width / 2 + height * stroke[i].x(),
                                          page.height - 2.5 - height * stroke[i].y());
  cairo_stroke(c);
}

/// The id of a part, where it is engraved; never reversed.
void draw_id(cairo_t* c, const Page& page, const Engraving& e, const Placement& placement)
{
  const Point_2 middle = placement(e.at);
  double degrees = placement.rotation + (placement.mirrored ? -e.angle : e.angle);
  if (page.turned) degrees = -degrees;
  const double a = degrees * 3.14159265358979323846 / 180, co = std::cos(a), si = std::sin(a);
  for (const Stroke& stroke : text_strokes(e.text))
    for (std::size_t i = 0; i < stroke.size(); ++i)
      (i ? cairo_line_to : cairo_move_to)(c, page.x(middle) + e.height * (co * stroke[i].x() - si * stroke[i].y()),
                                          page.y(middle) - e.height * (si * stroke[i].x() + co * stroke[i].y()));
  cairo_stroke(c);
}

void draw_textures(cairo_t* c, const Page& page, const Texture_sheet& sheet)
{
  std::map<const Image*, Surface> surfaces;
  // First everything with its whole bleed, then once more what belongs to each part, so that no neighbour's bleed
  // covers it.
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < sheet.printed.size(); ++i) {
      const Printed_part& part = sheet.printed[i];
      if (!part.image) continue;
      Surface& surface = surfaces[part.image];
      if (!surface) surface = cairo_surface_of(*part.image);
      cairo_save(c);
      clip(c, page, part.with_bleed);
      if (pass == 1) clip(c, page, part.own);
      paint(c, page, sheet.sheet.placements[i], part.grid, surface.get());
      cairo_restore(c);
    }
}

void draw_cuts(cairo_t* c, const Page& page, const Texture_sheet& sheet)
{
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(c, 0.1);
  cairo_set_source_rgb(c, 0, 0, 0);
  for (const Part_drawing& part : sheet.drawing.parts) {
    for (const auto* loops : {&part.inner, &part.outer})
      for (const Outline& loop : *loops) trace(c, page, loop);
    cairo_stroke(c);
  }
  cairo_set_line_width(c, 0.2);
  for (const Placement& placement : sheet.sheet.placements)
    for (const Engraving& e : sheet.parts[placement.part].engraving) draw_id(c, page, e, placement);
}

} // namespace

void write_texture_sheet(std::ostream& out, const Texture_sheet& sheet, bool mirrored)
{
  const auto& placements = sheet.sheet.placements;
  const bool inner_face_up = std::any_of(placements.begin(), placements.end(), [](auto& p) { return p.mirrored; });
  const Page page{sheet.sheet.width, sheet.sheet.height, inner_face_up != mirrored};
  const std::string use = mirrored ? "reversed: for transfer, face down on the outer faces"
                                   : "to be glued to the outer faces, this side up";
  const std::string note = "sheet " + std::to_string(sheet.number) +
                           (page.turned ? " turned over, " : " as it is cut, ") + use + "; 100 % size";
  Pdf_document document(out);
  document.set_title("textures of sheet " + std::to_string(sheet.number) + (mirrored ? ", reversed" : ""));
  for (int number = 0; number < 2; ++number) {
    cairo_t* c = document.begin_page(page.width, page.height);
    number == 0 ? draw_textures(c, page, sheet) : draw_cuts(c, page, sheet);
    draw_crosses(c, page);
    draw_note(c, page, note);
  }
  document.finish();
}
