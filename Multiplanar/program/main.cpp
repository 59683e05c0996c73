// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Interruption.h"
#include "blas_memory.h"
#include "command_line.h"
#include "commands.h"
#include "failure.h"

#include <CGAL/assertions_behaviour.h>
#include <glog/logging.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

namespace {

/// Errors are ours to tell, in one line; libraries keep quiet.
void silence_libraries(const char* program)
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  FLAGS_minloglevel = google::GLOG_FATAL;
  google::InitGoogleLogging(program);
}

int fail(Progress* progress, Exit_code code, const std::string& line)
{
  wait_if_interrupted();
  if (progress) progress->clear();
  std::fprintf(stderr, "%s\n", line.c_str());
  return code;
}

void run(const Settings& settings, Progress& progress)
{
  if (settings.command == "make") make(settings, progress);
  if (settings.command == "approximate") approximate(settings, progress);
  if (settings.command == "fabricate") fabricate(settings, progress);
  if (settings.command == "verify") verify(settings);
  if (settings.command == "compare") compare(settings, progress);
  if (settings.command == "preview") preview(settings, progress);
}

/// What was printed has to arrive, unless nobody reads it any more.
void check_standard_output()
{
  errno = 0;
  if ((std::fflush(stdout) != 0 || std::ferror(stdout)) && errno != EPIPE && errno != 0)
    throw resource_error(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

} // namespace

int main(int argc, char** argv)
{
  take_memory_of_blas();
  watch_for_interruption();
  silence_libraries(argv[0]);
  std::optional<Progress> progress;
  Progress* shown = nullptr;
  try {
    const std::optional<Settings> settings = parse_command_line(argc, argv);
    if (settings) {
      progress.emplace(settings->progress);
      shown = &*progress;
      run(*settings, *progress);
    }
    check_standard_output();
    return exit_done;
  } catch (const Failure& failure) {
    return fail(shown, failure.code, failure.what());
  } catch (const std::bad_alloc&) {
    return fail(shown, exit_resource, out_of_memory_line);
  } catch (const std::exception& error) {
    std::string what = error.what();
    for (char& c : what)
      if (c == '\n' || c == '\r') c = ' ';
    return fail(shown, exit_broken_promise, "internal error: " + what + ": please report it with the input");
  }
}
