// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/sources/device_opener.h"
#include "app/sources/found_devices.h"
#include "app/window/scan_control.h"
#include "app/window/window_parts.h"

namespace planewright {

/// Runs the form of laser and tilt unit: what is connected, their test, connecting them, and how they are.
class DeviceControl : public QObject {
    Q_OBJECT

public:
    DeviceControl(WindowParts& parts, ScanControl& scan);
    /// Ends a search or a test, and waits for it.
    ~DeviceControl() override;

private:
    /// Looks for what is connected; with `asks` lasers are opened and asked who they are.
    void search(bool asks);
    void show(const std::vector<FoundDevice>& found);
    void test();
    void takeCheck(std::size_t check, const std::optional<Result<std::string>>& result);
    void connectDevices(const DeviceSetup& setup);
    void showFacts();
    bool isIdle() const;

    WindowParts& parts_;
    ScanControl& scan_;
    std::shared_ptr<DeviceOpener> opener_;
    QTimer plugged_;  ///< what is plugged in comes in bursts: one search for all of it
    std::vector<DeviceCheck> checks_;
    std::stop_source stop_;
    BackgroundWork work_;  ///< last, so that it ends first
};

}  // namespace planewright
