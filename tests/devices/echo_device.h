// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "devices/emulated/emulated_device.h"

namespace planewright {

/// The smallest device: says everything again, a fixed time later. Beyond that it obeys two letters of its own: after
/// an 'S' it says frames of 'f', one each period from then on, and at an 'X' its link is pulled out.
class EchoDevice : public EmulatedDevice {
public:
    std::chrono::nanoseconds delay = std::chrono::milliseconds{2};
    std::chrono::nanoseconds period = std::chrono::milliseconds{5};
    std::size_t frame = 100;
    int frames = 1'000'000;  ///< that it says at most
    bool isPluggedIn = true;

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        if (std::count(bytes.begin(), bytes.end(), 'X') > 0)
            isPluggedIn = false;
        if (std::count(bytes.begin(), bytes.end(), 'S') > 0 && !nextFrame_)
            nextFrame_ = now + period;
        echoes_.push_back({now + delay, {bytes.begin(), bytes.end()}});
    }

    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> output;
        for (auto next = nextOutput(); next && *next <= now; next = nextOutput()) {
            if (nextFrame_ && *nextFrame_ == *next) {
                output.push_back({*nextFrame_, std::vector<std::uint8_t>(frame, 'f')});
                *nextFrame_ += period;
                if (--frames == 0)
                    nextFrame_.reset();
            } else {
                output.push_back(std::move(echoes_.front()));
                echoes_.pop_front();
            }
        }
        return output;
    }

    std::optional<std::chrono::nanoseconds> nextOutput() const override
    {
        if (echoes_.empty())
            return nextFrame_;
        return nextFrame_ ? std::min(*nextFrame_, echoes_.front().at) : echoes_.front().at;
    }

    bool isConnected(std::chrono::nanoseconds /*now*/) override { return isPluggedIn; }

private:
    std::deque<EmulatedOutput> echoes_;
    std::optional<std::chrono::nanoseconds> nextFrame_;
};

}  // namespace planewright
