// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <stop_token>

#include <QObject>
#include <QTimer>

#include "app/sources/found_devices.h"
#include "app/window/background_work.h"

namespace planewright {

/// Looks for devices when somebody asks, and when something was plugged in or pulled out: one search for all that
/// happens in half a second, however long it goes on. No request is lost: what comes while a search runs, or while the
/// devices are used for something else, is answered by one search afterwards.
class DeviceSearch : public QObject {
    Q_OBJECT

public:
    /// Finds what there is; on a thread of its own. With `asks` lasers are opened and asked who they are.
    using Find = std::function<FoundDevices(bool asks, const KnownLasers& known, const std::stop_token& stop)>;

    explicit DeviceSearch(Find find, QObject* parent = nullptr);
    /// Ends a search, and waits for it.
    ~DeviceSearch() override;

    void start(bool asks);
    /// Something has come or gone.
    void noteChange();
    /// While it is held nothing is searched for.
    void setHeld(bool held);

    bool isBusy() const { return work_.isBusy(); }
    const KnownLasers& known() const { return known_; }
    void setKnown(KnownLasers known) { known_ = std::move(known); }

signals:
    void begun();
    void found(const planewright::FoundDevices& found);

private:
    void next();

    Find find_;
    KnownLasers known_;
    QTimer changed_;
    bool isHeld_ = false;
    bool isWanted_ = false;
    bool asks_ = false;  ///< whether the search that is wanted does
    std::stop_source stop_;
    BackgroundWork work_;  ///< last, so that it ends first
};

}  // namespace planewright
