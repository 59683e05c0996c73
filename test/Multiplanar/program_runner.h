// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_PROGRAM_RUNNER_H
#define MULTIPLANAR_TEST_PROGRAM_RUNNER_H

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <csignal>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

// Runs the built program as a user would, in a folder of its own, and looks at what it prints and leaves behind.

namespace Multiplanar_test {

namespace fs = std::filesystem;

/// What a run of the program came to.
struct Outcome
{
  int code = -1; ///< exit code, or 1000 + the signal that ended it
  std::string out, err;

  int error_lines() const { return int(std::count(err.begin(), err.end(), '\n')); }
};

inline std::string content(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// A fixture with a folder that is empty at the beginning of each test and goes at its end.
class Program_test : public ::testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/multiplanar-test-XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = fs::canonical(name);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Starts the program with its standard output and error in files. \param prepare runs in the child first
  pid_t start(
      std::vector<std::string> arguments, const std::function<void()>& prepare = [] {}) const
  {
    arguments.insert(arguments.begin(), MULTIPLANAR_PROGRAM);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(&a[0]);
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    dup2(open(path("stdout").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0666), STDOUT_FILENO);
    dup2(open(path("stderr").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0666), STDERR_FILENO);
    // Whoever runs the tests may have had signals ignored or blocked, which programs inherit.
    for (const int s : {SIGINT, SIGTERM, SIGHUP}) signal(s, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    prepare();
    execv(argv[0], argv.data());
    _exit(127);
  }

  /// Waits for the end of a program and takes away what it printed.
  Outcome finish(pid_t child) const
  {
    int status = 0;
    waitpid(child, &status, 0);
    Outcome result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    result.out = content(path("stdout"));
    result.err = content(path("stderr"));
    fs::remove(path("stdout"));
    fs::remove(path("stderr"));
    return result;
  }

  Outcome run(const std::vector<std::string>& arguments) const { return finish(start(arguments)); }

  /// The names in the folder, hidden ones too, in order.
  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder)) result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

  fs::path folder;
};

/// The text of an OFF file; coordinates read back as the same doubles.
inline std::string off_text(const Mesh& mesh)
{
  char line[128];
  std::string text =
      "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point_3& p : mesh.points) {
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const auto& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "3 %d %d %d\n", t[0], t[1], t[2]);
    text += line;
  }
  return text;
}

/// ASCII STL: every triangle with its own vertices.
inline std::string stl_text(const Mesh& mesh)
{
  char line[128];
  std::string text = "solid test\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int v : t) {
      const Point_3& p = mesh.points[v];
      std::snprintf(line, sizeof line, "vertex %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
      text += line;
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid test\n";
}

/// OBJ with indices counted back from the last vertex.
inline std::string obj_text(const Mesh& mesh)
{
  char line[128];
  std::string text = "# a comment\nmtllib nowhere.mtl\no thing\n";
  for (const Point_3& p : mesh.points) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    text += line;
  }
  const int n = int(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", t[0] - n, t[1] - n, t[2] - n);
    text += line;
  }
  return text;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_PROGRAM_RUNNER_H
