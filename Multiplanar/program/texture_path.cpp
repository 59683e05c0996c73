// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture_path.h"
#include "failure.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace {

/// Is there a regular file at `path` that lies below `folder`, links followed?
bool is_file_below(const fs::path& folder, const fs::path& path)
{
  std::error_code error;
  const fs::path real = fs::canonical(path, error), root = error ? fs::path() : fs::canonical(folder, error);
  if (error || !fs::is_regular_file(real, error)) return false;
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

} // namespace

std::string folder_of(const std::string& file)
{
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder.string();
}

std::string file_below(const std::string& folder, const std::string& name, std::string& reason)
{
  std::string forward = name;
  if (forward.size() >= 2 && forward.front() == '"' && forward.back() == '"')
    forward = forward.substr(1, forward.size() - 2);
  std::replace(forward.begin(), forward.end(), '\\', '/');
  const fs::path path(forward), last = path.filename();
  if (last.empty() || forward.find('\0') != std::string::npos) {
    reason = ::quoted(name) + " names no file";
    return "";
  }
  const bool has_drive = forward.size() > 1 && forward[1] == ':';
  if (!path.is_absolute() && !has_drive && is_file_below(folder, fs::path(folder) / path))
    return (fs::path(folder) / path).string();
  if (is_file_below(folder, fs::path(folder) / last)) return (fs::path(folder) / last).string();
  reason = ::quoted(name) + " is not in the folder " + folder + " or below it";
  return "";
}
