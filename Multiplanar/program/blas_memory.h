// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_BLAS_MEMORY_H
#define MULTIPLANAR_PROGRAM_BLAS_MEMORY_H

/// OpenBLAS takes a buffer of 128 MB of address space for each thread that calls it, and where it gets none it asks
/// again, for ever. Takes those buffers while it can be asked whether there is room, and ends the threads that OpenBLAS
/// started before `main` (it starts them anew when it needs them). Ends the process with exit_resource and one line on
/// stderr if there is no room. To be called once, before any other thread is started.
void take_memory_of_blas();

#endif // MULTIPLANAR_PROGRAM_BLAS_MEMORY_H
