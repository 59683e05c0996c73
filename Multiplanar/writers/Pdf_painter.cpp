// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Pdf_painter.h"
#include "write_jpeg.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace {

constexpr double pi = 3.14159265358979323846;

} // namespace

void Pdf_painter::set(const Colour& colour) const { cairo_set_source_rgb(context, colour[0], colour[1], colour[2]); }

void Pdf_painter::set(const Style& style) const
{
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
  set(style.colour);
}

double Pdf_painter::width(const std::string& text, const Style& style) const
{
  set(style);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

void Pdf_painter::text(double x, double y, const std::string& text, const Style& style, double align) const
{
  const double w = align == 0 ? 0 : width(text, style);
  set(style);
  cairo_move_to(context, x - align * w, y);
  cairo_show_text(context, text.c_str());
  cairo_new_path(context);
}

std::vector<std::string> Pdf_painter::lines(double width, const std::string& text, const Style& style) const
{
  std::istringstream words(text);
  std::vector<std::string> result;
  for (std::string word; words >> word;) {
    const std::string longer = result.empty() ? word : result.back() + " " + word;
    if (!result.empty() && this->width(longer, style) <= width) result.back() = longer;
    else result.push_back(word);
  }
  return result;
}

double Pdf_painter::paragraph(double x, double y, double width, const std::string& text, const Style& style) const
{
  for (const std::string& line : lines(width, text, style)) {
    this->text(x, y, line, style);
    y += line_spacing * style.size;
  }
  return y;
}

void Pdf_painter::fitted_paragraph(double x, double y, double width, double height, const std::string& text,
                                   Style style) const
{
  while (style.size > 1 && line_spacing * style.size * double(lines(width, text, style).size()) > height)
    style.size *= 0.95;
  paragraph(x, y, width, text, style);
}

void Pdf_painter::badge(double x, double y, const std::string& text, const Style& style, const Colour& back) const
{
  const double w = width(text, style) + 0.9 * style.size, h = 1.35 * style.size;
  rounded_box(x - w / 2, y - h / 2, w, h, 0.35 * style.size);
  set(back);
  cairo_fill(context);
  this->text(x, y + 0.36 * style.size, text, style, 0.5);
}

void Pdf_painter::caption(double x, double y, const std::string& text, const Style& style) const
{
  const double w = width(text, style);
  set(style);
  cairo_move_to(context, x - w / 2, y + 0.36 * style.size);
  cairo_text_path(context, text.c_str());
  cairo_set_source_rgba(context, 1, 1, 1, 0.85);
  cairo_set_line_width(context, 0.28 * style.size);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke(context);
  this->text(x, y + 0.36 * style.size, text, style, 0.5); // as text, so that readers can search for it
}

void Pdf_painter::rounded_box(double x, double y, double width, double height, double radius) const
{
  cairo_new_path(context);
  cairo_arc(context, x + width - radius, y + radius, radius, -pi / 2, 0);
  cairo_arc(context, x + width - radius, y + height - radius, radius, 0, pi / 2);
  cairo_arc(context, x + radius, y + height - radius, radius, pi / 2, pi);
  cairo_arc(context, x + radius, y + radius, radius, pi, 3 * pi / 2);
  cairo_close_path(context);
}

void Pdf_painter::picture(double x, double y, double width, double height, const CGAL::Multiplanar::Image& image) const
{
  const std::string jpeg = jpeg_of(image, 90);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
  // The file's bytes go into the document as they are; the document gives them back.
  auto* bytes = new std::string(jpeg);
  const cairo_status_t status = cairo_surface_set_mime_data(
      surface, CAIRO_MIME_TYPE_JPEG, reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size(),
      [](void* data) { delete static_cast<std::string*>(data); }, bytes);
  if (status != CAIRO_STATUS_SUCCESS) {
    delete bytes;
    cairo_surface_destroy(surface);
    throw std::runtime_error(std::string("PDF: ") + cairo_status_to_string(status));
  }
  cairo_save(context);
  rounded_box(x, y, width, height, 2);
  cairo_clip(context);
  cairo_translate(context, x, y);
  cairo_scale(context, width / image.width, height / image.height);
  cairo_set_source_surface(context, surface, 0, 0);
  cairo_paint(context);
  cairo_restore(context);
  cairo_surface_destroy(surface);
}

void Pdf_painter::polygon(const std::vector<std::vector<Place>>& loops, const Colour& fill, const Colour& border) const
{
  cairo_new_path(context);
  for (const auto& loop : loops) {
    cairo_new_sub_path(context);
    for (const Place& p : loop) cairo_line_to(context, p[0], p[1]);
    cairo_close_path(context);
  }
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  set(fill);
  cairo_fill_preserve(context);
  set(border);
  cairo_set_line_width(context, 0.12);
  cairo_stroke(context);
}

void Pdf_painter::rule(double x0, double y, double x1) const
{
  set(line);
  cairo_set_line_width(context, 0.25);
  cairo_move_to(context, x0, y);
  cairo_line_to(context, x1, y);
  cairo_stroke(context);
}

void Pdf_painter::arrow(double x0, double y0, double x1, double y1) const
{
  const double length = std::hypot(x1 - x0, y1 - y0);
  if (length < 1) return;
  const double dx = (x1 - x0) / length, dy = (y1 - y0) / length, head = (std::min)(3.4, 0.6 * length), w = 0.42 * head;
  const double bx = x1 - head * dx, by = y1 - head * dy;
  for (const bool is_border : {true, false}) {
    set(is_border ? white : accent);
    cairo_set_line_width(context, is_border ? 1.9 : 1.1);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_move_to(context, x0, y0);
    cairo_line_to(context, bx, by);
    cairo_stroke(context);
    cairo_move_to(context, x1, y1);
    cairo_line_to(context, bx - w * dy, by + w * dx);
    cairo_line_to(context, bx + w * dy, by - w * dx);
    cairo_close_path(context);
    if (is_border) {
      cairo_set_line_width(context, 0.8);
      cairo_stroke(context);
    } else {
      cairo_fill(context);
    }
  }
}
