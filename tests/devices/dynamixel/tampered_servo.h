// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "devices/emulated/emulated_device.h"

namespace planewright {

/// A device whose answers a test changes on their way.
class TamperedServo : public EmulatedDevice {
public:
    using Bytes = std::vector<std::uint8_t>;
    /// What becomes of an answer, with the request before it.
    using Tamper = std::function<Bytes(const Bytes& request, Bytes answer)>;

    TamperedServo(std::shared_ptr<EmulatedDevice> device, Tamper tamper)
        : device_(std::move(device)), tamper_(std::move(tamper))
    {
    }

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        request_ = {bytes.begin(), bytes.end()};
        device_->receive(bytes, now);
    }
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> outputs = device_->takeOutput(now);
        for (EmulatedOutput& output : outputs)
            output.bytes = tamper_(request_, std::move(output.bytes));
        return outputs;
    }
    std::optional<std::chrono::nanoseconds> nextOutput() const override { return device_->nextOutput(); }
    bool isConnected(std::chrono::nanoseconds now) override { return device_->isConnected(now); }

private:
    std::shared_ptr<EmulatedDevice> device_;
    Tamper tamper_;
    Bytes request_;
};

}  // namespace planewright
