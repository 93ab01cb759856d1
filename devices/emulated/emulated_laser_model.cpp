// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser_model.h"

#include <array>
#include <string>

namespace planewright {

namespace {

constexpr EmulatedLaserModel kUtm30lx{
    .name = "UTM-30LX",
    .product = "SOKUIKI Sensor TOP-URG UTM-30LX",
    .firmware = "P.1.05(17/Apr./2009)",
    .protocol = "SCIP 2.0",
    .motor = "Initial(2400[rpm])<-Default setting by user",
    .line = "USB Full Speed",
    .nearest = 23,
    .farthest = 60'000,
    .stepsPerTurn = 1440,
    .firstStep = 0,
    .lastStep = 1080,
    .frontStep = 540,
    .turnsPerMinute = 2400,
    .reach = 30.0,
    .noReturn = 1,
    .blind = 4,
    .isOnAtPowerOn = true,
    .hasSerialLine = false,
    .tellsTimeInHex = true,
};

constexpr EmulatedLaserModel kUst20lx{
    .name = "UST-20LX",
    .product = "UST-20LX",
    .firmware = "2.23.0000",
    .protocol = "SCIP 2.2",
    .motor = "2400",
    .line = "Ethernet 100 [Mbps]",
    .nearest = 20,
    .farthest = 60'000,
    .stepsPerTurn = 1440,
    .firstStep = 0,
    .lastStep = 1080,
    .frontStep = 540,
    .turnsPerMinute = 2400,
    .reach = 20.0,
    .noReturn = 65'533,
    .blind = 65'533,
    .isOnAtPowerOn = true,
    .hasSerialLine = false,
    .tellsTimeInHex = false,
};

constexpr EmulatedLaserModel kUrg04lx{
    .name = "URG-04LX",
    .product = "SOKUIKI Sensor URG-04LX",
    .firmware = "3.3.00(16/Apr./2008)",
    .protocol = "SCIP 2.0",
    .motor = "Initial(600[rpm])<-Default setting by user",
    .line = "19200[bps]<-Default setting by user",
    .nearest = 20,
    .farthest = 5'600,
    .stepsPerTurn = 1024,
    .firstStep = 44,
    .lastStep = 725,
    .frontStep = 384,
    .turnsPerMinute = 600,
    .reach = 4.095,
    .noReturn = 0,
    .blind = 6,
    .isOnAtPowerOn = false,
    .hasSerialLine = true,
    .tellsTimeInHex = true,
};

constexpr std::array kModels{kUtm30lx, kUst20lx, kUrg04lx};

}  // namespace

LaserLimits EmulatedLaserModel::limits() const
{
    LaserLimits limits;
    limits.rangeMin = 0.001 * nearest;
    limits.rangeMax = 0.001 * farthest;
    limits.stepsPerTurn = stepsPerTurn;
    limits.firstStep = firstStep;
    limits.lastStep = lastStep;
    limits.frontStep = frontStep;
    limits.period = std::chrono::nanoseconds{std::chrono::minutes{1}} / turnsPerMinute;
    return limits;
}

Result<EmulatedLaserModel> emulatedLaserModel(std::string_view name)
{
    std::string known;
    for (const EmulatedLaserModel& model : kModels) {
        if (model.name == name)
            return model;
        known += (known.empty() ? "" : ", ") + std::string{model.name};
    }
    return fail(ErrorCode::Usage, "there is no emulated laser '" + std::string{name} + "'; known: " + known);
}

}  // namespace planewright
