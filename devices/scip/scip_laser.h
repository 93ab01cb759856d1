// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "devices/laser.h"
#include "devices/scip/scip_clock.h"
#include "devices/scip/scip_connect.h"
#include "devices/scip/scip_health.h"
#include "devices/scip/scip_link.h"
#include "devices/scip/scip_ranges.h"
#include "devices/scip/scip_revival.h"

namespace planewright {

/// A Hokuyo laser that speaks SCIP 2.0 or 2.2 over any transport.
///
/// What it hands out is what the laser has sent, or nothing: a scan that is damaged, has another number of beams than
/// was asked for, or the stamp of the one before is thrown away and counted. A stream that falls silent for 16 turns,
/// comes damaged five times in a row, or stamps the same time three times is started again; three such attempts with no
/// scan between them, and the laser counts as lost. One that reports a fault of its hardware is reset once, and then
/// started anew once where its model can.
class ScipLaser : public Laser {
public:
    /// `progress` is told what is waited for while connect() and start() take long, in the thread that calls them.
    ScipLaser(std::unique_ptr<Transport> transport, const Clock& clock, ScipProgress progress = {});
    /// Ends scanning and closes the transport.
    ~ScipLaser() override;

    /// May be called again while the transport lives, after an error too.
    Result<void> connect(const std::stop_token& stop) override;

    const LaserIdentity& identity() const override { return partner_.identity; }
    const LaserLimits& limits() const override { return partner_.limits; }
    const ScipCapabilities& capabilities() const { return partner_.able; }

    using Laser::start;
    /// Compares the clocks first, where the laser can. After an error or a stop it is told to be quiet. Errors (Usage):
    /// steps that it has not; NoDevice: it refuses; NeedsOperator: it stays faulty; otherwise as for connect().
    Result<void> start(const LaserBeams& beams, const std::stop_token& stop) override;

    /// Where it has to start the stream again it does that a step at a time, over as many calls as it takes. Errors
    /// (NeedsOperator): it stays faulty.
    Result<std::optional<LaserScan>> next(std::chrono::nanoseconds deadline, const std::stop_token& stop) override;

    /// Errors (DeviceLost): it was asked twice, and scans still come or nothing answers.
    Result<void> stop() override;

    Result<void> lookAfter() override;

    LinkHealth health() const override;
    std::vector<FaultRecord> takeLog() override { return health_.takeLog(); }

private:
    using Time = std::chrono::nanoseconds;

    /// Damaged scans in a row that start the stream again.
    static constexpr int kMostDamagedScans = 5;

    // Beginning and end: scip_laser.cpp.
    Result<void> beginScanning(const std::stop_token& stop);
    Result<void> switchOn(const std::stop_token& stop);
    Result<void> beginStream(const std::stop_token& stop);
    Result<void> cure(const std::string& status, const std::stop_token& stop);
    std::optional<ScipRevival::Cure> nextCure(const std::string& status);
    tl::unexpected<Error> faulty(const std::string& status);
    void streamsFrom(Time now);
    void quitUnheard();

    // What comes in between: scip_laser_scans.cpp.
    Result<std::optional<LaserScan>> take(const ScipArrival& arrival);
    std::optional<LaserScan> take(const ScipFrame& frame, Time arrived);
    Result<void> take(const ScipReply& reply);
    std::size_t takeRanges(const ScipFrame& frame, LaserScan& scan) const;
    void tellOfBlindness(const ScipFrame& frame, Time arrived);
    void countLost(const ScipClock::Scan& timed);
    void countDamage(std::string_view code, std::string text, std::string_view bytes);

    // How a stream that has failed begins again: scip_laser_revival.cpp.
    Result<void> keepAlive();
    Result<void> goOn();
    Result<void> takeRevived(const ScipReply& reply);
    Result<void> revive(ScipRevival::Cure cure, const std::string& reason);
    Result<void> cureInStream(const std::string& status);
    Time silenceUntil() const { return lastScan_ + 16 * partner_.limits.period; }

    ScipLink link_;
    ScipProgress progress_;
    ScipPartner partner_;
    std::optional<ScipRanges> ranges_;
    ScipClock clock_;
    ScipHealth health_;

    std::string stream_;  ///< the request that scans answer; empty: it does not scan
    ScipMeasurement measurement_;
    LaserBeams beams_;                              ///< the same
    Time lastScan_{0};                              ///< arrival of the last good one, or when the stream began
    std::optional<std::int64_t> lastMilliseconds_;  ///< its stamp, where the next one can be counted from it
    std::optional<Time> lastEnd_;                   ///< moment of its last beam
    int damaged_ = 0;                               ///< since the last good scan
    int attempts_ = 0;                              ///< to start the stream again, since then
    std::string reason_;                            ///< of the last one
    ScipRevival revival_;                           ///< the attempt that is under way
    int cures_ = 0;                                 ///< of a faulty laser, since the start
    bool isBlind_ = false;
};

}  // namespace planewright
