// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_INPUT_MESH_H
#define MULTIPLANAR_PROGRAM_INPUT_MESH_H

#include "Polygon_soup.h"

#include <CGAL/Multiplanar/internal/Connectivity.h>

#include <map>
#include <string>
#include <vector>

/// A mesh that the job can be done with: closed, oriented outward, connected, manifold, embedded.
struct Input_mesh
{
  std::string file;
  CGAL::Multiplanar::Points points; ///< in the order of the file, equal ones welded if the mesh was not closed
  CGAL::Multiplanar::internal::Connectivity connectivity; ///< faces in the order of the file
  std::vector<int> face_of_triangle;                      ///< the face of the file that a triangle belongs to
  int faces_in_file = 0;
  std::map<std::string, std::vector<double>> face_properties; ///< by face of the file
  std::vector<std::array<int, 3>> corners;                    ///< by triangle: places in the lists of `appearance`
  Soup_appearance appearance;                                 ///< colours and texture points by corner of the file
  double diagonal = 0;                                        ///< of the bounding box
  std::vector<std::string> notes;                             ///< what was done to the mesh
};

/// Mends what needs no decision (coincident vertices along seams, unused vertices, all faces inward) and refuses the
/// rest. Exact. \throws Failure (exit_input)
Input_mesh make_input_mesh(Polygon_soup soup, const std::string& file);

/// Refuses a number of panels that no surface like this one can have. \throws Failure (exit_input)
void check_number_of_panels(const Input_mesh& mesh, int panels);

#endif // MULTIPLANAR_PROGRAM_INPUT_MESH_H
