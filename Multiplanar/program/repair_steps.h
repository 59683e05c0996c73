// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_REPAIR_STEPS_H
#define MULTIPLANAR_PROGRAM_REPAIR_STEPS_H

#include "Repair_mesh.h"

// The steps of repair() in their order. Each says what it did, and nothing if there was nothing to do.

/// Makes one vertex of those at the same place, if the mesh is open; then one of those along its open edges that are
/// closer than 1e-5 of the diagonal.
void weld(Repair_mesh& mesh);

/// Removes triangles that use a vertex twice, repeat another triangle, or hang with an open edge on an edge of two or
/// more others.
void remove_useless_triangles(Repair_mesh& mesh);

/// Turns triangles until neighbours agree, and cuts edges and vertices apart where the surface is no manifold.
void orient(Repair_mesh& mesh);

/// On a manifold: joins what was cut apart and fits, removes triangles without area, fills holes, keeps the component
/// of largest volume, resolves self-intersections. \return is the result closed and embedded?
bool mend_surface(Repair_mesh& mesh);

/// Replaces the mesh by a surface close around it: always closed and embedded. Textures go.
void wrap(Repair_mesh& mesh);

#endif // MULTIPLANAR_PROGRAM_REPAIR_STEPS_H
