// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_PANEL_COLOURS_H
#define MULTIPLANAR_WRITERS_PANEL_COLOURS_H

#include <CGAL/Multiplanar/Linear_colour.h>
#include <CGAL/Multiplanar/Panel_complex.h>

#include <vector>

/// A colour for every panel: equally light hues, those of neighbours far apart.
std::vector<CGAL::Multiplanar::Linear_colour> panel_colours(const CGAL::Multiplanar::Panel_complex& complex);

/// Plywood, for what is no panel.
constexpr CGAL::Multiplanar::Linear_colour connector_colour{{0.55f, 0.40f, 0.24f}};

#endif // MULTIPLANAR_WRITERS_PANEL_COLOURS_H
