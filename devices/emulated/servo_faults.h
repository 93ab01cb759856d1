// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/types/error.h"
#include "devices/emulated/emulated_device.h"

namespace planewright {

/// What can be made to go wrong with an emulated servo.
enum class ServoFault {
    Stall,
    Frozen,
    Overload,
    Overheat,
    Voltage,
    Silent,
    Garbled,
    WrongId,
    Two,
    Echo,
    Wheel,
    PowerLoss,
    Slow,
    WrongAngle,
    Unplug,
    ByteLoss,
    AngleBit,
    RangeBit,
    ChecksumBit,
    InstructionBit,
};

/// A kind of fault as people name it, and a sentence about it.
struct ServoFaultKind {
    ServoFault fault;
    std::string_view kind;
    std::string_view sentence;
};

std::span<const ServoFaultKind> servoFaultKinds();

/// A fault and the turn of the laser from which on it is there.
struct ServoFaultAt {
    ServoFault fault;
    int step = 0;
};

/// Errors (Usage): a kind that no servo has, with those that it has; a step below 0.
Result<std::vector<ServoFaultAt>> readServoFaults(std::span<const FaultAt> faults);

}  // namespace planewright
