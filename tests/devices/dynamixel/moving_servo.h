// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/devices/dynamixel/servo_rig.h"

namespace planewright {

/// A servo on its way through 0 at 60°/s, with a fault to come at turn 10.
struct Moving : ServoRig {
    explicit Moving(const std::string& fault, EmulatedServoSettings settings = {}, DynamixelOptions options = {})
        : ServoRig(withPitch(std::move(settings)), {{fault, 10}}, options)
    {
        if (!ready() || !tilt->moveTo(degrees(60.0), degrees(60.0)))
            qFatal("the servo is not sound to begin with");
        while (truth(clock.now()) < 0.0)
            sample().value().value();
        link->forget();
        turn = 10;
        began = clock.now();
    }

    static EmulatedServoSettings withPitch(EmulatedServoSettings settings)
    {
        settings.pitch = degrees(-30.0);
        return settings;
    }

    std::vector<DynamixelPacket> writes() const
    {
        std::vector<DynamixelPacket> all;
        for (const WrittenRequest& request : link->written()) {
            if (request.packet.code == kWrite)
                all.push_back(request.packet);
        }
        return all;
    }

    std::chrono::nanoseconds began{0};
};

/// Says why where a result is an error.
#define VERIFY_DONE(call)                                         \
    do {                                                          \
        const auto done = call;                                   \
        QVERIFY2(done, done ? "" : done.error().message.c_str()); \
    } while (false)

#define VERIFY_SAYS(message, ...) QVERIFY2(says(message, __VA_ARGS__), (message).c_str())

}  // namespace planewright
