// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>

#include "app/window/device_control.h"
#include "app/window/scan_control.h"
#include "app/window/window_parts.h"

namespace planewright {

/// Lets the forms of the source say what is open, however it was opened.
class SourceControl : public QObject {
    Q_OBJECT

public:
    /// Both must live as long as this.
    SourceControl(WindowParts& parts, const ScanControl& scan, const DeviceControl& devices);

private:
    void show();

    WindowParts& parts_;
    const ScanControl& scan_;
    const DeviceControl& devices_;
    std::string shown_;  ///< the address that the forms have been filled from; what is typed then stays
};

}  // namespace planewright
