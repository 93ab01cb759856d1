// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <QObject>

#include "app/sources/open_source.h"
#include "app/window/background_work.h"
#include "ui/common/device_setup.h"

namespace planewright {

/// What is done with devices outside of a scan: their test, and bringing the head to level; one at a time, each told as
/// a list of checks.
class DeviceTrials : public QObject {
    Q_OBJECT

public:
    explicit DeviceTrials(QObject* parent = nullptr);
    /// Stops motion, and waits for what runs.
    ~DeviceTrials() override;

    /// Each does nothing while another one runs.
    void test(const std::string& laser, const NoddingSetup& setup);
    void home(const std::string& tiltUnit);
    /// Releases a unit that waits for a person: never unasked.
    void recover(const std::string& tiltUnit);

    /// Holds what one of them moves within one round trip, and ends it.
    void stopMotion();

    bool isBusy() const { return work_.isBusy(); }

signals:
    /// Another one runs, or none any more.
    void busyChanged();
    void checksChanged(const std::vector<planewright::DeviceCheck>& checks);
    void failed(const planewright::Error& error);
    /// One of them has ended well.
    void passed();

private:
    using Work = std::function<void(const std::stop_token& stop)>;

    void run(std::vector<std::string> checks, Work work);
    /// From any thread: how a check goes; nothing: it begins.
    void tell(std::size_t check, const std::optional<Result<std::string>>& result);
    /// From any thread: what the check that runs waits for.
    void tellWaiting(const std::string& line);

    std::vector<DeviceCheck> checks_;
    std::stop_source stop_;
    BackgroundWork work_;  ///< last, so that it ends first
};

}  // namespace planewright
