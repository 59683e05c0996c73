// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_DRAWING_H
#define MULTIPLANAR_VERIFY_DRAWING_H

#include "written_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

enum class Layer
{
  engrave,
  inner,
  outer
};

const char* name_of(Layer layer);

/// A line of a drawing, in mm, y upward.
struct Path
{
  Layer layer;
  std::string group; ///< the id of the innermost group that has one, if the format has groups
  Loop points;       ///< without a repetition of the first point at the end
  bool closed;
};

/// A sheet as a file shows it.
struct Drawing
{
  double width = 0, height = 0; ///< 0 if the format does not say
  std::vector<Path> paths;
  std::vector<std::string> complaints; ///< what can be read but is not as promised
};

/// \throw Unreadable if the file is no SVG, breaks off, or uses what our sheets never use
Drawing read_svg(const std::filesystem::path& file);

/// \throw Unreadable if the file is no DXF or breaks off
Drawing read_dxf(const std::filesystem::path& file);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_DRAWING_H
