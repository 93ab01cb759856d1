// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "devices/laser.h"
#include "devices/scip/scip_clock.h"
#include "devices/scip/scip_connect.h"
#include "devices/scip/scip_health.h"
#include "devices/scip/scip_link.h"
#include "devices/scip/scip_ranges.h"

namespace planewright {

/// A Hokuyo laser that speaks SCIP 2.0 or 2.2 over any transport.
///
/// What it hands out is what the laser has sent, or nothing: a scan that is damaged, has another number of beams than
/// was asked for, or the stamp of the one before is thrown away and counted. A stream that falls silent for 16 turns,
/// comes damaged five times in a row, or stamps the same time three times is started again; three such attempts with no
/// scan between them, and the laser counts as lost. One that reports a fault of its hardware is reset once.
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

    /// Compares the clocks first, where the laser can. Errors (Usage): steps that it has not; NoDevice: it refuses;
    /// otherwise as for connect().
    Result<void> start(int first, int last, const std::stop_token& stop) override;

    /// May come back some seconds after the deadline where it had to start the stream again.
    Result<std::optional<LaserScan>> next(std::chrono::nanoseconds deadline, const std::stop_token& stop) override;

    /// Errors (DeviceLost): it was asked twice, and scans still come or nothing answers.
    Result<void> stop() override;

    LinkHealth health() const override { return health_.read(link_.now()); }

private:
    using Time = std::chrono::nanoseconds;

    // Beginning and end: scip_laser.cpp.
    Result<void> switchOn(const std::stop_token& stop);
    Result<void> beginStream(const std::stop_token& stop);
    Result<void> resetOnce(const std::string& status, const std::stop_token& stop);

    // What comes in between: scip_laser_scans.cpp.
    std::optional<LaserScan> take(const ScipFrame& frame, Time arrived);
    Result<void> take(const ScipReply& reply, const std::stop_token& stop);
    std::size_t takeRanges(const ScipFrame& frame, LaserScan& scan) const;
    void countLost(const ScipClock::Scan& timed);
    void countDamage();
    Result<void> recover(const std::string& reason, const std::stop_token& stop);
    Result<bool> tryAgain(const std::stop_token& stop);
    Time silenceUntil() const { return lastScan_ + 16 * partner_.limits.period; }

    ScipLink link_;
    ScipProgress progress_;
    ScipPartner partner_;
    std::optional<ScipRanges> ranges_;
    ScipClock clock_;
    ScipHealth health_;

    std::string stream_;  ///< the request that scans answer; empty: it does not scan
    ScipMeasurement measurement_;
    Time lastScan_{0};                              ///< arrival of the last good one, or when the stream began
    std::optional<std::int64_t> lastMilliseconds_;  ///< its stamp, where the next one can be counted from it
    std::optional<Time> lastEnd_;                   ///< moment of its last beam
    int damaged_ = 0;                               ///< since the last good scan
    int attempts_ = 0;                              ///< to start the stream again, since then
    bool hasReset_ = false;                         ///< since the start
};

}  // namespace planewright
