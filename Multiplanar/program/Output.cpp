// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output.h"
#include "Interruption.h"
#include "failure.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

std::string reason(int error) { return error != 0 ? std::strerror(error) : "the system gives no reason"; }

Failure cannot_write(const std::string& path, int error)
{
  return resource_error(path + ": cannot be written: " + reason(error) +
                        (error == ENOSPC ? ": free some space" : ": choose another place (-o)"));
}

/// What earlier runs wrote; anything else in a folder is somebody's and must not go.
bool is_ours(const std::string& name)
{
  for (const char* ours : {"shell.ply", "panels.obj", "model.json", "report.json", "sheets", "fit-test.svg", "textures",
                           "assembly.html", "assembly.pdf", "assembly.glb", "preview", "parts.csv", "repaired.ply"})
    if (name == ours) return true;
  return false;
}

/// The path without a trailing slash, absolute, with links resolved as far as it exists.
std::string resolved(const std::string& path)
{
  fs::path p = fs::weakly_canonical(fs::absolute(path)).lexically_normal();
  if (!p.has_filename()) p = p.parent_path();
  return p.string();
}

/// A name beside `target` that nobody uses.
std::string neighbour_of(const std::string& target)
{
  const fs::path p(target);
  const std::string stem =
      (p.parent_path() / ("." + p.filename().string() + ".part-" + std::to_string(getpid()))).string();
  std::string name = stem;
  for (int i = 1; fs::exists(fs::symlink_status(name)); ++i) name = stem + "-" + std::to_string(i);
  return name;
}

} // namespace

Output::Output(Kind kind, const std::string& path) : kind(kind)
{
  if (path.empty()) throw usage_error("the output needs a name (-o)");
  try {
    target = resolved(path);
    if (!fs::path(target).has_filename()) throw usage_error(path + ": cannot be replaced: choose another output (-o)");
    refuse_strangers();
    make_temporary();
  } catch (const fs::filesystem_error& error) {
    throw cannot_write(path, error.code().value());
  }
}

void Output::make_temporary()
{
  const std::lock_guard<std::mutex> lock(output_mutex());
  try {
    make_parents();
    const std::string name = neighbour_of(target);
    const int made = kind == Kind::folder ? ::mkdir(name.c_str(), 0777)
                                          : ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (made < 0) throw cannot_write(target, errno);
    if (kind == Kind::file) ::close(made);
    temporary = name;
  } catch (...) {
    discard();
    throw;
  }
  std::vector<std::string> doomed(1, temporary);
  doomed.insert(doomed.end(), made_parents.rbegin(), made_parents.rend());
  remove_when_interrupted(std::move(doomed));
}

Output::~Output()
{
  if (committed) return;
  const std::lock_guard<std::mutex> lock(output_mutex());
  discard();
}

void Output::refuse_strangers() const
{
  const fs::file_status status = fs::status(target);
  if (!fs::exists(status)) return;
  if (kind == Kind::file) {
    if (!fs::is_regular_file(status)) throw usage_error(target + ": is not a file: choose another output (-o)");
    return;
  }
  if (!fs::is_directory(status)) throw usage_error(target + ": is not a folder: choose another output (-o)");
  if (fs::is_empty(target)) return;
  if (!fs::exists(target + "/model.json"))
    throw usage_error(target + ": holds no earlier output (no model.json): empty it or choose another folder (-o)");
  for (const auto& entry : fs::directory_iterator(target))
    if (!is_ours(entry.path().filename().string()))
      throw usage_error(target + ": holds " + quoted(entry.path().filename().string()) +
                        ", which is none of our output: move it away or choose another folder (-o)");
}

void Output::make_parents()
{
  std::vector<fs::path> missing;
  for (fs::path p = fs::path(target).parent_path(); !p.empty() && !fs::exists(p); p = p.parent_path())
    missing.push_back(p);
  for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
    fs::create_directory(*p);
    made_parents.push_back(p->string());
  }
}

/// \pre the caller holds output_mutex()
void Output::discard()
{
  std::error_code ignored;
  if (!temporary.empty()) fs::remove_all(temporary, ignored);
  for (auto p = made_parents.rbegin(); p != made_parents.rend(); ++p) fs::remove(*p, ignored);
  temporary.clear();
  made_parents.clear();
  remove_when_interrupted({});
}

void Output::write(const std::string& name, const std::function<void(std::ostream&)>& write_to)
{
  const std::string file = name.empty() ? temporary : temporary + "/" + name;
  const std::string shown = name.empty() ? target : target + "/" + name;
  std::error_code error;
  fs::create_directories(fs::path(file).parent_path(), error);
  errno = 0;
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  if (out) write_to(out);
  out.close(); // what was buffered is written only now
  if (!out) throw cannot_write(shown, errno);
}

/// A file is small enough to be held until the output is complete: so it needs no name that a signal could leave
/// behind.
void Output::write_beside(const std::string& extension, const std::function<void(std::ostream&)>& write_to)
{
  const std::string stem = fs::path(target).stem().string();
  beside = (fs::path(target).parent_path() / (stem + extension)).string();
  std::ostringstream out(std::ios::binary);
  write_to(out);
  beside_content = out.str();
}

/// \pre the caller holds output_mutex()
void Output::commit_beside()
{
  if (beside.empty()) return;
  const std::string hidden = neighbour_of(beside);
  errno = 0;
  std::ofstream out(hidden, std::ios::binary | std::ios::trunc);
  out << beside_content;
  out.close();
  if (out && ::rename(hidden.c_str(), beside.c_str()) == 0) return;
  const int error = errno;
  std::error_code ignored;
  fs::remove(hidden, ignored);
  throw cannot_write(beside, error);
}

void Output::commit()
{
  refuse_strangers(); // somebody may have put something there since
  const std::lock_guard<std::mutex> lock(output_mutex());
  commit_beside();
  const bool replaces_folder = kind == Kind::folder && fs::exists(target);
  if (replaces_folder) {
    // The two folders change names in one step; afterwards the temporary one is the old output.
    if (::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
      const std::string old = neighbour_of(target);
      if (::rename(target.c_str(), old.c_str()) != 0) throw cannot_write(target, errno);
      if (::rename(temporary.c_str(), target.c_str()) != 0) {
        const int error = errno;
        ::rename(old.c_str(), target.c_str());
        throw cannot_write(target, error);
      }
      temporary = old;
    }
    std::error_code ignored;
    fs::remove_all(temporary, ignored);
  } else if (::rename(temporary.c_str(), target.c_str()) != 0) throw cannot_write(target, errno);
  committed = true;
  remove_when_interrupted({});
}
