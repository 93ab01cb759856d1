// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_state.h"

namespace planewright::board {

std::string toText(State state)
{
    switch (state) {
        case State::Unarmed:
            return "UNARMED";
        case State::Armed:
            return "ARMED";
        case State::Moving:
            return "MOVING";
        case State::Sweeping:
            return "SWEEPING";
        case State::Stopped:
            return "STOPPED";
        case State::Estopped:
            return "ESTOPPED";
        case State::Fault:
            return "FAULT";
    }
    return "state " + std::to_string(static_cast<int>(state));
}

std::string toText(Fault fault)
{
    switch (fault) {
        case Fault::None:
            return "no fault";
        case Fault::Watchdog:
            return "no heartbeat reached it in time, so it stopped the motor and holds it";
        case Fault::NoSync:
            return "no sync pulse of the laser came for a second";
        case Fault::Stall:
            return "the motor did not get to its goal: something holds it";
        case Fault::ServoSilent:
            return "the servo does not answer";
        case Fault::Overload:
            return "the servo is overloaded";
        case Fault::Overheat:
            return "the servo is too hot";
        case Fault::Voltage:
            return "the servo's voltage is out of its limits";
        case Fault::ServoRefused:
            return "the servo took an instruction of the board for wrong";
        case Fault::WheelMode:
            return "the servo is set to turn without end (wheel mode)";
        case Fault::Jump:
            return "the servo lost its power, or was turned by force";
        case Fault::Firmware:
            return "its firmware found an error of its own";
    }
    return "fault " + std::to_string(static_cast<int>(fault));
}

std::string codeOf(Fault fault)
{
    switch (fault) {
        case Fault::None:
            return "board-stopped";
        case Fault::Watchdog:
            return "board-watchdog";
        case Fault::NoSync:
            return "board-no-sync";
        case Fault::Stall:
            return "board-stall";
        case Fault::ServoSilent:
            return "board-servo-silent";
        case Fault::Overload:
            return "board-overload";
        case Fault::Overheat:
            return "board-overheat";
        case Fault::Voltage:
            return "board-voltage";
        case Fault::ServoRefused:
            return "board-servo-refused";
        case Fault::WheelMode:
            return "board-wheel-mode";
        case Fault::Jump:
            return "board-jump";
        case Fault::Firmware:
            return "board-firmware";
    }
    return "board-fault-" + std::to_string(static_cast<int>(fault));
}

std::string toText(NakCode code)
{
    switch (code) {
        case NakCode::UnknownType:
            return "it does not know this message";
        case NakCode::Length:
            return "the message has the wrong length";
        case NakCode::Range:
            return "a value is out of range";
        case NakCode::State:
            return "not in this state";
        case NakCode::Busy:
            return "it is busy";
        case NakCode::Estopped:
            return "it is stopped in an emergency";
    }
    return "reason " + std::to_string(static_cast<int>(code));
}

std::string servoName(std::uint16_t model)
{
    switch (model) {
        case 12:
            return "AX-12";
        case 18:
            return "AX-18";
        case 24:
            return "RX-24";
        case 28:
            return "RX-28";
        case 29:
            return "MX-28";
        case 64:
            return "RX-64";
        case 310:
            return "MX-64";
        case 320:
            return "MX-106";
        default:
            return "servo model " + std::to_string(model);
    }
}

}  // namespace planewright::board
