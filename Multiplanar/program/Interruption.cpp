// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Interruption.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <utility>

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

[[noreturn]] void wait_for(sigset_t signals)
{
  int signal = SIGTERM;
  while (sigwait(&signals, &signal) != 0) {
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

/// The signals are blocked in every thread, and one thread takes them when they come. A handler would not do: METIS
/// puts its own in the place of any other while it runs, and there a SIGTERM only ends METIS. OpenBLAS starts threads
/// before `main`, where no signal is blocked yet: take_memory_of_blas() has ended them.
void watch_for_interruption()
{
  sigset_t signals;
  sigemptyset(&signals);
  for (int s : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action;
    sigaction(s, nullptr, &action);
    if (s == SIGHUP && action.sa_handler == SIG_IGN) continue; // started under nohup
    sigaddset(&signals, s);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal(SIGPIPE, SIG_IGN); // a reader of our progress that goes away is no reason to stop
  std::thread(wait_for, signals).detach();
}

std::mutex& output_mutex() { return mutex; }

void remove_when_interrupted(std::vector<std::string> paths) { doomed = std::move(paths); }

void wait_if_interrupted()
{
  while (interrupted) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}
