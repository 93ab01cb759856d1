// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>

#include "core/types/error.h"
#include "devices/emulated/emulated_device.h"

namespace planewright {

/// What can go wrong with an emulated control board.
enum class BoardFault {
    Crc,
    ByteLoss,
    Garbage,
    Silent,
    Duplicate,
    Delay,
    LostEvent,
    Reset,
    Watchdog,
    Stall,
    Overload,
    Overheat,
    Voltage,
    Button,
    NoSync,
    WrongAngle,
    Unplug,
};

/// A fault as people ask for it.
struct BoardFaultKind {
    BoardFault fault;
    std::string_view kind;      ///< as in FaultAt: "board-crc"
    std::string_view sentence;  ///< what it does
};

/// All of them, in the order in which they are shown.
std::span<const BoardFaultKind> boardFaultKinds();

/// The fault of a kind. Errors (Usage): no such kind, with those that there are; a step below 0.
Result<BoardFault> boardFaultOf(const FaultAt& fault);

}  // namespace planewright
