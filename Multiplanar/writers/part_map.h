// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PART_MAP_H
#define MULTIPLANAR_WRITERS_PART_MAP_H

#include "Assembly_guide.h"
#include "Pdf_painter.h"

/// Draws a page that shows where the parts of a sheet lie, each with its id in its colour.
void draw_part_map(const Pdf_painter& page, const Assembly_guide& guide, int sheet, double page_width,
                   double page_height, double margin);

#endif // MULTIPLANAR_WRITERS_PART_MAP_H
