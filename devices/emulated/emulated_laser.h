// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/error.h"
#include "devices/emulated/emulated_device.h"
#include "devices/emulated/emulated_laser_model.h"
#include "devices/emulated/emulated_view.h"
#include "devices/scip/scip_request.h"

namespace planewright {

/// What an emulated laser is made with.
struct EmulatedLaserOptions {
    EmulatedLaserModel model;  ///< of emulatedLaserModel()
    std::string serial = "00000001";
    std::chrono::nanoseconds phase{11'000'000};  ///< moment of step 0 of one of its turns
    std::chrono::milliseconds uptime{60'000};    ///< what its clock shows when it is first spoken to
    double clockDrift = 0.0;                     ///< how much faster its clock runs than the caller's
    std::uint64_t seed = 1;                      ///< of faults at random
    std::vector<FaultAt> faults;
};

/// A laser scanner that answers SCIP byte by byte as the real one does, in a room, tilted by something.
///
/// Its mirror turns all the time. A scan is what its beams see from their moments on, with the pitch of those moments;
/// it leaves when its last beam is measured and takes its time on the way, 1.5 MB/s. Power comes on when it is first
/// spoken to. Scans are numbered by turns of the mirror since it first streamed: that number draws the errors of
/// ranges, and faults begin at it.
class EmulatedLaser : public EmulatedDevice {
public:
    using Time = std::chrono::nanoseconds;

    /// `pitch` gives φ [rad] at a moment that has passed. Errors (Usage): a fault that there is not.
    static Result<std::shared_ptr<EmulatedLaser>> make(std::shared_ptr<const EmulatedView> view,
                                                       std::function<double(Time)> pitch,
                                                       const EmulatedLaserOptions& options);

    void receive(std::span<const std::uint8_t> bytes, Time now) override;
    std::vector<EmulatedOutput> takeOutput(Time now) override;
    std::optional<Time> nextOutput() const override;
    bool isConnected(Time now) override;

    /// One turn of its mirror.
    Time period() const { return limits_.period; }
    /// Turns of the mirror since it first streamed; 0 before.
    int turns(Time now) const { return numberOf(turnFrom(now)); }

private:
    struct Fault {
        std::string kind;
        int step;
        bool isOver;
    };
    /// A measurement that goes on.
    struct Stream {
        ScipMeasurement measurement;
        std::string tag;        ///< with its semicolon
        std::int64_t next = 0;  ///< the turn that is reported next
        int left = 0;           ///< scans still to come; 0: without end
    };
    /// A request in its parts, right or wrong.
    struct Request {
        std::string_view line;
        std::string_view command;
        std::string_view parameters;
        std::string_view tag;
    };
    EmulatedLaser(std::shared_ptr<const EmulatedView> view, std::function<double(Time)> pitch,
                  const EmulatedLaserOptions& options);

    // What time does: emulated_laser.cpp.
    void advance(Time now);
    void powerOn(Time now);
    void changeIdentity(int number);
    void reboot(Time now);
    void send(std::string bytes, Time ready);
    bool strikes(std::string_view kind, int number);
    bool hasAtConnect(std::string_view kind) const;
    void report(std::int64_t turn);
    void sendScan(std::int64_t turn, int number);
    std::vector<std::uint32_t> beams(const ScipMeasurement& measurement, std::int64_t turn) const;
    Time startOf(std::int64_t turn) const { return options_.phase + turn * limits_.period; }
    Time momentOf(std::int64_t turn, int step) const;
    std::int64_t turnFrom(Time moment) const;
    int numberOf(std::int64_t turn) const;
    std::uint32_t stampAt(Time moment) const;

    // What it answers: emulated_laser_requests.cpp.
    void answer(const std::string& line, Time now);
    std::string replyTo(const Request& request, Time now);
    std::string replyInTimeMode(const Request& request, Time now);
    std::string replyToMeasurement(const Request& request, Time now);
    std::string replyToReset(const Request& request, Time now);
    std::string replyToTime(const Request& request, Time now);
    std::string replyToSetting(const Request& request);
    std::string replyToSimulatedFault(const Request& request);
    std::string modelName() const { return std::string{options_.model.name} + (isOtherModel_ ? "-EW" : ""); }
    std::string identity(std::string_view echo) const;
    std::string facts(std::string_view echo) const;
    std::string condition(std::string_view echo, Time now) const;
    std::string_view mistakeIn(const Request& request) const;
    std::string_view mistakeInMeasurement(const Request& request) const;
    void beginStream(const ScipMeasurement& measurement, std::string_view tag, Time now);
    bool isFaulty() const { return isBroken_ || simulatedFault_ == 2; }

    std::shared_ptr<const EmulatedView> view_;
    std::function<double(Time)> pitch_;
    EmulatedLaserOptions options_;
    LaserLimits limits_;
    std::vector<Fault> faults_;

    std::string line_;  ///< a request that has not ended
    std::deque<EmulatedOutput> pending_;
    Time lineFreeAt_{0};                                   ///< when all that is pending has left
    std::vector<std::pair<std::string, Time>> answering_;  ///< commands, and when their replies have left

    std::optional<Time> poweredAt_;
    Time clockZero_{0};
    Time silentUntil_{0};
    std::optional<Time> unpluggedAt_;
    std::optional<Time> rebootAsked_;
    std::optional<Stream> stream_;
    std::optional<std::int64_t> firstTurn_;
    std::optional<std::uint32_t> stuckStamp_;
    bool isOn_ = false;
    bool isInTimeMode_ = false;
    bool speaksScip1_ = false;
    bool isBroken_ = false;
    bool isBlind_ = false;
    bool isOtherModel_ = false;
    int simulatedFault_ = 0;  ///< by DB
    int verifyingLeft_ = 0;   ///< scans that it leaves out to check itself
    int motorSpeed_ = 0;
    int lineSpeed_ = 19'200;
};

}  // namespace planewright
