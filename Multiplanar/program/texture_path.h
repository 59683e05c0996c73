// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_TEXTURE_PATH_H
#define MULTIPLANAR_PROGRAM_TEXTURE_PATH_H

#include <string>

/// The folder that a file lies in, "." if its name says none.
std::string folder_of(const std::string& file);

/// The file that a mesh or material file in `folder` means by `name`, which may be a path of another system. Only what
/// lies below the folder is ever read: of a path that leads elsewhere the last part is tried there.
/// \return empty if no such file is there; then `reason` says why
std::string file_below(const std::string& folder, const std::string& name, std::string& reason);

#endif // MULTIPLANAR_PROGRAM_TEXTURE_PATH_H
