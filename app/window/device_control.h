// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/sources/device_opener.h"
#include "app/window/device_search.h"
#include "app/window/device_trials.h"
#include "app/window/scan_control.h"
#include "app/window/window_parts.h"

namespace planewright {

/// Runs the form of laser and tilt unit: what is connected, their test, connecting them, and how they are.
class DeviceControl : public QObject {
    Q_OBJECT

public:
    DeviceControl(WindowParts& parts, ScanControl& scan);
    /// Ends what runs, and keeps what is set up.
    ~DeviceControl() override;

    /// What was asked for when devices were connected last.
    const DeviceSetup& connected() const { return connected_; }

    /// A click on the line about the devices shows their form.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectForm();
    void connectActions();
    void connectHealth();
    void showLine(const std::vector<HealthFact>& health);
    void connectTrials();
    void search(bool asks);
    void show(const FoundDevices& found);
    void test();
    void home();
    void recover();
    void connectDevices(const DeviceSetup& setup);
    /// What a scan takes with the devices that were connected last; empty for others.
    Result<std::string> estimate(const DeviceSetup& setup) const;
    void showFacts();
    void refresh();
    bool isIdle() const;
    bool hasConnectedHead() const;
    void refreshActions();
    /// Sets the session up for a laser; nothing to do for other addresses. Usage error where no tilt unit is chosen.
    Result<void> prepare(const std::string& fileOrAddress);
    /// Brings the form into sight without a search; false where it is not filled in, and then it has been said.
    bool showFilledForm();

    WindowParts& parts_;
    ScanControl& scan_;
    std::shared_ptr<DeviceOpener> opener_;
    DeviceSearch search_;
    DeviceTrials trials_;
    DeviceSetup connected_;  ///< what was asked for the last time
    std::optional<KnownScanner> scanner_;
    QTimer healthTimer_;  ///< devices are looked at while nothing else changes, too
};

}  // namespace planewright
