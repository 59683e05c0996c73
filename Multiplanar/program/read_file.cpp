// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "failure.h"
#include "read_mesh.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <sys/stat.h>

std::string read_file(const std::string& file)
{
  struct stat status;
  if (stat(file.c_str(), &status) != 0)
    throw input_error(file + ": cannot be read: " + std::strerror(errno) + ": check the name");
  if (S_ISDIR(status.st_mode)) throw input_error(file + ": is a folder: name a mesh file in it");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw input_error(file + ": cannot be read: " + std::strerror(errno) + ": check its permissions");
  std::string content;
  if (S_ISREG(status.st_mode)) content.reserve(std::size_t(status.st_size));
  char buffer[1 << 16];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) content.append(buffer, std::size_t(in.gcount()));
  if (in.bad()) throw input_error(file + ": cannot be read to its end: " + std::strerror(errno));
  return content;
}
