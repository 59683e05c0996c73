// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smallest_measures.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Multiplanar/Joint_options.h>

#include <algorithm>

void set_smallest_measures(const Settings& settings, const Input_mesh& mesh,
                           CGAL::Multiplanar::Approximation_options& options)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points.begin(), mesh.points.end());
  const double longest = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  const double units_per_mm = longest / settings.model.size;
  const double edge = settings.min_edge >= 0 ? settings.min_edge : settings.model.thickness / 2;
  const double width = settings.min_width >= 0 ? settings.min_width : settings.model.thickness;
  options.min_edge = (std::max)(edge * units_per_mm, 1e-9 * mesh.diagonal); // 0 would mean the library's default
  options.min_width = (std::max)(width * units_per_mm, 1e-9 * mesh.diagonal);
  if (settings.joints != CGAL::Multiplanar::Joint_mode::none)
    options.sheet_thickness = settings.model.thickness * units_per_mm;
}
