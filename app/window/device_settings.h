// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QSettings>

#include "app/sources/found_devices.h"
#include "ui/common/device_setup.h"

namespace planewright {

/// The devices that were set up the last time; what is not there, or makes no sense, is as it is without settings.
DeviceSetup loadDeviceSetup(const QSettings& settings);
void saveDeviceSetup(const DeviceSetup& setup, QSettings& settings);

/// The lasers that were asked once, by the ports where they were then.
KnownLasers loadKnownLasers(const QSettings& settings);
void saveKnownLasers(const KnownLasers& known, QSettings& settings);

}  // namespace planewright
