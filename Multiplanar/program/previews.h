// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PREVIEWS_H
#define MULTIPLANAR_PROGRAM_PREVIEWS_H

#include "preview_scenes.h"

#include <CGAL/Multiplanar/Model.h>

#include <functional>
#include <iosfwd>
#include <string>

/// Writes a file with this name, with what the function puts into the stream.
using File_writer = std::function<void(const std::string& name, const std::function<void(std::ostream&)>& write_to)>;

/// What the pictures of one model have in common: whence it is looked at, and by how many threads it is drawn.
struct Preview_view
{
  CGAL::Multiplanar::Vector_3 up, towards_viewer;
  int threads = 0; ///< 0: all
};

/// Where a model most likely has its upper side: what its pictures and its up marks show.
CGAL::Multiplanar::Vector_3 up_of(const CGAL::Multiplanar::Panel_complex& complex);

Preview_view preview_view(const CGAL::Multiplanar::Panel_complex& complex, int threads);

/// Writes `preview/input.png`: what was read, as a scene of its triangles.
void write_input_preview(const File_writer& write, const Scene& input, const Preview_view& view);

/// Writes the pictures of what was made: panels.png, assembled.png, inside.png, exploded.png, sheet-1.png ...
void write_model_previews(const File_writer& write, const CGAL::Multiplanar::Model& model, const Preview_view& view,
                          const Part_pictures& pictures = {});

#endif // MULTIPLANAR_PROGRAM_PREVIEWS_H
