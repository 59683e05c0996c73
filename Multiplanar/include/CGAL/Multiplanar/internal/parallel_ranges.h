// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_PARALLEL_RANGES_H
#define CGAL_MULTIPLANAR_INTERNAL_PARALLEL_RANGES_H

#include <CGAL/assertions.h>

#include <cstdint>
#include <future>
#include <thread>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The number of threads meant by an option `threads`: 0 stands for all that the machine has.
inline int resolved_threads(int threads)
{
  CGAL_precondition(threads >= 0);
  if (threads > 0) return threads;
  const unsigned all = std::thread::hardware_concurrency();
  return all == 0 ? 1 : int(all);
}

/// Calls `work(part, first, last)` for `parts` consecutive ranges that cover 0 .. n - 1, one thread each, and waits for
/// all of them. Range boundaries depend on n and `parts` alone. An exception of `work` is passed on.
template <class Work>
void parallel_ranges(int n, int parts, const Work& work)
{
  CGAL_precondition(n >= 0 && parts >= 1);
  const auto boundary = [&](int part) { return int(std::int64_t(n) * part / parts); };
  std::vector<std::future<void>> others;
  for (int part = 1; part < parts; ++part)
    others.push_back(std::async(std::launch::async, [&, part] { work(part, boundary(part), boundary(part + 1)); }));
  work(0, 0, boundary(1)); // a future's destructor waits, so nothing outlives this frame if it throws
  for (auto& other : others) other.get();
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_PARALLEL_RANGES_H
