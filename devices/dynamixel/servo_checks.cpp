// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_checks.h"

#include <cmath>

#include "devices/dynamixel/servo_state.h"

namespace planewright {

namespace {

constexpr std::uint32_t kPositionMode = 3;
constexpr std::uint32_t kSlave = 0x02;
constexpr std::uint32_t kProfileInTimes = 0x04;

std::string at(const ServoRegister& place)
{
    return "address " + std::to_string(place.address);
}

std::optional<std::string> reasonOfLimits(const DynamixelModel& model, const ServoSettings& settings)
{
    const std::string places = "its angle limits (" + at(model.table->lowestGoal) + " and " +
                               at(model.table->highestGoal) + "), for instance to 0 and " +
                               std::to_string(model.highestCount);
    if (settings.lowestGoal == 0 && settings.highestGoal == 0)
        return "turns without end like a wheel, since both of its angle limits are 0; set " + places;
    if (settings.lowestGoal == model.highestCount && settings.highestGoal == model.highestCount)
        return "counts several turns, since both of its angle limits are " + std::to_string(model.highestCount) +
               "; set " + places;
    if (settings.lowestGoal >= settings.highestGoal)
        return "has angle limits the wrong way round, " + std::to_string(settings.lowestGoal) + " and " +
               std::to_string(settings.highestGoal) + "; set " + places;
    return std::nullopt;
}

std::optional<std::string> reasonOfModes(const ControlTable& table, const RegisterImage& image)
{
    if (table.torqueMode.exists() && image.value(table.torqueMode) != 0)
        return "obeys a torque and no position (" + at(table.torqueMode) + "); switch its power off and on";
    if (!table.operatingMode.exists())
        return std::nullopt;
    const std::uint32_t mode = image.value(table.operatingMode);
    if (mode != kPositionMode)
        return "is in operating mode " + std::to_string(mode) +
               ", and only mode 3, position, stops where it is told; " + "set " + at(table.operatingMode) + " to 3";
    if ((image.value(table.driveMode) & kSlave) != 0)
        return "follows another servo as its slave; clear bit 1 of " + at(table.driveMode);
    if ((image.value(table.driveMode) & kProfileInTimes) != 0)
        return "takes the time of a motion for its speed; clear bit 2 of " + at(table.driveMode);
    return std::nullopt;
}

}  // namespace

std::optional<std::string> reasonNotToMove(const DynamixelModel& model, const RegisterImage& image)
{
    const ControlTable& table = *model.table;
    const ServoSettings settings = decodeSettings(model, image);
    if (auto reason = reasonOfModes(table, image))
        return reason;
    if (auto reason = reasonOfLimits(model, settings))
        return reason;
    if (settings.mostSpeed < 1)
        return "has the speed limit 0; set " + at(table.speedLimit);
    if (table.lock.exists() && image.value(table.lock) != 0)
        return "has its memory locked (" + at(table.lock) +
               "), and only the end of its power unlocks it; switch its "
               "power off and on";
    if (settings.returnLevel < 1)
        return "answers no reads; set its status return level (" + at(table.returnLevel) + ") to 2";
    return std::nullopt;
}

std::optional<std::string> faultOf(const TiltMounting& mounting)
{
    if (!std::isfinite(mounting.zeroPitch))
        return "the zero of the pitch is no number";
    if (std::abs(mounting.sign) != 1.0)
        return "the sign must be 1 or -1";
    if (!(mounting.scale > 0.5 && mounting.scale < 2.0))
        return "the scale must be between 0.5 and 2";
    if (!(mounting.lowest < mounting.highest))
        return "the lowest pitch must be below the highest";
    if (!(mounting.fastest > 0.0))
        return "the fastest speed must be above 0";
    return std::nullopt;
}

}  // namespace planewright
