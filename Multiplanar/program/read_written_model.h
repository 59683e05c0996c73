// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H
#define MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H

#include <CGAL/Multiplanar/Model.h>

#include <map>
#include <string>

/// What model.json says of the picture on the outer face of a part.
struct Written_texture
{
  std::string file;
  CGAL::Multiplanar::Point_2 origin = CGAL::Multiplanar::Point_2(0, 0);
  double mm_per_pixel = 0;
};

/// A model as a folder holds it.
struct Written_folder
{
  CGAL::Multiplanar::Model model;                  ///< all but the order of assembly; corners know no mesh
  std::map<std::string, Written_texture> textures; ///< by id of the part
};

/// Reads the model.json of a folder that make or fabricate wrote. \throws Failure (exit_input)
Written_folder read_written_model(const std::string& folder);

#endif // MULTIPLANAR_PROGRAM_READ_WRITTEN_MODEL_H
