// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_SERIAL_LIBRARIES_H
#define CGAL_MULTIPLANAR_INTERNAL_SERIAL_LIBRARIES_H

#include <mutex>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_MULTIPLANAR_HAS_DLSYM 1
#endif

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Looks up a function among the libraries that are loaded, whether or not this program was linked with them.
template <class Function>
Function* loaded_function(const char* name)
{
#ifdef CGAL_MULTIPLANAR_HAS_DLSYM
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
#else
  (void)name;
  return nullptr;
#endif
}

/// While an object of this class lives, CHOLMOD and BLAS calls made by its thread stay on that thread.
///
/// CHOLMOD opens an OpenMP region of four threads for every supernode, however few cores there are; for the sizes met
/// here the regions cost two to three times as much as the arithmetic. OpenBLAS gains little at these sizes and does
/// not promise the same last digits for every number of threads. Libraries that are not loaded are left alone.
///
/// OpenMP's settings belong to each thread, and so do those of an OpenBLAS that is built on it: every thread that calls
/// these libraries needs an object of its own.
class Serial_libraries
{
public:
  Serial_libraries()
  {
    if (openmp().is_loaded()) {
      levels_ = openmp().get_levels();
      team_ = openmp().get_threads();
      openmp().set_levels(0);  // a region gets a team of one even if it asks for more, as CHOLMOD's do
      openmp().set_threads(1); // what OpenBLAS looks at
    }
    std::lock_guard<std::mutex> lock(blas().mutex);
    if (blas().users++ == 0 && blas().set != nullptr && blas().get != nullptr) {
      blas().threads = blas().get();
      if (blas().threads > 1) blas().set(1);
    }
  }

  ~Serial_libraries()
  {
    {
      std::lock_guard<std::mutex> lock(blas().mutex);
      if (--blas().users == 0 && blas().threads > 1) blas().set(blas().threads);
    }
    if (levels_ < 0) return;
    openmp().set_threads(team_); // after OpenBLAS, which may set it too
    openmp().set_levels(levels_);
  }

  Serial_libraries(const Serial_libraries&) = delete;
  Serial_libraries& operator=(const Serial_libraries&) = delete;

private:
  struct Openmp
  {
    int (*get_levels)() = loaded_function<int()>("omp_get_max_active_levels");
    void (*set_levels)(int) = loaded_function<void(int)>("omp_set_max_active_levels");
    int (*get_threads)() = loaded_function<int()>("omp_get_max_threads");
    void (*set_threads)(int) = loaded_function<void(int)>("omp_set_num_threads");
    bool is_loaded() const { return get_levels && set_levels && get_threads && set_threads; }
  };

  /// OpenBLAS has one number of threads for the whole process: the first user saves it, the last one restores it.
  struct Blas
  {
    int (*get)() = loaded_function<int()>("openblas_get_num_threads");
    void (*set)(int) = loaded_function<void(int)>("openblas_set_num_threads");
    std::mutex mutex;
    int users = 0;
    int threads = 0;
  };

  static Openmp& openmp()
  {
    static Openmp functions;
    return functions;
  }

  static Blas& blas()
  {
    static Blas functions;
    return functions;
  }

  int levels_ = -1, team_ = -1;
};

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_SERIAL_LIBRARIES_H
