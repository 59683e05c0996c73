// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_ASSEMBLY_GUIDE_H
#define MULTIPLANAR_WRITERS_ASSEMBLY_GUIDE_H

#include "preview_scenes.h"

#include <CGAL/Multiplanar/Linear_colour.h>
#include <CGAL/Multiplanar/Model.h>

#include <iosfwd>
#include <string>
#include <vector>

/// What stands across one edge of a panel.
struct Guide_neighbour
{
  int panel, edge;
};

/// A model as seen by someone who puts it together: what all forms of the guide have in common.
struct Assembly_guide
{
  const CGAL::Multiplanar::Model& model;
  std::string title; ///< the input's name, as words
  CGAL::Multiplanar::Vector_3 up, towards_viewer;
  Part_pictures pictures; ///< that the outer faces show

  std::vector<int> step;                                ///< by part, counted from 0; -1 if there is no order
  std::vector<int> sheet;                               ///< by part, counted from 0; -1 if on none
  std::vector<int> panel;                               ///< by part; -1 for connectors
  std::vector<int> edge;                                ///< by part: of a connector; -1 for panels
  std::vector<CGAL::Multiplanar::Linear_colour> colour; ///< by part
  std::vector<std::vector<Guide_neighbour>>
      neighbours;                               ///< by panel, one for every edge, each neighbour's edges together
  std::vector<std::vector<int>> parts_of_panel; ///< by panel

  std::string panel_id(int p) const { return CGAL::Multiplanar::panel_id(model.complex, p); }
  bool is_panel(int part) const { return panel[part] >= 0; }
  int count_panels() const;
  int count_connectors() const { return int(model.parts.size()) - count_panels(); }
  /// Of the panel that a connector leads to from panel `p`.
  int other_end(int connector, int p) const { return model.complex.other_panel(edge[connector], p); }
};

/// \param up, towards_viewer unit vectors
Assembly_guide make_assembly_guide(const CGAL::Multiplanar::Model& model, const CGAL::Multiplanar::Vector_3& up,
                                   const CGAL::Multiplanar::Vector_3& towards_viewer,
                                   const Part_pictures& pictures = {});

/*!
Writes `assembly.glb` (glTF 2.0): every part a named node with a solid of its own, in metres, y up. A node's extras tell
its kind, its step, its sheet, and how it moves: `direction` (model axes, as the node's translation), `travel` in mm,
and `explode`, a translation in mm that pulls the model apart.
*/
void write_glb(std::ostream& out, const Assembly_guide& guide);

/// Writes `assembly.html`: one file with all it needs, that opens from disk in any browser with WebGL.
void write_assembly_html(std::ostream& out, const Assembly_guide& guide);

/// Writes `assembly.pdf`, on A4. \param threads that draw pictures; 0: all
void write_assembly_pdf(std::ostream& out, const Assembly_guide& guide, int threads = 0);

/// The bytes of a JPEG file with the picture of a part. \pre it has one
std::string jpeg_of_picture(const Part_picture& picture);

/// Where a part goes, in mm, when the model is pulled apart.
CGAL::Multiplanar::Vector_3 explosion_of(const Assembly_guide& guide, int part);

#endif // MULTIPLANAR_WRITERS_ASSEMBLY_GUIDE_H
