// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_TEXTURES_H
#define MULTIPLANAR_PROGRAM_TEXTURES_H

#include "Progress.h"
#include "previews.h"
#include "texture_sheet_pdf.h"

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/texture_baking.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

/// The looks of the source, and the mesh that became the panels.
struct Texture_source
{
  const CGAL::Multiplanar::Surface_appearance& looks;
  const std::vector<std::array<int, 3>>& triangles;
  const std::vector<int>& panel_of_face;
  CGAL::Multiplanar::Points points; ///< mm
};

/// Makes the images of the panels and the documents to print them from.
class Textures
{
public:
  /// Says in every part where its image will lie. \throws Failure if there would be too many pixels
  Textures(CGAL::Multiplanar::Model& model, const Texture_source& source,
           const CGAL::Multiplanar::Baking_options& options, double gap_between_parts, int threads);

  /// Writes textures/P01.png ..., and two documents a sheet.
  void write(const File_writer& write, Progress& progress);

  int number_of_images() const { return int(grids.size()); }
  /// Small versions for pictures of the whole, after write().
  const Part_pictures& pictures() const { return small_pictures; }

private:
  void check_size() const;
  void write_sheet(const File_writer& write, int sheet);
  std::vector<CGAL::Multiplanar::Image> bake(const std::vector<int>& panels) const;
  void write_images(const File_writer& write, const std::vector<int>& panels,
                    const std::vector<CGAL::Multiplanar::Image>& images);
  Printed_part printed_part(const CGAL::Multiplanar::Placement& placement,
                            const CGAL::Multiplanar::Part_drawing& drawing,
                            const CGAL::Multiplanar::Image& image) const;
  std::vector<int> panels_on(const CGAL::Multiplanar::Sheet& sheet) const;
  void keep_small(int panel, CGAL::Multiplanar::Image image);

  CGAL::Multiplanar::Model& model;
  const Texture_source& source;
  CGAL::Multiplanar::Baking_options options;
  double gap;
  int threads;
  std::map<int, CGAL::Multiplanar::Texture_grid> grids; ///< by panel
  std::map<int, std::string> files;                     ///< by panel, those written
  std::deque<CGAL::Multiplanar::Texture> small;         ///< never moved
  Part_pictures small_pictures;
};

#endif // MULTIPLANAR_PROGRAM_TEXTURES_H
