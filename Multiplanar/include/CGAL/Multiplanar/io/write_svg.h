// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_SVG_H
#define CGAL_MULTIPLANAR_IO_WRITE_SVG_H

#include <CGAL/Multiplanar/Palette.h>
#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/io/number_format.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

namespace internal {

inline void write_svg_path(std::ostream& out, const std::vector<Point_2>& path, bool closed, double sheet_height)
{
  out << "<path d=\"";
  for (std::size_t i = 0; i < path.size(); ++i)
    out << (i == 0   ? "M"
            : i == 1 ? " L"
                     : " ")
        << drawing_number(path[i].x()) << "," << drawing_number(sheet_height - path[i].y());
  out << (closed ? " Z\"/>\n" : "\"/>\n");
}

using Part_lines = std::function<const std::vector<std::vector<Point_2>>&(const Part_drawing&)>;

/// One layer: a group that holds a group for every part with lines in it.
inline void write_svg_layer(std::ostream& out, const Sheet_drawing& sheet, const std::string& name,
                            const std::string& colour, const std::string& suffix, bool closed, const Part_lines& lines)
{
  out << "<g inkscape:groupmode=\"layer\" inkscape:label=\"" << name << "\" id=\"layer-" << name << "\" stroke=\""
      << colour << "\">\n";
  for (const Part_drawing& part : sheet.parts) {
    if (lines(part).empty()) continue;
    out << "<g id=\"" << part.id << suffix << "\">\n";
    for (const auto& path : lines(part)) write_svg_path(out, path, closed, sheet.height);
    out << "</g>\n";
  }
  out << "</g>\n";
}

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes a sheet as SVG in mm: layers for Inkscape and laser software in the order engrave, inner cuts, outer cuts,
strokes of 0.01 mm without fill, text as single strokes. The group with a part's id holds the cut that frees it; its
inner cuts and its engraving are in groups called id-inner and id-engrave. The caller checks the state of `out`
afterwards.
*/
inline void write_svg(std::ostream& out, const Sheet_drawing& sheet, const Palette& palette = Palette())
{
  const std::string width = internal::drawing_number(sheet.width), height = internal::drawing_number(sheet.height);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << "<svg xmlns=\"http://www.w3.org/2000/svg\""
      << " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"" << width
      << "mm\" height=\"" << height << "mm\" viewBox=\"0 0 " << width << " " << height << "\">\n"
      << "<g fill=\"none\" stroke-width=\"0.01\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  using Lines = const std::vector<std::vector<Point_2>>&;
  internal::write_svg_layer(out, sheet, "engrave", palette.engrave, "-engrave", false,
                            [](const Part_drawing& p) -> Lines { return p.engraving; });
  internal::write_svg_layer(out, sheet, "inner", palette.inner, "-inner", true,
                            [](const Part_drawing& p) -> Lines { return p.inner; });
  internal::write_svg_layer(out, sheet, "outer", palette.outer, "", true,
                            [](const Part_drawing& p) -> Lines { return p.outer; });
  out << "</g>\n</svg>\n";
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_SVG_H
