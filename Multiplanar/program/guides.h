// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_GUIDES_H
#define MULTIPLANAR_PROGRAM_GUIDES_H

#include "previews.h"

/// Writes the guides to the assembly: assembly.html, assembly.pdf, assembly.glb.
void write_guides(const File_writer& write, const CGAL::Multiplanar::Model& model, const Preview_view& view,
                  const Part_pictures& pictures = {});

#endif // MULTIPLANAR_PROGRAM_GUIDES_H
