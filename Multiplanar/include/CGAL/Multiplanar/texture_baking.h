// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_TEXTURE_BAKING_H
#define CGAL_MULTIPLANAR_TEXTURE_BAKING_H

#include <CGAL/Multiplanar/Panel_complex.h>
#include <CGAL/Multiplanar/Part.h>
#include <CGAL/Multiplanar/Surface_appearance.h>
#include <CGAL/Multiplanar/internal/Flat_triangles.h>
#include <CGAL/Multiplanar/internal/bake_pixels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// \ingroup PkgMultiplanarTextures
/// Where the pixels of a panel's image lie in the plane of its part: pixel (i, j), counted from the upper left corner,
/// covers the square of side `mm_per_pixel` whose lower left corner is
/// origin + mm_per_pixel (i, height - 1 - j).
struct Texture_grid
{
  Point_2 origin = Point_2(0, 0); ///< lower left corner of the image
  double mm_per_pixel = 0;        ///< side of a pixel, in mm
  int width = 0;                  ///< in pixels
  int height = 0;                 ///< in pixels

  /// The centre of pixel (i, j) in the plane of the part.
  Point_2 centre(int i, int j) const
  {
    return Point_2(origin.x() + (i + 0.5) * mm_per_pixel, origin.y() + (height - j - 0.5) * mm_per_pixel);
  }
};

/// \ingroup PkgMultiplanarTextures
/// How fine the images of panels are, and how far they go beyond the panels.
struct Baking_options
{
  double dpi = 150; ///< dots per inch
  double bleed = 3; ///< mm beyond the outline of the panel that are still painted
};

/// \ingroup PkgMultiplanarTextures
/// The loops of panel `p`, untruncated, in the plane of a part that is cut from it; the outer one first.
inline std::vector<Outline> panel_loops(const Panel_complex& complex, int p, const Frame& frame)
{
  std::vector<Outline> loops;
  for (const auto& loop : complex.panels[p].loops) {
    loops.emplace_back();
    for (int corner : complex.loop_corners(loop)) loops.back().push_back(frame.project(complex.corners[corner].point));
  }
  return loops;
}

/// \ingroup PkgMultiplanarTextures
/// The grid that holds a panel and its bleed. \pre the panel has an outline, and the options are positive
inline Texture_grid texture_grid(const std::vector<Outline>& loops, const Baking_options& options)
{
  CGAL_precondition(!loops.empty() && !loops[0].empty() && options.dpi > 0 && options.bleed >= 0);
  double low_x = loops[0][0].x(), high_x = low_x, low_y = loops[0][0].y(), high_y = low_y;
  for (const Point_2& p : loops[0]) {
    low_x = (std::min)(low_x, p.x()), high_x = (std::max)(high_x, p.x());
    low_y = (std::min)(low_y, p.y()), high_y = (std::max)(high_y, p.y());
  }
  Texture_grid grid;
  grid.mm_per_pixel = 25.4 / options.dpi;
  const double margin = options.bleed + 2 * grid.mm_per_pixel;
  grid.origin = Point_2(low_x - margin, low_y - margin);
  grid.width = (std::max)(1, int(std::ceil((high_x - low_x + 2 * margin) / grid.mm_per_pixel)));
  grid.height = (std::max)(1, int(std::ceil((high_y - low_y + 2 * margin) / grid.mm_per_pixel)));
  return grid;
}

/*!
\ingroup PkgMultiplanarTextures

The image of a panel: every pixel shows what the source shows at the point that became this point of the panel.

The triangles of the mesh are those of the source, so the way back is: point of the panel, triangle of the moved mesh in
the panel's plane, barycentric coordinates there, the same coordinates in the source's texture. Where several texels
fall into a pixel, their mean light is taken: up to 8 x 8 places a pixel, each filtered over its share of the texels
(lengthwise and crosswise by the larger of the two singular values of pixels to texels). Beyond the outline, up to the
bleed and a pixel more, a pixel shows the nearest point of the panel. All else is transparent.

\param grid where the pixels lie: see `texture_grid()`
\param faces of the mesh that the panel consists of
\param triangles vertices by face
\param points positions of the vertices in mm, flat in the plane of `frame`
\param frame of the part; its first two coordinates are those of the image, seen from outside
\param appearance colours and textures of the triangles
\param options resolution and bleed, those that the grid was made with

Linear in pixels and in source texels under the panel. Memory: 4 bytes a pixel, and at most 100 MB beside.
*/
inline Image bake_panel(const Texture_grid& grid, const std::vector<int>& faces,
                        const std::vector<std::array<int, 3>>& triangles, const Points& points, const Frame& frame,
                        const Surface_appearance& appearance, const Baking_options& options = Baking_options())
{
  CGAL_precondition(grid.width > 0 && grid.height > 0 && !appearance.empty());
  internal::Flat_triangles flat;
  flat.mm_per_pixel = grid.mm_per_pixel;
  for (int f : faces) {
    internal::Flat_triangle t;
    t.face = f;
    for (int i = 0; i < 3; ++i) {
      const Point_2 p = frame.project(points[triangles[f][i]]);
      t.x[i] = (p.x() - grid.origin.x()) / grid.mm_per_pixel;
      t.y[i] = grid.height - (p.y() - grid.origin.y()) / grid.mm_per_pixel;
    }
    t.prepare();
    flat.triangles.push_back(t);
  }
  flat.borders = internal::borders_of(faces, triangles);
  return internal::bake_pixels(flat, appearance, grid.width, grid.height, options.bleed / grid.mm_per_pixel);
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_TEXTURE_BAKING_H
