// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_REPAIR_MESH_H
#define MULTIPLANAR_PROGRAM_REPAIR_MESH_H

#include <array>
#include <string>
#include <vector>

/// Triangles under repair, each with what the file says of its corners.
struct Repair_mesh
{
  using Triangle = std::array<int, 3>;
  static constexpr int no_corner = -1; ///< the corners of a triangle that no file named

  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
  std::vector<Triangle> corners;  ///< by triangle: positions in the lists of `Soup_appearance`
  std::vector<std::string> notes; ///< what was done, a line a step

  void say(const std::string& what) { notes.push_back("repair: " + what); }
  double diagonal() const;
};

#endif // MULTIPLANAR_PROGRAM_REPAIR_MESH_H
