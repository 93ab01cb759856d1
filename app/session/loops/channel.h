// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "devices/clock.h"

namespace planewright {

/// A queue from one thread to another that takes whatever comes: no one who pushes ever waits, and nothing is dropped.
/// Closing it wakes both ends. Any thread may call anything.
template <class T>
class Channel {
public:
    explicit Channel(const Clock& clock) : clock_(clock) {}

    /// False where the channel is closed; the value is then gone.
    bool push(T value)
    {
        const std::lock_guard lock{mutex_};
        if (closed_)
            return false;
        values_.push_back(std::move(value));
        changed_.notify_one();
        return true;
    }

    /// Waits for the next value, until a moment if one is given. Empty where that has come, or where the channel is
    /// closed and all that was pushed has been taken.
    std::optional<T> pop(std::optional<std::chrono::nanoseconds> until = std::nullopt)
    {
        std::unique_lock lock{mutex_};
        while (values_.empty() && !closed_ && !(until && clock_.now() >= *until))
            clock_.wait(lock, changed_, {}, until);
        if (values_.empty())
            return std::nullopt;
        std::optional<T> value{std::move(values_.front())};
        values_.pop_front();
        return value;
    }

    /// Nothing more comes in; what is in can still be taken.
    void close()
    {
        const std::lock_guard lock{mutex_};
        closed_ = true;
        changed_.notify_all();
    }

    /// Nothing more comes in or out.
    void abandon()
    {
        const std::lock_guard lock{mutex_};
        closed_ = true;
        values_.clear();
        changed_.notify_all();
    }

    /// True where pop() will never give anything again.
    bool isDone() const
    {
        const std::lock_guard lock{mutex_};
        return closed_ && values_.empty();
    }

    /// Values that wait to be taken.
    std::size_t depth() const
    {
        const std::lock_guard lock{mutex_};
        return values_.size();
    }

private:
    const Clock& clock_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<T> values_;
    bool closed_ = false;
};

}  // namespace planewright
