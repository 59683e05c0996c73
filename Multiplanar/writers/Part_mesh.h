// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PART_MESH_H
#define MULTIPLANAR_WRITERS_PART_MESH_H

#include <CGAL/Multiplanar/Part.h>

#include <array>
#include <vector>

/// Triangles with a normal at each corner, counter-clockwise seen from outside; of a group of faces.
struct Mesh_faces
{
  std::vector<CGAL::Multiplanar::Point_3> points;
  std::vector<CGAL::Multiplanar::Vector_3> normals; ///< by point, of length 1
  std::vector<CGAL::Multiplanar::Point_2> places;   ///< by point, in the plane of the part
  std::vector<std::array<int, 3>> triangles;
};

/// A part as a closed solid, for pictures: what is seen from outside, and what the beam cuts or looks inward.
struct Part_mesh
{
  Mesh_faces outer, rest;
  std::vector<std::array<CGAL::Multiplanar::Point_3, 2>> lines; ///< along its sharp edges
};

/// \param origin the points are given relative to it. A part whose outline touches itself gets walls only.
Part_mesh part_mesh(const CGAL::Multiplanar::Part& part, double thickness,
                    const CGAL::Multiplanar::Point_3& origin = CGAL::Multiplanar::Point_3(0, 0, 0));

#endif // MULTIPLANAR_WRITERS_PART_MESH_H
