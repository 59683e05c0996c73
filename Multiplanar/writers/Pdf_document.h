// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PDF_DOCUMENT_H
#define MULTIPLANAR_WRITERS_PDF_DOCUMENT_H

#include <iosfwd>
#include <memory>
#include <string>

typedef struct _cairo cairo_t;

/*!
A PDF whose pages are drawn in millimetres at true size, y pointing down from the upper left corner, as Cairo does.

The file names no date and no time: the same drawing gives the same bytes.
*/
class Pdf_document
{
public:
  /// Writes to `out`, which must outlive the document. \throw std::runtime_error when Cairo cannot begin
  explicit Pdf_document(std::ostream& out);
  Pdf_document(const Pdf_document&) = delete;
  Pdf_document& operator=(const Pdf_document&) = delete;
  ~Pdf_document();

  void set_title(const std::string& title);
  /// Ends the page before, if any, and begins one of so many millimetres. \return what to draw on, good until the next
  cairo_t* begin_page(double width_mm, double height_mm);
  /// Ends the document. \throw std::runtime_error when anything went wrong since it began
  void finish();

private:
  struct State;
  std::unique_ptr<State> state;
};

#endif // MULTIPLANAR_WRITERS_PDF_DOCUMENT_H
