// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "devices/emulated/emulated_device.h"

namespace planewright {

/// A device whose answers come later than it sends them, each by the next of some delays in turn, and in their order.
class DelayedServo : public EmulatedDevice {
public:
    using Time = std::chrono::nanoseconds;

    DelayedServo(std::shared_ptr<EmulatedDevice> device, std::vector<Time> delays)
        : device_(std::move(device)), delays_(std::move(delays))
    {
    }

    void receive(std::span<const std::uint8_t> bytes, Time now) override { device_->receive(bytes, now); }
    std::vector<EmulatedOutput> takeOutput(Time now) override
    {
        for (EmulatedOutput& output : device_->takeOutput(now)) {
            if (output.bytes.empty())
                continue;
            output.at += delays_[answers_++ % delays_.size()];
            if (!waiting_.empty())
                output.at = std::max(output.at, waiting_.back().at);
            waiting_.push_back(std::move(output));
        }
        std::vector<EmulatedOutput> there;
        for (; !waiting_.empty() && waiting_.front().at <= now; waiting_.pop_front())
            there.push_back(std::move(waiting_.front()));
        return there;
    }
    std::optional<Time> nextOutput() const override
    {
        const std::optional<Time> next = device_->nextOutput();
        if (waiting_.empty())
            return next;
        return std::min(waiting_.front().at, next.value_or(waiting_.front().at));
    }
    bool isConnected(Time now) override { return device_->isConnected(now); }

private:
    std::shared_ptr<EmulatedDevice> device_;
    std::vector<Time> delays_;
    std::deque<EmulatedOutput> waiting_;
    std::size_t answers_ = 0;
};

}  // namespace planewright
