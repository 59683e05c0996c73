// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheet_picture.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace CGAL::Multiplanar;

namespace {

void trace(cairo_t* c, const std::vector<Outline>& loops)
{
  for (const Outline& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) (i ? cairo_line_to : cairo_move_to)(c, loop[i].x(), loop[i].y());
    cairo_close_path(c);
  }
}

void draw_part(cairo_t* c, const Part_drawing& part, const Linear_colour& colour, double pixel)
{
  trace(c, part.outer);
  trace(c, part.inner);
  const auto channel = [&](int i) { return 0.35 + 0.65 * double(srgb_of_linear(colour[i])); };
  cairo_set_source_rgb(c, channel(0), channel(1), channel(2));
  cairo_fill_preserve(c);
  cairo_set_source_rgb(c, 0.25, 0.12, 0.08);
  cairo_set_line_width(c, 1.3 * pixel);
  cairo_stroke(c);
  cairo_set_source_rgb(c, 0.15, 0.15, 0.2);
  cairo_set_line_width(c, 1.6 * pixel);
  for (const Stroke& stroke : part.engraving) {
    for (std::size_t i = 0; i < stroke.size(); ++i)
      (i ? cairo_line_to : cairo_move_to)(c, stroke[i].x(), stroke[i].y());
    cairo_stroke(c);
  }
}

/// From Cairo's opaque pixels, which are words in the order of the machine.
Image image_of(cairo_surface_t* surface)
{
  cairo_surface_flush(surface);
  Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t word = reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t(y) * stride)[x];
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = word >> 16 & 255, pixel[1] = word >> 8 & 255, pixel[2] = word & 255, pixel[3] = 255;
    }
  return image;
}

} // namespace

Image sheet_picture(const Sheet_drawing& drawing, int width,
                    const std::function<Linear_colour(const std::string&)>& colour_of)
{
  CGAL_precondition(drawing.width > 0 && drawing.height > 0 && width > 0);
  const double margin = 0.02 * std::max(drawing.width, drawing.height), page_width = drawing.width + 2 * margin;
  const double page_height = drawing.height + 2 * margin;
  const double scale = std::min(width / page_width, 4000 / page_height); // pixels per mm
  const int columns = std::max(1, int(std::lround(page_width * scale))),
            rows = std::max(1, int(std::lround(page_height * scale)));
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
  cairo_t* c = cairo_create(surface);
  cairo_set_source_rgb(c, 0.96, 0.96, 0.965);
  cairo_paint(c);
  cairo_translate(c, 0, rows);
  cairo_scale(c, scale, -scale); // y upward
  cairo_translate(c, margin, margin);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  cairo_set_fill_rule(c, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_rectangle(c, 0, 0, drawing.width, drawing.height);
  cairo_set_source_rgb(c, 0.93, 0.885, 0.80); // birch
  cairo_fill_preserve(c);
  cairo_set_source_rgb(c, 0.6, 0.55, 0.47);
  cairo_set_line_width(c, 1 / scale);
  cairo_stroke(c);
  for (const Part_drawing& part : drawing.parts) draw_part(c, part, colour_of(part.id), 1 / scale);
  const cairo_status_t status = cairo_status(c);
  Image image = status == CAIRO_STATUS_SUCCESS ? image_of(surface) : Image();
  cairo_destroy(c);
  cairo_surface_destroy(surface);
  if (image.empty()) throw std::runtime_error(std::string("picture of a sheet: ") + cairo_status_to_string(status));
  return image;
}
