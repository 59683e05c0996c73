// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_REPAIR_H
#define MULTIPLANAR_PROGRAM_REPAIR_H

#include "Polygon_soup.h"

#include <string>
#include <vector>

/// Makes one closed, oriented, embedded surface of what a file holds, changing as little as it can: each step runs only
/// where it is needed, and says in one line what it did.
///
///  -# weld: vertices at the same place, and those along open edges closer than 1e-5 of the diagonal;
///  -# remove degenerate: faces without area, faces that stand there twice, faces that hang on an edge of two others;
///  -# orient: neighbours agree; where three or more faces meet in an edge they are cut apart;
///  -# fill holes;
///  -# keep the largest component, by volume;
///  -# resolve self-intersections: the faces around them are replaced;
///  -# wrap, where all of this does not suffice: a new surface around the mesh.
///
/// Colours and texture points stay with the triangles that remain; new triangles have none, and the notes say so.
/// \return triangles, or the soup as it was if nothing is to be mended (no notes then)
Polygon_soup repair(Polygon_soup soup, std::vector<std::string>& notes);

#endif // MULTIPLANAR_PROGRAM_REPAIR_H
