// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_FRAME_BUFFER_H
#define MULTIPLANAR_WRITERS_FRAME_BUFFER_H

#include "Camera.h"
#include "Scene.h"

#include <cstdint>
#include <vector>

/// The samples of a picture, several a pixel in each direction, and what is nearest to the eye in each.
struct Frame_buffer
{
  Frame_buffer(int width, int height, int samples)
      : samples(samples), width(width * samples), height(height * samples),
        inverse_depth(std::size_t(this->width) * this->height, 0), rgb(3 * std::size_t(this->width) * this->height)
  {
  }

  int samples;                      ///< a pixel, in each direction
  int width, height;                ///< in samples
  std::vector<float> inverse_depth; ///< 0: nothing was drawn
  std::vector<std::uint8_t> rgb;    ///< sRGB
};

/// A range of rows of samples; bands are drawn side by side by several threads.
struct Band
{
  int first, last; ///< rows first .. last - 1
};

/// Draws the part of a triangle that lies in a band, lit by a soft light from the upper left of the camera.
void draw_triangle(Frame_buffer& buffer, const Band& band, const Camera& camera, const Scene_triangle& triangle,
                   const CGAL::Multiplanar::Vector_3& up);

/// Draws the part of a line that lies in a band; `bias` is how far it is brought nearer to the eye, so that the faces
/// that it lies on do not hide it.
void draw_line(Frame_buffer& buffer, const Band& band, const Camera& camera, const Scene_line& line, double bias);

#endif // MULTIPLANAR_WRITERS_FRAME_BUFFER_H
