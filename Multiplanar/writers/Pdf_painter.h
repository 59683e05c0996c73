// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PDF_PAINTER_H
#define MULTIPLANAR_WRITERS_PDF_PAINTER_H

#include <CGAL/Multiplanar/Image.h>

#include <array>
#include <string>
#include <vector>

typedef struct _cairo cairo_t;

/// Text, pictures and marks on a page in millimetres, y downward.
class Pdf_painter
{
public:
  using Colour = std::array<double, 3>;
  static constexpr Colour ink{{0.13, 0.14, 0.16}}, soft{{0.42, 0.44, 0.47}}, line{{0.80, 0.78, 0.75}},
      accent{{0.82, 0.32, 0.10}}, white{{1, 1, 1}};

  explicit Pdf_painter(cairo_t* context) : context(context) {}

  /// How text looks; `size` is the height of the font in mm.
  struct Style
  {
    double size = 3.4;
    bool bold = false;
    Colour colour = ink;
  };

  double width(const std::string& text, const Style& style) const;
  /// \param x the left end, or with `align` 0.5 the middle and 1 the right end; y of the base line
  void text(double x, double y, const std::string& text, const Style& style, double align = 0) const;
  /// Breaks lines between words. \return the y of the base line of the line after the last
  double paragraph(double x, double y, double width, const std::string& text, const Style& style) const;
  /// A paragraph in smaller letters if it would be higher than `height`.
  void fitted_paragraph(double x, double y, double width, double height, const std::string& text, Style style) const;
  /// Text in a rounded box, around its middle.
  void badge(double x, double y, const std::string& text, const Style& style, const Colour& back) const;
  /// Text around its middle with a light border, for text on pictures.
  void caption(double x, double y, const std::string& text, const Style& style) const;
  /// A picture with rounded corners; compressed as JPEG.
  void picture(double x, double y, double width, double height, const CGAL::Multiplanar::Image& image) const;
  using Place = std::array<double, 2>;
  /// Filled with a thin border; loops after the first are holes.
  void polygon(const std::vector<std::vector<Place>>& loops, const Colour& fill, const Colour& border) const;
  void rule(double x0, double y, double x1) const;
  void arrow(double x0, double y0, double x1, double y1) const;

private:
  static constexpr double line_spacing = 1.4; ///< by the height of the font

  std::vector<std::string> lines(double width, const std::string& text, const Style& style) const;
  void set(const Colour& colour) const;
  void set(const Style& style) const;
  void rounded_box(double x, double y, double width, double height, double radius) const;

  cairo_t* context;
};

#endif // MULTIPLANAR_WRITERS_PDF_PAINTER_H
