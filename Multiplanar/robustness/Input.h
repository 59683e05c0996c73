// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_ROBUSTNESS_INPUT_H
#define MULTIPLANAR_ROBUSTNESS_INPUT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <set>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;

/// Why a mesh must be refused.
enum class Fault
{
  unreadable,
  not_manifold, ///< or not consistently oriented
  open,
  components,
  degenerate,
  intersecting,
  not_triangulable,
  panels ///< the number asked for suits no such surface
};

/// A mesh as CGAL's own readers and predicates see it; none of the program's code has a part in this.
struct Input
{
  std::vector<Point_3> points;                    ///< welded where the mesh would be open otherwise; those in use
  std::vector<std::vector<std::size_t>> polygons; ///< in the order of the file
  std::set<Fault> faults;
  int faces = 0; ///< triangles
  int genus = 0; ///< if there are no faults
};

Input read_input(const std::string& file);

/// Can a refusal with this message be meant for one of the faults?
bool is_right_message(const std::string& message, const std::set<Fault>& faults);

#endif // MULTIPLANAR_ROBUSTNESS_INPUT_H
