// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_WRITTEN_MODEL_H
#define MULTIPLANAR_VERIFY_WRITTEN_MODEL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// Coordinates are the written doubles; predicates are exact.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Loop = std::vector<Point_2>; ///< a closed polygon: the last vertex is followed by the first

/// A file that is not what it should be: a line that says where and what.
struct Unreadable : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// What model.json says, word by word, in mm. References to other things stay ids: whether they exist is for the checks.

struct Written_panel
{
  std::string id;
  Vector_3 normal;
  double offset = 0;
  std::vector<std::vector<int>> loops; ///< corners
};

struct Written_edge
{
  std::string id;
  std::array<std::string, 2> panels;
  std::array<int, 2> corners = {-1, -1};
  std::optional<double> dihedral; ///< degrees
  std::string joint, reason;
  std::vector<std::string> parts;
};

struct Written_frame
{
  Point_3 origin;
  Vector_3 u, v, normal;
};

struct Written_part
{
  std::string id;
  bool is_panel = true;
  Written_frame frame;
  Loop outline;
  std::vector<Loop> holes;
  double area = 0;
  std::vector<std::array<int, 2>> tabs;
  std::string texture; ///< a file, or empty
};

struct Written_placement
{
  std::string part;
  double x = 0, y = 0, rotation = 0;
  bool mirrored = false;
};

struct Written_sheet
{
  std::string file;
  double width = 0, height = 0;
  std::vector<Written_placement> placements;
};

struct Written_step
{
  int number = 0;
  std::vector<std::string> parts;
  Vector_3 direction;
  double travel = 0;
};

struct Written_model
{
  std::string input_file; ///< what the model was made from; may be empty
  double scale = 1, thickness = 0, kerf = 0, fit = 0;
  int most_panels = 0; ///< that were asked for; 0 if not said
  std::vector<Point_3> corners;
  std::vector<Written_panel> panels;
  std::vector<Written_edge> edges;
  std::vector<Written_part> parts;
  std::vector<Written_sheet> sheets;
  std::vector<Written_step> assembly;

  double diagonal() const; ///< of the bounding box of the corners
  int panel_index(const std::string& id) const;
  int part_index(const std::string& id) const;
  /// The panel that a part belongs to: its id, maybe with a lower-case letter behind it if the panel fell apart.
  int panel_of_part(const Written_part& part) const;

  std::map<std::string, int> panel_by_id, part_by_id;
};

/// \throw Unreadable with the place in the file
Written_model read_model(const std::filesystem::path& file);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_WRITTEN_MODEL_H
