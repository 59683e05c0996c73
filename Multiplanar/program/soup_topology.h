// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_SOUP_TOPOLOGY_H
#define MULTIPLANAR_PROGRAM_SOUP_TOPOLOGY_H

#include "Polygon_soup.h"

#include <string>

/// Has any edge one face only? Linear, up to a logarithm.
bool has_boundary(const Polygon_soup& soup);

/// Makes one vertex of those with equal coordinates; the first keeps its place. \return how many went
int weld_equal_points(Polygon_soup& soup);

/// Takes out vertices that no face uses; the others keep their order. \return how many went
int remove_unused_points(Polygon_soup& soup);

/// Refuses what is not one closed, oriented, connected 2-manifold, looking at the indices alone.
/// \throws Failure (exit_input), with a message of its own for every kind of fault
void check_topology(const Polygon_soup& soup, const std::string& name);

#endif // MULTIPLANAR_PROGRAM_SOUP_TOPOLOGY_H
