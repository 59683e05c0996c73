// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PREVIEW_SCENES_H
#define MULTIPLANAR_WRITERS_PREVIEW_SCENES_H

#include "Scene.h"

#include <CGAL/Multiplanar/Model.h>
#include <CGAL/Multiplanar/Surface_appearance.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// The outer face of a part as it will look: a picture, and the square of the part's plane that it covers.
struct Part_picture
{
  const CGAL::Multiplanar::Texture* texture = nullptr;
  CGAL::Multiplanar::Point_2 origin = CGAL::Multiplanar::Point_2(0, 0); ///< of its lower left corner
  double width = 0, height = 0;                                         ///< mm
};

/// By the id of the part.
using Part_pictures = std::map<std::string, Part_picture>;

/// A closed mesh, smooth but for its creases, light grey if it has no looks; these must outlive the scene.
Scene mesh_scene(const CGAL::Multiplanar::Points& points, const std::vector<std::array<int, 3>>& triangles,
                 const CGAL::Multiplanar::Vector_3& up, const CGAL::Multiplanar::Surface_appearance& looks = {});

/// The panels in colours, with their edges.
Scene panels_scene(const CGAL::Multiplanar::Panel_complex& complex, const CGAL::Multiplanar::Vector_3& up);

/// The parts as solids where the model has them; their outer faces as `pictures` say, in colours where they say
/// nothing.
Scene assembled_scene(const CGAL::Multiplanar::Model& model, const CGAL::Multiplanar::Vector_3& up,
                      const Part_pictures& pictures = {});

/// The parts as solids, without the panels that look towards the viewer.
Scene opened_scene(const CGAL::Multiplanar::Model& model, const CGAL::Multiplanar::Vector_3& up,
                   const CGAL::Multiplanar::Vector_3& view);

/// The parts as solids, pulled away from the middle of the model.
Scene exploded_scene(const CGAL::Multiplanar::Model& model, const CGAL::Multiplanar::Vector_3& up,
                     const Part_pictures& pictures = {});

#endif // MULTIPLANAR_WRITERS_PREVIEW_SCENES_H
