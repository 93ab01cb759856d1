// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/progress.h"

#include <cstdio>
#include <unistd.h>

namespace planewright {

Progress::Progress(std::string_view what)
    : what_(what),
      onTerminal_(::isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + std::chrono::seconds{1})
{
}

Progress::~Progress()
{
    if (shown_)
        std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::size_t done, std::size_t all)
{
    if (!onTerminal_ || all == 0)
        return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_)
        return;
    next_ = now + std::chrono::milliseconds{100};
    shown_ = true;
    std::fprintf(stderr, "\r%s %zu of %zu (%zu %%)\x1b[K", what_.c_str(), done, all, 100 * done / all);
    std::fflush(stderr);
}

}  // namespace planewright
