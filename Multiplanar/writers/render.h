// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_RENDER_H
#define MULTIPLANAR_WRITERS_RENDER_H

#include "Camera.h"
#include "Scene.h"

#include <CGAL/Multiplanar/Image.h>

/*!
Draws a scene without a display or a GPU: nearest surface by depth buffer, several samples a pixel, soft light, shade in
recesses and on the ground, over a light background. The same scene gives the same picture for any number of threads.

Memory: about 10 bytes a sample. Time is linear in triangles and samples.

\param samples a pixel in each direction
\param threads 0: all that the machine has
*/
CGAL::Multiplanar::Image render(const Scene& scene, const Camera& camera, int samples = 3, int threads = 0);

#endif // MULTIPLANAR_WRITERS_RENDER_H
