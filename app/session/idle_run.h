// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QThread>

#include "app/session/loops/idle_loop.h"

namespace planewright {

/// A thread that looks after a scanner between scans. Signals come in the thread of this object.
class IdleRun : public QObject {
    Q_OBJECT

public:
    IdleRun(std::shared_ptr<ScanSource> source, const Clock& clock);
    /// Waits for the thread, which ends soon: nobody else asks the devices anything then.
    ~IdleRun() override;

    void goHome() { loop_.goHome(); }

signals:
    /// With an angle [rad] where something has moved.
    void cameHome(std::optional<double> pitch);
    void homeFailed(const planewright::Error& error);
    void devicesTroubled(const std::vector<planewright::FaultRecord>& records);

private:
    std::shared_ptr<ScanSource> source_;
    IdleLoop loop_;
    std::unique_ptr<QThread> thread_;
};

}  // namespace planewright
