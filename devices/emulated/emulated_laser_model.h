// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

#include "core/types/error.h"
#include "devices/laser.h"
#include "devices/scip/scip_status.h"

namespace planewright {

/// What tells one emulated laser from another.
struct EmulatedLaserModel {
    std::string_view name;  ///< "UTM-30LX"
    std::string_view product;
    std::string_view firmware;
    std::string_view protocol;
    std::string_view motor;  ///< SCSP of the II reply
    std::string_view line;   ///< SBPS of it

    int nearest = 0;   ///< DMIN [mm]
    int farthest = 0;  ///< DMAX [mm]
    int stepsPerTurn = 0;
    int firstStep = 0;
    int lastStep = 0;
    int frontStep = 0;
    int turnsPerMinute = 0;
    double reach = 0.0;           ///< beyond, nothing comes back [m]
    std::uint32_t noReturn = 0;   ///< code of a beam that does not come back
    std::uint32_t blind = 0;      ///< code of a beam that comes back from its own window
    bool isOnAtPowerOn = false;   ///< the laser, without being asked
    bool hasSerialLine = false;   ///< and a motor whose speed may be set: SS, CR
    bool tellsTimeInHex = false;  ///< TIME of the II reply

    ScipVersion version() const { return scipVersionOf(protocol); }
    LaserLimits limits() const;
};

/// "UTM-30LX", "UST-20LX" or "URG-04LX"; another is a Usage error that lists the known.
Result<EmulatedLaserModel> emulatedLaserModel(std::string_view name);

}  // namespace planewright
