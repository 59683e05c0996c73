// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Interruption.h"

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <chrono>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace {

std::mutex mutex;
std::vector<std::string> doomed;
std::atomic<bool> interrupted(false);

/// Another thread may still be writing into the folder: try until nothing is left, but not forever.
void remove_whole(const std::string& path)
{
  std::error_code error;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    std::filesystem::remove_all(path, error);
    if (!std::filesystem::exists(path, error)) return;
  }
}

int signal_pipe[2];

/// Runs on any thread, libraries' own ones included: all that is allowed here is to pass the number on.
void on_signal(int signal)
{
  const char number = char(signal);
  const ssize_t written = write(signal_pipe[1], &number, 1);
  (void)written;
}

[[noreturn]] void wait_for_signal()
{
  char signal = SIGTERM;
  while (read(signal_pipe[0], &signal, 1) != 1) {
  }
  const std::lock_guard<std::mutex> lock(mutex);
  interrupted = true;
  if (!doomed.empty()) remove_whole(doomed.front());
  for (std::size_t i = 1; i < doomed.size(); ++i) rmdir(doomed[i].c_str());
  std::fprintf(stderr, "%sinterrupted%s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "",
               doomed.empty() ? "" : ": nothing was written");
  _exit(128 + signal);
}

} // namespace

void watch_for_interruption()
{
  if (pipe2(signal_pipe, O_CLOEXEC) != 0) return; // without it a signal ends the program as usual
  for (int s : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action;
    sigaction(s, nullptr, &action);
    if (s == SIGHUP && action.sa_handler == SIG_IGN) continue; // started under nohup
    action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigaction(s, &action, nullptr);
  }
  signal(SIGPIPE, SIG_IGN); // a reader of our progress that goes away is no reason to stop
  std::thread(wait_for_signal).detach();
}

std::mutex& output_mutex() { return mutex; }

void remove_when_interrupted(std::vector<std::string> paths) { doomed = std::move(paths); }

void wait_if_interrupted()
{
  while (interrupted) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}
