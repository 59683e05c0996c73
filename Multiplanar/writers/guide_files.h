// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_WRITERS_GUIDE_FILES_H
#define MULTIPLANAR_WRITERS_GUIDE_FILES_H

#include <string>

/// Files that are built into the program: the guide's page with `%NAME%` where something is to be filled in, its style
/// and script, and three.js with its camera control, as Debian has them.
namespace guide_files {

std::string page();
std::string style();
std::string script();
std::string three();
std::string orbit();

} // namespace guide_files

#endif // MULTIPLANAR_WRITERS_GUIDE_FILES_H
