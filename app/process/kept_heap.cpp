// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/process/kept_heap.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace planewright {

void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int kLargestBlock = 32 << 20;  // DEFAULT_MMAP_THRESHOLD_MAX of a 64-bit glibc
    // Each call ends the adjustment of both bounds by glibc itself.
    mallopt(M_MMAP_THRESHOLD, kLargestBlock);
    mallopt(M_TRIM_THRESHOLD, 2 * kLargestBlock);
#endif
}

}  // namespace planewright
