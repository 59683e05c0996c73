// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_sheet_pdf.h"
#include "Pdf_document.h"

#include <cairo.h>

#include <cstdio>
#include <vector>

using namespace CGAL::Multiplanar;

namespace {

void set_colour(cairo_t* context, const std::string& colour)
{
  unsigned red = 0, green = 0, blue = 0;
  std::sscanf(colour.c_str(), "#%2x%2x%2x", &red, &green, &blue);
  cairo_set_source_rgb(context, red / 255., green / 255., blue / 255.);
}

void draw_path(cairo_t* context, const std::vector<Point_2>& path, bool closed, double sheet_height)
{
  cairo_new_path(context);
  for (const Point_2& p : path) cairo_line_to(context, p.x(), sheet_height - p.y());
  if (closed) cairo_close_path(context);
  cairo_stroke(context);
}

} // namespace

void write_sheet_pdf(std::ostream& out, const Sheet_drawing& sheet, const Palette& palette, const std::string& title)
{
  Pdf_document document(out);
  document.set_title(title);
  cairo_t* context = document.begin_page(sheet.width, sheet.height);
  cairo_set_line_width(context, 0.01);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  set_colour(context, palette.engrave);
  for (const Part_drawing& part : sheet.parts)
    for (const Stroke& stroke : part.engraving) draw_path(context, stroke, false, sheet.height);
  set_colour(context, palette.inner);
  for (const Part_drawing& part : sheet.parts)
    for (const Outline& path : part.inner) draw_path(context, path, true, sheet.height);
  set_colour(context, palette.outer);
  for (const Part_drawing& part : sheet.parts)
    for (const Outline& path : part.outer) draw_path(context, path, true, sheet.height);
  document.finish();
}
