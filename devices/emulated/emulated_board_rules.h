// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>

#include "devices/board/board_message.h"

namespace planewright {

/// The tables of resources/manual/board-protocol.md that say when a board refuses.

/// What a board knows when it looks whether it may do something.
struct BoardCircumstances {
    board::State state = board::State::Unarmed;
    bool isGreeted = false;     ///< HELLO since the reset
    bool isConfigured = false;  ///< SET_CONFIG since the reset
    bool triggerWaits = false;
    board::Config config;
    int highest = 0;  ///< position of the servo
};

/// Why a request is not done; empty where it is.
std::optional<board::Nak> refusal(const board::Frame& request, const BoardCircumstances& now);

}  // namespace planewright
