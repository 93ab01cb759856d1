// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "devices/dynamixel/packet_parser.h"
#include "devices/emulated/emulated_device.h"
#include "devices/emulated/servo_body.h"
#include "devices/emulated/servo_faults.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// A bus of emulated servos.
struct EmulatedServoSettings {
    std::uint16_t model = 64;          ///< RX-64; see emulatedServoKinds()
    std::vector<std::uint8_t> ids{1};  ///< numbers of the servos; the first one tilts the laser
    int baud = 57'142;
    TiltMounting mounting;   ///< how the first one carries the laser; limits and speed do not count
    double pitch = 0.0;      ///< φ at the beginning [rad]
    std::uint64_t seed = 1;  ///< of whatever is left to chance in faults
    MotorDynamics dynamics;
    /// Values that differ from those of the factory, by address, in all servos.
    std::vector<std::pair<std::uint16_t, std::uint32_t>> registers;
};

/// Dynamixel servos on a half duplex bus, byte by byte as real ones: an RX-64 of protocol 1.0, and some others of 1.0
/// and 2.0.
///
/// Bytes take their time on the line, and an answer waits for the return delay. A request is obeyed when its last byte
/// has come. Requests with a wrong check are not answered. Whoever shares the bus answers at the same time where it has
/// the same number: on the line, a 0 wins over a 1. A servo goes on to its goal when nobody talks to it any more.
class EmulatedServo : public EmulatedDevice {
public:
    /// `turns` counts the laser's turns since it first streamed; without, faults of step 0 alone come.
    ///
    /// Errors (Usage): a model that cannot be emulated, a fault that is none, no servo, or a pitch that the first one
    /// cannot reach.
    static Result<std::shared_ptr<EmulatedServo>> make(const EmulatedServoSettings& settings,
                                                       std::span<const FaultAt> faults = {},
                                                       std::function<int(std::chrono::nanoseconds)> turns = {});

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override;
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override;
    std::optional<std::chrono::nanoseconds> nextOutput() const override;
    bool isConnected(std::chrono::nanoseconds now) override;

    /// φ of the first servo's shaft at a moment that has come [rad]: the truth, finer than any count.
    double pitchAt(std::chrono::nanoseconds at);

private:
    using Time = std::chrono::nanoseconds;
    using Bytes = std::vector<std::uint8_t>;

    /// Bytes on the line, from a moment on.
    struct Speech {
        Time from{0};
        Bytes bytes;
    };

    EmulatedServo(const EmulatedServoKind& kind, EmulatedServoSettings settings, std::vector<ServoFaultAt> faults,
                  std::function<int(std::chrono::nanoseconds)> turns);

    void advance(Time now);
    void bringFaults(Time now);
    void bring(ServoFault fault, Time now);
    bool has(ServoFault fault) const { return active_.contains(fault); }

    void handle(const DynamixelPacket& request, Time now);
    void handleSyncWrite(const DynamixelPacket& request, Time now);
    void handleSyncRead(const DynamixelPacket& request, Time now);
    /// Answers of several, each when the one before has ended.
    void answerInTurn(const std::vector<DynamixelStatus>& statuses, Time now);
    void answerAtOnce(const std::vector<std::pair<DynamixelStatus, Time>>& statuses, Time now);
    std::uint8_t refusalBits() const;
    Speech speech(DynamixelStatus status, Time from);
    void say(const Speech& speech);
    void transmit(const Speech& speech);

    Time timeOf(std::size_t bytes) const;
    Bytes withLosses(std::span<const std::uint8_t> bytes);
    double shaftOf(double pitch) const;
    std::uint64_t random(std::uint64_t below) { return random_() % below; }

    const EmulatedServoKind& kind_;
    EmulatedServoSettings settings_;
    std::function<int(std::chrono::nanoseconds)> turns_;
    std::vector<ServoFaultAt> waiting_;
    std::map<ServoFault, Time> active_;
    std::mt19937_64 random_;

    std::vector<ServoBody> bodies_;
    PacketParser parser_;
    std::deque<EmulatedOutput> coming_;   ///< bytes on their way to the servos
    std::deque<EmulatedOutput> outputs_;  ///< bytes on their way back, by the moment they leave
    Time lineFree_{0};                    ///< when the last byte to the servos has come
    Time now_{0};
    bool isConnected_ = true;
};

}  // namespace planewright
