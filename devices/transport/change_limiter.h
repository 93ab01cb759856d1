// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

namespace planewright {

/// Decides when to tell of changes: at once as long as they are few, and twice a second while there is a storm of them,
/// as a plug with a loose contact makes it. The last change is always told.
class ChangeLimiter {
public:
    static constexpr int kManyPerSecond = 5;  ///< more than these are a storm
    static constexpr std::chrono::milliseconds kQuiet{500};

    /// Something has changed. Times never go back.
    void note(std::chrono::nanoseconds now);

    /// When it has to be told; empty: nothing has changed since.
    std::optional<std::chrono::nanoseconds> due() const { return due_; }

    /// True once it is due, and then not again before the next change.
    bool take(std::chrono::nanoseconds now);

private:
    std::array<std::optional<std::chrono::nanoseconds>, kManyPerSecond> last_;  ///< times of the last changes
    std::size_t oldest_ = 0;
    std::optional<std::chrono::nanoseconds> due_;
};

}  // namespace planewright
