// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

// What the program leaves behind when it is stopped, or cannot write: the old output, or none.

using namespace Multiplanar_test;

namespace {

Mesh sphere() { return bumpy_sphere(6); } // 720 faces

class Program_interruption : public Program_test
{
};

TEST_F(Program_interruption, an_earlier_output_is_replaced_but_nothing_else)
{
  const std::string input = write("m.off", off_text(sphere()));
  const std::vector<std::string> arguments = {"make", input, "-o", path("new/out/"), "-k", "14", "--effort", "fast"};
  ASSERT_EQ(run(arguments).code, 0);
  const std::string before = content(path("new/out/model.json"));
  write("new/out/sheets/old.svg", "old");
  ASSERT_EQ(run(arguments).code, 0);
  EXPECT_EQ(content(path("new/out/model.json")), before);
  EXPECT_FALSE(fs::exists(path("new/out/sheets/old.svg")));

  write("new/out/thesis.txt", "mine");
  const Outcome refused = run(arguments);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("thesis.txt"), std::string::npos);
  EXPECT_EQ(content(path("new/out/thesis.txt")), "mine");

  fs::create_directory(path("photos"));
  write("photos/cat.jpg", "meow");
  EXPECT_EQ(run({"make", input, "-o", path("photos"), "-k", "14"}).code, 2);
  EXPECT_EQ(content(path("photos/cat.jpg")), "meow");
  EXPECT_EQ(names(), (std::vector<std::string>{"m.off", "new", "photos"}));
}

TEST_F(Program_interruption, interruption_leaves_nothing)
{
  const std::string input = write("m.off", off_text(bumpy_sphere(40))); // 32000 faces: longer than it takes to stop
  // At several moments, one of which is in METIS's ordering as a rule: it puts a handler of SIGTERM of its own in
  // place.
  const std::vector<std::pair<int, int>> signals = {{SIGINT, 200},  {SIGTERM, 0},   {SIGTERM, 60}, {SIGTERM, 120},
                                                    {SIGTERM, 180}, {SIGTERM, 240}, {SIGHUP, 300}};
  for (const auto& [signal, milliseconds] : signals) {
    const pid_t child = start({"make", input, "-o", path("deep/out"), "-k", "40"});
    while (!fs::exists(path("deep"))) usleep(1000);
    usleep(1000 * milliseconds);
    kill(child, signal);
    const Outcome outcome = finish(child);
    EXPECT_EQ(outcome.code, 128 + signal);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(names(), std::vector<std::string>{"m.off"});
  }
}

TEST_F(Program_interruption, a_full_disk_leaves_the_old_output)
{
  const std::string input = write("m.off", off_text(sphere()));
  const std::vector<std::string> arguments = {"make", input, "-o", path("out"), "-k", "14", "--effort", "fast"};
  const auto small_files_only = [] {
    const rlimit limit = {4096, 4096};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  for (const bool has_old_output : {false, true}) {
    if (has_old_output) ASSERT_EQ(run(arguments).code, 0);
    const auto names_before = names();
    const std::string before = content(path("out/model.json"));
    const Outcome outcome = finish(start(arguments, small_files_only));
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(names(), names_before);
    EXPECT_EQ(content(path("out/model.json")), before);
  }
}

TEST_F(Program_interruption, an_output_that_cannot_be_written_is_a_failed_resource)
{
  const std::string input = write("m.off", off_text(sphere()));
  const Outcome outcome = run({"make", input, "-o", "/proc/out", "-k", "14"});
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
}

} // namespace
