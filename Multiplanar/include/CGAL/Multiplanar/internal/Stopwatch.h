// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H
#define CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H

#include <chrono>
#include <map>
#include <string>

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
    Lap(Stopwatch& watch, std::string stage) : watch(watch), stage(std::move(stage)), begin(clock::now()) {}
    ~Lap() { watch.times[stage] += std::chrono::duration<double>(clock::now() - begin).count(); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

  private:
    Stopwatch& watch;
    std::string stage;
    clock::time_point begin;
  };

  const std::map<std::string, double>& seconds() const { return times; }

private:
  std::map<std::string, double> times;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_STOPWATCH_H
