// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "devices/clock.h"
#include "devices/emulated/emulated_device.h"
#include "devices/transport/transport.h"

namespace planewright {

/// A link to an emulated device in this process, by the caller's clock: with a clock that jumps, hours take no time and
/// every run is the same.
///
/// Devices of one rig share a mutex, since one asks the other where it is.
class EmulatedLink : public Transport {
public:
    EmulatedLink(std::shared_ptr<EmulatedDevice> device, std::shared_ptr<std::mutex> rig, const Clock& clock,
                 std::string name);

    std::string name() const override { return name_; }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    void close() override;

private:
    tl::unexpected<Error> gone() const;

    std::shared_ptr<EmulatedDevice> device_;
    std::shared_ptr<std::mutex> rig_;
    const Clock& clock_;
    std::string name_;
    std::condition_variable_any changed_;
    std::deque<EmulatedOutput> arrived_;
    bool isOpen_ = true;
};

}  // namespace planewright
