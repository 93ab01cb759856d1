// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

#include "devices/clock.h"
#include "devices/emulated/emulated_device.h"
#include "tests/devices/transport/emulated_usb_device.h"

namespace planewright {

/// Makes an emulated laser, servo or board the far end of an emulated USB device, in real time.
class FarEnd {
public:
    FarEnd(std::shared_ptr<EmulatedUsbDevice> usb, std::shared_ptr<EmulatedDevice> device, const Clock& clock);
    ~FarEnd();
    FarEnd(const FarEnd&) = delete;
    FarEnd& operator=(const FarEnd&) = delete;

private:
    void run(const std::stop_token& stop);

    std::shared_ptr<EmulatedUsbDevice> usb_;
    std::shared_ptr<EmulatedDevice> device_;
    const Clock& clock_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread thread_;
};

}  // namespace planewright
