// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/far_end.h"

#include <utility>

namespace planewright {

FarEnd::FarEnd(std::shared_ptr<EmulatedUsbDevice> usb, std::shared_ptr<EmulatedDevice> device, const Clock& clock)
    : usb_(std::move(usb)), device_(std::move(device)), clock_(clock)
{
    usb_->onReceive([this](std::span<const std::uint8_t> bytes) {
        const std::scoped_lock lock(mutex_);
        device_->receive(bytes, clock_.now());
        changed_.notify_all();
    });
    thread_ = std::jthread{[this](const std::stop_token& stop) { run(stop); }};
}

FarEnd::~FarEnd()
{
    usb_->onReceive({});
}

void FarEnd::run(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        for (const EmulatedOutput& output : device_->takeOutput(clock_.now()))
            usb_->send(output.bytes, true);
        clock_.wait(lock, changed_, stop, device_->nextOutput());
    }
}

}  // namespace planewright
