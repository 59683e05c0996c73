// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_SHEET_DRAWING_H
#define CGAL_MULTIPLANAR_SHEET_DRAWING_H

#include <CGAL/Multiplanar/Sheet.h>
#include <CGAL/Multiplanar/io/stroke_font.h>
#include <CGAL/Multiplanar/kerf_compensation.h>
#include <CGAL/Multiplanar/press_fit.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// What a machine does to one part, in the coordinates of its sheet (mm, y upward).
struct Part_drawing
{
  std::string id;                ///< of the part
  std::vector<Stroke> engraving; ///< open lines
  std::vector<Outline> inner;    ///< closed cuts of holes
  std::vector<Outline> outer;    ///< the closed cut that frees the part
};

/// The lines of one sheet, the same for every file format.
struct Sheet_drawing
{
  double width = 0;                  ///< of the sheet, in mm
  double height = 0;                 ///< of the sheet, in mm
  std::vector<Part_drawing> parts;   ///< in the order of the placements
  std::vector<std::string> warnings; ///< cuts that could not be drawn as they should
};

namespace internal {

/// Numbers in drawings are multiples of this many mm.
constexpr double drawing_unit = 1e-5;

inline Point_2 on_drawing_grid(const Point_2& p)
{
  return Point_2(std::round(p.x() / drawing_unit) * drawing_unit, std::round(p.y() / drawing_unit) * drawing_unit);
}

/// `path` placed and rounded, without vertices that fall together.
inline Outline drawn_path(const Outline& path, const Placement& placement)
{
  Outline result;
  for (const Point_2& p : path) {
    const Point_2 q = on_drawing_grid(placement(p));
    if (result.empty() || q != result.back()) result.push_back(q);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

/// The strokes of a text, placed. The place and the direction are mirrored with the part, the letters are not.
inline void draw_text(const Engraving& e, const Placement& placement, std::vector<Stroke>& strokes)
{
  const Point_2 middle = placement(e.at);
  const double degrees = placement.rotation + (placement.mirrored ? -e.angle : e.angle);
  const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
  for (const Stroke& stroke : text_strokes(e.text)) {
    Stroke drawn;
    for (const Point_2& p : stroke)
      drawn.push_back(on_drawing_grid(
          Point_2(middle.x() + e.height * (c * p.x() - s * p.y()), middle.y() + e.height * (s * p.x() + c * p.y()))));
    strokes.push_back(std::move(drawn));
  }
}

/// The paths of a part, with its tabs grown and compensated for the kerf where its loops are simple.
inline Cut_paths paths_of_part(const Part& part, double kerf, double fit, std::vector<std::string>& warnings)
{
  bool simple = is_simple_outline(part.outline);
  for (const Outline& hole : part.holes) simple = simple && is_simple_outline(hole);
  if (!simple) {
    warnings.push_back("part " + part.id + " has an outline that crosses itself: drawn without fit and kerf");
    return {part.outline, part.holes};
  }
  Cut_paths paths = compensate_kerf(press_fit_outline(part, fit), part.holes, kerf);
  if (paths.inner.size() < part.holes.size())
    warnings.push_back("part " + part.id + " has a hole narrower than the kerf: it cannot be cut");
  return paths;
}

inline Part_drawing draw_part(const Part& part, const Placement& placement, double kerf, double fit,
                              std::vector<std::string>& warnings)
{
  Part_drawing drawing;
  drawing.id = part.id;
  for (const Engraving& e : part.engraving) draw_text(e, placement, drawing.engraving);
  const Cut_paths paths = paths_of_part(part, kerf, fit, warnings);
  drawing.outer.push_back(drawn_path(paths.outer, placement));
  for (const Outline& path : paths.inner) drawing.inner.push_back(drawn_path(path, placement));
  bool simple = true;
  for (const auto* list : {&drawing.outer, &drawing.inner})
    for (const Outline& path : *list) simple = simple && is_simple_outline(path);
  if (!simple) warnings.push_back("part " + part.id + " has a cut that touches itself");
  return drawing;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarSheets

The lines of `sheet`: its parts placed, their tabs grown by the fit, kerf-compensated, rounded to 1e-5 mm, and checked
again for being simple after that.

\param sheet which parts lie where
\param parts the list that the sheet's placements refer to
\param kerf full width of the cut in mm
\param fit how much wider than its slot a tab is cut, in mm
*/
inline Sheet_drawing draw_sheet(const Sheet& sheet, const std::vector<Part>& parts, double kerf, double fit = 0)
{
  Sheet_drawing drawing;
  drawing.width = sheet.width;
  drawing.height = sheet.height;
  for (const Placement& p : sheet.placements) {
    CGAL_precondition(p.part >= 0 && p.part < int(parts.size()));
    drawing.parts.push_back(internal::draw_part(parts[p.part], p, kerf, fit, drawing.warnings));
  }
  return drawing;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_SHEET_DRAWING_H
