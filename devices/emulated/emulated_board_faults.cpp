// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board_faults.h"

#include <array>

namespace planewright {

std::span<const BoardFaultKind> boardFaultKinds()
{
    static constexpr auto kKinds = std::to_array<BoardFaultKind>({
        {BoardFault::Crc, "board-crc", "one bit of every fifth frame of the board is turned over"},
        {BoardFault::ByteLoss, "board-byte-loss", "every fifth frame of the board lacks a byte"},
        {BoardFault::Garbage, "board-garbage", "random bytes come before every fifth frame of the board"},
        {BoardFault::Silent, "board-silent", "the board hears and obeys, but nothing comes from it any more"},
        {BoardFault::Duplicate, "board-duplicate", "every frame of the board comes twice"},
        {BoardFault::Delay, "board-delay", "everything from the board comes 80 ms late"},
        {BoardFault::LostEvent, "board-lost-event", "every tenth event of the board is lost"},
        {BoardFault::Reset, "board-reset", "the board starts anew, once"},
        {BoardFault::Watchdog, "board-watchdog",
         "the board misses the heartbeats, once: it stops when it is armed next, or is"},
        {BoardFault::Stall, "board-stall", "something holds the motor"},
        {BoardFault::Overload, "board-overload", "the servo reports an overload, for three seconds"},
        {BoardFault::Overheat, "board-overheat", "the servo is at 82 °C, for three seconds"},
        {BoardFault::Voltage, "board-voltage", "the servo's supply falls to 9 V, for three seconds"},
        {BoardFault::Button, "board-button", "somebody presses the button for emergencies, for two seconds"},
        {BoardFault::NoSync, "board-no-sync", "the wire with the laser's sync pulses breaks"},
        {BoardFault::WrongAngle, "board-wrong-angle", "all positions that the board tells are 40 counts too high"},
        {BoardFault::Unplug, "board-unplug", "the board's cable is pulled out"},
    });
    return kKinds;
}

Result<BoardFault> boardFaultOf(const FaultAt& fault)
{
    std::string known;
    for (const BoardFaultKind& kind : boardFaultKinds()) {
        if (kind.kind == fault.kind && fault.step >= 0)
            return kind.fault;
        known += (known.empty() ? "" : ", ") + std::string{kind.kind};
    }
    if (fault.step < 0)
        return fail(ErrorCode::Usage, fault.kind + '@' + std::to_string(fault.step) + ": steps count from 0");
    return fail(ErrorCode::Usage, "no fault of a board is called '" + fault.kind + "'; there are " + known);
}

}  // namespace planewright
