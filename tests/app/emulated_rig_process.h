// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QProcess>
#include <QStringList>

/// Emulated devices in the corridor with seed 7, which a process of their own serves as long as this lives.
class EmulatedRigProcess {
public:
    /// `served` are the options of `planewright-cli emulate`, the laser first.
    explicit EmulatedRigProcess(const QStringList& served)
    {
        process_.start(PLANEWRIGHT_CLI, QStringList{"emulate", "--room", "corridor", "--seed", "7"} + served);
        while (addresses_.size() < 2 && process_.waitForReadyRead(60'000)) {
            while (process_.canReadLine())
                addresses_ += QString::fromUtf8(process_.readLine()).trimmed();
        }
    }

    ~EmulatedRigProcess()
    {
        process_.terminate();
        process_.waitForFinished(60'000);
    }
    EmulatedRigProcess(const EmulatedRigProcess&) = delete;
    EmulatedRigProcess& operator=(const EmulatedRigProcess&) = delete;

    bool isServing() const { return addresses_.size() == 2; }
    QByteArray error() { return process_.readAllStandardError(); }
    QString laser() const { return addresses_.at(0); }
    QString tiltUnit() const { return addresses_.at(1); }

private:
    QProcess process_;
    QStringList addresses_;
};
