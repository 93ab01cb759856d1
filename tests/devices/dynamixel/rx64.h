// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "devices/dynamixel/control_table.h"

namespace planewright {

/// The servo of most tests.
inline const DynamixelModel& rx64()
{
    return *findDynamixelModel(DynamixelProtocol::One, 64);
}

}  // namespace planewright
