// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_AMBIENT_OCCLUSION_H
#define MULTIPLANAR_WRITERS_AMBIENT_OCCLUSION_H

#include "Frame_buffer.h"

#include <vector>

/// The share of the sky, 0..1, that each pixel's surface sees past its surroundings within `radius`, guessed from the
/// depths of the picture alone.
std::vector<float> ambient_occlusion(const Frame_buffer& buffer, const Camera& camera, double radius, int threads);

#endif // MULTIPLANAR_WRITERS_AMBIENT_OCCLUSION_H
