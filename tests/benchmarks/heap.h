// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace planewright {

/// What this program has asked of the heap; whoever links heap.cpp counts.
struct Heap {
    std::int64_t held = 0;  ///< [bytes], as the allocator rounds them
    std::int64_t most = 0;
    std::int64_t requests = 0;
};
extern Heap heap;

}  // namespace planewright
