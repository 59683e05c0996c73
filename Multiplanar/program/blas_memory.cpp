// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blas_memory.h"
#include "failure.h"

#include <CGAL/Multiplanar/internal/serial_libraries.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace {

using CGAL::Multiplanar::internal::loaded_function;

constexpr std::size_t megabyte = std::size_t(1) << 20;
constexpr std::size_t buffer = 129 * megabyte; ///< what OpenBLAS takes at once, rounded up
constexpr std::size_t others = 64 * megabyte;  ///< stacks of threads, and what is needed until the first message

bool is_room_for(std::size_t bytes)
{
  void* const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED) return false;
  munmap(place, bytes);
  return true;
}

/// Leaves without exit(): that would wait for the threads of OpenBLAS, which wait for memory.
void need_room_for(std::size_t bytes)
{
  if (is_room_for(bytes)) return;
  std::fprintf(stderr, "%s\n", out_of_memory_line);
  std::fflush(stderr);
  _exit(exit_resource);
}

} // namespace

void take_memory_of_blas()
{
  auto* const threads = loaded_function<int()>("openblas_get_num_threads");
  auto* const end_threads = loaded_function<int()>("blas_thread_shutdown_");
  auto* const take = loaded_function<void*(int)>("blas_memory_alloc");
  auto* const give_back = loaded_function<void(void*)>("blas_memory_free");
  if (threads == nullptr || end_threads == nullptr) return; // another BLAS

  // Its own threads may be asking already, and are joined.
  need_room_for(std::size_t(std::max(1, threads())) * buffer + others);
  end_threads();
  if (take == nullptr || give_back == nullptr) return;

  // Buffers that were taken once are kept. The first is a must; of the others as many as the threads of ours that may
  // be in OpenBLAS at the same time, but under a narrow limit of the address space not all.
  std::vector<void*> buffers;
  need_room_for(buffer + others);
  const std::size_t wanted = std::max(1u, std::thread::hardware_concurrency());
  do buffers.push_back(take(0));
  while (buffers.size() < wanted && is_room_for(buffer + others));
  for (void* b : buffers) give_back(b);
}
