// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/heap.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace planewright {

Heap heap;

namespace {

void* taken(void* block)
{
    if (block == nullptr)
        throw std::bad_alloc{};
    heap.held += static_cast<std::int64_t>(malloc_usable_size(block));
    heap.most = std::max(heap.most, heap.held);
    ++heap.requests;
    return block;
}

void given(void* block) noexcept
{
    heap.held -= static_cast<std::int64_t>(malloc_usable_size(block));
    std::free(block);
}

}  // namespace
}  // namespace planewright

using namespace planewright;

void* operator new(std::size_t size)
{
    return taken(std::malloc(size));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    return taken(std::aligned_alloc(step, (size + step - 1) / step * step));
}

void operator delete(void* block) noexcept
{
    given(block);
}

void operator delete(void* block, std::size_t) noexcept
{
    given(block);
}

void operator delete(void* block, std::align_val_t) noexcept
{
    given(block);
}

void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
    given(block);
}
