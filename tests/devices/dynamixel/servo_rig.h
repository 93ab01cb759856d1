// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/types/angle.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/packet_parser.h"
#include "devices/emulated/emulated_link.h"
#include "devices/emulated/emulated_servo.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

/// The instruction that writes registers, in both protocols.
inline constexpr std::uint8_t kWrite = 0x03;

/// What was written to a link, and when.
struct WrittenRequest {
    std::chrono::nanoseconds at{0};
    DynamixelPacket packet;
};

/// A link that remembers what is written to it.
class RecordedLink : public Transport {
public:
    RecordedLink(std::unique_ptr<Transport> link, const Clock& clock, DynamixelProtocol protocol)
        : link_(std::move(link)), clock_(clock), protocol_(protocol)
    {
    }

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        return link_->read(into, deadline, stop);
    }
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        {
            const std::scoped_lock lock(mutex_);
            for (const DynamixelPacket& packet : PacketParser{protocol_}.push(bytes))
                written_.push_back({clock_.now(), packet});
        }
        return link_->write(bytes, deadline);
    }
    void close() override { link_->close(); }

    std::vector<WrittenRequest> written() const
    {
        const std::scoped_lock lock(mutex_);
        return written_;
    }
    void forget()
    {
        const std::scoped_lock lock(mutex_);
        written_.clear();
    }

private:
    std::unique_ptr<Transport> link_;
    const Clock& clock_;
    DynamixelProtocol protocol_;
    mutable std::mutex mutex_;
    std::vector<WrittenRequest> written_;
};

/// An emulated servo, a clock, and the driver between them.
struct ServoRig {
    static constexpr TiltMounting kMounting{0.0, 1.0, 1.0, degrees(-80.0), degrees(80.0), degrees(120.0)};

    explicit ServoRig(EmulatedServoSettings settings = {}, const std::vector<FaultAt>& faults = {},
                      DynamixelOptions options = {}, FakeClock::Kind kind = FakeClock::Kind::Jumps)
        : clock(kind)
    {
        if (options.mounting.fastest == 0.0)
            options.mounting = kMounting;
        settings.mounting = options.mounting;
        options.id = options.id == 1 ? settings.ids.front() : options.id;
        options.baud = settings.baud;
        servo = EmulatedServo::make(settings, faults, [this](std::chrono::nanoseconds /*now*/) {
                    return turn.load();
                }).value();
        auto emulated = std::make_unique<EmulatedLink>(servo, mutex, clock, "bus");
        auto recorded = std::make_unique<RecordedLink>(
            std::move(emulated), clock, settings.model == 1020 ? DynamixelProtocol::Two : DynamixelProtocol::One);
        link = recorded.get();
        tilt = std::make_unique<DynamixelTilt>(std::move(recorded), clock, options);
    }

    /// Connects and arms.
    Result<void> ready()
    {
        if (auto connected = tilt->connect({}); !connected)
            return connected;
        return tilt->arm({});
    }

    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds within = std::chrono::milliseconds{500})
    {
        return tilt->sample(clock.now() + within, {});
    }

    /// Samples until it has arrived or something is wrong; what it said last.
    Result<TiltSample> arrive(std::chrono::nanoseconds within = std::chrono::seconds{20})
    {
        const auto latest = clock.now() + within;
        while (clock.now() < latest) {
            const auto next = sample();
            if (!next)
                return tl::unexpected(next.error());
            if (*next && !(*next)->moving)
                return **next;
        }
        return fail(ErrorCode::Internal, "did not arrive");
    }

    /// Where the shaft is; a moment to come is made to come first.
    double truth(std::chrono::nanoseconds at)
    {
        if (at > clock.now())
            clock.advance(at - clock.now());
        const std::scoped_lock lock(*mutex);
        return servo->pitchAt(at);
    }

    std::atomic<int> turn{0};
    FakeClock clock;
    std::shared_ptr<std::mutex> mutex = std::make_shared<std::mutex>();
    std::shared_ptr<EmulatedServo> servo;
    RecordedLink* link = nullptr;
    std::unique_ptr<DynamixelTilt> tilt;
};

inline EmulatedServoSettings emulated(std::uint16_t model)
{
    EmulatedServoSettings settings;
    settings.model = model;
    return settings;
}

inline EmulatedServoSettings withRegister(EmulatedServoSettings settings, std::uint16_t address, std::uint32_t value)
{
    settings.registers.emplace_back(address, value);
    return settings;
}

/// True where a message has all of the words.
inline bool says(const std::string& message, const std::vector<std::string>& words)
{
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return message.find(word) != std::string::npos; });
}

}  // namespace planewright
