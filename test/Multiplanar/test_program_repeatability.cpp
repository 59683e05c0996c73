// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <random>

#include <sched.h>
#include <sys/mount.h>

// What may change without changing what comes out: the run, the number of threads, the numbering, the place and the
// units of the mesh. And a disk that is full, after which the run can simply be repeated.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

Mesh renumbered(const Mesh& mesh)
{
  std::mt19937_64 random(5);
  std::vector<int> place(mesh.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::size_t j = random() % (i + 1);
    place[i] = place[j];
    place[j] = int(i);
  }
  Mesh result = mesh;
  for (std::size_t i = 0; i < place.size(); ++i) result.points[std::size_t(place[i])] = mesh.points[i];
  for (auto& t : result.triangles)
    for (int& v : t) v = place[std::size_t(v)];
  for (std::size_t f = result.triangles.size(); f-- > 1;)
    std::swap(result.triangles[f], result.triangles[random() % (f + 1)]);
  return result;
}

class Program_repeatability : public Program_test
{
protected:
  /// In percent of the diagonal; -1 if there is no result.
  double hausdorff(const Mesh& mesh, int seed) const
  {
    const Outcome outcome = run({"approximate", write("m.off", off_text(mesh)), "-o", path("s.ply"), "-k", "12",
                                 "--effort", "fast", "--seed", std::to_string(seed)});
    const std::string words = "Hausdorff distance to the input: ";
    const std::size_t at = outcome.out.find(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(at, std::string::npos) << outcome.out;
    return at == std::string::npos ? -1 : std::stod(outcome.out.substr(at + words.size()));
  }

  /// The bytes of every file below a folder, by its path there. In report.json, without what may differ: how long it
  /// took and what was asked for.
  std::map<std::string, std::string> files_of(const std::string& name) const
  {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
      if (!entry.is_regular_file()) continue;
      std::string& bytes = result[fs::relative(entry.path(), path(name)).string()];
      bytes = content(entry.path());
      if (entry.path().filename() != "report.json") continue;
      json report = json::parse(bytes);
      report.erase("seconds");
      report["settings"].erase("threads");
      bytes = report.dump();
    }
    return result;
  }
};

} // namespace

TEST_F(Program_repeatability, every_file_is_the_same_for_any_number_of_threads_and_in_every_run)
{
  const std::string input = write("m.off", off_text(bumpy_sphere(4)));
  const auto made = [&](const std::string& threads) {
    const Outcome outcome =
        run({"make", input, "-o", path("out"), "-k", "12", "--effort", "fast", "--threads", threads, "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return files_of("out");
  };
  const auto first = made("1");
  EXPECT_GE(first.size(), 8u); // or this tests nothing
  EXPECT_EQ(first.count("shell.ply") + first.count("model.json") + first.count("sheets/sheet-1.svg"), 3u);
  for (const std::string threads : {"1", "2"}) {
    const auto again = made(threads);
    ASSERT_EQ(again.size(), first.size());
    for (const auto& file : first) {
      const auto found = again.find(file.first);
      ASSERT_NE(found, again.end()) << file.first;
      EXPECT_TRUE(found->second == file.second) << file.first << " differs with --threads " << threads;
    }
  }
}

TEST_F(Program_repeatability, numbering_place_and_units_change_the_distance_less_than_the_seed)
{
  const Mesh mesh = bumpy_sphere(4);
  double least = 1e9, most = 0;
  for (int seed = 0; seed < 8; ++seed) {
    const double distance = hausdorff(mesh, seed);
    least = (std::min)(least, distance);
    most = (std::max)(most, distance);
  }
  ASSERT_GT(least, 0.1);
  ASSERT_LT(least, most);        // or there is no spread to compare with
  const double rounding = 0.011; // of the two decimals shown
  const auto expect_as_good = [&](const Mesh& other, const char* how) {
    const double distance = hausdorff(other, 0);
    EXPECT_GT(distance, 0) << how;
    EXPECT_LE(distance, most + rounding) << how << ": over the seeds it is " << least << " to " << most;
  };
  expect_as_good(renumbered(mesh), "renumbered");
  expect_as_good(mapped(mesh, [](const Point_3& p) { return p + Vector_3(1e6, -1e6, 1e6); }), "moved by 1e6");
  const double unscaled = hausdorff(mesh, 0);
  for (const int power : {-27, -13, 13, 27}) {
    const double s = std::ldexp(1, power);
    // Nothing is rounded differently then: the same distance.
    EXPECT_EQ(hausdorff(mapped(mesh, [s](const Point_3& p) { return Point_3(s * p.x(), s * p.y(), s * p.z()); }), 0),
              unscaled)
        << "scaled by 2^" << power;
  }
}

TEST_F(Program_repeatability, a_disk_that_is_full_keeps_the_old_output)
{
  // A mount of this process alone, which goes with it.
  fs::create_directory(path("disk"));
  if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
      mount("tmpfs", path("disk").c_str(), "tmpfs", 0, "size=8m") != 0)
    GTEST_SKIP() << "no right to mount a small disk here";
  const auto unmount = [this](void*) { umount2(path("disk").c_str(), MNT_DETACH); };
  int any = 0;
  const std::unique_ptr<int, decltype(unmount)> mounted(&any, unmount);

  const std::string input = write("m.off", off_text(cube(2)));
  const std::vector<std::string> arguments = {"make", input,      "-o",   path("disk/out"), "-k",
                                              "6",    "--effort", "fast", "--quiet"};
  const auto on_disk = [this] {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(path("disk"))) result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  };
  /// All but this many bytes of the disk is taken.
  const auto fill = [this](std::uintmax_t left) {
    fs::remove(path("disk/ballast"));
    const std::uintmax_t room = fs::space(path("disk")).available;
    ASSERT_GT(room, left);
    write("disk/ballast", std::string(std::size_t(room - left), 'x'));
    ASSERT_LE(fs::space(path("disk")).available, left + 4096);
  };
  const auto expect_refused = [&](std::uintmax_t left, const std::vector<std::string>& names) {
    fill(left);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be written: No space left on device"), std::string::npos) << outcome.err;
    EXPECT_EQ(on_disk(), names) << left;
  };

  for (const std::uintmax_t left : {0, 4096, 65536}) expect_refused(left, {"ballast"});
  fs::remove(path("disk/ballast"));
  const Outcome repeated = run(arguments); // with room again
  ASSERT_EQ(repeated.code, 0) << repeated.err;
  const auto old = files_of("disk/out");
  for (const std::uintmax_t left : {0, 65536}) {
    expect_refused(left, {"ballast", "out"});
    EXPECT_EQ(files_of("disk/out"), old);
  }
  fs::remove(path("disk/ballast"));
  EXPECT_EQ(run(arguments).code, 0);
  EXPECT_EQ(run({"verify", path("disk/out")}).code, 0);
}
