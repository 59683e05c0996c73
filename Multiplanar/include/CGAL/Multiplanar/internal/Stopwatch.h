// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H
#define CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H

#include <chrono>
#include <ctime>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Seconds spent in named stages.
class Stopwatch
{
public:
  using clock = std::chrono::steady_clock;

  /// Counts the time from its construction to its end for one stage.
  class Lap
  {
  public:
    Lap(Stopwatch& watch, std::string stage)
        : watch(watch), stage(std::move(stage)), begin(clock::now()), processor_begin(std::clock())
    {}
    ~Lap()
    {
      watch.times[stage] += std::chrono::duration<double>(clock::now() - begin).count();
      watch.processor_times[stage] += double(std::clock() - processor_begin) / CLOCKS_PER_SEC;
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

  private:
    Stopwatch& watch;
    std::string stage;
    clock::time_point begin;
    std::clock_t processor_begin;
  };

  const std::map<std::string, double>& seconds() const { return times; }

  /// What the whole process, all its threads, computed meanwhile.
  const std::map<std::string, double>& processor_seconds() const { return processor_times; }

private:
  std::map<std::string, double> times, processor_times;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H
