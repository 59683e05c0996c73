// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Pdf_document.h"

#include <cairo-pdf.h>

#include <ostream>
#include <stdexcept>

namespace {

constexpr double points_per_mm = 72 / 25.4;

cairo_status_t pass_on(void* out, const unsigned char* data, unsigned int length)
{
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(reinterpret_cast<const char*>(data), length);
  return stream ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

void expect_success(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_WRITE_ERROR) // the stream itself tells of the latter
    throw std::runtime_error(std::string("PDF: ") + cairo_status_to_string(status));
}

} // namespace

struct Pdf_document::State
{
  explicit State(std::ostream& out)
      : surface(cairo_pdf_surface_create_for_stream(pass_on, &out, 1, 1)), context(cairo_create(surface))
  {
    // A fixed date, for there is no way to leave it out.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "multiplanar");
  }
  ~State()
  {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  cairo_surface_t* surface;
  cairo_t* context;
  bool has_page = false;
};

Pdf_document::Pdf_document(std::ostream& out) : state(std::make_unique<State>(out))
{
  expect_success(cairo_surface_status(state->surface));
}

Pdf_document::~Pdf_document() = default;

void Pdf_document::set_title(const std::string& title)
{
  cairo_pdf_surface_set_metadata(state->surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
}

cairo_t* Pdf_document::begin_page(double width_mm, double height_mm)
{
  cairo_t* context = state->context;
  if (state->has_page) {
    cairo_restore(context);
    cairo_show_page(context);
  }
  state->has_page = true;
  cairo_pdf_surface_set_size(state->surface, width_mm * points_per_mm, height_mm * points_per_mm);
  cairo_save(context);
  cairo_scale(context, points_per_mm, points_per_mm);
  return context;
}

void Pdf_document::finish()
{
  if (state->has_page) cairo_show_page(state->context);
  expect_success(cairo_status(state->context));
  cairo_surface_finish(state->surface);
  expect_success(cairo_surface_status(state->surface));
}
