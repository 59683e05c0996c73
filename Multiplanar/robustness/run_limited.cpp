// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_limited.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

std::string beginning_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string text(1 << 20, 0);
  in.read(&text[0], std::streamsize(text.size()));
  text.resize(std::size_t(in.gcount()));
  return text;
}

void redirect(int descriptor, const std::string& file)
{
  const int to = open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0666);
  if (to < 0 || dup2(to, descriptor) < 0) _exit(127);
  close(to);
}

/// In the child. Writable memory is limited a little above what is allowed: what is counted in the end is resident.
void set_limits(const Limits& limits)
{
  const rlim_t seconds = rlim_t(std::ceil(limits.seconds)), bytes = rlim_t(limits.megabytes * 1.25 * 1024 * 1024);
  const rlimit time = {seconds, seconds + 5}, data = {bytes, bytes}, core = {0, 0};
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_DATA, &data);
  setrlimit(RLIMIT_CORE, &core);
}

pid_t start(const std::vector<std::string>& command, const std::string& folder, const Limits& limits)
{
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
  if (child > 0) return child;
  redirect(STDOUT_FILENO, folder + "/stdout");
  redirect(STDERR_FILENO, folder + "/stderr");
  set_limits(limits);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

/// Waits; what hangs is ended. \return did it hang?
bool wait_for(pid_t child, double seconds, int& status, rusage& used)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  bool hangs = false;
  while (wait4(child, &status, hangs ? 0 : WNOHANG, &used) == 0) {
    usleep(2000);
    if (Clock::now() < end) continue;
    kill(child, SIGKILL);
    hangs = true;
  }
  return hangs;
}

double seconds_of(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

} // namespace

Process_result run_limited(const std::vector<std::string>& command, const std::string& folder, const Limits& limits)
{
  int status = 0;
  rusage used{};
  const pid_t child = start(command, folder, limits);
  Process_result result;
  result.out_of_time = wait_for(child, 10 * limits.seconds, status, used);
  result.seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  result.megabytes = double(used.ru_maxrss) / 1024;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  else result.signal = WTERMSIG(status);
  if (result.exit_code == 127) throw std::runtime_error(command[0] + ": cannot be run");
  if (result.signal == SIGXCPU || (result.signal == SIGKILL && result.seconds >= limits.seconds))
    result.out_of_time = true;
  result.output = beginning_of(folder + "/stdout");
  result.errors = beginning_of(folder + "/stderr");
  result.out_of_memory = result.megabytes > limits.megabytes ||
                         (result.exit_code == 4 && result.errors.find("out of memory") != std::string::npos);
  return result;
}
