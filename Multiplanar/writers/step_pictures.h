// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_STEP_PICTURES_H
#define MULTIPLANAR_WRITERS_STEP_PICTURES_H

#include "Assembly_guide.h"
#include "Camera.h"
#include "Scene.h"

#include <array>
#include <string>
#include <vector>

/// A word in a picture, around a place in pixels.
struct Picture_label
{
  enum class Kind
  {
    new_panel,
    new_connector,
    placed
  };
  std::string text;
  double x, y;
  Kind kind;
};

/// What is drawn over a picture.
struct Step_marks
{
  std::vector<Picture_label> labels;
  std::array<double, 4> arrow{}; ///< from (x, y) to (x, y), in pixels
  bool has_arrow = false;
};

/// The picture of a step, before it is drawn.
struct Step_picture
{
  Scene scene;
  Camera camera;
  Step_marks marks;
};

/*!
The pictures of all steps: what is placed is pale, what is new is coloured and stands off its place, against the
direction in which it comes. The view stays as it is from step to step unless a new panel would be seen from inside.
*/
class Step_pictures
{
public:
  /// \param width, height of the pictures in pixels
  Step_pictures(const Assembly_guide& guide, int width, int height);

  /// \pre called for the steps in their order
  Step_picture picture(int step);

private:
  void turn_towards(const CGAL::Multiplanar::Vector_3& direction);
  void add_part(Scene& scene, int part, int step) const;
  CGAL::Multiplanar::Vector_3 shift(int part, int step) const;
  void add_labels(Step_picture& picture, int step) const;
  void add_arrow(Step_picture& picture, int step) const;

  const Assembly_guide& guide;
  int width, height;
  CGAL::Multiplanar::Vector_3 view; ///< towards the viewer
  double size;                      ///< of the model, its diagonal in mm
};

#endif // MULTIPLANAR_WRITERS_STEP_PICTURES_H
